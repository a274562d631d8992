//! One seed of the angle study: its stimuli, and what each of its networks answers to them.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::network::{AngleConfig, Full, Network as _, OrientationOnly, Responses};
use super::stimulus::AngleStimulus;

/// Networks of a seed.
pub(super) const NETWORKS: u64 = 4;

/// Everything that was measured with one seed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The seed.
    pub seed: u64,
    /// Habituated only.
    pub young: Responses,
    /// Trained on angles, then habituated.
    pub old: Responses,
    /// As old, but test A's place in the circle was left out of training.
    pub held_out: Responses,
    /// As old, but without the direction between the midpoints.
    pub orientation_only: Responses,
}

/// Tries one seed; `done` is called after each of its networks.
#[must_use]
pub(super) fn run(seed: u64, config: &AngleConfig, done: impl Fn()) -> Trial {
    let direction = config.draw_direction(&mut Rng::stream(seed, 1));
    let habituation = AngleStimulus {
        direction,
        angle: 45.0,
    };
    // Test A is turned so that none of its lines has an orientation of the habituation stimulus.
    let turn = config.step() * (config.turn / config.step()).round();
    let rotated = AngleStimulus {
        direction: direction + turn,
        angle: 45.0,
    };
    let tests = [habituation, rotated, habituation.opened()];
    let held_out = |direction: f32| {
        let away = (direction - rotated.direction).rem_euclid(360.0);
        away.min(360.0 - away) > 0.5 * config.step()
    };
    let count = |responses| {
        done();
        responses
    };
    Trial {
        seed,
        young: count(Full::young(config, seed, &tests)),
        old: count(Full::old(config, seed, &tests, |_| true)),
        held_out: count(Full::old(config, seed, &tests, held_out)),
        orientation_only: count(OrientationOnly::old(config, seed, &tests, |_| true)),
    }
}

/// A number of each seed.
pub(super) fn of(trials: &[Trial], measure: impl Fn(&Trial) -> f64) -> Vec<f64> {
    trials.iter().map(measure).collect()
}

/// Which network of a seed.
pub(super) type Network = fn(&Trial) -> &Responses;

/// The networks of a seed, by the names in tables and figures.
pub(super) const NAMED: [(&str, Network); 4] = [
    ("young", |trial| &trial.young),
    ("old", |trial| &trial.old),
    ("old, A unseen", |trial| &trial.held_out),
    ("old, no midpoints", |trial| &trial.orientation_only),
];
