//! Independent components of a batch: principal components, whitened, turned by symmetric FastICA
//! (Hyvärinen 1999).

use cla_core::num::Rng;

use super::components::{FARTHEST, NEGLIGIBLE, dot, responding, units, work};
use super::linear::{decorrelated, dot as inner, eigen};
use super::module::{FUNCTION, Module, Plan, Work};

/// Stimuli that are kept, evenly over all that are expected.
const KEPT: u32 = 4000;
/// Iterations at most.
const ITERATIONS: u32 = 100;
/// No component turns farther than this, as one less its cosine: it has converged.
const CONVERGED: f64 = 1e-5;

/// What tells components from mixtures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Contrast {
    /// The hyperbolic tangent.
    Tanh,
    /// The cube, which is kurtosis.
    Cube,
}

impl Contrast {
    /// The nonlinearity and its slope.
    fn at(self, y: f64) -> (f64, f64) {
        match self {
            Self::Tanh => {
                let it = libm::tanh(y);
                (it, 1.0 - it * it)
            }
            Self::Cube => (y * y * y, 3.0 * y * y),
        }
    }
}

/// Stimuli, and what was found in them when they had ended.
pub(super) struct Batch {
    kept: Vec<f32>,
    every: u32,
    samples: u32,
    mean: Vec<f32>,
    /// Orthonormal, row by row.
    directions: Vec<f32>,
    /// What each component is of a stimulus less the mean.
    filters: Vec<f32>,
    features: usize,
    units: usize,
    gain: f32,
    contrast: Contrast,
    chance: Rng,
    computed: f64,
}

impl Batch {
    /// Nothing kept; components are drawn from `rng` to begin with. A component is 1 standard deviation
    /// at an activation of tanh `gain`.
    pub(super) fn new(plan: &Plan, gain: f32, contrast: Contrast, rng: &mut Rng) -> Self {
        Self {
            kept: Vec::new(),
            every: (plan.samples / KEPT).max(1),
            samples: 0,
            mean: vec![0.0; plan.features],
            directions: Vec::new(),
            filters: Vec::new(),
            features: plan.features,
            units: plan.units(),
            gain,
            contrast,
            chance: Rng::new(rng.next_seed()),
            computed: 0.0,
        }
    }

    /// The mean of what was kept, and the covariance.
    fn moments(&self) -> (Vec<f64>, Vec<f64>) {
        let d = self.features;
        let n = (self.kept.len() / d) as f64;
        let mut mean = vec![0.0; d];
        for stimulus in self.kept.chunks_exact(d) {
            for (sum, &it) in mean.iter_mut().zip(stimulus) {
                *sum += f64::from(it) / n;
            }
        }
        let mut covariance = vec![0.0; d * d];
        let mut centred = vec![0.0; d];
        for stimulus in self.kept.chunks_exact(d) {
            for ((to, &it), m) in centred.iter_mut().zip(stimulus).zip(&mean) {
                *to = f64::from(it) - m;
            }
            for (row, &a) in covariance.chunks_exact_mut(d).zip(&centred) {
                for (sum, &b) in row.iter_mut().zip(&centred) {
                    *sum += a * b / n;
                }
            }
        }
        (mean, covariance)
    }

    /// Whitened stimuli turned until each component is as far from Gaussian as it gets.
    fn turned(&mut self, white: &[f64], k: usize) -> Vec<f64> {
        let n = (white.len() / k) as f64;
        let drawn: Vec<f64> = (0..k * k)
            .map(|_| f64::from(self.chance.unit()) - 0.5)
            .collect();
        let mut turn = decorrelated(&drawn, k);
        for _ in 0..ITERATIONS {
            let mut next = vec![0.0; k * k];
            for z in white.chunks_exact(k) {
                for (row, to) in turn.chunks_exact(k).zip(next.chunks_exact_mut(k)) {
                    let (g, slope) = self.contrast.at(inner(row, z));
                    for ((to, &z), &w) in to.iter_mut().zip(z).zip(row) {
                        *to += (g * z - slope * w) / n;
                    }
                }
            }
            self.computed += n * (k * (3 * k + FUNCTION)) as f64;
            let next = decorrelated(&next, k);
            let rows = next.chunks_exact(k).zip(turn.chunks_exact(k));
            let moved = rows.map(|(a, b)| 1.0 - inner(a, b).abs());
            let farthest = moved.fold(0.0, f64::max);
            turn = next;
            if farthest < CONVERGED {
                break;
            }
        }
        turn
    }
}

