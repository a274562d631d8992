//! Shorter lives and their judgement; the worlds' tables; who must reach what.

use std::sync::Arc;

use cla_core::agent::AgentConfig;
use cla_core::num::Rng;
use cla_core::snapshot::Names;

use super::constructed::{beyond_chance, told};
use super::rivals::{Budget, Rival};
use super::{Aliased, AliasedOptions, Place, Trial, declared};
use crate::baseline::random::Random;
use crate::baseline::tabular::Tabular;
use crate::baseline::worlds::believer::Believer;
use crate::experiment::plan::trials;
use crate::experiment::record::judged_again;
use crate::learner::controller::Untaught;
use crate::learner::rewarded::rewarded;
use crate::learner::{Learner, live};
use crate::progress::Progress;
use crate::report::Verdict;
use crate::world::World;
use crate::world::barriers::Barriers;
use crate::world::pomdp::{Pomdp, PomdpWorld};

fn model(place: Place) -> Arc<Pomdp> {
    place.model().unwrap().unwrap()
}

#[test]
fn every_world_is_lived_in_written_down_and_judged_and_leaves_no_claim_without_a_number() {
    // Planning in the hallway takes a while.
    let mut options = AliasedOptions::standard(vec![3, 4]);
    options.places.retain(|it| *it != Place::Hallway);
    options.shorter = 100;
    let summary = judged_again::<Aliased>(&options).unwrap().summary;
    let ids = |claims: &[crate::report::Claim]| -> Vec<String> {
        claims.iter().map(|it| it.id.clone()).collect()
    };
    let mut known = declared();
    known.retain(|it| !it.id.contains("hallway"));
    assert_eq!(ids(&summary.claims), ids(&known));
    for claim in &summary.claims {
        assert_eq!(claim.ours.n, 2, "{}", claim.id);
        assert!(matches!(
            claim.verdict,
            Verdict::Measured | Verdict::TooSmall
        ));
    }
}

/// What the best earns when the state is known, where remembering all that was seen tells it.
#[test]
fn the_planner_reaches_the_optimum_where_memory_tells_the_state() {
    // A corridor takes its delay, the choice and the way back: 4 in each.
    for (place, best) in [
        (Place::TMaze2, 4.0 / 4.0),
        (Place::TMaze4, 4.0 / 6.0),
        (Place::TMaze8, 4.0 / 10.0),
        (Place::TMaze16, 4.0 / 18.0),
        (Place::Shuttle, 1.842),
    ] {
        let model = model(place);
        let known = model.model().rate(1e-9).gain;
        assert!((known - best).abs() < 1e-3, "{place:?} {known}");
        let mut planner = Untaught::new(Believer::new(place.plan(&model)), 1);
        let mut world = PomdpWorld::new(Arc::clone(&model), 1);
        let earned = rewarded(&mut planner, &mut world, 10_000).unwrap();
        let share = earned.per_action() / best;
        assert!((0.97..1.03).contains(&share), "{place:?} {share}");
    }
}

/// Who knows the state of the cheese maze has more than who must find it out.
#[test]
fn where_one_is_put_by_chance_a_belief_is_worth_less_than_the_state_and_more_than_chance() {
    let model = model(Place::Cheese);
    let known = model.model().rate(1e-9).gain;
    let live = |learner: &mut dyn Learner| {
        let mut world = PomdpWorld::new(Arc::clone(&model), 2);
        rewarded(learner, &mut world, 10_000).unwrap().per_action()
    };
    let planner = live(&mut Untaught::new(
        Believer::new(Place::Cheese.plan(&model)),
        2,
    ));
    let actions = model.actions().len() as u32;
    let random = live(&mut Untaught::new(Random { actions }, 2));
    assert!(
        planner < 1.02 * known && planner > 0.8 * known,
        "{planner} of {known}"
    );
    assert!(planner > 2.0 * random, "{planner} {random}");
}

