//! The lake's rules, what its planner promises and reaches, and what its rivals do.

use super::{GOAL, HOLES, Lake, STEPS, directions, neighbour, skater};
use crate::baseline::random::Random;
use crate::baseline::worlds::lake::Careful;
use crate::learner::controller::Untaught;
use crate::learner::rewarded::{driven, rewarded};
use crate::world::World;
use cla_core::word::ItemId;

#[test]
fn the_bank_stops_and_ice_leads_on() {
    assert_eq!((neighbour(0, 0), neighbour(0, 3)), (0, 0));
    assert_eq!((neighbour(0, 1), neighbour(0, 2)), (4, 1));
    assert_eq!((neighbour(GOAL, 1), neighbour(GOAL, 2)), (GOAL, GOAL));
    assert_eq!(neighbour(14, 2), GOAL);
    assert_eq!(skater::VOCABULARY.items[GOAL], "goal");
    // Down may slip to either side, never back.
    let mut down = directions(1);
    down.sort_unstable();
    assert_eq!(down, [0, 1, 2]);
}

#[test]
fn a_third_of_the_steps_go_each_way_and_one_item_is_on() {
    let mut counts = [0_u32; 16];
    for seed in 0..3000 {
        let mut world = Lake::new(seed);
        world.act(2);
        counts[world.field()] += 1;
        assert_eq!(world.sense().on().len(), 1);
        assert_eq!(world.sense().known().len(), 16);
        let item = ItemId(world.field() as u16);
        assert_eq!(world.sense().get(item), Some(true));
    }
    // Right, down, and up against the bank.
    for field in [1, 4, 0] {
        assert!((900..1100).contains(&counts[field]), "{counts:?}");
    }
}

#[test]
fn episodes_end_at_the_goal_in_a_hole_or_after_a_hundred_steps_and_only_the_goal_counts() {
    let mut world = Lake::new(3);
    let mut ends = [0_u32; 3];
    let mut steps = 0;
    for done in 0..200_000_usize {
        let before = world.obtained();
        world.act(if ends[2] == 0 { 0 } else { done % 4 });
        steps += 1;
        if world.episode_ended() {
            let at = world.field();
            let kind = [at == GOAL, HOLES.contains(&at), steps == STEPS];
            let kind = kind.iter().position(|&it| it).unwrap();
            ends[kind] += 1;
            assert_eq!(world.obtained() - before, u32::from(kind == 0));
            world.begin_episode();
            assert_eq!((world.field(), world.left()), (0, STEPS));
            steps = 0;
        } else {
            assert_eq!(world.obtained(), before);
        }
    }
    assert!(ends.iter().all(|&it| it > 0), "{ends:?}");
    assert_eq!(world.episodes(), ends.iter().sum::<u32>());
}

#[test]
fn an_action_in_an_ended_episode_is_the_first_of_the_next() {
    let mut world = Lake::new(1);
    while !world.episode_ended() {
        world.act(1);
    }
    world.act(0);
    assert_eq!(world.left(), STEPS - 1);
}

#[test]
fn the_same_seed_gives_the_same_life() {
    let life = |seed| {
        let mut world = Lake::new(seed);
        let fields = (0..500).map(|step| {
            world.act(step % 4);
            world.field()
        });
        fields.collect::<Vec<_>>()
    };
    assert_eq!(life(5), life(5));
    assert_ne!(life(5), life(6));
}

#[test]
fn the_planner_reaches_what_value_iteration_promises_and_the_rival_three_quarters_of_it() {
    let plan = Lake::optimum();
    let best = plan.value(0);
    // Known of this lake: .74 within a hundred steps.
    assert!((0.73..0.76).contains(&best), "{best}");
    let mut planned = [0.0; 4];
    let (mut careful, mut random) = (0.0, 0.0);
    for (seed, planned) in planned.iter_mut().enumerate() {
        let seed = seed as u64;
        let act = |world: &Lake| plan.action(world.field(), world.left() as usize);
        *planned = driven(&mut Lake::new(seed), 200_000, act).per_episode();
        let life = |learner: &mut dyn crate::learner::Learner| {
            rewarded(learner, &mut Lake::new(seed), 50_000).unwrap()
        };
        careful += life(&mut Untaught::new(Careful, seed)).per_episode() / 4.0;
        let mut chance = Untaught::new(Random { actions: 4 }, seed);
        random += life(&mut chance).per_episode() / 4.0;
    }
    let mean = planned.iter().fold(0.0, |sum, it| sum + it) / 4.0;
    assert!((mean - best).abs() < 0.01, "{mean} {best}");
    assert!(careful >= 0.75 * best, "{careful} {best}");
    assert!(random < 0.1 * careful, "{random} {careful}");
}
