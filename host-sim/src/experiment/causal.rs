//! Causal perception: a hierarchy learns what a launching is, in stages, and falls back (book, 4).
//!
//! [`run`] trains and tests one network a seed, with its controls, and returns a [`Study`]; the
//! study gives the summary (claims and tables) and the figures.
//! One parameter set, [`CausalConfig::standard`](network::CausalConfig::standard), serves all claims.
//! Nothing here prints or writes files.

mod claims;
mod figures;
pub mod measure;
pub mod network;
pub mod overload;
mod tables;

use cla_core::num::Rng;

use crate::progress::Progress;
use crate::report::figure::FigureError;
use crate::report::{Results, Summary};
use crate::world::launching::{Event, Noise};
use measure::{Causality, Stage, settled, train_with_stages};
use network::{Causal, CausalConfig, PerLayer, Training, View};
use overload::Overload;

/// Networks trained for a seed: the one the claims are about, and three controls.
const NETWORKS: u64 = 4;

/// Training with equal shares of the four events.
const EQUAL: [f32; 4] = [0.25; 4];

/// Training with Delay as the most frequent event.
const MOSTLY_DELAY: [f32; 4] = [0.05, 0.85, 0.05, 0.05];

/// Everything that was measured with one seed.
#[derive(Clone, Debug)]
pub struct SeedResult {
    /// The seed.
    pub seed: u64,
    /// The trained network on the four events.
    pub trained: Causality,
    /// The composites of the Direct event during training.
    pub stages: Vec<Stage>,
    /// From which share of training on each layer has settled.
    pub settled: PerLayer<f64>,
    /// One Noisy event, for the figure.
    pub noisy: View,
    /// The detectors on clean and noisy events.
    pub overload: Overload,
    /// The network before any training.
    pub untrained: Causality,
    /// A network that saw all events equally often.
    pub uniform: Causality,
    /// A network that saw Delay events 85 % of the time.
    pub mostly_delay: Causality,
    /// A network whose Top layer trained after Level 1.
    pub staged: Causality,
}

/// The results of all seeds.
#[derive(Clone, Debug)]
pub struct Study {
    config: CausalConfig,
    results: Vec<SeedResult>,
}

/// Runs the experiment for each seed, on all cores.
#[must_use]
pub fn run(seeds: &[u64], config: &CausalConfig, progress: &Progress) -> Study {
    let results = progress.over("causal perception", seeds, NETWORKS, |&seed, ticker| {
        run_seed(seed, config, || ticker.advance(1))
    });
    Study {
        config: *config,
        results,
    }
}

/// Runs the experiment for one seed; `done` is called after each of its networks.
#[must_use]
pub fn run_seed(seed: u64, config: &CausalConfig, done: impl Fn()) -> SeedResult {
    let mut causal = Causal::new(config, seed);
    let untrained = Causality::of(&mut causal);
    let stages = train_with_stages(&mut causal);
    let trained = Causality::of(&mut causal);
    let mut rng = Rng::stream(seed, 2);
    let launching = config.launching;
    let disturbed = Noise::Noisy.disturb(&launching.frames(Event::Direct), &mut rng);
    let noisy = causal.view(&launching.jittered(&disturbed, &mut rng));
    let overload = Overload::of(&mut causal, &mut rng);
    done();
    let control = |config: CausalConfig| {
        let mut causal = Causal::new(&config, seed);
        causal.train(|_, _| {});
        done();
        Causality::of(&mut causal)
    };
    SeedResult {
        seed,
        trained,
        settled: settled(&stages),
        stages,
        noisy,
        overload,
        untrained,
        uniform: control(CausalConfig {
            shares: EQUAL,
            ..*config
        }),
        mostly_delay: control(CausalConfig {
            shares: MOSTLY_DELAY,
            ..*config
        }),
        staged: control(CausalConfig {
            training: Training::Staged,
            ..*config
        }),
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

    /// The summary and the figures; those of single networks show the first seed.
    ///
    /// # Errors
    /// [`FigureError`] when a figure cannot be drawn.
    pub fn report(&self) -> Result<Results, FigureError> {
        let mut results = Results::new(self.summary());
        for (name, picture) in figures::all(&self.results)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}
