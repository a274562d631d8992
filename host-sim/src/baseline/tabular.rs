//! Tabular reinforcement learning: Q-learning and Sarsa(λ), on percepts or on a few steps of history.
//!
//! The same items, reflexes and actions as the brain has; the reward is what the world gives as a
//! number, and where it gives none, 1 when the Pioneer's `ingrip` is on after an action.
//! A state is the set of items that are on; with history also the sets and the actions before.
//!
//! The constants are the best of an earlier grid for the Pioneer (seeds 0–3, 10,000 actions of training)
//! and the first of the configurations among which the recovery experiment has its rivals
//! (`experiment/recover/rivals.rs`).
//! Sources: Watkins (1989); Rummery and Niranjan (1994); Singh and Sutton (1996) for the traces.

use std::collections::BTreeMap;
use std::num::NonZeroU32;

use cla_core::agent::Escape;
use cla_core::num::Rng;
use cla_core::word::ItemId;
use serde::{Deserialize, Serialize};

use super::patience::Patience;
use crate::failure::Failure;
use crate::learner::{Learner, Thought};
use crate::world::Percept;
use crate::world::pioneer::{ACTIONS, INGRIP};

/// By what a state and action are judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// The best action of the next state, whatever is done there (Watkins).
    QLearning,
    /// The action that is really done next, along eligibility traces.
    Sarsa(Traces),
}

/// How a visit marks a state and action for later rewards.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Traces {
    /// It is marked with 1; the other actions of the state lose their marks.
    Replacing,
    /// 1 is added.
    Accumulating,
}

/// What a state is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum History {
    /// The present percept.
    None,
    /// The present percept, the one before it and the action between them.
    OneStep,
    /// The present percept, the two before it and the actions between them.
    TwoSteps,
    /// The present percept, the four before it and the actions between them.
    FourSteps,
}

/// Moments before the present, at most.
pub(super) const MOST_STEPS: usize = 4;

impl History {
    /// How many moments before the present belong to a state.
    #[must_use]
    pub const fn steps(self) -> usize {
        match self {
            Self::None => 0,
            Self::OneStep => 1,
            Self::TwoSteps => 2,
            Self::FourSteps => MOST_STEPS,
        }
    }
}

/// The parameters of a tabular learner.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TabularConfig {
    /// By what a state and action are judged.
    pub method: Method,
    /// What a state is.
    pub history: History,
    /// Step size, in `(0, 1]`.
    pub alpha: f64,
    /// Discount of the future, in `[0, 1)`.
    pub discount: f64,
    /// Decay λ of the traces, in `[0, 1]`; Q-learning has none.
    pub lambda: f64,
    /// Share of random actions in training.
    pub explore: f64,
    /// Share of random actions afterwards.
    pub explore_acting: f64,
    /// What an untried action is held to be worth.
    pub optimism: f64,
    /// Random actions after a long time without reward, as the brain has them.
    pub escape: Option<Escape>,
}

impl TabularConfig {
    /// The best Sarsa(λ) of the earlier grid.
    pub const SARSA: Self = Self {
        method: Method::Sarsa(Traces::Replacing),
        history: History::None,
        alpha: 0.03,
        discount: 0.9,
        lambda: 0.8,
        explore: 0.1,
        explore_acting: 0.02,
        optimism: 0.5,
        escape: Some(ESCAPE),
    };

    /// The best Sarsa(λ) with one step of history of the grid.
    pub const SARSA_HISTORY: Self = Self {
        history: History::OneStep,
        alpha: 0.1,
        ..Self::SARSA
    };

    /// The best Q-learner with one step of history of the grid.
    pub const Q_HISTORY: Self = Self {
        history: History::OneStep,
        alpha: 0.1,
        explore: 0.3,
        escape: None,
        ..Self::Q
    };

    /// The best Q-learner of the grid.
    pub const Q: Self = Self {
        method: Method::QLearning,
        history: History::None,
        alpha: 0.03,
        discount: 0.9,
        lambda: 0.0,
        explore: 0.1,
        explore_acting: 0.02,
        optimism: 0.5,
        escape: Some(ESCAPE),
    };
}

