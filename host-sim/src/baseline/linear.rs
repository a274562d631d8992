//! Sarsa(λ) with linear values: each item that is on, now or with history before, votes for actions.
//!
//! Where percepts hardly ever come twice, because items blink or err, a table learns nothing; this
//! rival generalizes over items, one by one.
//! The reward is what the world gives as a number; where it gives none, 1 when the Pioneer's `ingrip`
//! is on after an action.
//! Sources: Rummery and Niranjan (1994); Sutton and Barto (2018), 12.7, for replacing traces.

use cla_core::agent::Escape;
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::patience::Patience;
use super::tabular::{History, MOST_STEPS, bits, captured};
use crate::failure::Failure;
use crate::learner::Learner;
use crate::world::{Percept, WORLD_WORDS, World};

/// The parameters of a linear learner.
///
/// ```
/// use host_sim::baseline::linear::LinearConfig;
/// assert!(LinearConfig::DEFAULT.discount < 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinearConfig {
    /// Which percepts and actions have votes.
    pub history: History,
    /// Step size in `(0, 1]`, shared by all that vote.
    pub alpha: f64,
    /// Discount of the future, in `[0, 1)`.
    pub discount: f64,
    /// Decay λ of the traces, in `[0, 1]`.
    pub lambda: f64,
    /// Share of random actions in training.
    pub explore: f64,
    /// Share of random actions afterwards.
    pub explore_acting: f64,
    /// Random actions after a long time without reward, as the brain has them.
    pub escape: Option<Escape>,
}

impl LinearConfig {
    /// A middle of the grid on which it is tuned for each world.
    pub const DEFAULT: Self = Self {
        history: History::None,
        alpha: 0.1,
        discount: 0.95,
        lambda: 0.8,
        explore: 0.1,
        explore_acting: 0.02,
        escape: None,
    };
}

/// Weights of items for actions.
///
/// ```
/// use host_sim::baseline::linear::{Linear, LinearConfig};
/// use host_sim::learner::rewarded::rewarded;
/// use host_sim::world::lake::Lake;
/// let mut world = Lake::new(1);
/// let mut learner = Linear::new(LinearConfig::DEFAULT, &world, 1);
/// assert_eq!(rewarded(&mut learner, &mut world, 100)?.actions, 100);
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
#[derive(Clone, Debug)]
pub struct Linear {
    config: LinearConfig,
    actions: usize,
    items: usize,
    /// By action, then what votes.
    weights: Vec<Vec<f64>>,
    marks: Vec<Vec<f64>>,
    rng: Rng,
    acting: bool,
    /// Percepts and actions of the last choices, the latest first.
    before: [Option<(u128, usize)>; MOST_STEPS],
    chosen: (Vec<usize>, usize),
    /// What voted, the action and the reward that wait for what comes next.
    waiting: Option<(Vec<usize>, usize, f64)>,
    patience: Patience,
}

/// Marks below this are forgotten.
const FAINT: f64 = 1e-3;

impl Linear {
    /// A learner that knows nothing, for a world with these items and actions.
    #[must_use]
    pub fn new<W: World>(config: LinearConfig, world: &W, seed: u64) -> Self {
        let (items, actions) = (world.items().len(), world.actions().len().max(1));
        let items = items.min(32 * WORLD_WORDS);
        // A constant, the items of all moments, and the actions of those before.
        let past = config.history.steps();
        let votes = 1 + (1 + past) * items + past * actions;
        Self {
            config,
            actions,
            items,
            weights: vec![vec![0.0; votes]; actions],
            marks: vec![vec![0.0; votes]; actions],
            rng: Rng::stream(seed, 6),
            acting: false,
            before: [None; MOST_STEPS],
            chosen: (Vec::new(), 0),
            waiting: None,
            patience: Patience::NEW,
        }
    }

    fn voters(&self, now: u128) -> Vec<usize> {
        let past = self.config.history.steps();
        let mut voters = vec![0];
        let mut vote = |first: usize, on: u128| {
            let items = (0..self.items).filter(|it| on >> it & 1 == 1);
            voters.extend(items.map(|it| first + it));
        };
        vote(1, now);
        for (at, moment) in self.before.iter().take(past).enumerate() {
            if let Some((on, _)) = moment {
                vote(1 + (at + 1) * self.items, *on);
            }
        }
        for (at, moment) in self.before.iter().take(past).enumerate() {
            let first = 1 + (1 + past) * self.items + at * self.actions;
            voters.extend(moment.map(|(_, action)| first + action));
        }
        voters
    }

    fn worth(&self, voters: &[usize], action: usize) -> f64 {
        let weights = &self.weights[action];
        voters.iter().fold(0.0, |sum, &it| sum + weights[it])
    }

