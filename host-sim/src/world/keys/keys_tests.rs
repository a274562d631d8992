//! The rules of keys and doors, and what planner, rival and chance bring home.

use super::{COLUMNS, FIRST_IDLE, Keys, LEAST, ROWS, STEPS, Situation, seeker};
use crate::baseline::random::Random;
use crate::baseline::worlds::keys::Searcher;
use crate::learner::Learner;
use crate::learner::controller::Untaught;
use crate::learner::rewarded::{driven, rewarded};
use crate::world::World;
use cla_core::num::Rng;
use cla_core::word::ItemId;

#[test]
fn a_door_opens_with_its_key_alone_and_a_wall_never() {
    for seed in 0..20 {
        let layout = Keys::new(seed).layout().clone();
        for row in 0..ROWS {
            for (column, own) in [(1, layout.red_row), (3, layout.blue_row)] {
                let mut now = Situation {
                    cell: row * COLUMNS + column,
                    ..Situation::START
                };
                let east = |now| layout.after(now, 1).cell == now.cell + 1;
                assert!(!east(now) && !east(layout.after(now, 5)));
                (now.has_red, now.has_blue) = (column == 3, column == 1);
                assert!(!east(layout.after(now, 5)), "the other key opens nothing");
                (now.has_red, now.has_blue) = (true, true);
                assert!(!east(now), "a key opens nothing by itself");
                assert_eq!(east(layout.after(now, 5)), row == own);
            }
        }
    }
}

#[test]
fn keys_are_taken_where_they_lie_and_kept_until_the_try_ends() {
    let mut world = Keys::new(3);
    let mut rng = Rng::new(3);
    let mut taken = 0;
    for _ in 0..20_000 {
        let before = world.situation();
        let ended = world.episode_ended();
        let action = rng.below(6) as usize;
        world.act(action);
        let now = world.situation();
        if ended {
            assert!(!now.has_blue && !now.red_open);
            continue;
        }
        let takes = action == 4 && before.cell == world.layout().red;
        assert_eq!(now.has_red, before.has_red || takes);
        taken += u32::from(now.has_red && !before.has_red);
        let shown = world.sense().get(ItemId(seeker::Item::has_red as u16));
        assert_eq!(shown, Some(now.has_red));
    }
    assert!(taken > 10);
}

#[test]
fn no_way_is_shorter_than_ten_actions_and_every_one_can_be_gone() {
    for seed in 0..100 {
        let mut world = Keys::new(seed);
        assert!(world.shortest() >= LEAST);
        let shortest = world.shortest();
        for _ in 0..shortest {
            assert!(!world.episode_ended());
            let action = world.planned();
            world.act(action);
        }
        assert!(world.episode_ended());
        assert_eq!(
            (world.obtained(), world.tries(), world.efficiency()),
            (1, 1, 1.0)
        );
    }
}

#[test]
fn a_try_without_the_prize_ends_after_two_hundred_actions() {
    let mut world = Keys::new(1);
    for _ in 0..STEPS {
        assert!(!world.episode_ended());
        world.act(0);
    }
    assert!(world.episode_ended());
    assert_eq!((world.tries(), world.obtained()), (1, 0));
}

#[test]
fn more_than_half_of_the_items_change_whatever_is_done_and_tell_nothing() {
    let mut world = Keys::new(2);
    let count = seeker::ITEMS.len();
    assert_eq!(count, 48);
    assert!(2 * (count - FIRST_IDLE) > count);
    let (mut on, mut changes) = (vec![0_u32; count], vec![0_u32; count]);
    let mut last = world.sense();
    for _ in 0..20_000 {
        world.act(5);
        let now = world.sense();
        for item in FIRST_IDLE..count {
            let id = ItemId(item as u16);
            on[item] += u32::from(now.get(id) == Some(true));
            changes[item] += u32::from(now.get(id) != last.get(id));
        }
        last = now;
    }
    for item in FIRST_IDLE..count {
        let expected = if item < seeker::Item::machine0 as usize {
            10_000
        } else {
            1000
        };
        let near = expected - expected / 6..expected + expected / 6;
        assert!(near.contains(&changes[item]), "{item} {}", changes[item]);
        assert!((7000..13_000).contains(&on[item]), "{item} {}", on[item]);
    }
}

#[test]
fn the_planner_needs_no_action_too_much_the_rival_few_and_chance_many() {
    let (mut planned, mut searched, mut random) = (0.0, 0.0, 0.0);
    let worlds = 10;
    for seed in 0..worlds {
        let share = |world: &Keys| world.efficiency() / f64::from(world.tries()) / worlds as f64;
        let mut world = Keys::new(seed);
        driven(&mut world, 2000, Keys::planned);
        planned += share(&world);
        let lived = |learner: &mut dyn Learner, actions: u32| {
            let mut world = Keys::new(seed);
            rewarded(learner, &mut world, actions).unwrap();
            share(&world)
        };
        searched += lived(&mut Untaught::new(Searcher::default(), seed), 2000);
        random += lived(&mut Untaught::new(Random { actions: 6 }, seed), 20_000);
    }
    assert!((planned - 1.0).abs() < 1e-9, "{planned}");
    assert!((0.75..1.0).contains(&searched), "{searched}");
    assert!(random < 0.1 * searched, "{random}");
    assert!(random > 0.0);
}

#[test]
fn the_same_seed_gives_the_same_rooms_and_tries() {
    let life = |seed| {
        let mut world = Keys::new(seed);
        let step = |it: usize| {
            world.act(it * 5 % 6);
            (world.situation(), world.sense())
        };
        (0..500).map(step).collect::<Vec<_>>()
    };
    assert_eq!(life(3), life(3));
    assert_ne!(life(3), life(4));
}
