//! One seed of the causal experiment: a network in training and at its tests, and its controls.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::measure::{Causality, Stage, settled, train_with_stages};
use super::network::{Causal, CausalConfig, PerLayer, Training, View};
use super::overload::Overload;
use crate::world::launching::{Event, Noise};

/// Networks trained for a seed: the one the claims are about, and three controls.
pub(super) const NETWORKS: u64 = 4;

/// Training with equal shares of the four events.
const EQUAL: [f32; 4] = [0.25; 4];

/// Training with Delay as the most frequent event.
const MOSTLY_DELAY: [f32; 4] = [0.05, 0.85, 0.05, 0.05];

/// Everything that was measured with one seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
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

/// Which network of a seed a control is about.
pub(super) type Control = fn(&Trial) -> &Causality;

/// A number of each seed.
pub(super) fn of<T>(trials: &[Trial], measure: impl Fn(&Trial) -> T) -> Vec<T> {
    trials.iter().map(measure).collect()
}

/// Tries one seed; `done` is called after each of its networks.
#[must_use]
pub(super) fn run(seed: u64, config: &CausalConfig, done: impl Fn()) -> Trial {
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
    Trial {
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
