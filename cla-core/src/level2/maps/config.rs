//! How a second level harvested from maps learns, with what works best by name.

use super::implication::Reading;
use crate::check::{ConfigError, is_share};
use crate::map::{HarvestConfig, TrainingConfig};

/// How a level harvested from maps learns.
///
/// ```
/// use cla_core::level2::{Reading, SomLevelConfig};
/// let book = SomLevelConfig { reading: Reading::Cut(0.9), ..SomLevelConfig::FORAGER };
/// assert_eq!(book.harvest.on, 0.9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SomLevelConfig {
    /// How its maps are trained.
    pub training: TrainingConfig,
    /// How they are read.
    pub harvest: HarvestConfig,
    /// Learned actions between two harvests, at least 1.
    pub harvest_every: u32,
    /// How counters become beliefs.
    pub reading: Reading,
    /// The least weight of a new label, in `[0, 1)`: about 1 / `forgetting` of them count; 0 never
    /// forgets.
    pub forgetting: f32,
    /// Synthetic items whose values are brought up to date at every step.
    pub values_per_step: u16,
}

impl SomLevelConfig {
    /// What works best on the simulated Pioneer.
    pub const FORAGER: Self = Self {
        training: TrainingConfig::FORAGER,
        harvest: HarvestConfig::FORAGER,
        harvest_every: 500,
        reading: Reading::Counters {
            prior: 2.0,
            trace_prior: 100.0,
        },
        forgetting: 0.01,
        values_per_step: 4,
    };
}

impl SomLevelConfig {
    /// Whether the values make sense together.
    ///
    /// # Errors
    /// The first [`ConfigError`] found.
    ///
    /// ```
    /// use cla_core::check::ConfigError;
    /// use cla_core::level2::SomLevelConfig;
    /// let config = SomLevelConfig { harvest_every: 0, ..SomLevelConfig::FORAGER };
    /// assert_eq!(config.check(), Err(ConfigError::NoActions));
    /// ```
    pub fn check(&self) -> Result<(), ConfigError> {
        let positive = |x: f32| x.is_finite() && x > 0.0;
        let reads = match self.reading {
            Reading::Counters { prior, trace_prior } => positive(prior) && positive(trace_prior),
            Reading::Cut(share) => is_share(share),
        };
        if !reads || !(0.0..1.0).contains(&self.forgetting) {
            return Err(ConfigError::Level2);
        }
        if self.harvest_every == 0 {
            return Err(ConfigError::NoActions);
        }
        self.harvest.check()?;
        self.training.check()
    }
}
