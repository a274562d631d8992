//! What a layer may be made of: the trait of all modules (book, 7.1.2).
//!
//! A module reads stimuli of a fixed length, learns from each of them once and answers with an activation
//! of each of its units, which is what the layer above reads.
//! Its novelty stands for looking time and tells overload; what it holds and what it computes is counted.

use std::fmt;

use serde::{Deserialize, Serialize};

/// The kinds of modules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// The self-organizing map of `cla-core` (book, 2.2).
    Map,
    /// Growing neural gas (Fritzke 1995).
    Gas,
    /// Incremental k-means (MacQueen 1967).
    Means,
    /// Independent components of a batch: FastICA (Hyvärinen 1999).
    Batch,
    /// Independent components in fixed memory: incremental principal components (Weng and others 2003),
    /// turned by EASI (Cardoso and Laheld 1996).
    Online,
}

impl Kind {
    /// All of them, the map first: it is what the others are compared with.
    pub const ALL: [Self; 5] = [Self::Map, Self::Gas, Self::Means, Self::Batch, Self::Online];

    /// The word that claim ids use.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Map => "som",
            Self::Gas => "neural_gas",
            Self::Means => "k_means",
            Self::Batch => "ica",
            Self::Online => "online_ica",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Map => "map (SOM)",
            Self::Gas => "growing neural gas",
            Self::Means => "k-means, incremental",
            Self::Batch => "FastICA, batch",
            Self::Online => "ICA, online",
        })
    }
}

/// Multiplications with an addition, of one stimulus; an exponential, a hyperbolic tangent and a square
/// root count for ten.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// To answer a stimulus.
    pub respond: f64,
    /// To learn one, the mean of all that were learned.
    pub learn: f64,
}

/// What an exponential, a hyperbolic tangent or a square root counts for.
pub const FUNCTION: usize = 10;

/// What a layer may be made of.
///
/// Every stimulus has the length that the module was made for; another length is a fault of the caller,
/// at which a module may panic.
///
/// ```
/// use cla_core::num::Rng;
/// use host_sim::experiment::modules::{Kind, Module, Plan, made};
///
/// let plan = Plan { side: 6, features: 12, width: 0.5, samples: 500, ..Plan::DEFAULT };
/// for kind in Kind::ALL {
///     let mut module = made(kind, &plan, 0, &mut Rng::new(1))?;
///     let mut rng = Rng::new(2);
///     for _ in 0..500 {
///         let place = rng.below(12) as usize;
///         let stimulus: Vec<f32> = (0..12).map(|it| if it == place { 1.0 } else { 0.1 * rng.unit() }).collect();
///         module.learn(&stimulus);
///     }
///     module.settle();
///     let mut answer = vec![0.0; module.units()];
///     let novelty = module.respond(&[0.5; 12], &mut answer);
///     assert!(novelty > 0.0 && answer.iter().all(|it| (0.0..=1.0).contains(it)), "{kind}");
/// }
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
pub trait Module: Send {
    /// Units, which is how many activations it gives.
    fn units(&self) -> usize;

    /// Learns from one stimulus.
    fn learn(&mut self, stimulus: &[f32]);

    /// The stimuli have ended for now: what learns from all of them at once does so.
    fn settle(&mut self) {}

    /// Writes the activation of each unit, in `[0, 1]`, into `activations`, which has a place for each;
    /// answers how new the stimulus is, a squared distance from what the module knows.
    fn respond(&self, stimulus: &[f32], activations: &mut [f32]) -> f32;

    /// The stimulus that each unit stands for, with how often it has won; `None` where units stand for
    /// none, as those of components do.
    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>>;

    /// Bytes of all that it holds while it learns.
    fn bytes(&self) -> usize;

    /// What it computes.
    fn work(&self) -> Work;
}

/// What a module is made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Units on each side of a map; others have as many units, side · side.
    pub side: usize,
    /// Values of a stimulus.
    pub features: usize,
    /// σ_a: at this distance from its prototype a unit is activated to .61 (book, 3.1).
    pub width: f32,
    /// About how many stimuli will be learned.
    pub samples: u32,
    /// A map's learning rate at the first and the last of them.
    pub alpha: (f32, f32),
    /// A map's neighbourhood at the last of them, in nodes; half the side at the first.
    pub neighbourhood: f32,
}

impl Plan {
    /// A small layer, to vary.
    pub const DEFAULT: Self = Self {
        side: 6,
        features: 12,
        width: 0.5,
        samples: 1000,
        alpha: (0.5, 0.04),
        neighbourhood: 0.7,
    };

    /// How many units.
    #[must_use]
    pub const fn units(&self) -> usize {
        self.side * self.side
    }
}

/// ‖x − m‖².
pub(super) fn squared_distance(stimulus: &[f32], prototype: &[f32]) -> f32 {
    let pairs = stimulus.iter().zip(prototype);
    pairs.map(|(x, m)| (x - m) * (x - m)).sum()
}

/// m ← m + rate · (x − m).
pub(super) fn approach(prototype: &mut [f32], stimulus: &[f32], rate: f32) {
    for (m, &x) in prototype.iter_mut().zip(stimulus) {
        *m += rate * (x - *m);
    }
}

/// Turns squared distances into the activations of equation 3.1; answers the least distance.
pub(super) fn activate(distances: &mut [f32], width: f32) -> f32 {
    let sharpness = 1.0 / (2.0 * width * width);
    let mut least = f32::INFINITY;
    for it in distances {
        least = least.min(*it);
        *it = cla_core::num::exp(-(*it * sharpness));
    }
    least
}

/// The place of the least number; of equals the first.
pub(super) fn least(numbers: &[f32]) -> usize {
    let mut best = 0;
    for (at, it) in numbers.iter().enumerate() {
        if *it < numbers[best] {
            best = at;
        }
    }
    best
}
