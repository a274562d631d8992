//! What the Pioneer does at walls, specimens and impossible parameters, as tests.

use cla_core::num::Rng;

use super::{
    BACKWARD, Blob, FORWARD, GRIP, INGRIP, Layout, Pioneer, PioneerConfig, Point, Pose, S1,
    SECTORS, TURN_AROUND, TURN_LEFT, TURN_RIGHT, World,
};
use cla_core::word::ItemId;

fn world(config: PioneerConfig, robot: Pose, specimens: &[(f64, f64)]) -> Pioneer {
    let specimens = specimens.iter().map(|&(x, y)| Point::new(x, y)).collect();
    Pioneer::with_layout(config, &Layout { robot, specimens }, 1).unwrap()
}

fn quiet(robot: Pose, specimens: &[(f64, f64)]) -> Pioneer {
    world(PioneerConfig::stage(5.0, 0.5), robot, specimens)
}

fn on(world: &Pioneer, item: u16) -> bool {
    world.sense().get(ItemId(item)) == Some(true)
}

const EAST: fn(f64) -> Pose = |x| Pose::new(Point::new(x, 0.0), 0.0);

#[test]
fn forward_stops_when_the_beam_breaks() {
    let mut world = quiet(EAST(0.0), &[(0.5, 0.0), (4.0, 0.0)]);
    world.act(FORWARD);
    assert!(on(&world, INGRIP));
    let x = world.robot().position.x;
    assert!((0.13..=0.17).contains(&x), "{x} m");
    assert_eq!(world.reflex(), Some(GRIP));
    assert_eq!(world.obtained(), 1);
    assert!(!on(&world, INGRIP) && !world.finished());
    assert_eq!(world.reflex(), None);
}

#[test]
fn the_last_specimen_ends_a_run_with_removal_only() {
    let robot = EAST(0.0);
    let mut removed = quiet(robot, &[(0.3, 0.0)]);
    let mut replaced = world(PioneerConfig::NOISE_FREE, robot, &[(0.3, 0.0)]);
    removed.act(GRIP);
    replaced.act(GRIP);
    assert!(removed.obtained() == 1 && removed.finished());
    assert!(replaced.obtained() == 1 && !replaced.finished());
    let back = replaced.specimens()[0].unwrap();
    assert!(back.distance(robot.position) >= 0.69);
}

#[test]
fn a_camera_that_reads_nan_makes_its_items_unknown_and_no_others() {
    let world = quiet(EAST(0.0), &[(0.3, 0.0)]);
    let blob = Blob {
        bearing: f64::NAN,
        range: 1.0,
        columns: 3,
        specimen: 0,
    };
    let percept = world.percept([Some(0), blob.sector()].into_iter());
    for item in S1..S1 + SECTORS as u16 {
        assert_eq!(percept.get(ItemId(item)), None);
    }
    assert_eq!(percept.get(ItemId(INGRIP)), Some(true));
    assert_eq!(percept.get(ItemId(super::BUMP)), Some(false));
}

#[test]
fn walls_stop_the_robot_and_set_bump_and_the_reflex_turns_it_round() {
    let mut world = quiet(EAST(4.7), &[(0.0, 4.0)]);
    world.act(FORWARD);
    assert!(on(&world, super::BUMP));
    let x = world.robot().position.x;
    assert!((4.77..4.82).contains(&x), "{x} m");
    assert_eq!(world.reflex(), Some(super::TURN_AROUND));
    assert!((world.robot().position.x - (x - 0.10)).abs() < 1e-9);
    // 10 cm are not enough for the rear corners to pass: the wall ends the turn early.
    assert!(world.robot().heading().to_degrees().abs() > 110.0);
    assert!(!on(&world, super::BUMP));
    assert_eq!(world.reflex(), None);
}

#[test]
fn a_body_that_passes_kicks_a_specimen_and_one_that_turns_does_not() {
    let mut world = quiet(EAST(0.0), &[(0.30, 0.15)]);
    for action in [
        TURN_LEFT, TURN_RIGHT, TURN_RIGHT, TURN_RIGHT, TURN_LEFT, TURN_LEFT,
    ] {
        world.act(action);
    }
    assert!((world.specimens()[0].unwrap().x - 0.30).abs() < 1e-6);
    world.act(FORWARD);
    for _ in 0..50 {
        world.act(GRIP);
    }
    let at = world.specimens()[0].unwrap();
    assert!(at.x > 0.8 && world.obtained() == 0, "{at:?}");
}

#[test]
fn the_nearest_blob_alone_decides_the_sector() {
    // Ahead at 2 m, far left at 1 m.
    let world = quiet(EAST(0.0), &[(2.0, 0.0), (0.91, 0.41)]);
    let near: Vec<u16> = world.sense().on().iter().map(|item| item.0).collect();
    let all: Vec<u16> = world
        .sense_all_sectors()
        .on()
        .iter()
        .map(|item| item.0)
        .collect();
    assert_eq!((near, all), (vec![0], vec![0, 2]));
}

#[test]
fn the_same_seed_and_actions_give_the_same_percepts() {
    let run = |seed: u64| {
        let mut world = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
        let mut rng = Rng::new(9);
        let mut percepts = Vec::new();
        for _ in 0..3000 {
            world.act(rng.below(6) as usize);
            percepts.push(world.sense());
            while world.reflex().is_some() {}
            percepts.push(world.sense());
        }
        percepts
    };
    assert_eq!(run(5), run(5));
    assert_ne!(run(5), run(6));
}