/// The brain's own way out of loops.
const ESCAPE: Escape = Escape {
    after: 100,
    burst: 10,
};

/// A percept, its items that are on as bits, and what was done in it, counted from 1.
type Moment = (u128, NonZeroU32);

/// The moment of an action.
fn moment(seen: u128, action: usize) -> Option<Moment> {
    Some((seen, NonZeroU32::MIN.saturating_add(action as u32)))
}

/// By what a row of the table is found: the present percept and, with history, the moments before,
/// the latest first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct State {
    now: u128,
    past: [Option<Moment>; MOST_STEPS],
}

/// A table of action values.
///
/// ```
/// use host_sim::baseline::tabular::{Tabular, TabularConfig};
/// use host_sim::learner::rewarded::rewarded;
/// use host_sim::world::{World, lake::Lake};
/// let mut world = Lake::new(1);
/// let mut learner = Tabular::with_actions(TabularConfig::Q, world.actions(), 1);
/// let income = rewarded(&mut learner, &mut world, 500)?;
/// assert!(income.episodes > 5 && learner.states() > 5);
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
#[derive(Clone)]
pub struct Tabular {
    config: TabularConfig,
    actions: &'static [&'static str],
    untried: Vec<f64>,
    rows: BTreeMap<State, Vec<f64>>,
    traces: Vec<(State, usize, f64)>,
    rng: Rng,
    acting: bool,
    /// Percepts and actions of the last choices, the latest first.
    before: [Option<Moment>; MOST_STEPS],
    /// State, action and reward that wait for what comes next.
    waiting: Option<(State, usize, f64)>,
    chosen: (State, usize),
    patience: Patience,
}

/// Marks below this are forgotten.
const FAINT: f64 = 1e-3;

impl Tabular {
    /// A learner that knows nothing, with the Pioneer's actions.
    #[must_use]
    pub fn new(config: TabularConfig, seed: u64) -> Self {
        Self::with_actions(config, &ACTIONS, seed)
    }

    /// A learner that knows nothing, with these actions, of which there is at least one.
    #[must_use]
    pub fn with_actions(
        config: TabularConfig,
        actions: &'static [&'static str],
        seed: u64,
    ) -> Self {
        Self {
            config,
            actions,
            untried: vec![config.optimism; actions.len().max(1)],
            rows: BTreeMap::new(),
            traces: Vec::new(),
            rng: Rng::stream(seed, 5),
            acting: false,
            before: [None; MOST_STEPS],
            waiting: None,
            chosen: (State::default(), 0),
            patience: Patience::NEW,
        }
    }

    /// The number of states met.
    #[must_use]
    pub fn states(&self) -> usize {
        self.rows.len()
    }

    fn row(&self, state: &State) -> &[f64] {
        self.rows.get(state).unwrap_or(&self.untried)
    }

    fn greedy(&mut self, state: &State) -> usize {
        let best = greatest(self.row(state));
        let equals = self.row(state).iter().filter(|&&value| value == best);
        let equals = equals.count() as u32;
        let which = self.rng.below(equals.max(1)) as usize;
        let row = self.row(state);
        let mut best_ones = (0..row.len()).filter(|&action| row[action] == best);
        best_ones.nth(which).unwrap_or(0)
    }

    fn pick(&mut self, state: &State) -> usize {
        let actions = self.untried.len() as u32;
        if self.acting && self.patience.ends(self.config.escape) {
            return self.rng.below(actions) as usize;
        }
        let share = if self.acting {
            self.config.explore_acting
        } else {
            self.config.explore
        };
        if self.rng.chance(share as f32) {
            self.rng.below(actions) as usize
        } else {
            self.greedy(state)
        }
    }

    /// Moves the values of what was done towards `reward` and what the future promises.
    fn improve(&mut self, (state, action, reward): (State, usize, f64), future: f64) {
        let TabularConfig {
            alpha,
            discount,
            lambda,
            ..
        } = self.config;
        let error = reward + discount * future - self.row(&state)[action];
        let untried = &self.untried;
        let Method::Sarsa(traces) = self.config.method else {
            let row = self.rows.entry(state).or_insert_with(|| untried.clone());
            row[action] += alpha * error;
            return;
        };
        let here = (state, action);
        match traces {
            Traces::Replacing => {
                self.traces.retain(|&(other, ..)| other != state);
                self.traces.push((state, action, 1.0));
            }
            Traces::Accumulating => match self.traces.iter_mut().find(|t| (t.0, t.1) == here) {
                Some(mark) => mark.2 += 1.0,
                None => self.traces.push((state, action, 1.0)),
            },
        }
        for (state, action, mark) in &mut self.traces {
            let row = self.rows.entry(*state).or_insert_with(|| untried.clone());
            row[*action] += alpha * error * *mark;
            *mark *= discount * lambda;
        }
        self.traces.retain(|&(_, _, mark)| mark > FAINT);
    }
}

