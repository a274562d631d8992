//! The map for binary stimuli with a byte for each weight: a quarter of the memory of `f32`.
//!
//! Weights are integers in −127 … 127 for −1 … 1; updates round at random, so that a step smaller
//! than 1/127 still moves a weight on average (to nearest, late training would stand still).
//! Integer arithmetic only between a stimulus and a weight: the same bits on every target.
//! [`BinarySom`](super::BinarySom) is the reference; this is a numerics of its own.

use super::column::{Column, GATHERED, LANES, add_up, add_up_last, add_up_signed};
use super::grid::{BestMatch, Grid, NodeId};
use super::prototypes::Prototypes;
use super::stimulus::SparseStimulus;
use crate::num::{Neighbourhood, Ones, Rng};
use crate::snapshot::{Flip, LARGEST, Mender, Reader, Stored, Writer, clipped};

/// The integer that stands for a weight of 1.
const ONE: i32 = 127;
/// Fractional bits of the step c = α·h.
const STEP_BITS: u32 = 16;

/// What a map of bytes keeps of its |m|²: all of them, four bytes a node, or with `()` nothing, so that
/// every search adds the squares of all weights.
///
/// ```
/// use cla_core::som::{ByteSom, Grid};
/// type Lean = ByteSom<20, 20, 142, ()>;
/// assert_eq!(size_of::<ByteSom<20, 20, 142>>(), size_of::<Lean>() + size_of::<Grid<i32, 20, 20>>());
/// ```
pub trait Norms<const WIDTH: usize, const HEIGHT: usize>: Clone + core::fmt::Debug {
    /// None of any node.
    const ZERO: Self;

    /// (127·|m|)² of all nodes, if they are kept.
    fn kept(&self) -> Option<&Grid<i32, WIDTH, HEIGHT>>;

    /// The same, to change.
    fn kept_mut(&mut self) -> Option<&mut Grid<i32, WIDTH, HEIGHT>>;
}

impl<const WIDTH: usize, const HEIGHT: usize> Norms<WIDTH, HEIGHT> for Grid<i32, WIDTH, HEIGHT> {
    const ZERO: Self = Self::filled(0);

    fn kept(&self) -> Option<&Self> {
        Some(self)
    }

    fn kept_mut(&mut self) -> Option<&mut Self> {
        Some(self)
    }
}

impl<const WIDTH: usize, const HEIGHT: usize> Norms<WIDTH, HEIGHT> for () {
    const ZERO: Self = ();

    fn kept(&self) -> Option<&Grid<i32, WIDTH, HEIGHT>> {
        None
    }

    fn kept_mut(&mut self) -> Option<&mut Grid<i32, WIDTH, HEIGHT>> {
        None
    }
}

/// A self-organizing map of `WIDTH` × `HEIGHT` prototypes over `FEATURES` binary features, a byte
/// for each weight.
///
/// `N` says whether |m|² is kept; distances and lives are the same.
///
/// ```
/// use cla_core::num::{Neighbourhood, Rng};
/// use cla_core::som::{ByteSom, Grid, Prototypes, SparseStimulus, best_match};
///
/// let mut som = ByteSom::<4, 4, 8>::ZERO;
/// som.randomize(&mut Rng::new(1));
/// let stimulus = SparseStimulus { on: &[0b0100_0010], minus: &[], unknown: &[] };
/// let mut scratch = Grid::filled(0.0);
/// let mut distances = Grid::filled(0.0);
/// som.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
/// let winner = best_match(&distances).node;
/// som.train(&stimulus, winner, 1.0, &Neighbourhood::winner_only(), |_| true);
/// assert_eq!((som.weight(winner, 1), som.weight(winner, 2)), (1.0, 0.0));
/// ```
#[derive(Clone, Debug)]
pub struct ByteSom<
    const WIDTH: usize,
    const HEIGHT: usize,
    const FEATURES: usize,
    N = Grid<i32, WIDTH, HEIGHT>,