/// A cue two actions ago is in two steps of history and not in the percept.
#[test]
fn tuned_rivals_with_history_see_a_cue_that_those_on_percepts_do_not() {
    let place = Place::TMaze2;
    let earned = |rival: Rival| {
        let model = model(place);
        let mut world = PomdpWorld::new(Arc::clone(&model), 1);
        let mut table = Tabular::with_actions(rival.tuned(place).unwrap(), world.actions(), 1);
        rewarded(&mut table, &mut world, 20_000).unwrap();
        table.act().unwrap();
        rewarded(&mut table, &mut world, 5000).unwrap().per_action()
    };
    let all = Rival::ALL.map(earned);
    for (rival, earned) in Rival::ALL.iter().zip(all) {
        let (low, high) = match rival.name() {
            // Right half of the time, who does not see the cue earns at most (4 - .1) / 2 in four actions.
            "q" | "sarsa" => (0.3, 0.53),
            _ => (0.7, 1.0),
        };
        assert!((low..=high).contains(&earned), "{} {earned}", rival.name());
    }
}

#[test]
fn all_rivals_were_tuned_among_as_many_configurations_of_one_grid() {
    for place in Place::ALL {
        // Seeds 0 to 99 are for tuning.
        assert!(Budget::of(place).seeds <= 100);
        for rival in Rival::ALL {
            let grid = rival.grid(place);
            assert_eq!(grid.len(), 32);
            let tuned = rival.tuned(place).unwrap();
            assert!(
                grid.contains(&tuned),
                "{place:?} {} {tuned:?}",
                rival.name()
            );
        }
    }
}

#[test]
fn what_is_told_is_counted_in_bits_and_chance_tells_nothing() {
    let mut rng = Rng::new(1);
    let mut moments = Vec::new();
    for _ in 0..4000 {
        let (seen, state) = (rng.below(2) as usize, rng.below(2) as usize);
        moments.push((seen, state, 2 * seen + state));
    }
    assert!((told(&moments) - 1.0).abs() < 0.01);
    assert!((beyond_chance(&moments, &mut rng) - 1.0).abs() < 0.01);
    for moment in &mut moments {
        moment.1 = rng.below(200) as usize;
    }
    assert!(told(&moments) > 0.03 && beyond_chance(&moments, &mut rng).abs() < 0.03);
}

#[test]
fn the_brains_that_are_kept_are_those_at_the_end_of_their_training() {
    let folder = tempfile::tempdir().unwrap();
    let options = AliasedOptions {
        places: vec![Place::Barriers, Place::Cheese],
        shorter: 100,
        ..AliasedOptions::standard(vec![3])
    };
    let kept = |progress: Progress| trials::<Aliased>(&options, &progress).unwrap();
    let progress = Progress::hidden().keeping_brains(folder.path()).unwrap();
    // What is measured is the same with it and without.
    assert_eq!(kept(progress), kept(Progress::hidden()));
    let read = |name: &str| std::fs::read(folder.path().join(format!("{name}.brain"))).unwrap();
    // Without the tests on the way, of which a life knows nothing.
    let world = PomdpWorld::new(model(Place::Cheese), 3);
    let names = Names::of(world.items(), world.actions());
    let config = AgentConfig::RESILIENT_LEVEL2;
    for (name, born) in [
        ("mind", Place::Cheese.mind(world.items(), 3)),
        ("level2", Place::Cheese.book(config, world.items(), 3)),
    ] {
        let mut learner = born.unwrap();
        rewarded(&mut *learner, &mut world.clone(), 500).unwrap();
        let image = learner.image(names).unwrap();
        let name = format!("aliased-3-cheese-{name}");
        assert!(image == Some(read(&name)), "{name}");
    }
    let mut room = Barriers::new(3).unwrap();
    let names = Names::of(room.items(), room.actions());
    let config = AgentConfig::FORAGER;
    let mut learner = Place::Barriers.book(config, room.items(), 3).unwrap();
    live(&mut *learner, &mut room, 200).unwrap();
    let image = learner.image(names).unwrap();
    assert!(image == Some(read("aliased-3-barriers-level1")));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 6);
}

#[test]
fn what_was_not_lived_is_no_number() {
    assert!(Trial::default().last(Place::Cheese, "mind").is_nan());
}
