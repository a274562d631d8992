//! One feature of all nodes, a byte for each weight, added up four nodes at a time.
//!
//! Four bytes lie in a word. Of weights that are not negative two columns are added before the word is
//! split into sums of 16 bits: 127 + 127 still fits a byte, and no node carries into its neighbour.

use super::grid::Grid;
use crate::snapshot::{Flip, Mender, Reader, Stored, Writer};

/// Nodes whose weights lie in one word.
pub(super) const LANES: usize = 4;
/// Columns that are added up in one pass: 255 times as many fit the 16 bits of a sum.
pub(super) const GATHERED: usize = 16;
/// Every second byte of a word.
const EVERY_SECOND: u32 = 0x00ff_00ff;
/// What makes a signed byte one that is not negative: 128 more.
const SIGNS: u32 = 0x8080_8080;

/// The weights of one feature; the alignment makes four of them one load on every processor.
#[derive(Clone, Debug, PartialEq)]
#[repr(align(4))]
pub(super) struct Column<const WIDTH: usize, const HEIGHT: usize>(Grid<i8, WIDTH, HEIGHT>);

impl<const WIDTH: usize, const HEIGHT: usize> Column<WIDTH, HEIGHT> {
    pub(super) const ZERO: Self = Self(Grid::filled(0));

    pub(super) const fn as_slice(&self) -> &[i8] {
        self.0.as_slice()
    }

    pub(super) const fn as_mut_slice(&mut self) -> &mut [i8] {
        self.0.as_mut_slice()
    }

    /// Four weights, the first in the lowest byte.
    #[inline(always)]
    fn word(&self, block: usize) -> u32 {
        let lanes = self.as_slice().as_chunks::<LANES>().0.get(block);
        lanes.map_or(0, |it| u32::from_le_bytes(it.map(|weight| weight as u8)))
    }

    /// The weights behind the last whole word.
    fn last(&self) -> &[i8] {
        self.as_slice().as_chunks::<LANES>().1
    }
}

/// Sums of four nodes: those of bytes 0 and 2 in one word, those of bytes 1 and 3 in the other.
#[derive(Clone, Copy, Default)]
struct Halves {
    even: u32,
    odd: u32,
}

impl Halves {
    #[inline(always)]
    const fn add(&mut self, bytes: u32) {
        self.even = self.even.wrapping_add(bytes & EVERY_SECOND);
        self.odd = self.odd.wrapping_add(bytes >> 8 & EVERY_SECOND);
    }

    #[inline(always)]
    const fn lanes(self) -> [i32; LANES] {
        let Self { even, odd } = self;
        [
            (even & 0xffff) as i32,
            (odd & 0xffff) as i32,
            (even >> 16) as i32,
            (odd >> 16) as i32,
        ]
    }
}

/// Sums of the weights of at most [`GATHERED`] columns, none of them negative, for four nodes.
#[inline(always)]
pub(super) fn add_up<const WIDTH: usize, const HEIGHT: usize>(
    columns: &[&Column<WIDTH, HEIGHT>],
    block: usize,
) -> [i32; LANES] {
    let (fours, rest) = columns.as_chunks::<4>();
    let mut sums = Halves::default();
    for [a, b, c, d] in fours {
        sums.add(a.word(block).wrapping_add(b.word(block)));
        sums.add(c.word(block).wrapping_add(d.word(block)));
    }
    let (pair, single) = rest.as_chunks::<2>();
    if let [[a, b]] = pair {
        sums.add(a.word(block).wrapping_add(b.word(block)));
    }
    if let [column] = single {
        sums.add(column.word(block));
    }
    sums.lanes()
}

/// As [`add_up`], for weights of both signs.
#[inline(always)]
pub(super) fn add_up_signed<const WIDTH: usize, const HEIGHT: usize>(
    columns: &[&Column<WIDTH, HEIGHT>],
    block: usize,
) -> [i32; LANES] {
    let mut sums = Halves::default();
    for column in columns {
        sums.add(column.word(block) ^ SIGNS);
    }
    let raised = 128 * columns.len() as i32;
    sums.lanes().map(|sum| sum - raised)
}

/// The sums of what lies behind the last whole word; at most three nodes.
pub(super) fn add_up_last<const WIDTH: usize, const HEIGHT: usize>(
    columns: &[&Column<WIDTH, HEIGHT>],
) -> [i32; LANES] {
    let mut sums = [0; LANES];
    for column in columns {
        for (sum, &weight) in sums.iter_mut().zip(column.last()) {
            *sum += i32::from(weight);
        }
    }
    sums
}

impl<const WIDTH: usize, const HEIGHT: usize> Stored for Column<WIDTH, HEIGHT> {
    const BLANK: Self = Self::ZERO;

    fn store(&self, to: &mut Writer<'_>) {
        self.0.store(to);
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        self.0.restore(from);
    }

    fn check(from: &mut Reader<'_>) {
        Grid::<i8, WIDTH, HEIGHT>::check(from);
    }

    fn mend(&mut self, by: &mut Mender) {
        self.0.mend(by);
    }

    fn flip(&mut self, by: &mut Flip) {
        self.0.flip(by);
    }
}

#[cfg(test)]
mod tests {
    use super::{Column, GATHERED, LANES, add_up, add_up_last, add_up_signed};
    use crate::num::Rng;

    /// Sums by four and one by one, of weights from `least` up.
    fn sums(least: i32, seed: u64) -> [[i32; 11]; 3] {
        let mut rng = Rng::new(seed);
        let mut columns = [const { Column::<11, 1>::ZERO }; GATHERED];
        let some = rng.below(GATHERED as u32 + 1) as usize;
        for weight in columns.iter_mut().flat_map(Column::as_mut_slice) {
            // Every third weight is one of both ends, where a carry would show.
            *weight = match rng.below(6) {
                0 => 127,
                1 => least as i8,
                _ => (least + rng.below((127 - least) as u32) as i32) as i8,
            };
        }
        let columns: std::vec::Vec<_> = columns.iter().take(some).collect();
        let [mut plain, mut fours, mut signed] = [[0; 11]; 3];
        for (node, sum) in plain.iter_mut().enumerate() {
            for column in &columns {
                *sum += i32::from(column.as_slice()[node]);
            }
        }
        for block in 0..2 {
            let place = block * LANES..(block + 1) * LANES;
            fours[place.clone()].copy_from_slice(&add_up(&columns, block));
            signed[place].copy_from_slice(&add_up_signed(&columns, block));
        }
        fours[8..].copy_from_slice(&add_up_last(&columns)[..3]);
        signed[8..].copy_from_slice(&add_up_last(&columns)[..3]);
        [plain, fours, signed]
    }

    #[test]
    fn four_nodes_at_a_time_have_the_sums_of_one_at_a_time() {
        for seed in 0..200 {
            let [plain, fours, signed] = sums(0, seed);
            assert_eq!((fours, signed), (plain, plain), "{seed}");
            let [plain, _, signed] = sums(-127, seed);
            assert_eq!(signed, plain, "{seed}");
        }
    }
}
