//! The map of binary stimuli: work in proportion to the features that are on (book, 5.3.1).
//!
//! The arithmetic is that of `cla_core::som::BinarySom`: d² = |m|² − 2·s·Σ v_j + k over what is on, a
//! prototype is m = s·v, and one factor decays it.
//! Where the core folds a node's factor into its weights when it gets small, this folds those of all
//! nodes in one pass over memory; both agree to about four digits.

use std::ops::Range;

/// A factor below this is folded into the weights: a pass over all of them is rare so, and numbers up
/// to its inverse lose no digits.
const SMALLEST_SCALE: f32 = 1.0 / 4_294_967_296.0;
/// Nodes whose sums are made together.
const LANES: usize = 32;

/// A map in three arrays: v feature by feature, and for every node s and |m|².
pub(crate) struct Binary<'a> {
    pub(crate) columns: &'a mut [f32],
    pub(crate) scale: &'a mut [f32],
    pub(crate) norm: &'a mut [f32],
}

/// Room for a number a node, three times.
pub(crate) struct Scratch {
    dots: Vec<f32>,
    kept: Vec<f32>,
    amounts: Vec<f32>,
}

impl Scratch {
    pub(crate) fn new(nodes: usize) -> Self {
        Self {
            dots: vec![0.0; nodes],
            kept: vec![0.0; nodes],
            amounts: vec![0.0; nodes],
        }
    }
}

/// What is on and what is unknown, by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sparse {
    pub(crate) on: Vec<usize>,
    pub(crate) unknown: Vec<usize>,
}

impl Sparse {
    /// Reads features of 0, 1 and NaN; the first other one is the error.
    pub(crate) fn read(stimulus: &[f32]) -> Result<Self, usize> {
        let mut it = Self::default();
        for (feature, &value) in stimulus.iter().enumerate() {
            if value == 1.0 {
                it.on.push(feature);
            } else if value.is_nan() {
                it.unknown.push(feature);
            } else if value != 0.0 {
                return Err(feature);
            }
        }
        Ok(it)
    }
}

