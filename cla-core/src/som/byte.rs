//! The map for binary stimuli with a byte for each weight: a quarter of the memory of `f32`.
//!
//! Weights are integers in −127 … 127 for −1 … 1; updates round at random, so that a step smaller
//! than 1/127 still moves a weight on average (to nearest, late training would stand still).
//! Integer arithmetic only between a stimulus and a weight: the same bits on every target.
//! [`BinarySom`](super::BinarySom) is the reference; this is a numerics of its own.

use super::grid::{Grid, NodeId};
use super::prototypes::Prototypes;
use super::stimulus::SparseStimulus;
use crate::num::{Neighbourhood, Ones, Rng};
use crate::snapshot::stored;

/// The integer that stands for a weight of 1.
const ONE: i32 = 127;
/// Fractional bits of the step c = α·h.
const STEP_BITS: u32 = 16;
/// Nodes whose sums are made together: as many as have room in the registers of the smallest part.
const LANES: usize = 4;
/// Features whose columns are added in one pass.
const GATHERED: usize = 16;

/// A self-organizing map of `WIDTH` × `HEIGHT` prototypes over `FEATURES` binary features, a byte
/// for each weight.
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
#[derive(Clone, Debug, PartialEq)]
pub struct ByteSom<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> {
    columns: [Grid<i8, WIDTH, HEIGHT>; FEATURES],
    /// State of the generator that rounds; never 0 after `randomize`.
    noise: u32,
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Prototypes<WIDTH, HEIGHT>
    for ByteSom<WIDTH, HEIGHT, FEATURES>
{
    const ZERO: Self = {
        assert!(
            FEATURES > 0 && FEATURES <= u16::MAX as usize,
            "a map has 1 to 65,535 features"
        );
        Self {
            columns: [const { Grid::filled(0) }; FEATURES],
            noise: 0,
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
        let sums = self.sums(stimulus, scratch);
        for (total, sum) in distances.as_mut_slice().iter_mut().zip(sums) {
            *total = unit * sum;
        }
    }

    fn add_squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        factor: f32,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        let unit = factor / (ONE * ONE) as f32;
        for (total, sum) in distances
            .as_mut_slice()
            .iter_mut()
            .zip(self.sums(stimulus, scratch))
        {
            *total += unit * sum;
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

    fn imprint(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId) {
        for (feature, column) in self.columns.iter_mut().enumerate() {
            let feature = feature as u16;
            if let Some(weight) = column.as_mut_slice().get_mut(usize::from(node.0)) {
                *weight = if stimulus.is_unknown(feature) {
                    (ONE / 2) as i8
                } else {
                    target_of(stimulus, feature) as i8
                };
            }
        }
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>
    ByteSom<WIDTH, HEIGHT, FEATURES>
{
    /// (127·‖x − m‖)² of every node over the known features: |m|² − 2·Σ m_j·x_j + |x|².
    ///
    /// Whole numbers, in an `i32` for up to 33,000 features; those of more than 1000 features may
    /// be rounded when they become floats.
    fn sums<'a>(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &'a mut Grid<f32, WIDTH, HEIGHT>,
    ) -> impl Iterator<Item = f32> + use<'a, WIDTH, HEIGHT, FEATURES> {
        let inside = |features: Ones<'_>| features.filter(|&j| usize::from(j) < FEATURES).count();
        let length = (inside(stimulus.on()) + inside(stimulus.minus())) as i32 * ONE * ONE;
        for sum in scratch.as_mut_slice() {
            *sum = f32::from_bits(length as u32);
        }
        for columns in self.columns.chunks(GATHERED) {
            add_each(columns.iter(), scratch, |weight| weight * weight);
        }
        self.add_those(stimulus.on(), scratch, |weight| -2 * ONE * weight);
        self.add_those(stimulus.minus(), scratch, |weight| 2 * ONE * weight);
        self.add_those(stimulus.unknown(), scratch, |weight| -weight * weight);
        let sums = scratch.as_slice().iter();
        sums.map(|sum| sum.to_bits() as i32 as f32)
    }

    /// Adds a term for each weight of the features, some features at a time.
    fn add_those(
        &self,
        mut features: Ones<'_>,
        sums: &mut Grid<f32, WIDTH, HEIGHT>,
        term: impl Fn(i32) -> i32,
    ) {
        loop {
            let columns = features.by_ref();
            let columns = columns.filter_map(|j| self.columns.get(usize::from(j)));
            let some: heapless::Vec<_, GATHERED, u8> = columns.take(GATHERED).collect();
            if some.is_empty() {
                return;
            }
            add_each(some.iter().copied(), sums, &term);
        }
    }

    /// m ← m + c·(x − m) on the known features of one node, rounded at random.
    fn step(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId, c: f32) {
        let c = (c * (1 << STEP_BITS) as f32) as i32;
        for (word, columns) in self.columns.chunks_mut(32).enumerate() {
            let bits = |words: &[u32]| words.get(word).copied().unwrap_or(0);
            let mut on = bits(stimulus.on);
            let mut minus = bits(stimulus.minus);
            let mut unknown = bits(stimulus.unknown);
            for column in columns {
                let target = ONE * ((on & 1) as i32 - (minus & 1) as i32);
                let known = unknown & 1 == 0;
                (on, minus, unknown) = (on >> 1, minus >> 1, unknown >> 1);
                let Some(weight) = column.as_mut_slice().get_mut(usize::from(node.0)) else {
                    return;
                };
                let difference = target - i32::from(*weight);
                if !known || difference == 0 {
                    continue;
                }
                self.noise ^= self.noise << 13;
                self.noise ^= self.noise >> 17;
                self.noise ^= self.noise << 5;
                let rounding = (self.noise >> (32 - STEP_BITS)) as i32;
                // At most 2¹⁶ · 254 + 2¹⁶: inside i32; the result lies between weight and target.
                let moved = (c * difference + rounding) >> STEP_BITS;
                *weight = (i32::from(*weight) + moved) as i8;
            }
        }
    }
}

/// Adds a term for each weight of the columns, with the sums of a block of nodes in registers.
///
/// `sums` are the bits of whole numbers: the scratch memory is one of floats for all maps.
fn add_each<'a, const WIDTH: usize, const HEIGHT: usize>(
    columns: impl Iterator<Item = &'a Grid<i8, WIDTH, HEIGHT>> + Clone,
    sums: &mut Grid<f32, WIDTH, HEIGHT>,
    term: impl Fn(i32) -> i32,
) {
    let (blocks, rest) = sums.as_mut_slice().as_chunks_mut::<LANES>();
    for (block, sums) in blocks.iter_mut().enumerate() {
        let mut own = sums.map(|sum| sum.to_bits() as i32);
        for column in columns.clone() {
            if let Some(weights) = column.as_slice().as_chunks::<LANES>().0.get(block) {
                for (own, &weight) in own.iter_mut().zip(weights) {
                    *own += term(i32::from(weight));
                }
            }
        }
        *sums = own.map(|own| f32::from_bits(own as u32));
    }
    for column in columns {
        let (_, weights) = column.as_slice().as_chunks::<LANES>();
        for (sum, &weight) in rest.iter_mut().zip(weights) {
            let own = sum.to_bits() as i32 + term(i32::from(weight));
            *sum = f32::from_bits(own as u32);
        }
    }
}

/// What a known feature is: −127, 0 or 127.
fn target_of(stimulus: &SparseStimulus<'_>, feature: u16) -> i32 {
    let bit = |words: &[u32]| match words.get(usize::from(feature / 32)) {
        Some(word) => (word >> (feature % 32) & 1) as i32,
        None => 0,
    };
    ONE * (bit(stimulus.on) - bit(stimulus.minus))
}

stored! {
    impl[const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize]
    ByteSom<WIDTH, HEIGHT, FEATURES> { columns, noise if |it: &u32| *it != 0 }
}

#[cfg(test)]
mod tests {
    use super::ByteSom;
    use crate::num::{Neighbourhood, Rng};
    use crate::som::{BinarySom, Grid, NodeId, Prototypes, SparseStimulus, best_match};

    /// Mean quantization error of a map trained on sixteen patterns of three items.
    fn error<M: Prototypes<6, 6>>(seed: u64) -> f32 {
        let mut map = M::ZERO;
        let mut rng = Rng::new(seed);
        map.randomize(&mut rng);
        let patterns: [u32; 16] = core::array::from_fn(|i| 1 << i | 1 << (i + 3) | 1 << (2 * i));
        let (mut scratch, mut total) = (Grid::filled(0.0), 0.0);
        for t in 0..3000 {
            let words = [patterns[rng.below(16) as usize]];
            let minus = [words[0] << 1 & !words[0]];
            let stimulus = SparseStimulus {
                on: &words,
                minus: &minus,
                unknown: &[],
            };
            let mut distances = Grid::filled(0.0);
            map.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
            let best = best_match(&distances);
            let sigma = 3.0 * 0.01_f32.powf(t as f32 / 3000.0);
            let near = Neighbourhood::gaussian(sigma, 0.01).unwrap();
            map.train(&stimulus, best.node, 0.05, &near, |_| true);
            if t >= 2500 {
                total += best.squared_distance / 500.0;
            }
        }
        total
    }

    #[test]
    fn bytes_represent_as_well_as_floats_though_a_late_step_is_below_their_resolution() {
        // A map that folds badly errs by more than any rounding does, so the median of five counts.
        let median = |error: fn(u64) -> f32| {
            let mut errors = [1, 2, 3, 4, 5].map(error);
            errors.sort_by(f32::total_cmp);
            errors[2]
        };
        let bytes = median(error::<ByteSom<6, 6, 40>>);
        let floats = median(error::<BinarySom<6, 6, 40>>);
        assert!((bytes - floats).abs() < 0.02, "{bytes} against {floats}");
    }

    #[test]
    fn small_steps_move_a_weight_on_average() {
        let mut map = ByteSom::<1, 1, 200>::ZERO;
        map.randomize(&mut Rng::new(9));
        let all = [u32::MAX; 7];
        let none = SparseStimulus {
            on: &[],
            minus: &[],
            unknown: &[],
        };
        let on = SparseStimulus {
            on: &all,
            minus: &[],
            unknown: &[],
        };
        map.imprint(&none, NodeId(0));
        for _ in 0..100 {
            map.train(&on, NodeId(0), 0.002, &Neighbourhood::winner_only(), |_| {
                true
            });
        }
        let mut mean = 0.0;
        for feature in 0..200 {
            mean += map.weight(NodeId(0), feature) / 200.0;
        }
        let expected = 1.0 - 0.998_f32.powi(100);
        assert!((mean - expected).abs() < 0.02, "{mean} against {expected}");
    }

    #[test]
    fn unknown_features_are_neither_compared_nor_trained() {
        let mut map = ByteSom::<1, 1, 3>::ZERO;
        map.randomize(&mut Rng::new(2));
        let before = map.weight(NodeId(0), 1);
        let stimulus = SparseStimulus {
            on: &[0b001],
            minus: &[0b100],
            unknown: &[0b010],
        };
        map.train(
            &stimulus,
            NodeId(0),
            1.0,
            &Neighbourhood::winner_only(),
            |_| true,
        );
        let weights = [0, 1, 2].map(|feature| map.weight(NodeId(0), feature));
        assert_eq!(weights, [1.0, before, -1.0]);
        let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
        map.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
        assert_eq!(distances.as_slice(), [0.0]);
    }

    #[test]
    fn a_step_rounds_up_as_often_as_its_fraction_says() {
        // From 0 towards 127 by 1/508: a quarter of the weights move by one, whichever they are.
        let mut map = ByteSom::<1, 1, 2000>::ZERO;
        map.randomize(&mut Rng::new(4));
        let (none, all) = ([0_u32; 63], [u32::MAX; 63]);
        let of = |on| SparseStimulus {
            on,
            minus: &[],
            unknown: &[],
        };
        for (on, goal, step) in [(&none, &all, 1.0), (&all, &none, -1.0)] {
            map.imprint(&of(on), NodeId(0));
            let c = 1.0 / 508.0;
            map.train(
                &of(goal),
                NodeId(0),
                c,
                &Neighbourhood::winner_only(),
                |_| true,
            );
            let from = if step > 0.0 { 0.0 } else { 1.0 };
            let moved = |feature: u16| (map.weight(NodeId(0), feature) - from) * 127.0 * step;
            let mut count = 0;
            let mut pairs = 0;
            for feature in 0..2000 {
                let far = moved(feature);
                assert!(far.abs() < 0.01 || (far - 1.0).abs() < 0.01, "{far}");
                count += u32::from(far > 0.5);
                pairs += u32::from(far > 0.5 && feature > 0 && moved(feature - 1) > 0.5);
            }
            // Five standard deviations; and of two neighbours one says nothing of the other.
            assert!((403..=597).contains(&count), "{count}");
            assert!((70..=180).contains(&pairs), "{pairs}");
        }
    }
}
