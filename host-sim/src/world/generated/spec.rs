//! What a generated world is made of: variables, what actions do to them, a goal, and what items show.

use cla_core::num::Rng;

use crate::world::names::{Names, kept};
use crate::world::shuffle;
use crate::world::solve::Mdp;

/// Fewest and most items of a world.
pub const ITEMS: (usize, usize) = (6, 64);

/// Fewest and most actions of a world.
pub const ACTIONS: (usize, usize) = (3, 12);

/// Most states: combinations of the values of all variables.
const MOST_STATES: usize = 240;

/// Least number of actions from one reward to the next, on average, for who knows everything.
const NOT_TOO_NEAR: f64 = 4.0;

/// What an action does to its variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The next value; the first after the last.
    Up,
    /// The value before; the last before the first.
    Down,
    /// This value.
    Set(usize),
    /// Nothing, ever.
    Nothing,
}

/// An action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effect {
    /// The variable that it changes.
    pub variable: usize,
    /// How.
    pub change: Change,
    /// Another variable and the value that this must have, or nothing happens.
    pub needs: Option<(usize, usize)>,
}

/// What an item shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shown {
    /// A reward has just come.
    Reward,
    /// The variable has one of the values whose bits are set; two values that share an item cannot
    /// be told apart.
    Value {
        /// Which variable.
        variable: usize,
        /// Its values, a bit each.
        values: u32,
    },
    /// Nothing: it is on in this share of the percepts.
    Blinks(f32),
    /// Nothing: it changes in this share of the steps.
    Drifts(f32),
}

/// A world as its seed has made it.
///
/// ```
/// use host_sim::world::generated::Spec;
/// let spec = Spec::random(1);
/// assert!((6..=64).contains(&spec.items().len()) && (3..=12).contains(&spec.actions().len()));
/// assert_eq!(spec.items()[0], "reward");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// Values of each variable.
    pub sizes: Vec<usize>,
    /// What each action does.
    pub effects: Vec<Effect>,
    /// The value that each variable has when the goal is reached; `None` is any.
    pub goal: Vec<Option<usize>>,
    /// What each item shows.
    pub shown: Vec<Shown>,
    /// The share of actions that do nothing.
    pub slip: f32,
    /// The share of readings of values in which an item errs.
    pub noise: f32,
    /// Actions between reaching the goal and the reward; 0 is at once.
    pub delay: usize,
}

fn one_of<T: Copy>(rng: &mut Rng, of: &[T]) -> T {
    of[rng.below(of.len() as u32) as usize]
}

impl Spec {
    /// The world of a seed: one in which the goal can be reached from everywhere, though not at once.
    #[must_use]
    pub fn random(seed: u64) -> Self {
        let mut rng = Rng::stream(seed, 67);
        loop {
            let spec = Self::drawn(&mut rng);
            if let Some(spec) = spec.filter(Self::is_worth_living_in) {
                return spec;
            }
        }
    }

    fn drawn(rng: &mut Rng) -> Option<Self> {
        let span = |rng: &mut Rng, (least, most): (usize, usize)| {
            least + rng.below((most - least + 1) as u32) as usize
        };
        let (items, actions) = (span(rng, ITEMS), span(rng, ACTIONS));
        let variables = span(rng, (2, actions.min(4)));
        let sizes: Vec<usize> = (0..variables).map(|_| span(rng, (2, 6))).collect();
        let merged = one_of(rng, &[0.0, 0.1, 0.2]);
        let mut shown = values_shown(rng, &sizes, merged);
        let states = sizes.iter().product::<usize>();
        if shown.len() + 1 > items || states > MOST_STATES {
            return None;
        }
        let signals = shown.len();
        while shown.len() + 1 < items {
            shown.push(match rng.below(5) {
                0 => shown[rng.below(signals as u32) as usize],
                1 | 2 => Shown::Drifts(0.05),
                _ => Shown::Blinks(one_of(rng, &[0.1, 0.3, 0.5])),
            });
        }
        shuffle(&mut shown, rng);
        shown.insert(0, Shown::Reward);
        let mut goal: Vec<Option<usize>> = (0..variables)
            .map(|it| {
                rng.chance(0.6)
                    .then(|| rng.below(sizes[it] as u32) as usize)
            })
            .collect();
        if goal.iter().all(Option::is_none) {
            goal[0] = Some(0);
        }
        Some(Self {
            effects: effects(rng, &sizes, actions),
            sizes,
            goal,
            shown,
            slip: one_of(rng, &[0.0, 0.05, 0.1, 0.2]),
            noise: one_of(rng, &[0.0, 0.01, 0.02, 0.05]),
            delay: one_of(rng, &[0, 0, 1, 2, 3]),
        })
    }