impl Binary<'_> {
    #[inline(always)]
    fn column(&self, feature: usize) -> &[f32] {
        let nodes = self.scale.len();
        &self.columns[feature * nodes..][..nodes]
    }

    /// ‖x − m‖² over the known features, for every node; what rounding would make negative is 0.
    #[inline(always)]
    pub(crate) fn squared_distances(&self, stimulus: &Sparse, distances: &mut [f32]) {
        let mut blocks = distances.chunks_exact_mut(LANES);
        let mut first = 0;
        for block in &mut blocks {
            let mut sums = [0.0_f32; LANES];
            for &feature in &stimulus.on {
                let (column, _) = self.column(feature)[first..].as_chunks::<LANES>();
                if let Some(column) = column.first() {
                    for (sum, value) in sums.iter_mut().zip(column) {
                        *sum += value;
                    }
                }
            }
            block.copy_from_slice(&sums);
            first += LANES;
        }
        let rest = blocks.into_remainder();
        rest.fill(0.0);
        for &feature in &stimulus.on {
            for (sum, value) in rest.iter_mut().zip(&self.column(feature)[first..]) {
                *sum += value;
            }
        }
        let length = stimulus.on.len() as f32;
        let nodes = self.scale.iter().zip(&*self.norm);
        for (distance, (scale, norm)) in distances.iter_mut().zip(nodes) {
            *distance = norm - 2.0 * scale * *distance + length;
        }
        for &feature in &stimulus.unknown {
            let nodes = self.scale.iter().zip(self.column(feature));
            for (distance, (scale, value)) in distances.iter_mut().zip(nodes) {
                let weight = scale * value;
                *distance -= weight * weight;
            }
        }
        for distance in distances {
            *distance = distance.max(0.0);
        }
    }

    /// m ← m + rate · (x − m) on the known features of some nodes, rates from 0 to 1.
    ///
    /// `rates` is left with 0 for the nodes that had to be set by hand.
    #[inline(always)]
    pub(crate) fn train(
        &mut self,
        stimulus: &Sparse,
        rates: &mut [f32],
        moving: Range<usize>,
        scratch: &mut Scratch,
    ) {
        let small = |(scale, rate): (&f32, &f32)| scale * (1.0 - rate) < SMALLEST_SCALE;
        // All of them, several at a time, and not up to the first.
        let any_small = |it: &Self, rates: &[f32]| {
            let nodes = it.scale[moving.clone()].iter().zip(rates);
            nodes.fold(false, |any, node| any | small(node))
        };
        if any_small(self, &rates[moving.clone()]) {
            self.fold();
            if any_small(self, &rates[moving.clone()]) {
                // A rate of almost 1: the node becomes the stimulus.
                for node in moving.clone() {
                    if 1.0 - rates[node] < SMALLEST_SCALE {
                        self.become_almost(stimulus, node, rates[node]);
                        rates[node] = 0.0;
                    }
                }
            }
        }
        let Scratch {
            dots,
            kept,
            amounts,
        } = scratch;
        let rates = &rates[moving.clone()];
        let all = self.scale.len();
        let (dots, amounts) = (&mut dots[..rates.len()], &mut amounts[..rates.len()]);
        let kept = &mut kept[..rates.len()];
        dots.fill(0.0);
        kept.fill(0.0);
        let scales = &mut self.scale[moving.clone()];
        for ((amount, scale), c) in amounts.iter_mut().zip(&*scales).zip(rates) {
            *amount = c / (scale * (1.0 - c));
        }
        for &feature in &stimulus.unknown {
            let column = &mut self.columns[feature * all..][moving.clone()];
            let nodes = column.iter_mut().zip(&*scales).zip(rates).zip(&mut *kept);
            for (((value, scale), c), kept) in nodes {
                let weight = scale * *value;
                *kept += weight * weight;
                *value = weight / (scale * (1.0 - c));
            }
        }
        for &feature in &stimulus.on {
            let column = &mut self.columns[feature * all..][moving.clone()];
            for ((value, dot), amount) in column.iter_mut().zip(&mut *dots).zip(&*amounts) {
                *dot += *value;
                *value += amount;
            }
        }
        let length = stimulus.on.len() as f32;
        let nodes = self.norm[moving].iter_mut().zip(scales).zip(rates);
        for (((norm, scale), &c), (dot, unknown)) in nodes.zip(dots.iter().zip(kept)) {
            let keep = 1.0 - c;
            let known = *norm - *unknown;
            *norm = keep * keep * known + 2.0 * c * keep * *scale * dot + c * c * length + *unknown;
            *scale *= keep;
        }
    }

    /// One node whose factor is 1 goes nearly all of the way.
    fn become_almost(&mut self, stimulus: &Sparse, node: usize, rate: f32) {
        let all = self.scale.len();
        let mut norm = 0.0;
        for (feature, column) in self.columns.chunks_exact_mut(all).enumerate() {
            let value = &mut column[node];
            if !stimulus.unknown.contains(&feature) {
                let on = f32::from(u8::from(stimulus.on.contains(&feature)));
                *value += rate * (on - *value);
            }
            norm += *value * *value;
        }
        self.norm[node] = norm;
    }

    /// Makes the factor of every node 1 and its |m|² what it is.
    #[inline(always)]
    pub(crate) fn fold(&mut self) {
        let nodes = self.scale.len();
        self.norm.fill(0.0);
        for column in self.columns.chunks_exact_mut(nodes) {
            let each = column.iter_mut().zip(&*self.scale).zip(&mut *self.norm);
            for ((value, scale), norm) in each {
                *value *= scale;
                *norm += *value * *value;
            }
        }
        self.scale.fill(1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::dense::{nearest, squared_distances, train};
    use super::super::rates::{Lattice, Rates, Shape};
    use super::{Binary, Scratch, Sparse};
    use cla_core::num::{Neighbourhood, Rng};
    use cla_core::som::{BinarySom, Grid, SparseStimulus, best_match};

    const FEATURES: usize = 40;
    const NODES: usize = 63;

    /// Weights feature by feature, and the core's map with the same.
    fn alike() -> (Vec<f32>, Box<BinarySom<9, 7, FEATURES>>) {
        let mut core = Box::new(BinarySom::new());
        core.randomize(&mut Rng::new(4));
        let mut weights = Vec::new();
        for feature in 0..FEATURES as u16 {
            weights.extend(
                (0..NODES as u16).map(|node| core.weight(cla_core::som::NodeId(node), feature)),
            );
        }
        (weights, core)
    }

    #[test]
    fn it_agrees_with_the_map_of_the_core_and_with_the_dense_one() {
        let (mut columns, mut core) = alike();
        let mut dense = columns.clone();
        let (mut scale, mut norm) = (vec![1.0; NODES], vec![0.0; NODES]);
        let mut map = Binary {
            columns: &mut columns,
            scale: &mut scale,
            norm: &mut norm,
        };
        map.fold();
        let lattice = Lattice {
            x: 7,
            y: 9,
            hexagonal: false,
            shape: Shape::Gaussian,
        };
        let (mut rates, mut scratch) = (Rates::new(lattice), Scratch::new(NODES));
        let (mut distances, mut of_dense) = (vec![0.0; NODES], vec![0.0; NODES]);
        let (mut grids, mut rng) = ((Grid::filled(0.0), Grid::filled(0.0)), Rng::new(8));
        for t in 0..600 {
            let mut stimulus = [0.0; FEATURES];
            for _ in 0..6 {
                stimulus[rng.below(FEATURES as u32) as usize] = 1.0;
            }
            if t % 3 == 0 {
                stimulus[rng.below(FEATURES as u32) as usize] = f32::NAN;
            }
            let sparse = Sparse::read(&stimulus).unwrap();
            let words = |features: &[usize]| {
                let mut words = [0_u32; 2];
                features
                    .iter()
                    .for_each(|it| words[it / 32] |= 1 << (it % 32));
                words
            };
            let (on, unknown) = (words(&sparse.on), words(&sparse.unknown));
            let core_stimulus = SparseStimulus {
                on: &on,
                minus: &[],
                unknown: &unknown,
            };
            core.squared_distances(&core_stimulus, &mut grids.0, &mut grids.1);
            map.squared_distances(&sparse, &mut distances);
            squared_distances(&dense, &stimulus, &mut of_dense);
            for (ours, theirs) in distances.iter().zip(grids.1.as_slice()) {
                assert!((ours - theirs).abs() < 1e-3, "{t}: {ours} {theirs}");
            }
            for (ours, theirs) in distances.iter().zip(&of_dense) {
                assert!((ours - theirs).abs() < 1e-3, "{t}: {ours} {theirs}");
            }
            let winner = best_match(&grids.1).node;
            let apart = distances[nearest(&distances)] - distances[usize::from(winner.0)];
            assert!(apart.abs() < 1e-4);
            // At times the winner becomes the stimulus itself.
            let alpha = if t % 50 == 49 { 1.0 } else { 0.3 };
            let near = Neighbourhood::gaussian(1.5, 0.0).unwrap();
            core.train(&core_stimulus, winner, alpha, &near, |_| true);
            rates.around(usize::from(winner.0), 1.5, alpha);
            train(&mut dense, &stimulus, &rates.of, rates.moving.clone());
            map.train(&sparse, &mut rates.of, rates.moving.clone(), &mut scratch);
        }
    }

    #[test]
    fn a_feature_that_is_not_binary_is_named() {
        assert_eq!(Sparse::read(&[0.0, 1.0, f32::NAN, 0.5]).unwrap_err(), 3);
    }
}
