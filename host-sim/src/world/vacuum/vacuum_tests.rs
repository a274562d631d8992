//! The room's rules, and what planner, rival and chance collect in it.

use super::planner;
use super::room::{FIELDS, Pose, Room};
use super::{CARRIED, CHARGE, DIRT, FULL, NOISE, Vacuum, cleaner};
use crate::baseline::random::Random;
use crate::baseline::worlds::vacuum::Sweeper;
use crate::learner::Learner;
use crate::learner::controller::Untaught;
use crate::learner::rewarded::{driven, rewarded};
use crate::world::World;
use cla_core::num::Rng;
use cla_core::word::ItemId;

#[test]
fn every_free_field_can_be_reached_and_no_obstacle_entered() {
    for seed in 0..50 {
        let mut rng = Rng::new(seed);
        let room = Room::random(&mut rng);
        let ways = room.ways(Pose {
            field: room.dock(),
            heading: 2,
        });
        for field in 0..FIELDS {
            let reached = (0..4).all(|heading| ways[Pose { field, heading }.index()] < u32::MAX);
            assert_eq!(reached, room.is_free(field), "{field} of {seed}");
        }
        let mut world = Vacuum::new(seed);
        for _ in 0..300 {
            world.act(rng.below(5) as usize);
            assert!(world.room().is_free(world.pose().field));
        }
    }
}

#[test]
fn only_suck_cleans_and_the_dirt_stays_as_much_as_it_was() {
    let mut world = Vacuum::new(2);
    let mut rng = Rng::new(2);
    let mut cleaned = 0;
    for _ in 0..5000 {
        let (here, before, battery) = (world.pose().field, world.obtained(), world.battery());
        let (dirty, action) = (world.is_dirty(here), rng.below(5) as usize);
        let carried = world.carried > 0;
        world.act(action);
        let expected = u32::from(dirty && action == 3 && !carried);
        assert_eq!(world.obtained() - before, expected);
        cleaned += expected;
        let known = world.sense().get(ItemId(cleaner::Item::cleaned as u16));
        assert_eq!(known, Some(expected == 1));
        assert_eq!((0..FIELDS).filter(|&it| world.is_dirty(it)).count(), DIRT);
        if action == 4 && here == 0 && !carried {
            assert_eq!(world.battery(), FULL.min(battery - 1 + CHARGE));
        }
    }
    assert!(cleaned > 20, "{cleaned}");
}

#[test]
fn an_empty_battery_costs_thirty_actions_and_ends_at_the_dock() {
    let mut world = Vacuum::new(4);
    world.pose.field = (0..FIELDS).rfind(|&it| world.room().is_free(it)).unwrap();
    let far = world.pose.field;
    for _ in 0..FULL {
        assert_eq!(world.times_carried(), 0);
        world.act(4);
    }
    assert_eq!((world.times_carried(), world.battery()), (1, 0));
    for _ in 1..CARRIED {
        world.act(0);
        assert_eq!(world.pose().field, far);
    }
    world.act(0);
    assert_eq!((world.pose().field, world.battery()), (0, FULL));
}

#[test]
fn every_sensor_errs_in_two_of_a_hundred_readings_and_the_valued_item_never() {
    let mut world = Vacuum::new(6);
    let mut rng = Rng::new(6);
    let mut errors = [0_u32; cleaner::ITEMS.len()];
    let readings = 50_000;
    for _ in 0..readings {
        world.act(rng.below(4) as usize);
        let truth = world.truth();
        for (item, errors) in errors.iter_mut().enumerate() {
            let seen = world.sense().get(ItemId(item as u16));
            *errors += u32::from(seen != Some(truth[item]));
        }
    }
    for (item, &errors) in errors.iter().enumerate() {
        let share = f64::from(errors) / f64::from(readings);
        let expected = if item < 13 { f64::from(NOISE) } else { 0.0 };
        assert!((share - expected).abs() < 0.004, "{item} {share}");
    }
}

#[test]
fn dirt_is_seen_along_a_line_and_not_behind_an_obstacle() {
    let mut world = Vacuum::new(1);
    world.room = Room::random(&mut Rng::new(1));
    let mut seen = [0; 2];
    for field in (0..FIELDS).filter(|&it| Room::random(&mut Rng::new(1)).is_free(it)) {
        for heading in 0..4 {
            world.pose = Pose { field, heading };
            let truth = world.truth()[cleaner::Item::dirt_ahead as usize];
            let mut at = world.pose;
            let mut found = false;
            while let Some(field) = world.room.ahead(at) {
                at.field = field;
                found |= world.is_dirty(field);
            }
            assert_eq!(truth, found);
            seen[usize::from(found)] += 1;
        }
    }
    assert!(seen[0] > 20 && seen[1] > 20, "{seen:?}");
}

#[test]
fn the_rival_collects_three_quarters_of_what_the_planner_does_and_chance_a_fraction() {
    let (mut planned, mut swept, mut chance) = (0.0, 0.0, 0.0);
    for seed in 0..10 {
        let world = || Vacuum::new(seed);
        let mut room = world();
        planned += driven(&mut room, 5000, planner::action).earned;
        assert_eq!(room.times_carried(), 0, "{seed}");
        let lived = |learner: &mut dyn Learner| rewarded(learner, &mut world(), 5000).unwrap();
        swept += lived(&mut Untaught::new(Sweeper::default(), seed)).earned;
        chance += lived(&mut Untaught::new(Random { actions: 5 }, seed)).earned;
    }
    assert!(
        swept >= 0.75 * planned && swept < planned,
        "{swept} {planned}"
    );
    assert!(chance < 0.25 * swept, "{chance} {swept}");
}

#[test]
fn the_same_seed_gives_the_same_life_in_the_same_room() {
    let life = |seed| {
        let mut world = Vacuum::new(seed);
        let step = |it: usize| {
            world.act(it * 7 % 5);
            (world.pose(), world.sense())
        };
        (0..500).map(step).collect::<Vec<_>>()
    };
    assert_eq!(life(3), life(3));
    assert_ne!(life(3), life(4));
}
