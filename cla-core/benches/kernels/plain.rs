//! The peer: a map of real weights, searched and trained by the loops that a textbook prints.

use cla_core::num::{Neighbourhood, Rng};
use cla_core::som::NodeId;

/// Prototypes node by node.
pub(crate) struct PlainMap<const W: usize, const H: usize, const FEATURES: usize> {
    prototypes: [[[f32; FEATURES]; W]; H],
}

impl<const W: usize, const H: usize, const FEATURES: usize> PlainMap<W, H, FEATURES> {
    /// Weights drawn from `[0, 1)`.
    pub(crate) fn random() -> Self {
        let mut rng = Rng::new(1);
        Self {
            prototypes: [(); H].map(|()| [(); W].map(|()| [(); FEATURES].map(|()| rng.unit()))),
        }
    }

    /// The node whose prototype is nearest.
    pub(crate) fn search(&self, stimulus: &[f32; FEATURES]) -> NodeId {
        let mut best = (f32::INFINITY, 0);
        for (node, prototype) in self.prototypes.as_flattened().iter().enumerate() {
            let mut distance = 0.0;
            for (x, m) in stimulus.iter().zip(prototype) {
                distance += (x - m) * (x - m);
            }
            if distance < best.0 {
                best = (distance, node);
            }
        }
        NodeId(best.1 as u16)
    }

    /// Moves every prototype towards the stimulus, by how near it lies to the winner.
    pub(crate) fn train(
        &mut self,
        stimulus: &[f32; FEATURES],
        winner: NodeId,
        alpha: f32,
        near: &Neighbourhood<W, H>,
    ) {
        let (row, column) = (usize::from(winner.0) / W, usize::from(winner.0) % W);
        for (y, prototypes) in self.prototypes.iter_mut().enumerate() {
            for (x, prototype) in prototypes.iter_mut().enumerate() {
                let rate = alpha * near.weight(x.abs_diff(column), y.abs_diff(row));
                for (m, stimulus) in prototype.iter_mut().zip(stimulus) {
                    *m += rate * (stimulus - *m);
                }
            }
        }
    }
}
