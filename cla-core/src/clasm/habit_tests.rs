//! What becomes a habit, as tests.

use std::boxed::Box;

use super::{ActionId, HabitConfig, Habits, ItemSet, SyntheticId};
use crate::clasm::{
    Adaptation, Agent, AgentConfig, AgentError, ConfigError, ItemId, ItemStates, SurpriseConfig,
};

type Three = Habits<1, 3, 2, 4>;
const CONFIG: HabitConfig = HabitConfig::FORAGER;
const RIGHT: ActionId = ActionId(0);
const WRONG: ActionId = ActionId(1);

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
        it.feel((at(place), None, RIGHT), reward, 0.1, &CONFIG);
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
    it.feel((at(0), trace, WRONG), 0.0, 0.5, &CONFIG);
    it.feel((at(1), None, RIGHT), 0.0, 0.5, &CONFIG);
    it.feel((at(0), None, RIGHT), 10.0, 0.5, &CONFIG);
    it.feel((at(2), None, RIGHT), 0.0, 0.5, &CONFIG);
    // Always and item 0 by half of the reward; what was before by less; its item came again.
    let fading = CONFIG.discount * CONFIG.lambda;
    assert_eq!(it.always, [5.0, 0.0]);
    assert_eq!(it.items[0], [5.0, 0.0]);
    assert_eq!(it.items[1], [5.0 * fading, 0.0]);
    assert_eq!(it.traces[1], [0.0, 5.0 * fading * fading]);
    assert_eq!(it.worth(&at(0), trace), [10.0, 5.0 * fading * fading]);
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
            0.1,
            &CONFIG,
        );
    }
    let moved = it.feel((ItemSet::EMPTY, None, RIGHT), 0.0, 0.1, &CONFIG);
    assert_eq!(moved, 1 + 16);
    for (step, worth) in it.traces.iter().enumerate() {
        assert_eq!(worth[0] > 0.0, step >= 40 - 16, "{step}");
    }
    it.pause();
    assert_eq!(it.feel((at(0), None, RIGHT), 10.0, 0.5, &CONFIG), 0);
}

#[test]
fn many_features_at_full_rate_do_not_run_away() {
    let config = HabitConfig {
        discount: 0.0,
        ..CONFIG
    };
    let mut it = Three::new();
    let everything = ItemSet::first(3);
    for _ in 0..1000 {
        it.feel(
            (everything, Some(SyntheticId(0)), RIGHT),
            10.0,
            1.0,
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
    it.feel((at(0), None, RIGHT), 0.0, 0.5, &CONFIG);
    it.add(10.0);
    it.feel((at(1), None, RIGHT), 0.0, 0.5, &CONFIG);
    assert_eq!(it.worth(&at(0), None), [10.0, 0.0]);
}

#[test]
fn an_item_that_stands_for_another_schema_begins_without_habits() {
    let mut it = Three::new();
    let trace = SyntheticId(2);
    it.feel((at(0), Some(trace), RIGHT), 10.0, 0.25, &CONFIG);
    it.feel((at(1), None, RIGHT), 0.0, 0.25, &CONFIG);
    assert_eq!(it.traces[2], [2.5, 0.0]);
    it.feel((at(1), Some(trace), RIGHT), 10.0, 0.25, &CONFIG);
    it.renew(trace);
    it.feel((at(2), None, RIGHT), 0.0, 0.25, &CONFIG);
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
    it.begin(config, 1).unwrap();
    it.knowledge_mut()
        .set_inherent_value(ItemId(1), 10.0)
        .unwrap();
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
        assert_eq!(none.reconfigure(config(bad)), Err(ConfigError::Habits));
    }
    // A configuration is no birth.
    let mut unborn = Miner::new();
    unborn.reconfigure(config(CONFIG)).unwrap();
    let now = ItemStates::all_off(2);
    assert_eq!(unborn.choose(&now), Err(AgentError::NotBegun));
    assert_eq!(unborn.learn(&now), Err(AgentError::NotBegun));
    assert_eq!(unborn.act(Adaptation::Frozen), Err(AgentError::NotBegun));
    let seen = unborn.observe(&now, RIGHT, &now);
    assert_eq!(seen, Err(AgentError::NotBegun));
}
