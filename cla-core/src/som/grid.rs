//! A value for every node of a map, and the search for the smallest.

use core::fmt;

use crate::snapshot::{Flip, Mender, Reader, Stored, Writer};

/// The index of a node: row · width + column.
///
/// ```
/// use cla_core::som::{Grid, NodeId};
/// let grid = Grid::<f32, 20, 10>::filled(0.0);
/// assert_eq!(grid.position(NodeId(45)), (5, 2));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u16);

impl fmt::Display for NodeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "node {}", self.0)
    }
}

/// The node nearest to a stimulus, and its squared distance.
///
/// ```
/// use cla_core::som::{Grid, best_match};
/// let mut distances = Grid::<f32, 2, 2>::filled(1.0);
/// distances.as_mut_slice()[2] = 0.5;
/// let best = best_match(&distances);
/// assert_eq!((best.node.0, best.squared_distance), (2, 0.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BestMatch {
    /// The winner; of equally near nodes the lowest index.
    pub node: NodeId,
    /// ‖x − m‖² of the winner.
    pub squared_distance: f32,
}

/// One value for each node of a map of `WIDTH` × `HEIGHT` nodes, row by row.
///
/// ```
/// use cla_core::som::Grid;
/// let mut grid = Grid::<f32, 3, 2>::filled(0.0);
/// grid.as_mut_slice()[4] = 2.5; // column 1 of row 1
/// assert_eq!(grid.rows()[1][1], 2.5);
/// assert_eq!(Grid::<f32, 3, 2>::NODES, 6);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid<T, const WIDTH: usize, const HEIGHT: usize>([[T; WIDTH]; HEIGHT]);

impl<T: Copy, const WIDTH: usize, const HEIGHT: usize> Grid<T, WIDTH, HEIGHT> {
    /// The number of nodes.
    pub const NODES: usize = {
        assert!(WIDTH > 0 && HEIGHT > 0, "a map needs at least one node");
        assert!(
            WIDTH * HEIGHT <= u16::MAX as usize,
            "a map has at most 65,535 nodes"
        );
        WIDTH * HEIGHT
    };

    /// A grid with `value` everywhere.
    #[must_use]
    pub const fn filled(value: T) -> Self {
        let _ = Self::NODES;
        Self([[value; WIDTH]; HEIGHT])
    }

    /// All values in the order of their [`NodeId`].
    #[must_use]
    pub const fn as_slice(&self) -> &[T] {
        self.0.as_flattened()
    }

    /// All values in the order of their [`NodeId`], to change.
    pub const fn as_mut_slice(&mut self) -> &mut [T] {
        self.0.as_flattened_mut()
    }

    /// The rows of the grid.
    #[must_use]
    pub const fn rows(&self) -> &[[T; WIDTH]; HEIGHT] {
        &self.0
    }

    /// The rows of the grid, to change.
    pub const fn rows_mut(&mut self) -> &mut [[T; WIDTH]; HEIGHT] {
        &mut self.0
    }

    /// Column and row of a node.
    #[must_use]
    pub const fn position(&self, node: NodeId) -> (usize, usize) {
        let index = node.0 as usize;
        (index % WIDTH, index / WIDTH)
    }
}

/// The node with the smallest squared distance; ties go to the lowest index.
///
/// Squared distances are 0 or more: a negative number and a NaN never win, and a grid of nothing
/// else answers node 0 with an infinite distance.
#[must_use]
pub fn best_match<const WIDTH: usize, const HEIGHT: usize>(
    squared_distances: &Grid<f32, WIDTH, HEIGHT>,
) -> BestMatch {
    // From 0 upwards the bits of floats are in the order of the floats; a sign bit or a NaN is above
    // them all. Integers compare in fewer instructions, above all without an FPU; and a search for
    // the next smaller one, which is rare, is a shorter loop than one that keeps the smallest.
    let mut best = (0, f32::INFINITY.to_bits());
    let mut rest = squared_distances.as_slice().iter().enumerate();
    while let Some((index, smaller)) = rest.find(|(_, distance)| distance.to_bits() < best.1) {
        best = (index, smaller.to_bits());
    }
    BestMatch {
        node: NodeId(best.0 as u16),
        squared_distance: f32::from_bits(best.1),
    }
}

impl<T: Stored + Copy, const WIDTH: usize, const HEIGHT: usize> Stored for Grid<T, WIDTH, HEIGHT> {
    const BLANK: Self = Self::filled(T::BLANK);

    fn store(&self, to: &mut Writer<'_>) {
        self.0.store(to);
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        self.0.restore(from);
    }

    fn check(from: &mut Reader<'_>) {
        <[[T; WIDTH]; HEIGHT]>::check(from);
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
    use super::{Grid, NodeId, best_match};

    #[test]
    fn ties_go_to_the_lowest_index() {
        let grid = Grid::<f32, 3, 3>::filled(2.0);
        assert_eq!(best_match(&grid).node, NodeId(0));
    }

    #[test]
    fn a_nan_never_wins() {
        let mut grid = Grid::<f32, 2, 2>::filled(f32::NAN);
        grid.as_mut_slice()[3] = 9.0;
        assert_eq!(best_match(&grid).node, NodeId(3));
    }

    #[test]
    fn the_smallest_wins_wherever_it_stands_and_a_negative_number_never() {
        let mut grid = Grid::<f32, 3, 2>::filled(2.0);
        for place in 0..6 {
            grid.as_mut_slice()[place] = 0.5;
            let best = best_match(&grid);
            assert_eq!(
                (best.node, best.squared_distance),
                (NodeId(place as u16), 0.5)
            );
            grid.as_mut_slice()[place] = 2.0;
        }
        grid.as_mut_slice()
            .copy_from_slice(&[5.0, 3.0, 4.0, 1.0, -7.0, 1.0]);
        assert_eq!(best_match(&grid).node, NodeId(3));
        let nothing = best_match(&Grid::<f32, 2, 1>::filled(-1.0));
        assert_eq!(
            (nothing.node, nothing.squared_distance),
            (NodeId(0), f32::INFINITY)
        );
    }

    #[test]
    fn nodes_are_counted_row_by_row() {
        let mut grid = Grid::<u8, 3, 2>::filled(0);
        assert_eq!(Grid::<u8, 3, 2>::NODES, 6);
        for (node, place) in [(0, (0, 0)), (2, (2, 0)), (3, (0, 1)), (5, (2, 1))] {
            assert_eq!(grid.position(NodeId(node)), place);
        }
        grid.rows_mut()[1][2] = 7;
        assert_eq!((grid.as_slice()[5], grid.rows()[1]), (7, [0, 0, 7]));
        assert_eq!(std::string::ToString::to_string(&NodeId(12)), "node 12");
    }
}
