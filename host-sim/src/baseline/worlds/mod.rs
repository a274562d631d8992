//! The rivals of the worlds that are not the Pioneer's: one written by hand for each, and the
//! parameters of the tabular learners that did best there.
//!
//! Tuned with `examples/worlds.rs` on seeds 0 to 4 (keys 0 to 2, generated worlds 0 to 9), each learner
//! on each world by itself: α .03 .1 .3 .6, discount .8 .9 .98, λ .5 .9, untried actions worth 0 or .5
//! (the shuttle 5), random actions .1 in training and .02 afterwards.

use super::linear::LinearConfig;
use super::tabular::{History, Method, TabularConfig, Traces};

pub mod believer;
pub mod generated;
pub mod keys;
pub mod lake;
pub mod shuttle;
pub mod vacuum;

/// The rivals that learn, as they did best in a world.
///
/// ```
/// use host_sim::baseline::worlds::lake::TUNED;
/// assert!(TUNED.q.escape.is_none());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Tuned {
    /// Q-learning on percepts.
    pub q: TabularConfig,
    /// Q-learning on the last three percepts and the actions between them.
    pub q_history: TabularConfig,
    /// Sarsa(λ) on percepts.
    pub sarsa: TabularConfig,
    /// Sarsa(λ) on the last three percepts and the actions between them.
    pub sarsa_history: TabularConfig,
    /// Linear Sarsa(λ) on percepts.
    pub linear: LinearConfig,
    /// Linear Sarsa(λ) on the last three percepts and the actions between them.
    pub linear_history: LinearConfig,
}

/// A Q-learner by step size, discount and the worth of untried actions.
const fn q(history: History, alpha: f64, discount: f64, optimism: f64) -> TabularConfig {
    TabularConfig {
        history,
        alpha,
        discount,
        optimism,
        escape: None,
        ..TabularConfig::Q
    }
}

/// Sarsa(λ) by step size, discount, λ and the worth of untried actions.
const fn sarsa(
    history: History,
    alpha: f64,
    discount: f64,
    lambda: f64,
    optimism: f64,
) -> TabularConfig {
    TabularConfig {
        method: Method::Sarsa(Traces::Replacing),
        lambda,
        ..q(history, alpha, discount, optimism)
    }
}

/// Linear Sarsa(λ) by step size, discount and λ.
const fn linear(history: History, alpha: f64, discount: f64, lambda: f64) -> LinearConfig {
    LinearConfig {
        history,
        alpha,
        discount,
        lambda,
        ..LinearConfig::DEFAULT
    }
}
