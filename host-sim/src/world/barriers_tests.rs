//! Where barriers stand, and that nothing but a bump shows them.

use core::f64::consts::TAU;

use super::Barriers;
use crate::baseline::sector::Sector;
use crate::learner::controller::live;
use crate::world::World;
use crate::world::arena::Arena;
use crate::world::config::PioneerConfig;
use crate::world::geometry::Point;
use crate::world::pioneer::Pioneer;
use cla_core::num::Rng;

#[test]
fn barriers_stand_in_the_room_and_not_where_the_robot_begins_and_turns() {
    for seed in 0..20 {
        let room = Barriers::new(seed).unwrap();
        let radius = room.pioneer().config().radius;
        let mut arena = Arena::new(radius, &[]);
        for &barrier in room.barriers() {
            arena.raise(barrier);
        }
        for step in 0..72 {
            let turned = room.pioneer().robot().turned(f64::from(step) * TAU / 72.0);
            assert!(!arena.body_hits_wall(&turned), "seed {seed}: {turned:?}");
        }
        for barrier in room.barriers() {
            assert!(arena.body_hits_wall(&barrier.pose), "seed {seed}");
            for side in [-0.25, 0.25] {
                let end = barrier.pose.turned(side * TAU).ahead(0.5 * barrier.length);
                assert!(end.position.distance(Point::default()) <= radius);
            }
        }
    }
}

/// The first percept is that of the room without them, and a servo bumps into what it does not see.
#[test]
fn nothing_shows_a_barrier_but_a_bump() {
    let (mut with, mut without) = ([0, 0], [0, 0]);
    for seed in 0..5 {
        let mut room = Barriers::new(seed).unwrap();
        let mut empty = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
        assert_eq!(room.sense(), empty.sense());
        let servo = || (Sector::new(0.5), Rng::stream(seed, 3));
        let (mut it, mut rng) = servo();
        with[0] += live(&mut room, World::sense, &mut it, &mut rng, 1000);
        with[1] += room.pioneer().bump_reflexes();
        let (mut it, mut rng) = servo();
        without[0] += live(&mut empty, World::sense, &mut it, &mut rng, 1000);
        without[1] += empty.bump_reflexes();
    }
    assert!(
        with[1] > 2 * without[1] && with[0] < without[0],
        "{with:?} {without:?}"
    );
}