impl Module for Batch {
    fn units(&self) -> usize {
        self.units
    }

    fn learn(&mut self, stimulus: &[f32]) {
        if self.samples.is_multiple_of(self.every) {
            self.kept.extend_from_slice(stimulus);
        }
        self.samples += 1;
    }

    fn settle(&mut self) {
        let d = self.features;
        if self.kept.len() < 2 * d {
            return;
        }
        let (mean, covariance) = self.moments();
        let found = eigen(covariance, d);
        let count = self.kept.len() / d;
        self.computed += (count * d * d) as f64 + found.rotations as f64 * (12 * d) as f64;
        let whole: f64 = found.pairs.iter().map(|it| it.0.max(0.0)).sum();
        let most = (self.units / 2).min(d);
        let counted = found.pairs.iter().take(most);
        let counted = counted.take_while(|it| it.0 > NEGLIGIBLE * whole);
        let pairs: Vec<&(f64, Vec<f64>)> = counted.collect();
        let k = pairs.len();
        if k == 0 {
            return;
        }
        let mut white = Vec::with_capacity(count * k);
        for stimulus in self.kept.chunks_exact(d) {
            let centred: Vec<f64> = stimulus
                .iter()
                .zip(&mean)
                .map(|(&it, m)| f64::from(it) - m)
                .collect();
            white.extend(
                pairs
                    .iter()
                    .map(|(value, it)| inner(it, &centred) / value.sqrt()),
            );
        }
        self.computed += (count * k * d) as f64;
        let turn = self.turned(&white, k);
        self.mean = mean.iter().map(|&it| it as f32).collect();
        self.directions = pairs
            .iter()
            .flat_map(|it| it.1.iter().map(|&it| it as f32))
            .collect();
        self.filters = vec![0.0; k * d];
        for (filter, row) in self.filters.chunks_exact_mut(d).zip(turn.chunks_exact(k)) {
            for ((value, direction), weight) in pairs.iter().zip(row) {
                for (to, it) in filter.iter_mut().zip(direction) {
                    *to += (weight * it / value.sqrt()) as f32;
                }
            }
        }
    }

    fn respond(&self, stimulus: &[f32], activations: &mut [f32]) -> f32 {
        let centred: Vec<f32> = stimulus
            .iter()
            .zip(&self.mean)
            .map(|(x, m)| x - m)
            .collect();
        let filters = self.filters.chunks_exact(self.features);
        let components: Vec<f32> = filters
            .map(|it| dot(it, &centred).clamp(-FARTHEST, FARTHEST))
            .collect();
        units(&components, self.gain, activations);
        let directions = self.directions.chunks_exact(self.features);
        let said: f32 = directions.map(|it| dot(it, &centred).powi(2)).sum();
        (dot(&centred, &centred) - said).max(0.0)
    }

    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>> {
        None
    }

    fn bytes(&self) -> usize {
        let held = self.kept.len() + self.mean.len() + self.directions.len() + self.filters.len();
        // While it learns there are also a covariance, its eigenvectors and the whitened stimuli.
        let k = self.filters.len() / self.features;
        let passing = 2 * self.features * self.features + k * (self.kept.len() / self.features);
        4 * held + 8 * passing + size_of::<Self>()
    }

    fn work(&self) -> Work {
        let k = self.filters.len() / self.features;
        work(
            responding(k, self.features, false),
            self.computed,
            self.samples,
        )
    }
}
