//! Q and Sarsa(λ) on histories of three lengths, and how each was tuned.
//!
//! All rivals get the same [`Budget`] in a world: 32 configurations each, every one tried on a few
//! seeds and the best on all.
//! `examples/aliased.rs` makes `data/aliased.tsv`, the best of each, again.

use crate::baseline::tabular::{History, Method, TabularConfig, Traces};
use crate::failure::Failure;

use super::places::Place;

/// The best of each rival in each world.
const TUNED: &str = include_str!("../../../data/aliased.tsv");

/// How many lives a rival's tuning has in a world, and how long they are.
///
/// ```
/// use host_sim::experiment::aliased::Place;
/// use host_sim::experiment::aliased::rivals::Budget;
/// assert!(Budget::of(Place::Barriers).seeds < Budget::of(Place::Cheese).seeds);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Actions of training.
    pub training: u32,
    /// Actions of the test.
    pub test: u32,
    /// Seeds, from 0 on, with which every configuration is tried.
    pub first_seeds: u64,
    /// Seeds, from 0 on, with which the best [`KEPT`](Self::KEPT) are.
    pub seeds: u64,
}

impl Budget {
    /// Configurations that are tried with all seeds.
    pub const KEPT: usize = 6;

    /// The same for all rivals in a world; a life among barriers takes many times longer.
    #[must_use]
    pub const fn of(place: Place) -> Self {
        let (first_seeds, seeds) = match place {
            Place::Barriers => (1, 5),
            _ => (4, 20),
        };
        Self {
            training: 20_000,
            test: place.test(),
            first_seeds,
            seeds,
        }
    }
}

/// Who learns by reinforcement alone, and from how long a history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rival {
    /// Whether it is Q-learning; Sarsa(λ) otherwise.
    pub q: bool,
    /// What a state is.
    pub history: History,
}

impl Rival {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::new(true, History::None),
        Self::new(true, History::TwoSteps),
        Self::new(true, History::FourSteps),
        Self::new(false, History::None),
        Self::new(false, History::TwoSteps),
        Self::new(false, History::FourSteps),
    ];

    const fn new(q: bool, history: History) -> Self {
        Self { q, history }
    }

    /// Its name in what is measured.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match (self.q, self.history) {
            (true, History::None) => "q",
            (true, History::FourSteps) => "q_4",
            (true, _) => "q_2",
            (false, History::None) => "sarsa",
            (false, History::FourSteps) => "sarsa_4",
            (false, _) => "sarsa_2",
        }
    }

    /// The configurations among which it is tuned in a world.
    #[must_use]
    pub fn grid(self, place: Place) -> Vec<TabularConfig> {
        let mut grid = Vec::new();
        for alpha in [0.03, 0.1, 0.3, 0.6] {
            for discount in [0.9, 0.98] {
                for optimism in [0.0, place.optimism()] {
                    let base = TabularConfig {
                        history: self.history,
                        alpha,
                        discount,
                        optimism,
                        escape: None,
                        ..TabularConfig::Q
                    };
                    // What Sarsa has in traces, Q-learning has in another share of random actions.
                    grid.extend(if self.q {
                        [0.1, 0.3].map(|explore| TabularConfig { explore, ..base })
                    } else {
                        [0.5, 0.9].map(|lambda| TabularConfig {
                            method: Method::Sarsa(Traces::Replacing),
                            lambda,
                            ..base
                        })
                    });
                }
            }
        }
        grid
    }

    /// The configuration that did best in a world.
    ///
    /// # Errors
    /// [`Failure`] when the committed table does not have it.
    pub fn tuned(self, place: Place) -> Result<TabularConfig, Failure> {
        let row = TUNED
            .lines()
            .map(|line| line.split('\t').collect::<Vec<_>>())
            .find(|row| row.first() == Some(&place.name()) && row.get(1) == Some(&self.name()));
        let [_, _, alpha, discount, explore, lambda, optimism, ..] =
            *row.ok_or("data/aliased.tsv lacks a rival")?
        else {
            return Err("a row of data/aliased.tsv is too short".into());
        };
        let base = if self.q {
            TabularConfig::Q
        } else {
            TabularConfig {
                method: Method::Sarsa(Traces::Replacing),
                ..TabularConfig::Q
            }
        };
        Ok(TabularConfig {
            history: self.history,
            alpha: alpha.parse()?,
            discount: discount.parse()?,
            explore: explore.parse()?,
            lambda: lambda.parse()?,
            optimism: optimism.parse()?,
            escape: None,
            ..base
        })
    }
}
