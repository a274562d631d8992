//! What a `.POMDP` file says: names, chances, rewards.

use cla_core::num::Rng;

use crate::world::names::Names;
use crate::world::solve::Mdp;

/// Chrisman's shuttle, whose best policy earns 1.842 in a step.
pub const SHUTTLE: &str = include_str!("../../../data/pomdp/shuttle_95.POMDP");

/// What some steps earn; `None` is any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reward {
    pub(super) action: Option<usize>,
    pub(super) from: Option<usize>,
    pub(super) to: Option<usize>,
    pub(super) seen: Option<usize>,
    pub(super) value: f64,
}

/// What a file says.
///
/// ```
/// use host_sim::world::pomdp::{Pomdp, SHUTTLE};
/// let shuttle = Pomdp::parse(SHUTTLE)?;
/// assert_eq!(shuttle.actions(), ["TurnAround", "GoForward", "Backup"]);
/// assert_eq!(shuttle.chance(2, 3, 0), 0.7);
/// assert_eq!(shuttle.reward(2, 3, 0, 4), 10.0);
/// # Ok::<(), host_sim::world::pomdp::PomdpError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pomdp {
    pub(super) states: Names,
    pub(super) actions: Names,
    pub(super) observations: Names,
    pub(super) discount: f64,
    pub(super) start: Vec<f64>,
    /// By action, state, next state.
    pub(super) transitions: Vec<f64>,
    /// By action, state that it led to, observation.
    pub(super) observes: Vec<f64>,
    /// The last that fits holds.
    pub(super) rewards: Vec<Reward>,
}

impl Pomdp {
    /// Names of the states.
    #[must_use]
    pub const fn states(&self) -> Names {
        self.states
    }

    /// Names of the actions.
    #[must_use]
    pub const fn actions(&self) -> Names {
        self.actions
    }

    /// Names of the observations.
    #[must_use]
    pub const fn observations(&self) -> Names {
        self.observations
    }

    /// The file's discount, 1 when it has none.
    #[must_use]
    pub const fn discount(&self) -> f64 {
        self.discount
    }

    /// The chances of the states to start in.
    #[must_use]
    pub fn start(&self) -> &[f64] {
        &self.start
    }

    /// The chances of the next states.
    #[must_use]
    pub fn next(&self, action: usize, state: usize) -> &[f64] {
        let count = self.states.len();
        let from = (action * count + state) * count;
        &self.transitions[from..from + count]
    }

    /// The chance of one next state.
    #[must_use]
    pub fn chance(&self, action: usize, state: usize, next: usize) -> f64 {
        self.next(action, state)[next]
    }

    /// The chances of the observations in the state that an action has led to.
    #[must_use]
    pub fn observed(&self, action: usize, next: usize) -> &[f64] {
        let (count, width) = (self.states.len(), self.observations.len());
        let from = (action * count + next) * width;
        &self.observes[from..from + width]
    }

    /// What a step earns.
    #[must_use]
    pub fn reward(&self, action: usize, state: usize, next: usize, seen: usize) -> f64 {
        let fits = |which: Option<usize>, it| which.is_none_or(|which| which == it);
        let step = |it: &&Reward| {
            let ends = fits(it.action, action) && fits(it.from, state);
            ends && fits(it.to, next) && fits(it.seen, seen)
        };
        let last = self.rewards.iter().rev().find(step);
        last.map_or(0.0, |it| it.value)
    }

    /// What an action earns in a state on average.
    #[must_use]
    pub fn expected(&self, action: usize, state: usize) -> f64 {
        let mut sum = 0.0;
        for (next, &chance) in self.next(action, state).iter().enumerate() {
            if chance > 0.0 {
                for (seen, &sight) in self.observed(action, next).iter().enumerate() {
                    if sight > 0.0 {
                        sum += chance * sight * self.reward(action, state, next, seen);
                    }
                }
            }
        }
        sum
    }

    /// The world as it is for who always knows the state: a bound on what can be earned.
    #[must_use]
    pub fn model(&self) -> Mdp {
        Mdp::new(self.states.len(), self.actions.len(), |state, action| {
            let next = self.next(action, state).iter().copied().enumerate();
            let outcomes = next.filter(|it| it.1 > 0.0).collect();
            (outcomes, self.expected(action, state))
        })
    }
}

/// Draws an index by these chances, which sum up to 1.
pub(super) fn draw(chances: &[f64], rng: &mut Rng) -> usize {
    let mut left = f64::from(rng.unit());
    for (index, &chance) in chances.iter().enumerate() {
        if left < chance {
            return index;
        }
        left -= chance;
    }
    // What is left of rounding goes to the last that can be.
    chances.iter().rposition(|&it| it > 0.0).unwrap_or(0)
}
