//! The learners that the brain is measured against, and how each was tuned.
//!
//! All rivals get the same budget: [`TRIALS`] configurations each, the first by hand and the others
//! drawn from the grids below, on the same [`SEEDS`], each tested after three lengths of training.
//! The score is what is captured in 3000 undamaged actions and in the 3000 after the camera was turned
//! by 12°; [`Rival::tuned`] is the best.
//! `examples/tune.rs` makes `data/tuning.tsv`, the table of all trials, again.
//! The brain's own configuration is frozen: it is not among the trials.

use cla_core::agent::{Adaptation, AgentConfig, Escape};
use cla_core::choice::HabitConfig;
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::life::{Childhood, Protocol, course};
use crate::baseline::linear::{Linear, LinearConfig};
use crate::baseline::tabular::{History, Method, Tabular, TabularConfig, Traces};
use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::forager::Forager;
use crate::world::damage::Damage;
use crate::world::setting::WorldOptions;

/// Configurations of each rival that are tried.
pub const TRIALS: u32 = 64;
/// Seeds on which each is tried, from 0 on.
pub const SEEDS: u64 = 20;
/// Lengths of training after which each is tested, in quarters of a childhood.
pub const LENGTHS: [u32; 3] = [1, 2, 4];

/// Who learns by reinforcement alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Rival {
    /// A table of percepts, Sarsa(λ).
    Sarsa,
    /// A table of the last two or three percepts with the actions between them, Sarsa(λ).
    SarsaHistory,
    /// Each item has a vote, at once or one and two steps later, too: Sarsa(λ) with linear values.
    Linear,
    /// Sarsa(λ) with linear values over what habits see, and nothing else: the brain itself, of
    /// whose votes habits have all.
    Habits,
    /// A table of percepts, Q-learning.
    Q,
    /// A table of the last two or three percepts with the actions between them, Q-learning.
    QHistory,
}

/// Parameters of a rival.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setup {
    /// Of a table.
    Table(TabularConfig),
    /// Of votes of items.
    Linear(LinearConfig),
    /// Of a brain whose votes are habits alone.
    Habits(HabitsAlone),
}

/// Parameters of a brain whose votes are habits alone; nothing surprises it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HabitsAlone {
    /// Share of a TD error that each feature learns, in `[0, 1]`.
    pub rate: f32,
    /// Discount of the future, in `[0, 1)`.
    pub discount: f32,
    /// λ, in `[0, 1]`.
    pub lambda: f32,
    /// Share of random actions in training.
    pub explore: f32,
    /// Actions in a row that training chooses the same way.
    pub run: u16,
    /// Random actions after a long time without reward.
    pub escape: Option<Escape>,
}

impl HabitsAlone {
    /// The brain: schemas are learned, for one that has succeeded is a feature, and have no vote.
    #[must_use]
    pub const fn agent(&self) -> AgentConfig {
        AgentConfig {
            greedy_share: 1.0 - self.explore,
            training_run: self.run,
            escape: self.escape,
            habits: Some(HabitConfig {
                weight: 1.0,
                discount: self.discount,
                lambda: self.lambda,
                learning_rate: self.rate,
                doubting_rate: self.rate,
                ..HabitConfig::FORAGER
            }),
            ..AgentConfig::FORAGER_LEVEL2
        }
    }
}

/// A learner that can be copied with all that it knows.
pub trait Pupil: Learner {
    /// The copy.
    fn copy(&self) -> Box<dyn Learner>;
}

impl<T: Learner + Clone + 'static> Pupil for T {
    fn copy(&self) -> Box<dyn Learner> {
        Box::new(self.clone())
    }
}

impl Setup {
    /// A learner that knows nothing.
    ///
    /// # Errors
    /// [`Failure`] when the configuration cannot work or the world cannot be built.
    pub fn newborn(&self, world: &WorldOptions, seed: u64) -> Result<Box<dyn Pupil>, Failure> {
        Ok(match *self {
            Self::Table(config) => Box::new(Tabular::new(config, seed)),
            Self::Linear(config) => Box::new(Linear::new(config, &world.build(seed)?, seed)),
            Self::Habits(it) => Box::new(Forager::born(it.agent(), Adaptation::Relearning, seed)?),
        })
    }
}

/// A configuration and the length of training after which it is best, in quarters of a childhood.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuned {
    /// The parameters.
    pub setup: Setup,
    /// The length of training.
    pub quarters: u32,
}

