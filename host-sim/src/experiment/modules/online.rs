//! Independent components in fixed memory, a stimulus at a time.
//!
//! Directions are those of incremental principal components, free of a covariance (Weng, Zhang and
//! Hwang 2003); what they whiten is turned by EASI (Cardoso and Laheld 1996) in its normalized form.
//! No stimulus is kept.

use super::components::{FARTHEST, NEGLIGIBLE, dot, responding, units, work};
use super::module::{FUNCTION, Module, Plan, Work};

/// How much more than its share a new stimulus counts for a direction (Weng's amnesic parameter).
const AMNESIC: f32 = 2.0;
/// The share of expected stimuli after which components begin to turn: directions come first.
const FIRST: u32 = 4;

/// Directions and a turn.
pub(super) struct Online {
    mean: Vec<f32>,
    /// Row by row; the length of each is its variance.
    directions: Vec<f32>,
    /// k · k.
    turn: Vec<f32>,
    features: usize,
    units: usize,
    gain: f32,
    rate: f32,
    samples: u32,
    turns_from: u32,
    computed: f64,
}

impl Online {
    /// Knows nothing; components turn by `rate`.
    pub(super) fn new(plan: &Plan, gain: f32, rate: f32) -> Self {
        let most = (plan.units() / 2).min(plan.features);
        let mut turn = vec![0.0; most * most];
        for at in 0..most {
            turn[at * most + at] = 1.0;
        }
        Self {
            mean: vec![0.0; plan.features],
            directions: vec![0.0; most * plan.features],
            turn,
            features: plan.features,
            units: plan.units(),
            gain,
            rate,
            samples: 0,
            turns_from: plan.samples / FIRST,
            computed: 0.0,
        }
    }

    fn most(&self) -> usize {
        self.directions.len() / self.features
    }

    /// The stimulus on each direction that counts, in standard deviations, and what none of them says.
    fn whitened(&self, stimulus: &[f32]) -> (Vec<f32>, f32) {
        let mut left: Vec<f32> = stimulus
            .iter()
            .zip(&self.mean)
            .map(|(x, m)| x - m)
            .collect();
        let rows = || self.directions.chunks_exact(self.features);
        let variances: Vec<f32> = rows().map(|it| dot(it, it).sqrt()).collect();
        let whole: f32 = variances.iter().sum();
        let mut white = Vec::with_capacity(variances.len());
        for (direction, &variance) in rows().zip(&variances) {
            if f64::from(variance) <= NEGLIGIBLE * f64::from(whole) {
                break;
            }
            let along = dot(direction, &left) / variance;
            for (it, v) in left.iter_mut().zip(direction) {
                *it -= along * v / variance;
            }
            white.push((along / variance.sqrt()).clamp(-FARTHEST, FARTHEST));
        }
        (white, dot(&left, &left))
    }

    fn components(&self, white: &[f32]) -> Vec<f32> {
        let rows = self.turn.chunks_exact(self.most().max(1));
        rows.take(white.len()).map(|it| dot(it, white)).collect()
    }

    /// Moves each direction towards what those before it leave of the stimulus.
    fn direct(&mut self, stimulus: &[f32]) {
        let n = self.samples as f32;
        let mut left: Vec<f32> = stimulus
            .iter()
            .zip(&self.mean)
            .map(|(x, m)| x - m)
            .collect();
        let new = ((1.0 + AMNESIC) / n).min(1.0);
        let rows = self.directions.chunks_exact_mut(self.features);
        for direction in rows.take(self.samples as usize - 1) {
            let length = dot(direction, direction).sqrt();
            if length <= f32::MIN_POSITIVE {
                direction.copy_from_slice(&left);
            } else {
                let along = dot(direction, &left) / length;
                for (v, it) in direction.iter_mut().zip(&left) {
                    *v += new * (along * it - *v);
                }
            }
            let length = dot(direction, direction).sqrt();
            if length <= f32::MIN_POSITIVE {
                break;
            }
            let along = dot(direction, &left) / length;
            for (it, v) in left.iter_mut().zip(direction.iter()) {
                *it -= along * v / length;
            }
        }
    }

    /// EASI: W ← W − μ[(yyᵀ − 1) / (1 + μ yᵀy) + (gyᵀ − ygᵀ) / (1 + μ |yᵀg|)] W, by outer products.
    fn turn(&mut self, white: &[f32]) {
        let y = self.components(white);
        let g: Vec<f32> = y.iter().map(|&it| libm::tanhf(it)).collect();
        let (most, rate) = (self.most(), self.rate);
        let through = |by: &[f32]| -> Vec<f32> {
            let mut sums = vec![0.0; y.len()];
            for (row, weight) in self.turn.chunks_exact(most).zip(by) {
                for (sum, it) in sums.iter_mut().zip(row) {
                    *sum += weight * it;
                }
            }
            sums
        };
        let (a, b) = (through(&y), through(&g));
        let white_rate = rate / (1.0 + rate * dot(&y, &y));
        let turn_rate = rate / (1.0 + rate * dot(&y, &g).abs());
        for ((row, &y), &g) in self.turn.chunks_exact_mut(most).zip(&y).zip(&g) {
            for ((w, &a), &b) in row.iter_mut().zip(&a).zip(&b) {
                *w -= white_rate * (y * a - *w) + turn_rate * (g * a - y * b);
            }
        }
    }
}

impl Module for Online {
    fn units(&self) -> usize {
        self.units
    }

    fn learn(&mut self, stimulus: &[f32]) {
        self.samples += 1;
        let share = 1.0 / self.samples as f32;
        super::module::approach(&mut self.mean, stimulus, share);
        self.direct(stimulus);
        self.computed += (4 * self.most() * self.features + 2 * self.most() * FUNCTION) as f64;
        if self.samples > self.turns_from {
            let (white, _) = self.whitened(stimulus);
            self.turn(&white);
            let k = white.len();
            self.computed += (3 * k * self.features + 7 * k * k + k * FUNCTION) as f64;
        }
    }

    fn respond(&self, stimulus: &[f32], activations: &mut [f32]) -> f32 {
        let (white, left) = self.whitened(stimulus);
        units(&self.components(&white), self.gain, activations);
        left
    }

    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>> {
        None
    }

    fn bytes(&self) -> usize {
        let most = self.most();
        // Beside what is kept: the rest of a stimulus, components, their nonlinearity, two sums.
        let passing = self.features + 6 * most;
        let held = self.mean.len() + self.directions.len() + self.turn.len();
        4 * (held + passing) + size_of::<Self>()
    }

    fn work(&self) -> Work {
        let respond = responding(self.most(), self.features, true);
        let lengths = (self.most() * (self.features + FUNCTION)) as f64;
        work(respond + lengths, self.computed, self.samples)
    }
}
