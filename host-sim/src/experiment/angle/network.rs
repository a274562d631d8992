//! The networks of the angle study: three maps and a Top layer, or two without the midpoints.
//!
//! Both are the same [`Structure`] of `cla-core`, wired by types.

use cla_core::layer::{Join, Layer, LayerConfig, Signal, Stack, Structure};
use cla_core::num::{Rng, Schedule};
use serde::{Deserialize, Serialize};

use super::stimulus::{AngleStimulus, MIDPOINT_CHANNELS, ORIENTATION_CHANNELS};

type Orientation = Layer<6, 6, ORIENTATION_CHANNELS>;
type Midpoints = Layer<6, 6, MIDPOINT_CHANNELS>;
/// Two orientations and the direction between the midpoints.
pub(super) type Full = Stack<Join<Join<Orientation, Orientation>, Midpoints>, 8, 8, 108>;
/// The control: nothing tells where the second line lies.
pub(super) type OrientationOnly = Stack<Join<Orientation, Orientation>, 8, 8, 72>;

/// All parameters of the angle study; angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AngleConfig {
    /// Directions in which training shows the 45° angle, evenly around the circle.
    pub directions: u16,
    /// How far test A is turned from the habituation stimulus, rounded to a direction.
    pub turn: f32,
    /// Training trials of old networks.
    pub trials: u32,
    /// Habituation trials.
    pub habituation: u32,
    /// Each trial's direction and angle are off by up to this much, uniformly.
    pub jitter: f32,
    /// The learning rate, at the first and the last training trial, geometric.
    pub alpha: (f32, f32),
    /// The neighbourhood at the last training trial, in nodes; half the side at the first.
    pub final_neighbourhood: f32,
    /// σ_a of the maps and of the Top layer.
    pub activation_width: [f32; 2],
}

impl AngleConfig {
    /// The set of all angle claims.
    pub const STANDARD: Self = Self {
        directions: 24,
        turn: 90.0,
        trials: 4000,
        habituation: 100,
        jitter: 2.0,
        alpha: (0.5, 0.03),
        final_neighbourhood: 0.5,
        activation_width: [0.5, 0.6],
    };

    /// One of the training directions.
    pub(super) fn draw_direction(&self, rng: &mut Rng) -> f32 {
        self.step() * rng.below(u32::from(self.directions)) as f32
    }

    /// Degrees from one training direction to the next.
    pub(super) fn step(&self) -> f32 {
        360.0 / f32::from(self.directions)
    }

    /// The stimulus as it is met in a trial.
    fn jittered(&self, stimulus: AngleStimulus, rng: &mut Rng) -> AngleStimulus {
        let mut off = || self.jitter * (2.0 * rng.unit() - 1.0);
        AngleStimulus {
            direction: stimulus.direction + off(),
            angle: stimulus.angle + off(),
        }
    }

    fn layer(&self, width: f32, side: f32) -> LayerConfig {
        let schedule =
            |from, to| Schedule::geometric(from, to, self.trials).expect("positive values");
        LayerConfig::try_new(
            width,
            schedule(self.alpha.0, self.alpha.1),
            schedule(side / 2.0, self.final_neighbourhood),
        )
        .expect("a positive width")
    }
}

/// What is answered to the three stimuli of Fig 2.1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Looking {
    /// The 45° angle of habituation.
    pub habituated: f64,
    /// Test A: 45°, rotated, with new orientations of its lines.
    pub rotated: f64,
    /// Test B: 135°, with the orientations of habituation.
    pub opened: f64,
}

/// What one network answers, at both of its levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Responses {
    /// Novelty at the Top layer: the network's response.
    pub top: Looking,
    /// How far the activations of Level 1 are from those of the habituation stimulus, Σ |a − b|.
    pub level_1: Looking,
}

/// What the study needs of a structure, with and without midpoints.
pub(super) trait Network: Structure {
    /// Readies all layers for a life of [`AngleConfig::trials`].
    fn start(&mut self, config: &AngleConfig, rng: &mut Rng);

    /// What the network reads of a stimulus.
    fn sensors(stimulus: AngleStimulus) -> Self::Sensors;

    /// The activations of Level 1, map by map.
    fn components(&self) -> Vec<f32>;