const ESCAPES: [Option<Escape>; 2] = [
    None,
    Some(Escape {
        after: 100,
        burst: 10,
    }),
];
const DISCOUNTS: [f64; 5] = [0.8, 0.85, 0.9, 0.95, 0.98];
const LAMBDAS: [f64; 7] = [0.0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95];
const EXPLORE: [f64; 4] = [0.05, 0.1, 0.2, 0.3];
const EXPLORE_ACTING: [f64; 5] = [0.005, 0.01, 0.02, 0.05, 0.1];
const TRACES: [Traces; 2] = [Traces::Replacing, Traces::Accumulating];
const PAST: [History; 2] = [History::OneStep, History::TwoSteps];
/// Of tables alone.
const OPTIMISM: [f64; 3] = [0.0, 0.5, 1.0];
const ALPHA_OF_TABLES: [f64; 8] = [0.01, 0.02, 0.03, 0.05, 0.1, 0.2, 0.3, 0.5];
/// Of votes; those of a moment share it.
const ALPHA_OF_VOTES: [f64; 7] = [0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.8];
const ANY_PAST: [History; 3] = [History::None, History::OneStep, History::TwoSteps];
/// Of habits; each feature has it for itself.
const RATES: [f64; 6] = [0.003, 0.01, 0.03, 0.05, 0.1, 0.2];
const RUNS: [u16; 3] = [1, 10, 50];

fn any<T: Copy>(rng: &mut Rng, grid: &[T]) -> T {
    // Grids are short and none is empty.
    grid[rng.below(grid.len() as u32) as usize]
}

impl Rival {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Sarsa,
        Self::SarsaHistory,
        Self::Linear,
        Self::Habits,
        Self::Q,
        Self::QHistory,
    ];

    /// The rival with the highest score of all: the one that both levels are compared with.
    pub const BEST: Self = Self::Habits;

    /// Which of the trials was the best, and after which length of training.
    const fn best_trial(self) -> (u32, u32) {
        match self {
            Self::Sarsa => (55, 2),
            Self::SarsaHistory => (0, 4),
            Self::Linear => (15, 4),
            Self::Habits => (36, 4),
            Self::Q => (8, 2),
            Self::QHistory => (53, 4),
        }
    }

    /// The configuration that it takes part with.
    #[must_use]
    pub fn tuned(self) -> Tuned {
        let (trial, quarters) = self.best_trial();
        let setup = self.draw(trial);
        Tuned { setup, quarters }
    }

    /// Its name in tables and figures.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sarsa => "Sarsa(λ)",
            Self::SarsaHistory => "Sarsa(λ), history",
            Self::Linear => "Sarsa(λ), linear in items",
            Self::Habits => "Sarsa(λ), linear, as habits",
            Self::Q => "Q-learning",
            Self::QHistory => "Q-learning, history",
        }
    }

    /// One of the configurations that are tried; the first is the one by hand.
    #[must_use]
    pub fn draw(self, trial: u32) -> Setup {
        let mut rng = Rng::stream(u64::from(trial), 70 + self as u64);
        let rng = &mut rng;
        let table = |rng: &mut Rng, by_hand: TabularConfig, is_sarsa: bool| {
            if trial == 0 {
                return Setup::Table(by_hand);
            }
            let past = by_hand.history != History::None;
            Setup::Table(TabularConfig {
                method: if is_sarsa {
                    Method::Sarsa(any(rng, &TRACES))
                } else {
                    Method::QLearning
                },
                history: if past { any(rng, &PAST) } else { History::None },
                alpha: any(rng, &ALPHA_OF_TABLES),
                discount: any(rng, &DISCOUNTS),
                lambda: if is_sarsa { any(rng, &LAMBDAS) } else { 0.0 },
                explore: any(rng, &EXPLORE),
                explore_acting: any(rng, &EXPLORE_ACTING),
                optimism: any(rng, &OPTIMISM),
                escape: any(rng, &ESCAPES),
            })
        };
        match self {
            Self::Sarsa => table(rng, TabularConfig::SARSA, true),
            Self::SarsaHistory => table(rng, TabularConfig::SARSA_HISTORY, true),
            Self::Q => table(rng, TabularConfig::Q, false),
            Self::QHistory => table(rng, TabularConfig::Q_HISTORY, false),
            Self::Linear if trial == 0 => Setup::Linear(LinearConfig::DEFAULT),
            Self::Linear => Setup::Linear(LinearConfig {
                history: any(rng, &ANY_PAST),
                alpha: any(rng, &ALPHA_OF_VOTES),
                discount: any(rng, &DISCOUNTS),
                lambda: any(rng, &LAMBDAS),
                explore: any(rng, &EXPLORE),
                explore_acting: any(rng, &EXPLORE_ACTING),
                escape: any(rng, &ESCAPES),
            }),
            Self::Habits if trial == 0 => Setup::Habits(HabitsAlone {
                rate: HabitConfig::FORAGER.learning_rate,
                discount: HabitConfig::FORAGER.discount,
                lambda: HabitConfig::FORAGER.lambda,
                explore: 0.1,
                run: 1,
                escape: AgentConfig::FORAGER.escape,
            }),
            Self::Habits => Setup::Habits(HabitsAlone {
                rate: any(rng, &RATES) as f32,
                discount: any(rng, &DISCOUNTS) as f32,
                lambda: any(rng, &LAMBDAS) as f32,
                explore: any(rng, &EXPLORE) as f32,
                run: any(rng, &RUNS),
                escape: any(rng, &ESCAPES),
            }),
        }
    }
}

