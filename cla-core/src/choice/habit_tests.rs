//! What becomes a habit, as tests.

use std::boxed::Box;

use super::{ActionId, HabitConfig, Habits, ItemSet, SyntheticId, Traces};
use crate::adaptation::SurpriseConfig;
use crate::agent::{Adaptation, Agent, AgentConfig, AgentError};
use crate::check::Config;
use crate::word::{ItemId, ItemStates};

type Three = Habits<1, 3, 2, 4>;
const CONFIG: HabitConfig = HabitConfig::FORAGER;
const RIGHT: ActionId = ActionId(0);
const WRONG: ActionId = ActionId(1);

fn rate(learning_rate: f32) -> HabitConfig {
    HabitConfig {
        learning_rate,
        ..CONFIG
    }
}

fn at(item: u16) -> ItemSet<1> {
    let mut on = ItemSet::EMPTY;
    on.insert(ItemId(item)).unwrap();
    on
}

#[test]
fn in_a_ring_every_action_gets_the_discounted_sum_of_what_follows_it() {
    let mut it = Three::new();
    for step in 0..6000_u16 {
        let place = step % 3;
        let reward = if place == 2 { 10.0 } else { 0.0 };
        it.feel((at(place), None, RIGHT), reward, false, &rate(0.1));
    }
    let g = CONFIG.discount;
    let last = 10.0 / (1.0 - g * g * g);
    for (place, expected) in [(2, last), (1, g * last), (0, g * g * last)] {
        let [right, wrong] = it.worth(&at(place), None);
        assert!(
            (right - expected).abs() < 0.01 * expected,
            "{place}: {right}"
        );
        assert_eq!(wrong, 0.0);
    }
}

#[test]
fn a_reward_is_felt_back_along_the_way_and_a_feature_that_came_again_by_its_last_action() {
    let mut it = Three::new();
    let trace = Some(SyntheticId(1));
    it.feel((at(0), trace, WRONG), 0.0, false, &rate(0.5));
    it.feel((at(1), None, RIGHT), 0.0, false, &rate(0.5));
    it.feel((at(0), None, RIGHT), 10.0, false, &rate(0.5));
    it.feel((at(2), None, RIGHT), 0.0, false, &rate(0.5));
    // Always and item 0 by half of the reward; what was before by less; its item came again.
    let fading = CONFIG.discount * CONFIG.lambda;
    assert_eq!(it.always, [5.0, 0.0]);
    assert_eq!(it.items[0], [5.0, 0.0]);
    assert_eq!(it.items[1], [5.0 * fading, 0.0]);
    assert_eq!(it.traces[1], [0.0, 5.0 * fading * fading]);
    assert_eq!(it.worth(&at(0), trace), [10.0, 5.0 * fading * fading]);
}

#[test]
fn where_traces_accumulate_every_deed_feels_it_and_in_a_doubt_the_newest_alone() {
    let accumulating = HabitConfig {
        learning_rate: 0.1,
        doubting_rate: 0.1,
        traces: Traces::Accumulating,
        ..CONFIG
    };
    let trace = Some(SyntheticId(1));
    let lived = |doubts| {
        let mut it = Three::new();
        it.feel((at(0), trace, WRONG), 0.0, doubts, &accumulating);
        it.feel((at(0), trace, RIGHT), 10.0, doubts, &accumulating);
        let moved = it.feel((at(2), None, RIGHT), 0.0, doubts, &accumulating);
        (it, moved)
    };
    let fading = CONFIG.discount * CONFIG.lambda;
    let (it, moved) = lived(false);
    assert_eq!(moved, 6);
    let both = [1.0, fading];
    assert_eq!((it.always, it.items[0], it.traces[1]), (both, both, both));
    let (it, moved) = lived(true);
    assert_eq!(moved, 3);
    let newest = [1.0, 0.0];
    assert_eq!(
        (it.always, it.items[0], it.traces[1]),
        (newest, newest, newest)
    );
}

