//! What a layer can read: anything with a fixed number of values (book, 3.3).
//!
//! Arrays, activations, delay lines and tuples of these are signals, so hand-wired hierarchies and
//! the ready structures join them in the same way.
//! A signal is copied once, into the layer that reads it; nothing is allocated.

use core::slice::IterMut;

use crate::som::Grid;

/// A vector of [`LEN`](Self::LEN) numbers that a layer can read.
///
/// A tuple of signals is their join, first to last: the tree structure.
///
/// ```
/// use cla_core::layer::Signal;
///
/// let joined = ([1.0, 2.0], [3.0]);
/// let mut values = [0.0; 3];
/// joined.write(&mut values.iter_mut());
/// assert_eq!(values, [1.0, 2.0, 3.0]);
/// assert_eq!(<([f32; 2], [f32; 1])>::LEN, 3);
/// ```
pub trait Signal {
    /// How many values the signal has.
    const LEN: usize;

    /// Writes the values into the next [`LEN`](Self::LEN) places of `out`; fewer if `out` ends.
    fn write(&self, out: &mut IterMut<'_, f32>);
}

/// Writes `values` into the next places of `out`.
pub(super) fn write_slice(values: &[f32], out: &mut IterMut<'_, f32>) {
    // The values come first in the zip, so that no place is taken once they have ended.
    for (&value, place) in values.iter().zip(out) {
        *place = value;
    }
}

impl<const LEN: usize> Signal for [f32; LEN] {
    const LEN: usize = LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        write_slice(self, out);
    }
}

impl<const WIDTH: usize, const HEIGHT: usize> Signal for Grid<f32, WIDTH, HEIGHT> {
    const LEN: usize = Grid::<f32, WIDTH, HEIGHT>::NODES;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        write_slice(self.as_slice(), out);
    }
}

impl<S: Signal> Signal for &S {
    const LEN: usize = S::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        (**self).write(out);
    }
}

impl<A: Signal, B: Signal> Signal for (A, B) {
    const LEN: usize = A::LEN + B::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.0.write(out);
        self.1.write(out);
    }
}

impl<A: Signal, B: Signal, C: Signal> Signal for (A, B, C) {
    const LEN: usize = A::LEN + B::LEN + C::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.0.write(out);
        self.1.write(out);
        self.2.write(out);
    }
}

impl<A: Signal, B: Signal, C: Signal, D: Signal> Signal for (A, B, C, D) {
    const LEN: usize = A::LEN + B::LEN + C::LEN + D::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.0.write(out);
        self.1.write(out);
        self.2.write(out);
        self.3.write(out);
    }
}

/// A signal times `PERCENT` / 100, to balance the parts of a join.
///
/// A layer compares whole vectors, so a part with large or many values outweighs the others.
///
/// ```
/// use cla_core::layer::{Scaled, Signal};
///
/// let mut values = [0.0; 3];
/// ([1.0], Scaled::<_, 50> { source: [1.0, 2.0] }).write(&mut values.iter_mut());
/// assert_eq!(values, [1.0, 0.5, 1.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scaled<S, const PERCENT: u32> {
    /// The signal or structure that is scaled.
    pub source: S,
}

impl<S: Signal, const PERCENT: u32> Signal for Scaled<S, PERCENT> {
    const LEN: usize = S::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        // The places are taken off `out`, so that they can be scaled where they are.
        let places = core::mem::take(out).into_slice();
        if let Some((ours, rest)) = places.split_at_mut_checked(S::LEN) {
            self.source.write(&mut ours.iter_mut());
            for value in ours {
                *value *= PERCENT as f32 / 100.0;
            }
            *out = rest.iter_mut();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Scaled, Signal};
    use crate::som::Grid;

    #[test]
    fn a_join_keeps_the_order_of_its_parts_and_their_lengths() {
        let grid = Grid::<f32, 2, 1>::filled(7.0);
        let joined = (&grid, [1.0], (Scaled::<_, 25> { source: [4.0] }, [2.0]));
        let mut values = [9.0; 6];
        joined.write(&mut values.iter_mut());
        // The sixth place is not part of the join and stays as it was.
        assert_eq!(values, [7.0, 7.0, 1.0, 1.0, 2.0, 9.0]);
    }

    #[test]
    fn a_place_too_few_is_no_panic() {
        let mut values = [0.0; 2];
        ([1.0], [2.0, 3.0]).write(&mut values.iter_mut());
        assert_eq!(values, [1.0, 2.0]);
    }
}
