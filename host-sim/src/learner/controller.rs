//! A controller that learns nothing, as a [`Learner`]: the floor and the ceiling of a comparison.

use cla_core::num::Rng;

use super::Learner;
use crate::baseline::Controller;
use crate::options::Failure;
use crate::world::Percept;

/// Any controller with its own source of chance.
#[derive(Clone, Debug)]
pub struct Untaught<C> {
    controller: C,
    rng: Rng,
}

impl<C: Controller> Untaught<C> {
    /// A controller for the life of a seed.
    #[must_use]
    pub const fn new(controller: C, seed: u64) -> Self {
        Self {
            controller,
            rng: Rng::stream(seed, 3),
        }
    }
}

impl<C: Controller> Learner for Untaught<C> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        Ok(self.controller.choose(now, &mut self.rng))
    }

    fn learn(&mut self, _: &Percept) -> Result<(), Failure> {
        Ok(())
    }

    fn observe(&mut self, _: &Percept, _: usize, _: &Percept) -> Result<(), Failure> {
        Ok(())
    }
}
