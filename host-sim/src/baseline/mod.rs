//! Controllers that learn nothing: what a learner has to beat.
//!
//! `random` draws any action; `sector` and `lock` are hand-coded visual servos for the Pioneer, the
//! ones that drove the original simulator in `host-sim/data/stage`.

pub mod lock;
pub mod random;
pub mod sector;

use cla_core::num::Rng;

use crate::world::Percept;

/// Something that chooses the Pioneer's next action from its percept.
pub trait Controller {
    /// The index of the next action, given what the sensors report now.
    ///
    /// Reflexes have already run, so `ingrip` and `bump` are off.
    fn choose(&mut self, percept: &Percept, rng: &mut Rng) -> usize;
}
