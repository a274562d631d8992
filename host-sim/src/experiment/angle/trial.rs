//! One seed of the angle study: its stimuli, and what each of its networks answers to them.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::num::Rng;

use super::network::{AngleConfig, Full, Network, OrientationOnly, Responses};
use super::stimulus::AngleStimulus;

/// Networks of a seed.
pub const NETWORKS: u64 = 4;

/// Everything that was measured with one seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeedResult {
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

/// Runs the study for one seed; `done` is called after each of its networks.
#[must_use]
pub fn run_seed(seed: u64, config: &AngleConfig, done: impl Fn()) -> SeedResult {
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
    SeedResult {
        seed,
        young: count(Full::young(config, seed, &tests)),
        old: count(Full::old(config, seed, &tests, |_| true)),
        held_out: count(Full::old(config, seed, &tests, held_out)),
        orientation_only: count(OrientationOnly::old(config, seed, &tests, |_| true)),
    }
}