    /// Novelty at the Top layer.
    fn novelty(&self) -> f32;

    /// A network that has met nothing before the habituation stimulus: it is at the beginning of the
    /// life that an old network has behind it.
    fn young(config: &AngleConfig, seed: u64, tests: &[AngleStimulus; 3]) -> Responses {
        let mut network = Box::new(Self::NEW);
        network.start(config, &mut Rng::stream(seed, 0));
        habituate(&mut *network, config, seed, tests, 0)
    }

    /// A network that has seen 45° in all directions that `shown` lets through.
    fn old(
        config: &AngleConfig,
        seed: u64,
        tests: &[AngleStimulus; 3],
        shown: impl Fn(f32) -> bool,
    ) -> Responses {
        let mut network = Box::new(Self::NEW);
        network.start(config, &mut Rng::stream(seed, 0));
        let mut rng = Rng::stream(seed, 2);
        for t in 0..config.trials {
            let direction = loop {
                let direction = config.draw_direction(&mut rng);
                if shown(direction) {
                    break direction;
                }
            };
            let stimulus = AngleStimulus {
                direction,
                angle: 45.0,
            };
            let sensors = Self::sensors(config.jittered(stimulus, &mut rng));
            network.learn(&sensors, t).expect("stimuli are finite");
        }
        habituate(&mut *network, config, seed, tests, config.trials)
    }
}

/// Habituates to the first of `tests`, then looks at all three without learning.
fn habituate<N: Network>(
    network: &mut N,
    config: &AngleConfig,
    seed: u64,
    tests: &[AngleStimulus; 3],
    from_sample: u32,
) -> Responses {
    let mut rng = Rng::stream(seed, 3);
    for t in 0..config.habituation {
        let sensors = N::sensors(config.jittered(tests[0], &mut rng));
        network
            .learn(&sensors, from_sample + t)
            .expect("stimuli are finite");
    }
    let [habituated, rotated, opened] = tests.map(|test| {
        network
            .activate(&N::sensors(test))
            .expect("stimuli are finite");
        (network.components(), f64::from(network.novelty()))
    });
    let changed = |components: &[f32]| -> f64 {
        components
            .iter()
            .zip(&habituated.0)
            .map(|(a, b)| f64::from((a - b).abs()))
            .sum()
    };
    Responses {
        level_1: Looking {
            habituated: changed(&habituated.0),
            rotated: changed(&rotated.0),
            opened: changed(&opened.0),
        },
        top: Looking {
            habituated: habituated.1,
            rotated: rotated.1,
            opened: opened.1,
        },
    }
}

/// The values of a signal.
fn values<S: Signal>(signal: &S) -> Vec<f32> {
    let mut values = vec![0.0; S::LEN];
    signal.write(&mut values.iter_mut());
    values
}

impl Network for Full {
    fn start(&mut self, config: &AngleConfig, rng: &mut Rng) {
        let map = config.layer(config.activation_width[0], 6.0);
        self.lower.first.first.start(&map, rng);
        self.lower.first.second.start(&map, rng);
        self.lower.second.start(&map, rng);
        self.upper
            .start(&config.layer(config.activation_width[1], 8.0), rng);
    }

    fn sensors(stimulus: AngleStimulus) -> Self::Sensors {
        ((stimulus.first(), stimulus.second()), stimulus.midpoints())
    }

    fn components(&self) -> Vec<f32> {
        values(&self.lower)
    }

    fn novelty(&self) -> f32 {
        self.upper.novelty()
    }
}

impl Network for OrientationOnly {
    fn start(&mut self, config: &AngleConfig, rng: &mut Rng) {
        let map = config.layer(config.activation_width[0], 6.0);
        self.lower.first.start(&map, rng);
        self.lower.second.start(&map, rng);
        self.upper
            .start(&config.layer(config.activation_width[1], 8.0), rng);
    }

    fn sensors(stimulus: AngleStimulus) -> Self::Sensors {
        (stimulus.first(), stimulus.second())
    }

    fn components(&self) -> Vec<f32> {
        values(&self.lower)
    }

    fn novelty(&self) -> f32 {
        self.upper.novelty()
    }
}
