//! The controller `random`: every action equally often.

use cla_core::num::Rng;

use crate::learner::controller::Controller;
use crate::world::Percept;

/// Draws uniformly from the first `actions` actions.
#[derive(Clone, Debug)]
pub struct Random {
    /// How many actions there are; 0 counts as 1.
    pub actions: u32,
}

impl Controller for Random {
    fn choose(&mut self, _: &Percept, rng: &mut Rng) -> usize {
        rng.below(self.actions) as usize
    }
}
