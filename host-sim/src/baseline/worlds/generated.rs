//! The rivals of generated worlds.
//!
//! The one written by hand is the engineer who made the world: who knows what every item shows and
//! every action does, reads the values off the percept, and where an item errs or two values share
//! one, takes the value that the last action should have led to.

use std::sync::Arc;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Tuned, linear, q, sarsa};
use crate::baseline::tabular::History;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::generated::{Shown, Spec};

/// The learners that did best here.
pub const TUNED: Tuned = Tuned {
    q: q(History::None, 0.6, 0.8, 0.5),
    q_history: q(History::TwoSteps, 0.03, 0.9, 0.5),
    sarsa: sarsa(History::None, 0.3, 0.8, 0.9, 0.5),
    sarsa_history: sarsa(History::TwoSteps, 0.3, 0.98, 0.5, 0.5),
    linear: linear(History::None, 0.3, 0.9, 0.9),
    linear_history: linear(History::TwoSteps, 0.3, 0.9, 0.5),
};

/// Reads the percept by what is known of the world.
///
/// ```
/// use std::sync::Arc;
/// use host_sim::baseline::worlds::generated::Engineer;
/// use host_sim::world::generated::Spec;
/// assert!(Engineer::new(Arc::new(Spec::random(1))).optimum() > 0.0);
/// ```
#[derive(Clone, Debug)]
pub struct Engineer {
    spec: Arc<Spec>,
    policy: Arc<[usize]>,
    optimum: f64,
    /// The state that is expected now.
    expected: Option<usize>,
}

impl Engineer {
    /// One who has just begun.
    #[must_use]
    pub fn new(spec: Arc<Spec>) -> Self {
        let rate = spec.model().rate(1e-6);
        Self {
            spec,
            policy: rate.policy.into(),
            optimum: rate.gain,
            expected: None,
        }
    }

    /// What the best policy earns in an action when the state is known.
    #[must_use]
    pub const fn optimum(&self) -> f64 {
        self.optimum
    }

    /// How many of the items that show values a state disagrees with.
    fn disagrees(&self, state: usize, percept: &Percept) -> usize {
        let wrong = |(index, shown): (usize, &Shown)| match *shown {
            Shown::Value { variable, values } => {
                let has = values >> self.spec.value(state, variable) & 1 == 1;
                percept.get(ItemId(index as u16)) == Some(!has)
            }
            _ => false,
        };
        let items = self.spec.shown.iter().enumerate();
        items.filter(|&it| wrong(it)).count()
    }
}

impl Controller for Engineer {
    fn choose(&mut self, percept: &Percept, _: &mut Rng) -> usize {
        // What was expected comes first among equals.
        let far = |state: usize| {
            let variables = 0..self.spec.sizes.len();
            self.expected.map_or(0, |expected| {
                let differs =
                    |&it: &usize| self.spec.value(expected, it) != self.spec.value(state, it);
                variables.filter(differs).count()
            })
        };
        let cost = |&state: &usize| (self.disagrees(state, percept), far(state));
        let state = (0..self.spec.states()).min_by_key(cost).unwrap_or(0);
        let action = self.policy[state];
        let after = || self.spec.after(state, &self.spec.effects[action]);
        self.expected = (!self.spec.is_goal(state)).then(after);
        action
    }
}