#[test]
fn habits_stay_within_what_can_be_earned_however_many_items_are_on_for_however_long() {
    let mut tried = 0;
    for traces in [Traces::Replacing, Traces::Accumulating] {
        for (discount, lambda, rate) in [(0.85, 0.8, 0.01), (0.85, 0.8, 1.0), (0.95, 1.0, 0.1)] {
            if traces == Traces::Replacing && rate == 1.0 {
                // These drift.
                continue;
            }
            for (items, stay) in [(0, 40), (6, 12), (118, 12), (118, 40)] {
                let config = HabitConfig {
                    discount,
                    lambda,
                    learning_rate: rate,
                    traces,
                    ..CONFIG
                };
                let mut it = Habits::<4, 118, 2, 4>::new();
                let (here, there) = (ItemSet::first(items), ItemSet::EMPTY);
                let most = 10.0 / (1.0 - discount);
                for step in 0..4000 {
                    let leaves = step % (stay + 1) == stay;
                    let reward = if leaves { 10.0 } else { 0.0 };
                    let (on, action) = if leaves {
                        (there, WRONG)
                    } else {
                        (here, RIGHT)
                    };
                    it.feel((on, None, action), reward, false, &config);
                    for worth in [it.worth(&here, None), it.worth(&there, None)] {
                        assert!(
                            worth[0].abs() <= most && worth[1].abs() <= most,
                            "{worth:?}"
                        );
                    }
                }
                tried += 1;
            }
        }
    }
    assert_eq!(tried, 20);
}

#[test]
fn no_more_is_felt_than_the_last_deeds_and_nothing_after_a_pause() {
    // Every deed has a trace of its own; the ring has gone round more than once.
    let mut it = Habits::<1, 1, 2, 40>::new();
    for step in 0..40 {
        let reward = if step == 39 { 10.0 } else { 0.0 };
        it.feel(
            (ItemSet::EMPTY, Some(SyntheticId(step)), RIGHT),
            reward,
            false,
            &rate(0.1),
        );
    }
    let moved = it.feel((ItemSet::EMPTY, None, RIGHT), 0.0, false, &rate(0.1));
    assert_eq!(moved, 1 + 16);
    for (step, worth) in it.traces.iter().enumerate() {
        assert_eq!(worth[0] > 0.0, step >= 40 - 16, "{step}");
    }
    it.pause();
    assert_eq!(it.feel((at(0), None, RIGHT), 10.0, false, &rate(0.5)), 0);
}

#[test]
fn many_features_at_full_rate_do_not_run_away() {
    let config = HabitConfig {
        discount: 0.0,
        ..rate(1.0)
    };
    let mut it = Three::new();
    let everything = ItemSet::first(3);
    for _ in 0..1000 {
        it.feel(
            (everything, Some(SyntheticId(0)), RIGHT),
            10.0,
            false,
            &config,
        );
    }
    let [right, _] = it.worth(&everything, Some(SyntheticId(0)));
    assert!((right - 10.0).abs() < 1e-3, "{right}");
}

#[test]
fn what_a_reflex_brings_belongs_to_the_deed_before_it() {
    let mut it = Three::new();
    it.add(10.0);
    it.feel((at(0), None, RIGHT), 0.0, false, &rate(0.5));
    it.add(10.0);
    it.feel((at(1), None, RIGHT), 0.0, false, &rate(0.5));
    assert_eq!(it.worth(&at(0), None), [10.0, 0.0]);
}

#[test]
fn an_item_that_stands_for_another_schema_begins_without_habits() {
    let mut it = Three::new();
    let trace = SyntheticId(2);
    it.feel((at(0), Some(trace), RIGHT), 10.0, false, &rate(0.25));
    it.feel((at(1), None, RIGHT), 0.0, false, &rate(0.25));
    assert_eq!(it.traces[2], [2.5, 0.0]);
    it.feel((at(1), Some(trace), RIGHT), 10.0, false, &rate(0.25));
    it.renew(trace);
    it.feel((at(2), None, RIGHT), 0.0, false, &rate(0.25));
    assert_eq!(it.traces[2], [0.0, 0.0]);
    // An id outside the capacity is nothing, not a panic.
    it.renew(SyntheticId(99));
    assert_eq!(it.worth(&at(9), Some(SyntheticId(99))), it.always);
}

/// One item; the action `gold` always brings the valued one, if the mine is not empty.
type Miner = Agent<1, 2, 4, 4, 2, 16, 16, 8, 16>;

fn miner(habits: Option<HabitConfig>) -> Box<Miner> {
    let mut it = Box::new(Miner::new());
    let config = AgentConfig {
        habits,
        surprise: Some(SurpriseConfig::FORAGER),
        greedy_share: 0.5,
        ..AgentConfig::FORAGER_LEVEL2
    };
    it.be_born(config, &[(ItemId(1), 10.0)], 1).unwrap();
    it
}

