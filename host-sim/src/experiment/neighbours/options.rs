//! What the study of neighbours varies.

use serde::Serialize;

use super::values::Learning;
use crate::failure::Impossible;

/// Settings that robots with and without neighbours were tried with, as many of each.
pub const TRIALS: usize = 6;
/// The settings that were kept: without neighbours, and with them.
pub const KEPT: [usize; 2] = [2, 2];

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NeighboursOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// The settings without neighbours and with them, each below [`TRIALS`].
    pub settings: [usize; 2],
    /// Studies are shorter by this factor: 1, or more where programs are tested.
    pub shorter: u32,
}

impl NeighboursOptions {
    /// The settings that were kept, or with `trial` the setting of that number.
    ///
    /// # Errors
    /// [`Impossible`] when there is no such setting.
    ///
    /// ```
    /// use host_sim::experiment::neighbours::NeighboursOptions;
    /// assert!(NeighboursOptions::new(vec![1], Some(5)).is_ok());
    /// assert!(NeighboursOptions::new(vec![1], Some(6)).is_err());
    /// ```
    pub fn new(seeds: Vec<u64>, trial: Option<usize>) -> Result<Self, Impossible> {
        if let Some(trial) = trial.filter(|&it| it >= TRIALS) {
            return Err(Impossible::new(format!(
                "--trial {trial}: neighbours were tried with settings 0 to {}",
                TRIALS - 1
            )));
        }
        Ok(Self {
            seeds,
            settings: trial.map_or(KEPT, |it| [it; 2]),
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

    /// How a robot without neighbours learns: six rates; and one with them: three rates, two shares.
    #[must_use]
    pub fn learning(&self, with: bool) -> Learning {
        if with {
            let trial = self.settings[1] % TRIALS;
            Learning {
                rate: [0.2, 0.5, 0.8][trial % 3],
                shared: [0.3, 0.7][trial / 3],
            }
        } else {
            Learning {
                rate: [0.2, 0.35, 0.5, 0.65, 0.8, 0.95][self.settings[0] % TRIALS],
                shared: 0.0,
            }
        }
    }
}
