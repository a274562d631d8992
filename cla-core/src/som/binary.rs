//! The map for binary stimuli: work proportional to the features that are on (book, 5.3.1).
//!
//! A stimulus with k features on costs O(nodes · k) instead of O(nodes · features):
//! d² = |m|² − 2·Σ m_j + k over the features j that are on, with |m|² kept for every node and the
//! decay of a whole prototype kept as one factor (m = s·v).
//! Weights lie feature by feature, so a feature that is on is one contiguous column.
//! Unknown features count neither in the search nor in the update.
//! [`DenseSom`](super::DenseSom) is the oracle: both agree to about four digits, not to the bit.

use super::grid::{Grid, NodeId};
use super::stimulus::SparseStimulus;
use crate::num::{Neighbourhood, Rng};
use crate::snapshot::{LARGEST, clipped, stored};

/// A prototype's factor is folded into its weights when it falls below this: far above the point
/// where dividing by it loses digits, and rare enough to cost little.
pub(super) const SMALLEST_SCALE: f32 = 1.0 / 1024.0;

/// Nodes whose sums are made together: with as many weights they fill the registers of an FPU.
const LANES: usize = 16;

/// Neighbours that are moved together; bounds the stack.
const RUN: usize = 8;

/// Features on up to which a stimulus is searched for in one pass.
const GATHERED: usize = 16;

