//! What the study of modules varies.

use serde::Serialize;

use super::make::{KEPT, TRIALS};
use super::module::Kind;
use crate::failure::Impossible;

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModulesOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// The setting of each kind of module, in the order of [`Kind::ALL`], each below [`TRIALS`].
    pub settings: [usize; 5],
    /// Trainings and lives are shorter by this factor: 1, or more where programs are tested.
    pub shorter: u32,
}

impl ModulesOptions {
    /// The settings that were kept, or with `trial` the setting of that number for every kind.
    ///
    /// # Errors
    /// [`Impossible`] when there is no such setting.
    ///
    /// ```
    /// use host_sim::experiment::modules::ModulesOptions;
    /// assert!(ModulesOptions::new(vec![1], None).is_ok());
    /// assert_eq!(ModulesOptions::new(vec![1], Some(3)).map(|it| it.settings), Ok([3; 5]));
    /// assert!(ModulesOptions::new(vec![1], Some(6)).is_err());
    /// ```
    pub fn new(seeds: Vec<u64>, trial: Option<usize>) -> Result<Self, Impossible> {
        if let Some(trial) = trial.filter(|&it| it >= TRIALS) {
            return Err(Impossible::new(format!(
                "--trial {trial}: modules were tried with settings 0 to {}",
                TRIALS - 1
            )));
        }
        Ok(Self {
            seeds,
            settings: trial.map_or(KEPT, |it| [it; 5]),
            shorter: 1,
        })
    }

    /// So many of anything, made shorter.
    #[must_use]
    pub fn length(&self, of: u32) -> u32 {
        (of / self.shorter.max(1)).max(1)
    }

    /// Whether these are the settings and lengths of all claims.
    #[must_use]
    pub fn is_standard(&self) -> bool {
        self.settings == KEPT && self.shorter == 1
    }

    /// The setting of a kind.
    #[must_use]
    pub const fn setting(&self, kind: Kind) -> usize {
        self.settings[kind as usize]
    }
}