#[test]
fn nothing_ever_leaves_the_room_or_passes_a_wall() {
    for (seed, config) in [
        (1, PioneerConfig::NOISY),
        (
            2,
            PioneerConfig {
                backward: 0.5,
                radius: 2.5,
                ..PioneerConfig::NOISY
            },
        ),
        (3, PioneerConfig::stage(3.0, 0.5)),
    ] {
        let mut world = Pioneer::new(config, seed).unwrap();
        let mut rng = Rng::new(seed);
        let centre = Point::default();
        for _ in 0..10_000 {
            // Mostly forward, to meet walls and specimens.
            let action = rng.below(9) as usize;
            world.act(if action < 6 { action } else { FORWARD });
            while world.reflex().is_some() {}
            for corner in world.body() {
                assert!(corner.distance(centre) <= config.radius + 0.005);
            }
            for at in world.specimens().iter().flatten() {
                assert!(at.distance(centre) <= config.radius - 0.039, "{at:?}");
            }
        }
    }
}

#[test]
fn every_blob_is_missed_when_the_drop_out_is_certain() {
    let mut config = PioneerConfig {
        drop_out: 1.0,
        ..PioneerConfig::NOISE_FREE
    };
    let blind = world(config, EAST(0.0), &[(2.0, 0.0)]);
    assert!(blind.sense().on().is_empty());
    config.drop_out = 0.0;
    assert_eq!(
        world(config, EAST(0.0), &[(2.0, 0.0)]).sense().on().len(),
        1
    );
}

#[test]
fn drop_out_and_motion_noise_have_the_stated_size() {
    let mut misses = 0;
    let mut squares = (0.0, 0.0);
    let n = 4000;
    for seed in 0..n {
        let robot = EAST(0.0);
        let layout = Layout {
            robot,
            specimens: vec![Point::new(4.0, 0.0)],
        };
        let mut world = Pioneer::with_layout(PioneerConfig::NOISY, &layout, seed).unwrap();
        misses += u32::from(world.blobs().is_empty());
        world.act(FORWARD);
        squares.0 += (world.robot().position.x / 0.5 - 1.0).powi(2);
        world.act(TURN_LEFT);
        squares.1 += (world.robot().heading().to_degrees() - 5.0).powi(2);
    }
    let share = f64::from(misses) / n as f64;
    assert!((0.15..=0.19).contains(&share), "{share}");
    let (step, turn) = ((squares.0 / n as f64).sqrt(), (squares.1 / n as f64).sqrt());
    assert!((0.028..=0.032).contains(&step) && (0.47..=0.53).contains(&turn));
}

#[test]
fn an_unknown_action_changes_nothing() {
    let mut world = Pioneer::new(PioneerConfig::NOISY, 3).unwrap();
    let before = (world.sense(), *world.robot());
    world.act(6);
    world.act(usize::MAX);
    assert_eq!(before, (world.sense(), *world.robot()));
}

#[test]
fn a_turn_does_not_stop_at_a_specimen_but_may_end_with_one_in_the_grip() {
    let mut world = quiet(EAST(0.0), &[(0.0, 0.30), (0.0, -0.30)]);
    world.act(TURN_AROUND);
    assert!(!on(&world, INGRIP));
    world = quiet(EAST(0.0), &[(-0.30, 0.0)]);
    world.act(TURN_AROUND);
    assert!(on(&world, INGRIP));
    world.act(BACKWARD);
    assert!(world.robot().position.x > 0.0);
}

#[test]
fn impossible_worlds_are_refused() {
    let tight = PioneerConfig {
        radius: 1.2,
        ..PioneerConfig::NOISY
    };
    assert!(Pioneer::new(tight, 1).is_err());
    let layout = Layout::parse("0\n4 0\n", 5.0).unwrap();
    assert!(Pioneer::with_layout(PioneerConfig::stage(3.0, 0.5), &layout, 1).is_err());
    let mut world = Pioneer::new(PioneerConfig::NOISY, 1).unwrap();
    assert!(world.set_camera_offset(f64::NAN).is_err());
    assert!(world.set_camera_offset(12.0).is_ok());
}

#[test]
fn the_reference_world_runs_far_faster_than_ten_thousand_actions_a_second() {
    let mut world = Pioneer::new(PioneerConfig::NOISY, 1).unwrap();
    let mut rng = Rng::new(1);
    let begun = std::time::Instant::now();
    for _ in 0..20_000 {
        world.act(rng.below(6) as usize);
        while world.reflex().is_some() {}
    }
    let rate = 20_000.0 / begun.elapsed().as_secs_f64();
    println!("{rate:.0} actions/s");
    assert!(rate > 10_000.0, "{rate:.0} actions/s");
}

#[test]
fn a_run_has_the_same_bits_in_every_build() {
    let mut world = Pioneer::new(PioneerConfig::NOISY, 7).unwrap();
    let mut rng = Rng::new(7);
    let mut hash = 0xCBF2_9CE4_8422_2325_u64;
    let mut mix = |bits: u64| hash = (hash ^ bits).wrapping_mul(0x100_0000_01B3);
    for _ in 0..5000 {
        // Mostly forward, to meet walls and specimens.
        let action = rng.below(9) as usize;
        world.act(if action < 6 { action } else { FORWARD });
        while world.reflex().is_some() {}
        mix(u64::from(world.sense().on().words()[0]));
    }
    mix(world.robot().position.x.to_bits());
    for at in world.specimens().iter().flatten() {
        mix(at.x.to_bits());
        mix(at.y.to_bits());
    }
    assert_eq!(hash, 0xECDA_738D_E462_340A, "{hash:#018X}");
}