/// A self-organizing map of `WIDTH` × `HEIGHT` prototypes over `FEATURES` binary features.
///
/// ```
/// use cla_core::num::{Neighbourhood, Rng};
/// use cla_core::som::{BinarySom, Grid, SparseStimulus, best_match};
///
/// let mut som = BinarySom::<4, 4, 8>::new();
/// som.randomize(&mut Rng::new(1));
/// let stimulus = SparseStimulus { on: &[0b0100_0010], minus: &[], unknown: &[] };
/// let mut scratch = Grid::filled(0.0);
/// let mut distances = Grid::filled(0.0);
/// som.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
/// let winner = best_match(&distances).node;
/// som.train(&stimulus, winner, 1.0, &Neighbourhood::winner_only(), |_| true);
/// assert_eq!((som.weight(winner, 1), som.weight(winner, 2)), (1.0, 0.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BinarySom<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> {
    /// v, feature by feature; a weight is `scale · v`.
    columns: [Grid<f32, WIDTH, HEIGHT>; FEATURES],
    /// s of each node.
    pub(crate) scale: Grid<f32, WIDTH, HEIGHT>,
    /// |m|² of each node.
    pub(super) squared_norm: Grid<f32, WIDTH, HEIGHT>,
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>
    BinarySom<WIDTH, HEIGHT, FEATURES>
{
    /// A map of all-zero memory, so that a static one costs no flash.
    ///
    /// Call [`randomize`](Self::randomize) before training.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                FEATURES > 0 && FEATURES <= u16::MAX as usize,
                "a map has 1 to 65,535 features"
            );
        }
        Self {
            columns: [const { Grid::filled(0.0) }; FEATURES],
            scale: Grid::filled(0.0),
            squared_norm: Grid::filled(0.0),
        }
    }

    /// Draws every weight from `[0, 1)`, feature by feature.
    pub fn randomize(&mut self, rng: &mut Rng) {
        self.scale.as_mut_slice().fill(1.0);
        self.squared_norm.as_mut_slice().fill(0.0);
        for column in &mut self.columns {
            let norms = self.squared_norm.as_mut_slice().iter_mut();
            for (weight, norm) in column.as_mut_slice().iter_mut().zip(norms) {
                *weight = rng.unit();
                *norm += *weight * *weight;
            }
        }
    }

    /// One weight; 0 for a node or feature outside the map.
    #[must_use]
    pub fn weight(&self, node: NodeId, feature: u16) -> f32 {
        let index = usize::from(node.0);
        let value = self
            .columns
            .get(usize::from(feature))
            .and_then(|c| c.as_slice().get(index));
        match (value, self.scale.as_slice().get(index)) {
            (Some(value), Some(scale)) => scale * value,
            _ => 0.0,
        }
    }

    /// Writes ‖x − m‖² (over the known features) of every node into `distances`.
    ///
    /// `scratch` is overwritten.
    /// A squared distance that rounding would make negative counts as 0.
    /// Features outside the map are left out.
    pub fn squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        self.distances(stimulus, scratch, distances, |total, own| *total = own);
    }

    /// As [`squared_distances`](Self::squared_distances), but adds `factor` times the distance to
    /// what is there.
    ///
    /// `factor` lies in `[0, 1e20]`; another number counts as the nearest of these, NaN as 0.
    pub fn add_squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        factor: f32,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        let factor = clipped(factor, LARGEST);
        self.distances(stimulus, scratch, distances, |total, own| {
            *total += factor * own;
        });
    }

    fn distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
        put: impl Fn(&mut f32, f32),
    ) {
        let mut on = heapless::Vec::<_, GATHERED, u8>::new();
        let few = stimulus
            .on()
            .filter_map(|j| self.columns.get(usize::from(j)))
            .all(|column| on.push(column).is_ok());
        if few && stimulus.minus().next().is_none() && stimulus.unknown().next().is_none() {
            self.distances_of_few(&on, distances, put);
        } else {
            self.distances_of_any(stimulus, scratch, distances, put);
        }
    }

    /// The common case: the sums of a block of nodes stay in registers until they are distances.
    fn distances_of_few(
        &self,
        on: &[&Grid<f32, WIDTH, HEIGHT>],
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
        put: impl Fn(&mut f32, f32),
    ) {
        let length = on.len() as f32;
        let (totals, last_totals) = distances.as_mut_slice().as_chunks_mut::<LANES>();
        let (scales, last_scales) = self.scale.as_slice().as_chunks::<LANES>();
        let (norms, last_norms) = self.squared_norm.as_slice().as_chunks::<LANES>();
        let Some((first, others)) = on.split_first() else {
            for (total, &norm) in distances
                .as_mut_slice()
                .iter_mut()
                .zip(self.squared_norm.as_slice())
            {
                put(total, not_below_zero(norm));
            }
            return;
        };
        let (first, last) = first.as_slice().as_chunks::<LANES>();
        let nodes = totals.iter_mut().zip(scales).zip(norms).zip(first);
        for (block, (((totals, scales), norms), first)) in nodes.enumerate() {
            let mut sums = *first;
            for column in others {
                if let Some(values) = column.as_slice().as_chunks::<LANES>().0.get(block) {
                    for (sum, value) in sums.iter_mut().zip(values) {
                        *sum += value;
                    }
                }
            }
            finish(totals, &sums, scales, norms, length, &put);
        }
        let mut sums = [0.0; LANES];
        for (sum, value) in sums.iter_mut().zip(last) {
            *sum = *value;
        }
        for column in others {
            let (_, values) = column.as_slice().as_chunks::<LANES>();
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += value;
            }
        }
        finish(last_totals, &sums, last_scales, last_norms, length, &put);
    }

    /// Any stimulus, feature by feature; the same sums in the same order, so the same bits.
    fn distances_of_any(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
        put: impl Fn(&mut f32, f32),
    ) {
        let dots = scratch.as_mut_slice();
        dots.fill(0.0);
        let mut length = 0.0;
        for column in stimulus
            .on()
            .filter_map(|j| self.columns.get(usize::from(j)))
        {
            length += 1.0;
            for (dot, value) in dots.iter_mut().zip(column.as_slice()) {
                *dot += value;
            }
        }
        for column in stimulus
            .minus()
            .filter_map(|j| self.columns.get(usize::from(j)))
        {
            length += 1.0;
            for (dot, value) in dots.iter_mut().zip(column.as_slice()) {
                *dot -= value;
            }
        }
        let nodes = self
            .scale
            .as_slice()
            .iter()
            .zip(self.squared_norm.as_slice());
        for (dot, (scale, norm)) in dots.iter_mut().zip(nodes) {
            *dot = norm - 2.0 * scale * *dot + length;
        }
        for column in stimulus
            .unknown()
            .filter_map(|j| self.columns.get(usize::from(j)))
        {
            let nodes = self.scale.as_slice().iter().zip(column.as_slice());
            for (distance, (scale, value)) in dots.iter_mut().zip(nodes) {
                let weight = scale * value;
                *distance -= weight * weight;
            }
        }
        for (total, &own) in distances.as_mut_slice().iter_mut().zip(dots.iter()) {
            put(total, not_below_zero(own));
        }
    }

    /// Moves the prototypes around `winner` towards the stimulus: m ← m + α·h·(x − m) on known
    /// features, for the nodes that `may_move` lets.
    ///
    /// `alpha` lies in `[0, 1]`; another one, and a winner outside the map, change nothing.
    pub fn train(
        &mut self,
        stimulus: &SparseStimulus<'_>,
        winner: NodeId,
        alpha: f32,
        neighbourhood: &Neighbourhood<WIDTH, HEIGHT>,
        may_move: impl Fn(NodeId) -> bool,
    ) {
        if usize::from(winner.0) >= Grid::<f32, WIDTH, HEIGHT>::NODES
            || !(0.0..=1.0).contains(&alpha)
        {
            return;
        }
        let (column, row) = self.scale.position(winner);
        let top = row.saturating_sub(neighbourhood.vertical_radius());
        let left = column.saturating_sub(neighbourhood.horizontal_radius());
        let bottom = (row + neighbourhood.vertical_radius()).min(HEIGHT - 1);
        let right = (column + neighbourhood.horizontal_radius()).min(WIDTH - 1);
        let plain = stimulus.unknown().next().is_none();
        let mut run = Run::new();
        for y in top..=bottom {
            run.first = y * WIDTH + left;
            for x in left..=right {
                let node = NodeId((y * WIDTH + x) as u16);
                if run.nodes == RUN {
                    self.move_run(stimulus, &mut run);
                    run.first = y * WIDTH + x;
                }
                if may_move(node) {
                    let c = alpha * neighbourhood.weight(x.abs_diff(column), y.abs_diff(row));
                    if plain && self.enter(&mut run, c) {
                        continue;
                    }
                    self.step(stimulus, node, c);
                }
                self.move_run(stimulus, &mut run);
                run.first = y * WIDTH + x + 1;
            }
            self.move_run(stimulus, &mut run);
        }
    }

    /// Takes the next node into a run and decays its prototype; not one that is due for folding.
    fn enter(&mut self, run: &mut Run, c: f32) -> bool {
        let index = run.first + run.nodes;
        let place = run.steps.get_mut(run.nodes);
        if let (Some(step), Some(scale)) = (place, self.scale.as_mut_slice().get_mut(index)) {
            let (before, keep) = (*scale, 1.0 - c);
            let after = before * keep;
            if after >= SMALLEST_SCALE {
                *scale = after;
                *step = Step {
                    c,
                    before,
                    amount: c / after,
                    dot: 0.0,
                };
                run.nodes += 1;
                return true;
            }
        }
        false
    }

    /// What [`step`](Self::step) does after the decay, for neighbours in a row at once: column by
    /// column instead of node by node, each node's sums in the same order.
    fn move_run(&mut self, stimulus: &SparseStimulus<'_>, run: &mut Run) {
        let nodes = run.first..run.first + run.nodes;
        let steps = match run.steps.get_mut(..run.nodes) {
            Some(steps) if !steps.is_empty() => steps,
            _ => return,
        };
        run.nodes = 0;
        let mut length = 0.0;
        for j in stimulus.on() {
            let column = self.columns.get_mut(usize::from(j));
            if let Some(values) = column.and_then(|it| it.as_mut_slice().get_mut(nodes.clone())) {
                length += 1.0;
                for (value, step) in values.iter_mut().zip(steps.iter_mut()) {
                    step.dot += *value;
                    *value += step.amount;
                }
            }
        }
        for j in stimulus.minus() {
            let column = self.columns.get_mut(usize::from(j));
            if let Some(values) = column.and_then(|it| it.as_mut_slice().get_mut(nodes.clone())) {
                length += 1.0;
                for (value, step) in values.iter_mut().zip(steps.iter_mut()) {
                    step.dot -= *value;
                    *value -= step.amount;
                }
            }
        }
        if let Some(norms) = self.squared_norm.as_mut_slice().get_mut(nodes) {
            for (norm, step) in norms.iter_mut().zip(steps) {
                *norm = step.norm_after(*norm, 0.0, length);
            }
        }
    }

    /// Makes a node's prototype the stimulus itself; unknown features become ½, neither on nor off.
    pub fn imprint(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId) {
        let index = usize::from(node.0);
        let Some(scale) = self.scale.as_mut_slice().get_mut(index) else {
            return;
        };
        *scale = 1.0;
        for (j, column) in self.columns.iter_mut().enumerate() {
            if let Some(value) = column.as_mut_slice().get_mut(index) {
                *value = if stimulus.is_unknown(j as u16) {
                    0.5
                } else {
                    0.0
                };
            }
        }
        self.add(stimulus, index, 1.0);
        self.recompute_norm(index);
    }

    /// Makes all weights of a node ½.
    pub(super) fn know_nothing(&mut self, node: NodeId) {
        let index = usize::from(node.0);
        if let Some(scale) = self.scale.as_mut_slice().get_mut(index) {
            *scale = 1.0;
        }
        for column in &mut self.columns {
            if let Some(value) = column.as_mut_slice().get_mut(index) {
                *value = 0.5;
            }
        }
        self.recompute_norm(index);
    }

    /// m ← (1 − c)·m + c·x on the known features of one node.
    ///
    /// Rare, and in a frame of its own: it shall not deepen the stack of every update.
    #[inline(never)]
    fn step(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId, c: f32) {
        let index = usize::from(node.0);
        let keep = 1.0 - c;
        let Some(scale) = self.scale.as_mut_slice().get_mut(index) else {
            return;
        };
        let before = *scale;
        let after = before * keep;
        if after < SMALLEST_SCALE {
            self.fold(stimulus, index, keep);
            self.add(stimulus, index, c);
            self.recompute_norm(index);
            return;
        }
        *scale = after;
        let mut unknown_norm = 0.0;
        for j in stimulus.unknown() {
            if let Some(value) = value_mut(&mut self.columns, j, index) {
                let weight = before * *value;
                unknown_norm += weight * weight;
                *value = weight / after;
            }
        }
        let (dot, length) = self.add(stimulus, index, c / after);
        if let Some(norm) = self.squared_norm.as_mut_slice().get_mut(index) {
            let step = Step {
                c,
                before,
                amount: c / after,
                dot,
            };
            *norm = step.norm_after(*norm, unknown_norm, length);
        }
    }

    /// Adds `amount` times the stimulus to v; returns Σ v_j·x_j before that, and |x|².
    fn add(&mut self, stimulus: &SparseStimulus<'_>, index: usize, amount: f32) -> (f32, f32) {
        let mut dot = 0.0;
        let mut length = 0.0;
        for j in stimulus.on() {
            if let Some(value) = value_mut(&mut self.columns, j, index) {
                dot += *value;
                length += 1.0;
                *value += amount;
            }
        }
        for j in stimulus.minus() {
            if let Some(value) = value_mut(&mut self.columns, j, index) {
                dot -= *value;
                length += 1.0;
                *value -= amount;
            }
        }
        (dot, length)
    }

    /// Makes the node's factor 1, with the known weights times `keep`.
    fn fold(&mut self, stimulus: &SparseStimulus<'_>, index: usize, keep: f32) {
        let Some(scale) = self.scale.as_mut_slice().get_mut(index) else {
            return;
        };
        let before = *scale;
        *scale = 1.0;
        for (j, column) in self.columns.iter_mut().enumerate() {
            if let Some(value) = column.as_mut_slice().get_mut(index) {
                let unknown = stimulus.is_unknown(j as u16);
                *value *= if unknown { before } else { before * keep };
            }
        }
    }

    fn recompute_norm(&mut self, index: usize) {
        let mut total = 0.0;
        for value in self
            .columns
            .iter()
            .filter_map(|column| column.as_slice().get(index))
        {
            total += value * value;
        }
        if let Some(norm) = self.squared_norm.as_mut_slice().get_mut(index) {
            *norm = total;
        }
    }
}