fn dig(agent: &mut Miner, full: bool, steps: u32) -> u32 {
    let mut here = ItemStates::all_off(2);
    here.set(ItemId(0), Some(true)).unwrap();
    let mut gold = here;
    gold.set(ItemId(1), Some(true)).unwrap();
    let mut dug = 0;
    for _ in 0..steps {
        let digs = agent.choose(&here).unwrap().action == RIGHT;
        agent
            .learn(if digs && full { &gold } else { &here })
            .unwrap();
        dug += u32::from(digs);
    }
    dug
}

#[test]
fn an_agent_in_doubt_changes_its_habits_faster_and_a_frozen_one_not_at_all() {
    let mut calm = miner(Some(CONFIG));
    dig(&mut calm, true, 1000);
    let worth = |it: &Miner| it.habits().worth(&at(0), None)[0];
    let before = worth(&calm);
    assert!(before > 10.0, "{before}");
    calm.act(Adaptation::Relearning).unwrap();
    let (mut frozen, mut doubting) = (calm.clone(), calm.clone());
    doubting.doubt();
    frozen.act(Adaptation::Frozen).unwrap();
    for it in [&mut calm, &mut doubting, &mut frozen] {
        dig(it, false, 4);
    }
    assert_eq!(worth(&frozen), before);
    assert!(worth(&doubting) < worth(&calm) && worth(&calm) < before);
    assert!(frozen.cost().habits == 0 && calm.cost().habits > 0);
}

#[test]
fn without_habits_nothing_is_practised_and_bad_ones_are_refused() {
    let mut none = miner(None);
    dig(&mut none, true, 200);
    assert_eq!(*none.habits(), Habits::new());
    let config = |habits| AgentConfig {
        habits: Some(habits),
        ..AgentConfig::FORAGER_LEVEL2
    };
    for bad in [
        HabitConfig {
            weight: 1.5,
            ..CONFIG
        },
        HabitConfig {
            discount: 1.0,
            ..CONFIG
        },
        HabitConfig {
            learning_rate: f32::NAN,
            ..CONFIG
        },
    ] {
        let refused = none.reconfigure(config(bad)).unwrap_err();
        assert!(refused.field.starts_with("HabitConfig::"), "{refused}");
    }
    // A configuration is no birth.
    let mut unborn = Miner::new();
    unborn.reconfigure(config(CONFIG)).unwrap();
    let now = ItemStates::all_off(2);
    assert_eq!(unborn.choose(&now), Err(AgentError::NotBorn));
    assert_eq!(unborn.learn(&now), Err(AgentError::NotBorn));
    assert_eq!(unborn.act(Adaptation::Frozen), Err(AgentError::NotBorn));
    let seen = unborn.observe(&now, RIGHT, &now);
    assert_eq!(seen, Err(AgentError::NotBorn));
}

#[test]
fn habits_that_are_cleared_are_as_new() {
    let mut it = Three::new();
    it.feel(
        (at(0), Some(SyntheticId(1)), RIGHT),
        10.0,
        false,
        &rate(0.5),
    );
    it.feel((at(1), None, RIGHT), 0.0, false, &rate(0.5));
    assert_ne!(it, Three::new());
    it.clear();
    assert_eq!(it, Three::new());
    assert_eq!(it, Three::default());
}

#[test]
fn a_new_life_begins_without_the_habits_of_the_old_one() {
    let mut agent = miner(Some(CONFIG));
    dig(&mut agent, true, 200);
    assert_ne!(*agent.habits(), Habits::new());
    agent
        .be_born(AgentConfig::FORAGER_LEVEL2, &[(ItemId(1), 10.0)], 1)
        .unwrap();
    assert_eq!(*agent.habits(), Habits::new());
}

