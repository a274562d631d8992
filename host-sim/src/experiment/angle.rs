//! The angle study of Cohen and Younger (1984), with the layers of the causal study (book, 2.1.2).
//!
//! Two line segments are seen as two orientations and the direction from one midpoint to the other;
//! three maps read them and a Top layer reads the maps.
//! Young networks know only the habituation stimulus; old ones have seen angles of 45° before.
//! The response to a test stimulus is its novelty at the Top layer, which stands for looking time.
//! The book describes the infants and the principle and has no such model: all of it is our
//! extension, to show that the layers serve a second domain.

mod claims;
mod network;
mod stimulus;

pub use network::AngleConfig;
pub use stimulus::{AngleStimulus, MIDPOINT_CHANNELS, ORIENTATION_CHANNELS};

use cla_core::num::Rng;

use crate::progress::Progress;
use crate::report::figure::FigureError;
use crate::report::{Results, Summary};
use network::{Full, Network, OrientationOnly};

/// Networks of a seed.
const NETWORKS: u64 = 4;

/// What is answered to the three stimuli of Fig 2.1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Looking {
    /// The 45° angle of habituation.
    pub habituated: f64,
    /// Test A: 45°, rotated, with new orientations of its lines.
    pub rotated: f64,
    /// Test B: 135°, with the orientations of habituation.
    pub opened: f64,
}

/// What one network answers, at both of its levels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Responses {
    /// Novelty at the Top layer: the network's response.
    pub top: Looking,
    /// How far the activations of Level 1 are from those of the habituation stimulus, Σ |a − b|.
    pub level_1: Looking,
}

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

/// The results of all seeds.
#[derive(Clone, Debug)]
pub struct Study {
    config: AngleConfig,
    results: Vec<SeedResult>,
}

/// Runs the study for each seed, on all cores.
#[must_use]
pub fn run(seeds: &[u64], config: &AngleConfig, progress: &Progress) -> Study {
    let results = progress.over("angles", seeds, NETWORKS, |&seed, ticker| {
        run_seed(seed, config, || ticker.advance(1))
    });
    Study {
        config: *config,
        results,
    }
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

impl Study {
    /// What was measured with each seed.
    #[must_use]
    pub fn results(&self) -> &[SeedResult] {
        &self.results
    }

    /// Claims, tables and parameters.
    #[must_use]
    pub fn summary(&self) -> Summary {
        claims::summary(&self.config, &self.results)
    }

    /// The summary and the figures.
    ///
    /// # Errors
    /// [`FigureError`] when a figure cannot be drawn.
    pub fn report(&self) -> Result<Results, FigureError> {
        let mut results = Results::new(self.summary());
        for (name, picture) in claims::figures(&self.results)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}