/// The items that are on as the bits of a number.
pub(super) fn bits(percept: &Percept) -> u128 {
    let words = percept.on().words().iter().rev();
    words.fold(0, |bits, &word| bits << 32 | u128::from(word))
}

/// The reward of a world that gives none as a number: 1 when the Pioneer holds something.
pub(super) fn captured(now: &Percept) -> f64 {
    f64::from(u8::from(now.get(ItemId(INGRIP)) == Some(true)))
}

fn greatest(row: &[f64]) -> f64 {
    row.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

impl Tabular {
    fn feel(&mut self, reward: f64) {
        self.waiting = Some((self.chosen.0, self.chosen.1, reward));
        self.patience.feel(reward > 0.0);
    }
}

impl Learner for Tabular {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        let seen = bits(now);
        let mut past = self.before;
        past[self.config.history.steps()..].fill(None);
        let state = State { now: seen, past };
        let action = self.pick(&state);
        if let Some(waiting) = self.waiting.take() {
            let row = self.row(&state);
            let future = match self.config.method {
                Method::QLearning => greatest(row),
                Method::Sarsa(_) => row[action],
            };
            self.improve(waiting, future);
        }
        self.before.rotate_right(1);
        self.before[0] = moment(seen, action);
        self.chosen = (state, action);
        Ok(action)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.feel(captured(now));
        Ok(())
    }

    fn learn_with(&mut self, _: &Percept, reward: f32) -> Result<(), Failure> {
        self.feel(f64::from(reward));
        Ok(())
    }

    /// Nothing comes after the end of an episode.
    fn interrupt(&mut self) -> Result<(), Failure> {
        if let Some(waiting) = self.waiting.take() {
            self.improve(waiting, 0.0);
        }
        self.traces.clear();
        self.before = [None; MOST_STEPS];
        Ok(())
    }

    /// What follows an action is what is there after its reflexes: they teach nothing of their own.
    fn observe(&mut self, _: &Percept, _: usize, _: &Percept) -> Result<(), Failure> {
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.acting = true;
        self.patience.begin();
        Ok(())
    }

    fn reason(&self) -> Thought {
        let (state, action) = self.chosen;
        Thought {
            schema: format!("{} of state {}", self.actions[action], state.now),
            action,
            value: self.row(&state)[action] as f32,
            alarmed: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{History, Method, Tabular, TabularConfig, Traces};
    use crate::learner::{Learner, live};
    use crate::world::pioneer::{ACTIONS, BACKWARD, FORWARD, GRIP, INGRIP, ITEMS};
    use crate::world::{Percept, World};
    use cla_core::word::ItemId;

    /// Five places in a row; forward from the last but one brings the reward, backward leads back.
    struct Corridor {
        place: u16,
        obtained: u32,
        /// Whether the two places before the reward look alike.
        alike: bool,
        ends: u32,
    }

    impl World for Corridor {
        fn items(&self) -> &'static [&'static str] {
            &ITEMS
        }

        fn actions(&self) -> &'static [&'static str] {
            &ACTIONS
        }

        fn sense(&self) -> Percept {
            let mut percept = Percept::all_off(7);
            let look = if self.alike && self.place == 3 {
                2
            } else {
                self.place
            };
            let item = if self.place == 4 { INGRIP } else { look };
            percept.set(ItemId(item), Some(true)).unwrap();
            percept
        }

        fn act(&mut self, action: usize) {
            match action {
                FORWARD => self.place += 1,
                BACKWARD => self.place = self.place.saturating_sub(1),
                // Anything else is a step too far.
                _ => self.place = 0,
            }
        }

        fn reflex(&mut self) -> Option<usize> {
            let there = self.place == 4;
            there.then(|| {
                self.obtained += 1;
                self.place = 0;
                GRIP
            })
        }

        fn obtained(&self) -> u32 {
            self.obtained
        }

        fn finished(&self) -> bool {
            self.obtained >= self.ends
        }
    }

    const fn corridor(alike: bool) -> Corridor {
        Corridor {
            place: 0,
            obtained: 0,
            alike,
            ends: u32::MAX,
        }
    }

    const METHODS: [Method; 3] = [
        Method::QLearning,
        Method::Sarsa(Traces::Replacing),
        Method::Sarsa(Traces::Accumulating),
    ];

    fn learner(method: Method, history: History) -> Tabular {
        let config = TabularConfig {
            method,
            history,
            explore_acting: 0.0,
            ..TabularConfig::SARSA
        };
        Tabular::new(config, 3)
    }

    #[test]
    fn every_method_learns_the_way_through_a_corridor() {
        for method in METHODS {
            for history in [History::None, History::OneStep] {
                let mut learner = learner(method, history);
                live(&mut learner, &mut corridor(false), 10_000).unwrap();
                learner.act().unwrap();
                let lived = live(&mut learner, &mut corridor(false), 400).unwrap();
                let captures = lived.total();
                assert!(
                    (95..=100).contains(&captures),
                    "{method:?} {history:?} {captures}"
                );
            }
        }
    }

    #[test]
    fn traces_carry_a_reward_back_further_than_one_step_learning_does() {
        let valued = |method| {
            let mut config = TabularConfig::SARSA;
            (config.method, config.optimism) = (method, 0.0);
            let mut learner = Tabular::new(config, 3);
            let mut world = corridor(false);
            world.ends = 1;
            live(&mut learner, &mut world, 100_000).unwrap();
            // The reward is judged when the next choice is made.
            learner.choose(&world.sense()).unwrap();
            let values = learner.rows.values().flatten();
            values.filter(|&&value| value > 0.0).count()
        };
        assert_eq!(valued(Method::QLearning), 1);
        assert!(valued(Method::Sarsa(Traces::Replacing)) > 2);
    }

    #[test]
    fn one_step_of_history_tells_apart_what_looks_alike() {
        let states = |history| {
            let mut learner = learner(Method::QLearning, history);
            live(&mut learner, &mut corridor(true), 5_000).unwrap();
            learner.states()
        };
        assert!(states(History::None) <= 4 && states(History::OneStep) > 10);
    }

    #[test]
    fn a_state_reaches_as_far_back_as_its_history_says() {
        for (history, steps) in [
            (History::None, 0),
            (History::OneStep, 1),
            (History::TwoSteps, 2),
            (History::FourSteps, 4),
        ] {
            let mut learner = learner(Method::QLearning, history);
            for _ in 0..7 {
                learner.choose(&Percept::all_off(7)).unwrap();
                learner.learn(&Percept::all_off(7)).unwrap();
            }
            let past = learner.chosen.0.past;
            assert_eq!(past.iter().flatten().count(), steps, "{history:?}");
            assert!(past[..steps].iter().all(Option::is_some));
        }
    }

    #[test]
    fn a_world_that_ends_early_ends_the_life_and_what_was_learned_stays() {
        let mut learner = learner(Method::QLearning, History::None);
        let mut world = corridor(false);
        world.ends = 3;
        let lived = live(&mut learner, &mut world, 100_000).unwrap();
        assert_eq!(lived.total(), 3);
        assert!(lived.obtained.len() < 4000 && learner.states() == 4);
    }

    #[test]
    fn what_is_unknown_is_not_on() {
        let mut learner = learner(Method::QLearning, History::None);
        for state in [Percept::UNKNOWN, Percept::all_off(7)] {
            learner.choose(&state).unwrap();
            learner.learn(&state).unwrap();
        }
        learner.choose(&Percept::UNKNOWN).unwrap();
        assert_eq!(learner.states(), 1);
    }
}
