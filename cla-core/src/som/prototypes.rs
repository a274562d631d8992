//! What a map of binary stimuli can do, whatever its weights are stored in.

use super::binary::BinarySom;
use super::grid::{BestMatch, Grid, NodeId, best_match};
use super::stimulus::SparseStimulus;
use crate::num::{Neighbourhood, Rng};

/// The prototypes of a map of `WIDTH` × `HEIGHT` nodes over binary stimuli.
///
/// [`BinarySom`] stores weights as `f32` and is the reference; [`ByteSom`](super::ByteSom) stores
/// them in a byte each.
///
/// ```
/// use cla_core::num::Rng;
/// use cla_core::som::{BinarySom, ByteSom, NodeId, Prototypes, SparseStimulus};
/// fn imprinted<M: Prototypes<2, 2>>() -> f32 {
///     let mut map = M::ZERO;
///     map.randomize(&mut Rng::new(1));
///     let stimulus = SparseStimulus { on: &[0b10], minus: &[], unknown: &[] };
///     map.imprint(&stimulus, NodeId(3));
///     map.weight(NodeId(3), 1)
/// }
/// assert_eq!(imprinted::<BinarySom<2, 2, 4>>(), 1.0);
/// assert_eq!(imprinted::<ByteSom<2, 2, 4>>(), 1.0);
/// ```
pub trait Prototypes<const WIDTH: usize, const HEIGHT: usize> {
    /// A map of all-zero memory.
    const ZERO: Self;

    /// What an image of a brain calls this storage of weights: 1 for `f32`, 2 for a byte.
    const STORED_AS: u8;

    /// Draws every weight from `[0, 1)`.
    fn randomize(&mut self, rng: &mut Rng);

    /// One weight in `[−1, 1]`; 0 for a node or feature outside the map.
    fn weight(&self, node: NodeId, feature: u16) -> f32;

    /// Writes ‖x − m‖² (over the known features) of every node into `distances`; `scratch` is
    /// overwritten.
    fn squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        distances.as_mut_slice().fill(0.0);
        self.add_squared_distances(stimulus, 1.0, scratch, distances);
    }

    /// Adds `factor` · ‖x − m‖² (over the known features) of every node to `distances`;
    /// `scratch` is overwritten.
    ///
    /// `factor` lies in `[0, 1e20]`; another number counts as the nearest of these, NaN as 0.
    fn add_squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        factor: f32,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    );

    /// The node nearest to a stimulus; of equally near ones the lowest index.
    ///
    /// `scratch` and `distances` are work memory: what is in them afterwards is not said.
    fn best_match(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) -> BestMatch {
        self.squared_distances(stimulus, scratch, distances);
        best_match(distances)
    }

    /// Moves the prototypes around `winner` towards the stimulus: m ← m + α·h·(x − m) on known
    /// features, for the nodes that `may_move` lets.
    fn train(
        &mut self,
        stimulus: &SparseStimulus<'_>,
        winner: NodeId,
        alpha: f32,
        neighbourhood: &Neighbourhood<WIDTH, HEIGHT>,
        may_move: impl Fn(NodeId) -> bool,
    );

    /// Makes a node whose weights cannot be so one that says nothing, and its norm what it is; whether
    /// anything was wrong.
    fn audit(&mut self, _node: NodeId) -> bool {
        false
    }

    /// Makes what follows from the weights anew.
    fn rebuild(&mut self) {}

    /// Mends what is of the whole map, not of one node; whether anything was wrong.
    fn audit_whole(&mut self) -> bool {
        false
    }

    /// Makes a node's prototype the stimulus itself; unknown features become ½.
    fn imprint(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId);
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Prototypes<WIDTH, HEIGHT>
    for BinarySom<WIDTH, HEIGHT, FEATURES>
{
    const ZERO: Self = Self::new();
    const STORED_AS: u8 = 1;

    fn randomize(&mut self, rng: &mut Rng) {
        Self::randomize(self, rng);
    }

    fn weight(&self, node: NodeId, feature: u16) -> f32 {
        Self::weight(self, node, feature)
    }

    fn squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        Self::squared_distances(self, stimulus, scratch, distances);
    }

    fn add_squared_distances(
        &self,
        stimulus: &SparseStimulus<'_>,
        factor: f32,
        scratch: &mut Grid<f32, WIDTH, HEIGHT>,
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) {
        Self::add_squared_distances(self, stimulus, factor, scratch, distances);
    }

    fn train(
        &mut self,
        stimulus: &SparseStimulus<'_>,
        winner: NodeId,
        alpha: f32,
        neighbourhood: &Neighbourhood<WIDTH, HEIGHT>,
        may_move: impl Fn(NodeId) -> bool,
    ) {
        Self::train(self, stimulus, winner, alpha, neighbourhood, may_move);
    }

    fn audit(&mut self, node: NodeId) -> bool {
        self.audit_node(node)
    }

    fn imprint(&mut self, stimulus: &SparseStimulus<'_>, node: NodeId) {
        Self::imprint(self, stimulus, node);
    }
}

#[cfg(test)]
#[path = "prototypes_tests.rs"]
mod tests;
