//! What drives a robot and learns nothing: the floor and the ceiling of a comparison.
//!
//! [`live`] drives it by itself; [`Untaught`] makes it a [`Learner`], for the lives that all share.

use cla_core::num::Rng;

use super::Learner;
use crate::failure::Failure;
use crate::world::{Percept, World};

/// Something that chooses the Pioneer's next action from its percept.
pub trait Controller {
    /// The index of the next action, given what the sensors report now.
    ///
    /// Reflexes have already run, so `ingrip` and `bump` are off.
    fn choose(&mut self, percept: &Percept, rng: &mut Rng) -> usize;
}

/// Lets a controller live in a world for `actions` actions, or until the world has ended.
///
/// `sense` is what it sees: `World::sense`, as a learner, or `Pioneer::sense_all_sectors`, as the
/// controllers of the Stage runs.
/// Returns what it has obtained in this time.
pub fn live<W: World + ?Sized>(
    world: &mut W,
    sense: impl Fn(&W) -> Percept,
    controller: &mut dyn Controller,
    rng: &mut Rng,
    actions: u32,
) -> u32 {
    let before = world.obtained();
    while world.reflex().is_some() {}
    for _ in 0..actions {
        if world.finished() {
            break;
        }
        world.act(controller.choose(&sense(world), rng));
        while world.reflex().is_some() {}
    }
    world.obtained() - before
}

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
