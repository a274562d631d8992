//! How a second level harvested from maps learns, with what works best by name.

use super::implication::Reading;
use crate::check::{Config, ConfigError, Range};
use crate::map::{HarvestConfig, TrainingConfig};

/// How a level harvested from maps learns.
///
/// ```
/// use cla_core::check::Config;
/// use cla_core::level2::{Reading, SomLevelConfig};
/// let book = SomLevelConfig { reading: Reading::Cut(0.9), ..SomLevelConfig::FORAGER };
/// assert_eq!(book.harvest.on, 0.9);
/// let never = SomLevelConfig { harvest_every: 0, ..book };
/// assert_eq!(never.check().unwrap_err().field, "SomLevelConfig::harvest_every");
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
    /// Synthetic items whose values are brought up to date at every step; more than 1024 count as that, so
    /// that a step ends whoever wrote the configuration.
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

impl Config for SomLevelConfig {
    fn check(&self) -> Result<(), ConfigError> {
        self.training.check()?;
        self.harvest.check()?;
        let every = self.harvest_every as f32;
        Range::AT_LEAST_ONE.check("SomLevelConfig::harvest_every", every)?;
        match self.reading {
            Reading::Counters { prior, trace_prior } => {
                Range::ABOVE_ZERO.check("Reading::Counters::prior", prior)?;
                Range::ABOVE_ZERO.check("Reading::Counters::trace_prior", trace_prior)?;
            }
            Reading::Cut(share) => Range::SHARE.check("Reading::Cut", share)?,
        }
        Range::BELOW_ONE.check("SomLevelConfig::forgetting", self.forgetting)
    }
}