#[test]
fn a_td_error_is_what_came_and_what_is_to_be_had_less_what_was_expected() {
    let mut it = Three::new();
    it.items[0] = [4.0, 0.0];
    it.items[1] = [0.0, 6.0];
    it.feel((at(0), None, RIGHT), 3.0, false, &rate(0.25));
    // Always and the item move by a quarter each of 3 + .85 · 6 − 4.
    let moved = it.feel((at(1), None, WRONG), 0.0, false, &rate(0.25));
    assert_eq!(moved, 2);
    let step = 0.25 * (3.0 + 0.85 * 6.0 - 4.0);
    let near = |value: f32, expected: f32| assert!((value - expected).abs() < 1e-5, "{value}");
    near(it.always[0], step);
    near(it.items[0][0], 4.0 + step);
    assert_eq!(it.items[1], [0.0, 6.0]);
    // At full rate a deed of two features moves by half the error each: to what was felt.
    it.feel((at(2), None, RIGHT), 0.0, false, &rate(1.0));
    let before = it.worth(&at(2), None)[0];
    near(it.items[1][1] + it.always[1], 0.85 * before);
}

#[test]
fn what_is_not_finite_is_not_learned() {
    let mut it = Three::new();
    it.feel((at(0), None, RIGHT), f32::INFINITY, false, &rate(0.5));
    assert_eq!(it.feel((at(1), None, RIGHT), 0.0, false, &rate(0.5)), 0);
    assert_eq!(it.worth(&at(0), None), [0.0, 0.0]);
}

#[test]
fn a_trace_that_came_again_belongs_to_the_newer_deed() {
    let mut it = Three::new();
    let trace = Some(SyntheticId(3));
    it.feel((ItemSet::EMPTY, trace, WRONG), 0.0, false, &rate(0.25));
    it.feel((ItemSet::EMPTY, trace, RIGHT), 10.0, false, &rate(0.25));
    let moved = it.feel((ItemSet::EMPTY, None, RIGHT), 0.0, false, &rate(0.25));
    assert_eq!((moved, it.traces[3]), (2, [2.5, 0.0]));
    // A trace that is renewed is no part of the deeds any more, others are.
    it.feel(
        (ItemSet::EMPTY, Some(SyntheticId(2)), RIGHT),
        0.0,
        false,
        &rate(0.25),
    );
    it.renew(SyntheticId(3));
    it.feel((ItemSet::EMPTY, None, RIGHT), 10.0, false, &rate(0.25));
    it.feel((ItemSet::EMPTY, None, RIGHT), 0.0, false, &rate(0.25));
    assert_eq!(it.traces[3], [0.0, 0.0]);
    assert!(it.traces[2][0] > 0.5);
}

#[test]
fn a_configuration_of_habits_is_sound_when_every_number_is_in_range() {
    let bad: [fn(&mut HabitConfig); 9] = [
        |it| it.weight = 1.5,
        |it| it.weight = -0.5,
        |it| it.discount = 1.0,
        |it| it.discount = -0.1,
        |it| it.lambda = 1.1,
        |it| it.lambda = f32::NAN,
        |it| it.learning_rate = -1.0,
        |it| it.doubting_rate = 2.0,
        |it| it.doubting_rate = f32::INFINITY,
    ];
    for (index, spoil) in bad.into_iter().enumerate() {
        let mut config = CONFIG;
        assert!(config.check().is_ok());
        spoil(&mut config);
        assert!(config.check().is_err(), "{index}");
    }
    let edges = HabitConfig {
        weight: 0.0,
        discount: 0.0,
        lambda: 1.0,
        learning_rate: 0.0,
        doubting_rate: 1.0,
        traces: Traces::Accumulating,
    };
    assert!(edges.check().is_ok());
}

#[test]
fn at_full_rate_all_features_of_a_deed_together_move_to_what_was_felt() {
    for (on, trace) in [
        (ItemSet::EMPTY, None),
        (at(0), None),
        (ItemSet::EMPTY, Some(SyntheticId(1))),
        (ItemSet::first(3), Some(SyntheticId(1))),
    ] {
        let mut it = Three::new();
        it.feel((on, trace, RIGHT), 6.0, false, &rate(1.0));
        it.pause();
        it.feel((on, trace, RIGHT), 6.0, false, &rate(1.0));
        assert_eq!(
            it.worth(&on, trace),
            [0.0, 0.0],
            "a pause forgets what came"
        );
        it.feel((ItemSet::EMPTY, None, WRONG), 0.0, false, &rate(1.0));
        let [right, wrong] = it.worth(&on, trace);
        assert!(
            (right - 6.0).abs() < 1e-5 && wrong == 0.0,
            "{right} {wrong}"
        );
    }
}