/// Neighbours in a row that move together.
struct Run {
    /// Index of the first node.
    first: usize,
    nodes: usize,
    steps: [Step; RUN],
}

impl Run {
    const fn new() -> Self {
        Self {
            first: 0,
            nodes: 0,
            steps: [Step {
                c: 0.0,
                before: 0.0,
                amount: 0.0,
                dot: 0.0,
            }; RUN],
        }
    }
}

/// How far one node moves.
#[derive(Clone, Copy)]
struct Step {
    /// The share of the way.
    c: f32,
    /// The factor before.
    before: f32,
    /// What a feature that is on adds to v.
    amount: f32,
    /// Σ v_j·x_j before.
    dot: f32,
}

impl Step {
    /// (1 − c)²·|m|² + 2c(1 − c)·m·x + c²·|x|² over the known features; the unknown keep theirs.
    fn norm_after(&self, norm: f32, unknown: f32, length: f32) -> f32 {
        let Self { c, before, dot, .. } = *self;
        let keep = 1.0 - c;
        let known = norm - unknown;
        keep * keep * known + 2.0 * c * keep * before * dot + c * c * length + unknown
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Default
    for BinarySom<WIDTH, HEIGHT, FEATURES>
{
    fn default() -> Self {
        Self::new()
    }
}

/// The number, or 0 for a negative one: no comparison, whose flags cost an FPU two instructions more.
#[inline(always)]
fn not_below_zero(x: f32) -> f32 {
    let bits = x.to_bits();
    f32::from_bits(bits & !((bits as i32 >> 31) as u32))
}

/// Sums of weights become squared distances.
#[inline(always)]
fn finish(
    totals: &mut [f32],
    sums: &[f32],
    scales: &[f32],
    norms: &[f32],
    length: f32,
    put: impl Fn(&mut f32, f32),
) {
    for (((total, sum), scale), norm) in totals.iter_mut().zip(sums).zip(scales).zip(norms) {
        let own = norm - 2.0 * scale * sum + length;
        put(total, not_below_zero(own));
    }
}

fn value_mut<const WIDTH: usize, const HEIGHT: usize>(
    columns: &mut [Grid<f32, WIDTH, HEIGHT>],
    feature: u16,
    index: usize,
) -> Option<&mut f32> {
    columns
        .get_mut(usize::from(feature))
        .and_then(|column| column.as_mut_slice().get_mut(index))
}

stored! {
    impl[const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize]
    BinarySom<WIDTH, HEIGHT, FEATURES> {
        columns => within 2.0 / SMALLEST_SCALE,
        scale => within 1.0,
        squared_norm => within 2.0 * u16::MAX as f32,
    }
}

#[cfg(test)]
#[path = "binary_tests.rs"]
mod tests;
