//! What the generator promises, and what planner, rival and chance earn in its worlds.

use std::sync::Arc;

use super::{ACTIONS, Change, Generated, ITEMS, Shown, Spec, dweller};
use crate::baseline::random::Random;
use crate::baseline::worlds::generated::Engineer;
use crate::learner::Learner;
use crate::learner::controller::Untaught;
use crate::learner::rewarded::{driven, rewarded};
use crate::world::World;
use cla_core::num::Rng;
use cla_core::word::ItemId;

fn specs(seeds: u64) -> Vec<Arc<Spec>> {
    (0..seeds)
        .map(|seed| Arc::new(Spec::random(seed)))
        .collect()
}

#[test]
fn worlds_are_of_every_kind_that_the_generator_names_and_fit_the_brain() {
    let specs = specs(100);
    let has = |is: &dyn Fn(&Spec) -> bool| specs.iter().filter(|it| is(it)).count();
    for spec in &specs {
        assert!((ITEMS.0..=ITEMS.1).contains(&spec.shown.len()));
        assert!((ACTIONS.0..=ACTIONS.1).contains(&spec.effects.len()));
        let now = Generated::new(Arc::clone(spec), 1).sense();
        assert_eq!(usize::from(now.known().len()), dweller::ITEMS.len());
        assert!(
            now.on()
                .iter()
                .all(|it| usize::from(it.0) < spec.shown.len())
        );
        assert_eq!(spec.items(), &dweller::VOCABULARY.items[..spec.shown.len()]);
        assert_eq!(
            spec.actions(),
            &dweller::VOCABULARY.actions[..spec.effects.len()]
        );
        for (variable, &size) in spec.sizes.iter().enumerate() {
            let turns = |it: &&super::Effect| {
                it.variable == variable && it.change == Change::Up && size > 1
            };
            assert!(spec.effects.iter().any(|it| turns(&it)));
        }
    }
    let shared = |it: &Shown| matches!(it, Shown::Value { values, .. } if values.count_ones() > 1);
    let idle = |it: &Shown| matches!(it, Shown::Blinks(_) | Shown::Drifts(_));
    assert!(has(&|it| it.noise > 0.0) > 50 && has(&|it| it.noise == 0.0) > 10);
    assert!(has(&|it| it.slip > 0.0) > 50 && has(&|it| it.slip == 0.0) > 10);
    assert!(has(&|it| it.delay > 0) > 40 && has(&|it| it.delay == 0) > 20);
    assert!(has(&|it| it.shown.iter().any(shared)) > 20);
    assert!(has(&|it| it.shown.iter().any(idle)) > 50);
    assert!(has(&|it| it.shown.len() < 20) > 5 && has(&|it| it.shown.len() > 50) > 10);
}

#[test]
fn values_are_read_from_states_as_they_were_written() {
    for spec in specs(20) {
        for state in 0..spec.states() {
            for (variable, &size) in spec.sizes.iter().enumerate() {
                for value in 0..size {
                    let with = spec.with(state, variable, value);
                    assert_eq!(spec.value(with, variable), value);
                    let same = |it| it == variable || spec.value(with, it) == spec.value(state, it);
                    assert!((0..spec.sizes.len()).all(same));
                }
            }
        }
    }
}

#[test]
fn rewards_come_late_by_the_delay_and_are_shown_when_they_come() {
    let spec = specs(100).into_iter().find(|it| it.delay == 2).unwrap();
    let mut world = Generated::new(Arc::clone(&spec), 1);
    let mut rng = Rng::new(1);
    let (mut reached, mut shown) = (Vec::new(), Vec::new());
    for step in 0..20_000 {
        let before = world.earned();
        world.act(rng.below(spec.effects.len() as u32) as usize);
        if spec.is_goal(world.state()) {
            reached.push(step + 2);
        }
        let on = world.sense().get(ItemId(0)) == Some(true);
        assert_eq!(world.earned() - before, f64::from(u8::from(on)));
        if on {
            shown.push(step);
        }
    }
    reached.retain(|&step| step < 20_000);
    assert!(!shown.is_empty());
    assert_eq!(reached, shown);
}

#[test]
fn items_err_as_often_as_the_world_says_and_blink_as_they_should() {
    let spec = specs(100).into_iter().find(|it| it.noise == 0.05).unwrap();
    let mut world = Generated::new(Arc::clone(&spec), 3);
    let (mut errors, mut readings) = (0_u32, 0_u32);
    for step in 0..20_000 {
        world.act(step);
        for (index, shown) in spec.shown.iter().enumerate() {
            if let Shown::Value { variable, values } = *shown {
                let has = values >> spec.value(world.state(), variable) & 1 == 1;
                readings += 1;
                let on = world.sense().get(ItemId(index as u16)) == Some(true);
                errors += u32::from(on != has);
            }
        }
    }
    let share = f64::from(errors) / f64::from(readings);
    assert!((share - 0.05).abs() < 0.005, "{share}");
}

#[test]
fn value_iteration_is_reached_by_its_policy_and_the_engineer_by_three_quarters() {
    let (mut engineered, mut random) = (0.0, 0.0);
    let worlds = 30;
    for (seed, spec) in specs(worlds).into_iter().enumerate() {
        let rate = spec.model().rate(1e-6);
        let world = || Generated::new(Arc::clone(&spec), seed as u64);
        let planned = driven(&mut world(), 20_000, |it| rate.policy[it.state()]);
        let share = planned.per_action() / rate.gain;
        assert!((share - 1.0).abs() < 0.06, "{seed}: {share}");
        let lived = |learner: &mut dyn Learner| {
            let income = rewarded(learner, &mut world(), 5000).unwrap();
            income.per_action() / rate.gain / worlds as f64
        };
        engineered += lived(&mut Untaught::new(Engineer::new(Arc::clone(&spec)), 1));
        let actions = spec.effects.len() as u32;
        random += lived(&mut Untaught::new(Random { actions }, 1));
    }
    assert!((0.75..1.02).contains(&engineered), "{engineered}");
    assert!(random < 0.5 * engineered, "{random} {engineered}");
}

#[test]
fn the_same_seeds_give_the_same_world_and_life() {
    let life = |world, seed| {
        let mut world = Generated::new(Arc::new(Spec::random(world)), seed);
        let step = |it: usize| {
            world.act(it * 5);
            (world.state(), world.sense())
        };
        (0..300).map(step).collect::<Vec<_>>()
    };
    assert_eq!(life(1, 1), life(1, 1));
    assert_ne!(life(1, 1), life(1, 2));
    assert_eq!(Spec::random(7), Spec::random(7));
    assert_ne!(Spec::random(7), Spec::random(8));
}
