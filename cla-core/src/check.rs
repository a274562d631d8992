//! What is asked of every configuration before it may work, and the error when it cannot.

use core::fmt;

/// A configuration that cannot work.
///
/// ```
/// use cla_core::agent::AgentConfig;
/// use cla_core::check::ConfigError;
/// let config = AgentConfig { greedy_share: 1.5, ..AgentConfig::FORAGER };
/// assert_eq!(config.check(), Err(ConfigError::GreedyShare));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ConfigError {
    /// `greedy_share` is outside `[0, 1]` or NaN.
    GreedyShare,
    /// `forgetting` is outside `[0, 1]` or NaN.
    Forgetting,
    /// `values.discount` is outside `[0, 1)` or NaN.
    Discount,
    /// `values.chain_reliability` is outside `[0, 1]`, or `values.chain_relevance` negative, or NaN.
    Chain,
    /// An escape after 0 actions or with a burst of 0.
    Escape,
    /// A harvest threshold is outside `[0, 1]` or NaN, or `off` is not below `on`.
    Thresholds,
    /// `harvest_every` or `training_run` is 0.
    NoActions,
    /// The learning rate starts above 1.
    Alpha,
    /// The second level's prior is not above 0, or its forgetting outside `[0, 1)`, or NaN.
    Level2,
    /// An alarm that could never or always ring, a doubt without actions, or a share out of range.
    Surprise,
    /// A rate, weight or λ of habits is outside `[0, 1]`, or their discount outside `[0, 1)`, or NaN.
    Habits,
    /// The neighbourhood cut is outside `[0, 1]`, or a weight or vigilance is negative, or NaN.
    Training,
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::GreedyShare => "the greedy share must lie between 0 and 1",
            Self::Forgetting => "forgetting must lie between 0 and 1",
            Self::Discount => "the discount must lie between 0 and 1, 1 excluded",
            Self::Chain => "the bounds of a chain must be finite and in range",
            Self::Escape => "an escape needs at least one action before it and one in it",
            Self::Thresholds => "harvest thresholds must satisfy 0 <= off < on <= 1",
            Self::NoActions => "a harvest and a training run need at least one action",
            Self::Alpha => "the learning rate must not exceed 1",
            Self::Level2 => "a prior must be above 0, forgetting between 0 and 1, 1 excluded",
            Self::Surprise => "alarms, doubt and optimism must be finite and in range",
            Self::Habits => "weight, rates and lambda of habits must lie between 0 and 1",
            Self::Training => "cut, result weight and vigilance must be finite and in range",
        })
    }
}

impl core::error::Error for ConfigError {}

/// Whether a number lies between 0 and 1, both included.
pub(crate) fn is_share(x: f32) -> bool {
    (0.0..=1.0).contains(&x)
}
