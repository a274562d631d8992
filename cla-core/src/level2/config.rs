//! How the second level learns, and when it leaves the decision to the first (book, 3.4, 6.2.3).

use crate::check::{Config, ConfigError, Range};
use crate::snapshot::{Flip, Reader, Stored, Writer, stored};

/// How the second level learns.
///
/// ```
/// use cla_core::level2::Level2Config;
/// assert_eq!(Level2Config::FORAGER.prior, 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Level2Config {
    /// κ: how many verified occasions the reliability of level 1 counts for; above 0.
    pub prior: f32,
    /// Share of a state's value that comes from the rewards that really followed it, in `[0, 1]`;
    /// the rest is what the beliefs promise.
    ///
    /// Beliefs that remember one schema still mistake some states for others, and a plan may
    /// exploit the mistake; experience does not.
    pub experience: f32,
    /// λ: how far back a reward is felt, in `[0, 1]`.
    pub lambda: f32,
    /// The least weight of a new reward, in `[0, 1]`.
    pub learning_rate: f32,
    /// The least weight of a new occasion, in `[0, 1)`: about 1 / `forgetting` of them count;
    /// 0 never forgets.
    pub forgetting: f32,
    /// Synthetic items whose value is brought up to date at every step; more than 1024 count as that, so
    /// that a step ends whoever wrote the configuration.
    pub values_per_step: u16,
    /// When level 1 decides although level 2 has something to say.
    pub fallback: Fallback,
}

/// When a level that has something to say leaves the decision to the level below.
///
/// ```
/// use cla_core::level2::{Fallback, Level2Config};
/// assert_eq!(Level2Config::FORAGER.fallback, Fallback::Never);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Fallback {
    /// Level 2 decides wherever it knows what happened last; its beliefs fall back one by one.
    Never,
    /// Level 2 is overloaded while its recent share of right predictions is below this share of
    /// what it was (book, 3.4 and 6.3).
    MeanReliability(f32),
    /// The level whose best action has the larger value decides; of equals level 2 (6.2.3).
    ValueThenReliability,
}

impl Level2Config {
    /// What works best on the simulated Pioneer.
    pub const FORAGER: Self = Self {
        prior: 2.0,
        experience: 0.5,
        lambda: 0.9,
        learning_rate: 0.02,
        forgetting: 0.01,
        values_per_step: 4,
        fallback: Fallback::Never,
    };
}

impl Config for Level2Config {
    fn check(&self) -> Result<(), ConfigError> {
        Range::ABOVE_ZERO.check("Level2Config::prior", self.prior)?;
        Range::SHARE.check("Level2Config::experience", self.experience)?;
        Range::SHARE.check("Level2Config::lambda", self.lambda)?;
        Range::SHARE.check("Level2Config::learning_rate", self.learning_rate)?;
        Range::BELOW_ONE.check("Level2Config::forgetting", self.forgetting)?;
        match self.fallback {
            Fallback::MeanReliability(share) => {
                Range::SHARE.check("Fallback::MeanReliability", share)
            }
            Fallback::Never | Fallback::ValueThenReliability => Ok(()),
        }
    }
}

stored! {
    impl[] Level2Config {
        prior, experience, lambda, learning_rate, forgetting, values_per_step, fallback
    }
}

impl Stored for Fallback {
    const BLANK: Self = Self::Never;

    fn store(&self, to: &mut Writer<'_>) {
        match self {
            Self::Never => 0_u8.store(to),
            Self::MeanReliability(share) => {
                1_u8.store(to);
                share.store(to);
            }
            Self::ValueThenReliability => 2_u8.store(to),
        }
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        let (mut kind, mut share) = (0_u8, 0.0);
        kind.restore(from);
        *self = match kind {
            0 => Self::Never,
            1 => {
                share.restore(from);
                Self::MeanReliability(share)
            }
            _ => Self::ValueThenReliability,
        };
        from.require(kind <= 2);
    }

    // Which of them it is stays: each bit of it would make another shape.
    fn flip(&mut self, by: &mut Flip) {
        let _ = by.field(8);
        if let Self::MeanReliability(share) = self {
            share.flip(by);
        }
    }
}