    fn pick(&mut self, voters: &[usize]) -> usize {
        if self.acting && self.patience.ends(self.config.escape) {
            return self.rng.below(self.actions as u32) as usize;
        }
        let share = if self.acting {
            self.config.explore_acting
        } else {
            self.config.explore
        };
        if self.rng.chance(share as f32) {
            return self.rng.below(self.actions as u32) as usize;
        }
        let worths: Vec<f64> = (0..self.actions).map(|it| self.worth(voters, it)).collect();
        let best = worths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let equals: Vec<usize> = (0..self.actions).filter(|&it| worths[it] == best).collect();
        let which = self.rng.below(equals.len() as u32) as usize;
        equals.get(which).map_or(0, |&it| it)
    }

    fn improve(&mut self, (voters, action, reward): (Vec<usize>, usize, f64), future: f64) {
        let LinearConfig {
            alpha,
            discount,
            lambda,
            ..
        } = self.config;
        let error = reward + discount * future - self.worth(&voters, action);
        let step = alpha * error / voters.len() as f64;
        for (other, marks) in self.marks.iter_mut().enumerate() {
            for &it in &voters {
                marks[it] = f64::from(u8::from(other == action));
            }
        }
        for (weights, marks) in self.weights.iter_mut().zip(&mut self.marks) {
            for (weight, mark) in weights.iter_mut().zip(marks) {
                if *mark > FAINT {
                    *weight += step * *mark;
                    *mark *= discount * lambda;
                }
            }
        }
    }
}

impl Learner for Linear {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        let seen = bits(now);
        let voters = self.voters(seen);
        let action = self.pick(&voters);
        if let Some(waiting) = self.waiting.take() {
            let future = self.worth(&voters, action);
            self.improve(waiting, future);
        }
        self.before.rotate_right(1);
        self.before[0] = Some((seen, action));
        self.chosen = (voters, action);
        Ok(action)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.learn_with(now, captured(now) as f32)
    }

    fn learn_with(&mut self, _: &Percept, reward: f32) -> Result<(), Failure> {
        let (voters, action) = core::mem::take(&mut self.chosen);
        self.waiting = Some((voters, action, f64::from(reward)));
        self.patience.feel(reward > 0.0);
        Ok(())
    }

    fn interrupt(&mut self) -> Result<(), Failure> {
        if let Some(waiting) = self.waiting.take() {
            self.improve(waiting, 0.0);
        }
        for marks in &mut self.marks {
            marks.fill(0.0);
        }
        self.before = [None; MOST_STEPS];
        Ok(())
    }

    fn observe(&mut self, _: &Percept, _: usize, _: &Percept) -> Result<(), Failure> {
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.acting = true;
        self.patience.begin();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Linear, LinearConfig};
    use crate::baseline::tabular::{History, Tabular, TabularConfig};
    use crate::learner::Learner;
    use crate::learner::rewarded::rewarded;
    use crate::world::World;
    use crate::world::distracted::Distracted;
    use crate::world::lake::Lake;

    fn share(learner: &mut dyn Learner, distractors: usize) -> f64 {
        let mut world = Distracted::new(Lake::new(1), distractors, 1);
        rewarded(learner, &mut world, 40_000).unwrap();
        learner.act().unwrap();
        rewarded(learner, &mut world, 10_000).unwrap().per_episode()
    }

    #[test]
    fn where_one_item_is_on_it_learns_what_a_table_learns() {
        let config = LinearConfig {
            alpha: 0.2,
            discount: 0.98,
            ..LinearConfig::DEFAULT
        };
        let linear = share(&mut Linear::new(config, &Lake::new(1), 1), 0);
        assert!(linear > 0.4, "{linear}");
    }

    #[test]
    fn items_that_blink_end_a_table_and_not_votes() {
        let world = Distracted::new(Lake::new(1), 20, 1);
        let config = LinearConfig {
            alpha: 0.05,
            discount: 0.98,
            ..LinearConfig::DEFAULT
        };
        let linear = share(&mut Linear::new(config, &world, 1), 20);
        let mut table = Tabular::with_actions(TabularConfig::Q, world.actions(), 1);
        let table = share(&mut table, 20);
        assert!(linear > 4.0 * table && linear > 0.1, "{linear} {table}");
    }

    #[test]
    fn with_history_what_was_before_has_votes_of_its_own() {
        grows(History::TwoSteps, [2, 4, 6, 6, 6, 6]);
        grows(History::FourSteps, [2, 4, 6, 8, 10, 10]);
    }

    fn grows(history: History, voters: [usize; 6]) {
        let config = LinearConfig {
            history,
            ..LinearConfig::DEFAULT
        };
        let mut learner = Linear::new(config, &Lake::new(1), 1);
        let mut world = Lake::new(1);
        for expected in voters {
            let action = learner.choose(&world.sense()).unwrap();
            assert_eq!(learner.chosen.0.len(), expected);
            world.act(action);
            learner.learn_with(&world.sense(), 0.0).unwrap();
            world.begin_episode();
        }
        learner.interrupt().unwrap();
        learner.choose(&world.sense()).unwrap();
        assert_eq!(learner.chosen.0.len(), 2);
    }
}
