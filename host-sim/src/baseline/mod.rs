//! Rivals: what a brain has to beat.
//!
//! Controllers that learn nothing: `random` draws any action; `sector` and `lock` are hand-coded
//! visual servos for the Pioneer, the ones that drove the original simulator in
//! `host-sim/data/stage`; `told` is a servo that is told what broke.
//! Learners: `tabular` and `linear` reinforcement learning, `drescher`'s marginal attribution.

mod checks;
pub mod drescher;
pub mod linear;
pub mod lock;
pub mod patience;
pub mod random;
pub mod sector;
pub mod tabular;
pub mod told;
pub mod worlds;

#[cfg(test)]
mod tests {
    use super::random::Random;
    use super::sector::Sector;
    use crate::learner::controller::{Controller, live};
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
