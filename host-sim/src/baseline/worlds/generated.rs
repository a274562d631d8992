//! The rivals of generated worlds.
//!
//! The one written by hand is the engineer who made the world: who knows what every item shows, how
//! often it errs and what every action does, keeps a belief over the states, and does what is best in
//! the likeliest.

use std::sync::Arc;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Tuned, linear, q, sarsa};
use crate::baseline::tabular::History;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::generated::{Shown, Spec};
use crate::world::solve::Mdp;

/// The learners that did best here.
pub const TUNED: Tuned = Tuned {
    q: q(History::None, 0.6, 0.8, 0.5),
    q_history: q(History::TwoSteps, 0.03, 0.9, 0.5),
    sarsa: sarsa(History::None, 0.3, 0.8, 0.9, 0.5),
    sarsa_history: sarsa(History::TwoSteps, 0.3, 0.98, 0.5, 0.5),
    linear: linear(History::None, 0.3, 0.9, 0.9),
    linear_history: linear(History::TwoSteps, 0.3, 0.9, 0.5),
};

/// Least likelihood of a reading: nothing is impossible, or one surprise would end a belief.
const LEAST: f64 = 1e-3;

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
    model: Arc<Mdp>,
    policy: Arc<[usize]>,
    optimum: f64,
    /// How likely each state is.
    belief: Vec<f64>,
    last: Option<usize>,
}

impl Engineer {
    /// One who has just begun, and may be anywhere.
    #[must_use]
    pub fn new(spec: Arc<Spec>) -> Self {
        let model = spec.model();
        let rate = model.rate(1e-6);
        Self {
            belief: vec![1.0 / spec.states() as f64; spec.states()],
            spec,
            model: Arc::new(model),
            policy: rate.policy.into(),
            optimum: rate.gain,
            last: None,
        }
    }

    /// What the best policy earns in an action when the state is known.
    #[must_use]
    pub const fn optimum(&self) -> f64 {
        self.optimum
    }

    /// How likely a percept is in a state.
    fn likelihood(&self, state: usize, percept: &Percept) -> f64 {
        let errs = f64::from(self.spec.noise).max(LEAST);
        let mut likelihood = 1.0;
        for (index, shown) in self.spec.shown.iter().enumerate() {
            if let Shown::Value { variable, values } = *shown {
                let has = values >> self.spec.value(state, variable) & 1 == 1;
                let read = percept.get(ItemId(index as u16));
                likelihood *= read.map_or(1.0, |on| if on == has { 1.0 - errs } else { errs });
            }
        }
        likelihood
    }

    /// What is believed after an action and a percept.
    fn update(&mut self, percept: &Percept) {
        let mut belief = self.belief.clone();
        if let Some(action) = self.last {
            belief.fill(0.0);
            for (state, share) in self.belief.iter().enumerate() {
                for &(next, chance) in self.model.outcomes(state, action) {
                    belief[next] += share * chance;
                }
            }
        }
        for (state, share) in belief.iter_mut().enumerate() {
            *share *= self.likelihood(state, percept);
        }
        let total = belief.iter().fold(0.0, |sum, share| sum + share);
        // A percept that cannot be leaves the belief as it was.
        if total > 0.0 {
            self.belief = belief.iter().map(|share| share / total).collect();
        }
    }
}

impl Controller for Engineer {
    fn choose(&mut self, percept: &Percept, _: &mut Rng) -> usize {
        self.update(percept);
        let mut likeliest = 0;
        for (state, &share) in self.belief.iter().enumerate() {
            if share > self.belief[likeliest] {
                likeliest = state;
            }
        }
        let action = self.policy[likeliest];
        self.last = Some(action);
        action
    }
}