/// What one configuration brings on one seed, after each of the [`LENGTHS`] of training: captures in
/// 3000 undamaged actions, and in the 3000 after the camera was turned by 12°.
///
/// # Errors
/// [`Failure`] when the world cannot be built or the configuration cannot work.
pub fn tried(setup: &Setup, world: &WorldOptions, seed: u64) -> Result<[[u32; 2]; 3], Failure> {
    let protocol = Protocol {
        after: 3000,
        ..Protocol::STANDARD
    };
    let mut learner = setup.newborn(world, seed)?;
    let mut childhood = Childhood::new(world, &protocol, seed)?;
    let mut lived = 0;
    let mut brought = [[0; 2]; 3];
    for (length, brought) in LENGTHS.iter().zip(&mut brought) {
        while lived < *length {
            childhood.quarter(&mut *learner)?;
            lived += 1;
        }
        let mut grown = learner.copy();
        grown.act()?;
        let course = course(&mut *grown, world, &protocol, Damage::Camera(12.0), seed)?;
        *brought = [course.before.iter().sum(), course.after.iter().sum()];
    }
    Ok(brought)
}

#[cfg(test)]
mod tests {
    use super::{LENGTHS, Rival, SEEDS, Setup, TRIALS};
    use crate::baseline::tabular::{History, Method};

    const TABLE: &str = include_str!("../../../data/tuning.tsv");

    /// Trial, length of training in actions and score of a rival's lines.
    fn lines(rival: Rival) -> Vec<(u32, u32, f64)> {
        let name = format!("{rival:?}");
        let read = |line: &str| {
            let cells: Vec<&str> = line.split('\t').collect();
            let number = |place: usize| cells[place].parse::<f64>().unwrap();
            let score = number(3) + number(4);
            (cells[0] == name).then(|| (number(1) as u32, number(2) as u32, score))
        };
        TABLE.lines().skip(1).filter_map(read).collect()
    }

    fn best(rival: Rival) -> (u32, u32, f64) {
        let by_score = |a: &(u32, u32, f64), b: &(u32, u32, f64)| a.2.total_cmp(&b.2);
        lines(rival).into_iter().max_by(by_score).unwrap()
    }

    #[test]
    fn every_rival_had_the_same_budget_and_is_the_best_of_it() {
        for rival in Rival::ALL {
            assert_eq!(lines(rival).len(), TRIALS as usize * LENGTHS.len());
            let (trial, training, score) = best(rival);
            assert_eq!((trial, training / 5000), rival.best_trial(), "{rival:?}");
            assert!(score <= best(Rival::BEST).2, "{rival:?}");
        }
        // Seeds from 100 on are not for tuning.
        const { assert!(SEEDS <= 100) };
    }

    #[test]
    fn draws_are_the_same_every_time_and_keep_to_their_rival() {
        for trial in 0..TRIALS {
            for rival in Rival::ALL {
                let setup = rival.draw(trial);
                assert_eq!(setup, rival.draw(trial));
                let fits = match (rival, setup) {
                    (Rival::Linear, Setup::Linear(_)) | (Rival::Habits, Setup::Habits(_)) => true,
                    (_, Setup::Table(it)) => {
                        let q = matches!(rival, Rival::Q | Rival::QHistory);
                        let past = matches!(rival, Rival::SarsaHistory | Rival::QHistory);
                        (it.method == Method::QLearning) == q
                            && (it.history != History::None) == past
                    }
                    _ => false,
                };
                assert!(fits, "{rival:?} {setup:?}");
            }
        }
    }

    #[test]
    fn habits_alone_have_the_whole_vote() {
        let Setup::Habits(it) = Rival::Habits.draw(0) else {
            panic!("a brain");
        };
        let habits = it.agent().habits.unwrap();
        assert_eq!(habits.weight, 1.0);
        assert!(it.agent().surprise.is_none());
    }
}