    /// Whether the goal can be reached from every state, and takes some steps.
    fn is_worth_living_in(&self) -> bool {
        let states = self.states();
        let mut reaches: Vec<bool> = (0..states).map(|it| self.is_goal(it)).collect();
        if reaches.iter().all(|&it| it) {
            return false;
        }
        loop {
            let found: Vec<usize> = (0..states)
                .filter(|&it| {
                    let mut effects = self.effects.iter();
                    !reaches[it] && effects.any(|effect| reaches[self.after(it, effect)])
                })
                .collect();
            if found.is_empty() {
                break;
            }
            for it in found {
                reaches[it] = true;
            }
        }
        let far = || 1.0 / self.model().rate(1e-4).gain >= NOT_TOO_NEAR;
        reaches.iter().all(|&it| it) && far()
    }

    /// Names of the items: `reward`, and then what says nothing about what they show.
    #[must_use]
    pub fn items(&self) -> Names {
        let name = |it: usize| match it {
            0 => "reward".to_owned(),
            it => format!("i{it}"),
        };
        kept(&(0..self.shown.len()).map(name).collect::<Vec<_>>())
    }

    /// Names of the actions.
    #[must_use]
    pub fn actions(&self) -> Names {
        let names = (0..self.effects.len()).map(|it| format!("a{it}"));
        kept(&names.collect::<Vec<_>>())
    }

    /// States: all combinations of values.
    #[must_use]
    pub fn states(&self) -> usize {
        self.sizes.iter().product()
    }

    /// The value of a variable in a state.
    #[must_use]
    pub fn value(&self, state: usize, variable: usize) -> usize {
        let below = self.sizes[..variable].iter().product::<usize>();
        state / below % self.sizes[variable]
    }

    /// The state that differs from this one in the value of a variable.
    #[must_use]
    pub fn with(&self, state: usize, variable: usize, value: usize) -> usize {
        let below = self.sizes[..variable].iter().product::<usize>();
        state - self.value(state, variable) * below + value * below
    }

    /// Whether the goal is reached in a state.
    #[must_use]
    pub fn is_goal(&self, state: usize) -> bool {
        let mut goals = self.goal.iter().enumerate();
        goals.all(|(it, goal)| goal.is_none_or(|goal| self.value(state, it) == goal))
    }

    /// The state after an action that does not slip.
    #[must_use]
    pub fn after(&self, state: usize, effect: &Effect) -> usize {
        let Effect {
            variable, needs, ..
        } = *effect;
        if needs.is_some_and(|(other, value)| self.value(state, other) != value) {
            return state;
        }
        let (value, size) = (self.value(state, variable), self.sizes[variable]);
        let value = match effect.change {
            Change::Up => (value + 1) % size,
            Change::Down => (value + size - 1) % size,
            Change::Set(value) => value,
            Change::Nothing => value,
        };
        self.with(state, variable, value)
    }

    /// The truth: whoever reaches the goal earns 1 and begins again in any other state.
    #[must_use]
    pub fn model(&self) -> Mdp {
        let begins: Vec<usize> = (0..self.states()).filter(|&it| !self.is_goal(it)).collect();
        Mdp::new(self.states(), self.effects.len(), |state, action| {
            if self.is_goal(state) {
                let chance = 1.0 / begins.len() as f64;
                return (begins.iter().map(|&it| (it, chance)).collect(), 0.0);
            }
            let next = self.after(state, &self.effects[action]);
            let slip = f64::from(self.slip);
            let reward = if self.is_goal(next) { 1.0 - slip } else { 0.0 };
            (vec![(next, 1.0 - slip), (state, slip)], reward)
        })
    }
}

/// An item for every value, one alone for two values; some values share theirs with the next.
fn values_shown(rng: &mut Rng, sizes: &[usize], merged: f32) -> Vec<Shown> {
    let mut shown = Vec::new();
    for (variable, &size) in sizes.iter().enumerate() {
        let first = usize::from(size == 2);
        let mut value = first;
        while value < size {
            let mut values = 1 << value;
            if value + 1 < size && rng.chance(merged) {
                value += 1;
                values |= 1 << value;
            }
            shown.push(Shown::Value { variable, values });
            value += 1;
        }
    }
    shown
}

/// An action for each variable that turns it round, and others that do anything.
fn effects(rng: &mut Rng, sizes: &[usize], actions: usize) -> Vec<Effect> {
    let mut effects: Vec<Effect> = (0..actions)
        .map(|action| {
            let free = action >= sizes.len();
            let variable = if free {
                rng.below(sizes.len() as u32) as usize
            } else {
                action
            };
            let set = Change::Set(rng.below(sizes[variable] as u32) as usize);
            let change = match rng.below(5) {
                _ if !free => Change::Up,
                0 => Change::Up,
                1 | 2 => Change::Down,
                3 => set,
                _ => Change::Nothing,
            };
            let other = rng.below(sizes.len() as u32) as usize;
            let value = rng.below(sizes[other] as u32) as usize;
            let needs = (other != variable && rng.chance(0.5)).then_some((other, value));
            Effect {
                variable,
                change,
                needs,
            }
        })
        .collect();
    shuffle(&mut effects, rng);
    effects
}