> {
    columns: [Column<WIDTH, HEIGHT>; FEATURES],
    /// State of the generator that rounds; never 0 after `randomize`.
    noise: u32,
    /// (127·|m|)² of every node.
    norms: N,
    /// Whether a weight may be below 0: some stimulus had a feature at −1.
    signed: bool,
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize, N: Norms<WIDTH, HEIGHT>>
    Prototypes<WIDTH, HEIGHT> for ByteSom<WIDTH, HEIGHT, FEATURES, N>
{
    const ZERO: Self = {
        assert!(
            FEATURES > 0 && FEATURES <= u16::MAX as usize,
            "a map has 1 to 65,535 features"
        );
        Self {
            columns: [const { Column::ZERO }; FEATURES],
            noise: 0,
            norms: N::ZERO,
            signed: false,
        }
    };
    const STORED_AS: u8 = 2;

    fn randomize(&mut self, rng: &mut Rng) {
        self.noise = rng.next_u32() | 1;
        for column in &mut self.columns {
            for weight in column.as_mut_slice() {
                *weight = rng.below(ONE as u32) as i8;
            }
        }
        self.derive();
    }

    fn weight(&self, node: NodeId, feature: u16) -> f32 {
        let column = self.columns.get(usize::from(feature));
        let weight = column.and_then(|it| it.as_slice().get(usize::from(node.0)));
        weight.map_or(0.0, |&weight| f32::from(weight) / ONE as f32)
    }

    fn squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        let unit = 1.0 / (ONE * ONE) as f32;
        let mut totals = distances.as_mut_slice().iter_mut();
        self.each_sum(stimulus, scratch, |length, sums| {
            for (sum, total) in sums.iter().zip(totals.by_ref()) {
                *total = unit * sum.wrapping_add(length) as f32;
            }
        });
    }

    fn add_squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        factor: f32,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        let unit = clipped(factor, LARGEST) / (ONE * ONE) as f32;
        let mut totals = distances.as_mut_slice().iter_mut();
        self.each_sum(stimulus, scratch, |length, sums| {
            for (sum, total) in sums.iter().zip(totals.by_ref()) {
                *total += unit * sum.wrapping_add(length) as f32;
            }
        });
    }

    /// Whole numbers are compared; one becomes a float.
    fn best_match(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        _distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) -> BestMatch {
        let mut best = (0_u32, i32::MAX, 0);
        let mut first = 0_u32;
        self.each_sum(stimulus, scratch, |length, sums| {
            // A nearer one is rare: the four are asked first, and the search among them is apart.
            if sums.iter().any(|&sum| sum < best.1) {
                best = nearest(best, first, length, sums);
            }
            first += LANES as u32;
        });
        let (node, sum, length) = best;
        BestMatch {
            node: NodeId(node as u16),
            squared_distance: 1.0 / (ONE * ONE) as f32 * sum.wrapping_add(length) as f32,
        }
    }

    fn train(
        &mut self,
        stimulus: &SparseStimulus<'_>,
        winner: NodeId,
        alpha: f32,
        neighbourhood: &Neighbourhood<WIDTH, HEIGHT>,
        may_move: impl Fn(NodeId) -> bool,
    ) {
        if usize::from(winner.0) >= Grid::<i8, WIDTH, HEIGHT>::NODES
            || !(0.0..=1.0).contains(&alpha)
        {
            return;
        }
        self.signed |= has_minus(stimulus);
        let (column, row) = Grid::<i8, WIDTH, HEIGHT>::filled(0).position(winner);
        let top = row.saturating_sub(neighbourhood.vertical_radius());
        let left = column.saturating_sub(neighbourhood.horizontal_radius());
        let bottom = (row + neighbourhood.vertical_radius()).min(HEIGHT - 1);
        let right = (column + neighbourhood.horizontal_radius()).min(WIDTH - 1);
        for y in top..=bottom {
            for x in left..=right {
                let node = NodeId((y * WIDTH + x) as u16);
                if may_move(node) {
                    let near = neighbourhood.weight(x.abs_diff(column), y.abs_diff(row));
                    self.step(stimulus, node, alpha * near);
                }
            }
        }
    }

    fn audit(&mut self, node: NodeId) -> bool {
        let index = usize::from(node.0);
        let mut sound = true;
        let mut norm = 0_i32;
        for column in &self.columns {
            let weight = i32::from(column.as_slice().get(index).copied().unwrap_or(0));
            sound &= -ONE <= weight && (weight >= 0 || self.signed);
            norm = norm.wrapping_add(weight * weight);
        }
        if !sound {
            self.know_nothing(node);
            return true;
        }
        let kept = self.norms.kept_mut();
        match kept.and_then(|it| it.as_mut_slice().get_mut(index)) {
            Some(kept) if *kept != norm => {
                *kept = norm;
                true
            }
            _ => false,
        }
    }

    fn rebuild(&mut self) {
        self.derive();
    }

    fn audit_whole(&mut self) -> bool {
        let stands = self.noise == 0;
        self.noise |= u32::from(stands);
        stands
    }

    fn imprint(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId) {
        self.signed |= has_minus(stimulus);
        let mut norm = 0_i32;
        for (feature, column) in self.columns.iter_mut().enumerate() {
            let feature = feature as u16;
            let target = if stimulus.is_unknown(feature) {
                ONE / 2
            } else {
                target_of(stimulus, feature)
            };
            norm = norm.wrapping_add(target * target);
            if let Some(weight) = column.as_mut_slice().get_mut(usize::from(node.0)) {
                *weight = target as i8;
            }
        }
        let kept = self.norms.kept_mut();
        if let Some(kept) = kept.and_then(|it| it.as_mut_slice().get_mut(usize::from(node.0))) {
            *kept = norm;
        }
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize, N: Norms<WIDTH, HEIGHT>>
    ByteSom<WIDTH, HEIGHT, FEATURES, N>
{
    /// Shows (127·‖x − m‖)² of every node over the known features, |m|² − 2·Σ m_j·x_j + |x|², four
    /// nodes at a time and in their order: |x|², which is that of all, and the rest.
    ///
    /// Whole numbers, in an `i32` for up to 33,000 features; those of more than 1000 features may
    /// be rounded when they become floats.
    #[inline(always)]
    fn each_sum(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        mut see: impl FnMut(i32, &[i32]),
    ) {
        let mut on = heapless::Vec::<_, GATHERED, u8>::new();
        let few = self.of(stimulus.on()).all(|column| on.push(column).is_ok())
            && stimulus.minus().next().is_none()
            && stimulus.unknown().next().is_none();
        match self.norms.kept() {
            Some(norms) if few && !self.signed => sums_of_few(norms, &on, see),
            _ => {
                self.sums_of_any(stimulus, scratch);
                for sums in scratch.as_slice().chunks(LANES) {
                    let mut some = [0; LANES];
                    for (own, sum) in some.iter_mut().zip(sums) {
                        *own = sum.to_bits() as i32;
                    }
                    see(0, some.get(..sums.len()).unwrap_or(&[]));
                }
            }
        }
    }

    /// The columns of features that the map has.
    fn of(&self, features: Ones<'_>) -> impl Iterator<Item = &Column<WIDTH, HEIGHT>> {
        features.filter_map(|j| self.columns.get(usize::from(j)))
    }

    /// Any stimulus, whatever is kept: `sums` become the bits of whole numbers, for the scratch memory
    /// is one of floats for all maps.
    #[inline(never)]
    fn sums_of_any(&self, stimulus: &SparseStimulus<'_>, sums: &mut Grid<f32, WIDTH, HEIGHT>) {
        let features = self.of(stimulus.on()).count() + self.of(stimulus.minus()).count();
        let length = (features as i32).wrapping_mul(ONE * ONE);
        if let Some(norms) = self.norms.kept() {
            for (sum, norm) in sums.as_mut_slice().iter_mut().zip(norms.as_slice()) {
                *sum = f32::from_bits(norm.wrapping_add(length) as u32);
            }
        } else {
            sums.as_mut_slice().fill(f32::from_bits(length as u32));
            for column in &self.columns {
                add_squares(column, 1, sums);
            }
        }
        self.add_those(stimulus.on(), -2 * ONE, sums);
        self.add_those(stimulus.minus(), 2 * ONE, sums);
        for column in self.of(stimulus.unknown()) {
            add_squares(column, -1, sums);
        }
    }

    /// Adds `factor` times each weight of the features, some features at a time.
    fn add_those(&self, mut features: Ones<'_>, factor: i32, sums: &mut Grid<f32, WIDTH, HEIGHT>) {
        loop {
            let columns = features.by_ref();
            let columns = columns.filter_map(|j| self.columns.get(usize::from(j)));
            let some: heapless::Vec<_, GATHERED, u8> = columns.take(GATHERED).collect();
            if some.is_empty() {
                return;
            }
            let add = |sums: &mut [f32], lanes: [i32; LANES]| {
                for (sum, own) in sums.iter_mut().zip(lanes) {
                    let all = (sum.to_bits() as i32).wrapping_add(factor.wrapping_mul(own));
                    *sum = f32::from_bits(all as u32);
                }
            };
            let (blocks, last) = sums.as_mut_slice().as_chunks_mut::<LANES>();
            for (block, sums) in blocks.iter_mut().enumerate() {
                add(sums, add_up_signed(&some, block));
            }
            add(last, add_up_last(&some));
        }
    }

    /// m ← m + c·(x − m) on the known features of one node, rounded at random.
    #[inline(never)]
    fn step(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId, c: f32) {
        let c = (c * (1 << STEP_BITS) as f32) as i32;
        let index = usize::from(node.0);
        let mut noise = self.noise;
        let mut norm = 0_i32;
        for (word, columns) in self.columns.chunks_mut(32).enumerate() {
            let bits = |words: &[u32]| words.get(word).copied().unwrap_or(0);
            let [mut on, mut minus, mut unknown] =
                [stimulus.on, stimulus.minus, stimulus.unknown].map(bits);
            let weights = columns
                .iter_mut()
                .filter_map(|it| it.as_mut_slice().get_mut(index));
            if minus | unknown == 0 {
                // The loop of almost all stimuli, whose numbers all have room in registers.
                for weight in weights {
                    let moved = move_towards(ONE * (on & 1) as i32, *weight, c, &mut noise);
                    on >>= 1;
                    norm = norm.wrapping_add(moved * moved);
                    *weight = moved as i8;
                }
                continue;
            }
            for weight in weights {
                let target = ONE * ((on & 1) as i32 - (minus & 1) as i32);
                let moved = if unknown & 1 == 0 {
                    move_towards(target, *weight, c, &mut noise)
                } else {
                    i32::from(*weight)
                };
                (on, minus, unknown) = (on >> 1, minus >> 1, unknown >> 1);
                norm = norm.wrapping_add(moved * moved);
                *weight = moved as i8;
            }
        }
        self.noise = noise;
        let kept = self.norms.kept_mut();
        if let Some(kept) = kept.and_then(|it| it.as_mut_slice().get_mut(index)) {
            *kept = norm;
        }
    }

    /// Makes all weights of a node ½.
    fn know_nothing(&mut self, node: NodeId) {
        let index = usize::from(node.0);
        for column in &mut self.columns {
            if let Some(weight) = column.as_mut_slice().get_mut(index) {
                *weight = (ONE / 2) as i8;
            }
        }
        let kept = self.norms.kept_mut();
        if let Some(kept) = kept.and_then(|it| it.as_mut_slice().get_mut(index)) {
            *kept = (FEATURES as i32).wrapping_mul((ONE / 2) * (ONE / 2));
        }
    }

    /// Makes what follows from the weights anew.
    fn derive(&mut self) {
        let all = self.columns.iter().flat_map(|it| it.as_slice());
        self.signed = all.fold(false, |signed, &weight| signed | (weight < 0));
        if let Some(norms) = self.norms.kept_mut() {
            norms.as_mut_slice().fill(0);
            for column in &self.columns {
                for (norm, &weight) in norms.as_mut_slice().iter_mut().zip(column.as_slice()) {
                    *norm = norm.wrapping_add(i32::from(weight) * i32::from(weight));
                }
            }
        }
    }
}

/// A weight that has gone the share `c` / 2¹⁶ of its way to a target, rounded at random; where there is
/// no way, no number is drawn.
#[inline(always)]
fn move_towards(target: i32, weight: i8, c: i32, noise: &mut u32) -> i32 {
    let before = i32::from(weight);
    let difference = target - before;
    if difference == 0 {
        return before;
    }
    *noise ^= *noise << 13;
    *noise ^= *noise >> 17;
    *noise ^= *noise << 5;
    let rounding = (*noise >> (32 - STEP_BITS)) as i32;
    // At most 2¹⁶ · 254 + 2¹⁶: inside i32; the result lies between weight and target.
    before + ((c * difference + rounding) >> STEP_BITS)
}

/// The common case: few features on, no weight below 0; the sums of a block of nodes stay in registers.
#[inline(always)]
fn sums_of_few<const WIDTH: usize, const HEIGHT: usize>(
    norms: &Grid<i32, WIDTH, HEIGHT>,
    on: &[&Column<WIDTH, HEIGHT>],
    mut see: impl FnMut(i32, &[i32]),
) {
    let length = on.len() as i32 * ONE * ONE;
    let (blocks, last) = norms.as_slice().as_chunks::<LANES>();
    for (block, norms) in blocks.iter().enumerate() {
        let mut sums = add_up(on, block);
        for (sum, norm) in sums.iter_mut().zip(norms) {
            *sum = norm.wrapping_sub(2 * ONE * *sum);
        }
        see(length, &sums);
    }
    let mut sums = add_up_last(on);
    for (sum, norm) in sums.iter_mut().zip(last) {
        *sum = norm.wrapping_sub(2 * ONE * *sum);
    }
    see(length, sums.get(..last.len()).unwrap_or(&[]));
}

/// Adds `sign` times the square of each weight to sums that are the bits of whole numbers.
fn add_squares<const WIDTH: usize, const HEIGHT: usize>(
    column: &Column<WIDTH, HEIGHT>,
    sign: i32,
    sums: &mut Grid<f32, WIDTH, HEIGHT>,
) {
    for (sum, &weight) in sums.as_mut_slice().iter_mut().zip(column.as_slice()) {
        let square = sign * i32::from(weight) * i32::from(weight);
        *sum = f32::from_bits((sum.to_bits() as i32).wrapping_add(square) as u32);
    }
}

/// The nearest of what is known and of some nodes from `first` on: node, sum without |x|², and |x|².
#[cold]
#[inline(never)]
fn nearest(best: (u32, i32, i32), first: u32, length: i32, sums: &[i32]) -> (u32, i32, i32) {
    let mut nearest = best;
    for (node, &sum) in (first..).zip(sums) {
        if sum < nearest.1 {
            nearest = (node, sum, length);
        }
    }
    nearest
}

/// Whether any feature is at −1.
fn has_minus(stimulus: &SparseStimulus<'_>) -> bool {
    stimulus.minus().next().is_some()
}

/// What a known feature is: −127, 0 or 127.
fn target_of(stimulus: &SparseStimulus<'_>, feature: u16) -> i32 {
    let bit = |words: &[u32]| match words.get(usize::from(feature / 32)) {
        Some(word) => (word >> (feature % 32) & 1) as i32,
        None => 0,
    };
    ONE * (bit(stimulus.on) - bit(stimulus.minus))
}

/// Two maps are equal that have the same weights and round alike; the rest follows.
impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize, N> PartialEq
    for ByteSom<WIDTH, HEIGHT, FEATURES, N>
{
    fn eq(&self, other: &Self) -> bool {
        self.columns == other.columns && self.noise == other.noise
    }
}

/// The weights and the generator; what is kept of |m|² is made again.
impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize, N: Norms<WIDTH, HEIGHT>> Stored
    for ByteSom<WIDTH, HEIGHT, FEATURES, N>
{
    const BLANK: Self = <Self as Prototypes<WIDTH, HEIGHT>>::ZERO;

    fn store(&self, to: &mut Writer<'_>) {
        self.columns.store(to);
        self.noise.store(to);
        to.require(self.noise != 0);
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        self.columns.restore(from);
        self.noise.restore(from);
        from.require(self.noise != 0);
        self.derive();
    }

    fn check(from: &mut Reader<'_>) {
        <[Column<WIDTH, HEIGHT>; FEATURES]>::check(from);
        let mut noise = 0_u32;
        noise.restore(from);
        from.require(noise != 0);
    }

    fn mend(&mut self, by: &mut Mender) {
        if self.audit_whole() {
            by.count();
        }
    }

    fn flip(&mut self, by: &mut Flip) {
        self.columns.flip(by);
        self.noise.flip(by);
        if by.sees_derived() {
            self.signed.flip(by);
            if let Some(norms) = self.norms.kept_mut() {
                norms.flip(by);
            }
        }
    }
}

#[cfg(test)]
#[path = "byte_tests.rs"]
mod tests;
