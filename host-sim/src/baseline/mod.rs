//! Rivals: what a brain has to beat.
//!
//! Controllers that learn nothing: `random` draws any action; `sector` and `lock` are hand-coded
//! visual servos for the Pioneer, the ones that drove the original simulator in
//! `host-sim/data/stage`; `told` is a servo that is told what broke.
//! Learners: `tabular` reinforcement learning, `drescher`'s marginal attribution.

pub mod drescher;
pub mod lock;
pub mod random;
pub mod sector;
pub mod tabular;
pub mod told;

use cla_core::num::Rng;

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
/// Returns the captures of this time.
pub fn live<W: World + ?Sized>(
    world: &mut W,
    sense: impl Fn(&W) -> Percept,
    controller: &mut dyn Controller,
    rng: &mut Rng,
    actions: u32,
) -> u32 {
    let before = world.captures();
    while world.reflex() {}
    for _ in 0..actions {
        if world.finished() {
            break;
        }
        world.act(controller.choose(&sense(world), rng));
        while world.reflex() {}
    }
    world.captures() - before
}

#[cfg(test)]
mod tests {
    use super::random::Random;
    use super::sector::Sector;
    use super::{Controller, live};
    use crate::world::config::PioneerConfig;
    use crate::world::pioneer::Pioneer;
    use crate::world::{Percept, World};
    use cla_core::num::Rng;

    type Sense = fn(&Pioneer) -> Percept;

    fn captures(sense: Sense, mut controller: impl Controller, seed: u64) -> u32 {
        let mut world = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
        let mut rng = Rng::stream(seed, 3);
        live(&mut world, sense, &mut controller, &mut rng, 3000)
    }

    #[test]
    fn a_servo_forages_many_times_better_than_chance() {
        let mut sums = [0; 3];
        for seed in 0..5 {
            sums[0] += captures(Pioneer::sense, Random { actions: 6 }, seed);
            sums[1] += captures(Pioneer::sense_all_sectors, Sector::new(0.5), seed);
            sums[2] += captures(Pioneer::sense, Sector::new(0.5), seed);
        }
        // The nearest blob alone is the better guide: all blobs make it change its mind.
        assert!(sums[1] > 10 * sums[0] && sums[2] > sums[1], "{sums:?}");
    }
}
