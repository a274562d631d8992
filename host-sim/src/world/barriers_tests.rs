//! Where barriers stand, and that nothing but a bump shows them.

use super::{Barriers, COUNT, GAPS, LENGTH};
use crate::baseline::sector::Sector;
use crate::learner::controller::live;
use crate::world::World;
use crate::world::config::PioneerConfig;
use crate::world::geometry::Point;
use crate::world::pioneer::Pioneer;
use cla_core::num::Rng;

#[test]
fn barriers_stand_in_the_room_and_not_where_the_robot_begins() {
    for seed in 0..20 {
        let room = Barriers::new(seed).unwrap();
        assert_eq!(room.barriers().len(), COUNT);
        for barrier in room.barriers() {
            let from_centre = barrier.pose.position.distance(Point::default());
            assert!((GAPS.0..=5.0 - GAPS.1).contains(&from_centre));
            assert_eq!(barrier.length, LENGTH);
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
