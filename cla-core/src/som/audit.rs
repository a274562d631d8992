//! Maps looked through for what cannot be so.

use super::binary::{BinarySom, SMALLEST_SCALE};
use super::grid::NodeId;

/// What rounding may add to a weight, and to a norm as a share of it.
const ROUNDING: f32 = 0.05;

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>
    BinarySom<WIDTH, HEIGHT, FEATURES>
{
    /// Makes a node whose weights lie outside −1 to 1 one of ½ everywhere, and a norm that is not that
    /// of the weights what it is; whether anything was wrong.
    pub(crate) fn audit_node(&mut self, node: NodeId) -> bool {
        let index = usize::from(node.0);
        let Some(&scale) = self.scale.as_slice().get(index) else {
            return false;
        };
        let mut sound = (SMALLEST_SCALE..=1.0).contains(&scale);
        let mut norm = 0.0;
        for feature in 0..FEATURES as u16 {
            let weight = self.weight(node, feature);
            sound &= weight.abs() <= 1.0 + ROUNDING;
            norm += weight * weight;
        }
        if !sound {
            self.know_nothing(node);
            return true;
        }
        match self.squared_norm.as_mut_slice().get_mut(index) {
            Some(kept) if !is_near(*kept, norm) => {
                *kept = norm;
                true
            }
            _ => false,
        }
    }
}

/// Whether a norm is what it should be but for rounding; one that is none is not.
fn is_near(kept: f32, norm: f32) -> bool {
    (kept - norm).abs() <= ROUNDING * (1.0 + norm)
}
