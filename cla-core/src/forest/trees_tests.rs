//! Contexts that grow from samples: what they ask, what they leave out, and work in parts.

use super::super::budget::WorkBudget;
use super::super::memory::Sample;
use super::super::moment::Moment;
use super::{Forest, Horizon};
use crate::num::Rng;
use crate::word::{ItemId, ItemStates};

type Woods = Forest<1, 8, 2, 64, 32>;

const HORIZON: Horizon = Horizon {
    discount: 0.9,
    lambda: 0.8,
};

/// Eight items: some on, by their bits, and some unknown.
fn percept(on: u32, unknown: u32) -> ItemStates<1> {
    let mut now = ItemStates::all_off(8);
    for item in 0..8 {
        let state = (unknown >> item & 1 == 0).then_some(on >> item & 1 == 1);
        now.set(ItemId(item), state).unwrap();
    }
    now
}

fn finish(forest: &mut Woods, budget: u32, crowded: bool) {
    for _ in 0..1_000_000 {
        if !forest.is_pending() {
            return;
        }
        forest.work(&mut WorkBudget::of(budget), HORIZON, crowded);
    }
    panic!("work never ends");
}

/// Episodes of one action: action 1 brings 1 where items 0 and 1 are on; all items blink, and some
/// readings are lost.
fn conjunction(budget: u32, lost: f32, seed: u64) -> Woods {
    let mut forest = Woods::new();
    forest.begin(7);
    let mut rng = Rng::new(seed);
    for _ in 0..1_000 {
        let on = rng.next_u32() & 0xFF;
        let mut unknown = 0;
        for item in 0..8 {
            unknown |= u32::from(rng.chance(lost)) << item;
        }
        let action = rng.below(2) as u8;
        let reward = f32::from(u8::from(action == 1 && on & 0b11 == 0b11));
        let now = percept(on, unknown);
        forest.remember(Sample::new(&now, action, reward).beginning());
        forest.interrupt();
    }
    // Three members: as many rounds.
    for _ in 0..3 {
        finish(&mut forest, budget, true);
        for _ in 0..32 {
            forest.remember(Sample::new(&percept(0, 0), 0, 0.0).beginning());
            forest.interrupt();
        }
    }
    forest
}

fn value(forest: &Woods, on: u32, unknown: u32) -> [f32; 2] {
    forest.values(&Moment::first(&percept(on, unknown))).0
}

#[test]
fn contexts_say_no_more_than_they_must() {
    let forest = conjunction(10_000, 0.0, 1);
    for noise in [0, 0b1010_1000, 0b0101_0100, 0b1111_1100] {
        assert!(value(&forest, 0b11 | noise, 0)[1] > 0.9);
        assert!(value(&forest, 0b01 | noise, 0)[1] < 0.1);
        assert!(value(&forest, 0b10 | noise, 0)[1] < 0.1);
        assert!(value(&forest, 0b11 | noise, 0)[0].abs() < 0.1);
    }
    // A leaf for each side of the two questions, and hardly more.
    assert!(forest.leaves() <= 6, "{}", forest.leaves());
}

#[test]
fn the_items_that_matter_are_named_where_tables_are_crowded() {
    let forest = conjunction(10_000, 0.0, 2);
    let mask: std::vec::Vec<u16> = forest.mask().iter().map(|item| item.0).collect();
    assert_eq!(mask, [0, 1]);
    assert!(forest.relevance(ItemId(0)) > 30.0);
    assert!((2..8).all(|item| forest.relevance(ItemId(item)) < 15.0));
}

#[test]
fn an_unknown_item_costs_what_it_was_worth() {
    let forest = conjunction(10_000, 0.0, 3);
    let half = value(&forest, 0b01, 0b10)[1];
    assert!((half - 0.5).abs() < 0.1, "{half}");
    let quarter = value(&forest, 0, 0xFF)[1];
    assert!((quarter - 0.25).abs() < 0.08, "{quarter}");
    // Others may be unknown at no cost.
    assert!(value(&forest, 0b11, 0xFC)[1] > 0.9);
}

#[test]
fn samples_with_lost_readings_teach_too() {
    let forest = conjunction(10_000, 0.3, 4);
    assert!(value(&forest, 0b11, 0)[1] > 0.6);
    assert!(value(&forest, 0b01, 0)[1] < 0.25);
}

#[test]
fn work_in_small_parts_grows_the_same_trees_to_the_bit() {
    let (at_once, spread) = (conjunction(u32::MAX, 0.1, 5), conjunction(1, 0.1, 5));
    assert_eq!(at_once.grown(), spread.grown());
    for on in 0..256 {
        let (one, other) = (value(&at_once, on, 0), value(&spread, on, 0));
        assert_eq!(one.map(f32::to_bits), other.map(f32::to_bits));
    }
}

#[test]
fn a_call_does_not_much_more_than_its_budget() {
    // A step looks at 8 samples, or at every feature of a leaf; a sweep's step at every tree.
    let mut forest = conjunction(10_000, 0.0, 6);
    for _ in 0..64 {
        forest.remember(Sample::new(&percept(1, 0), 0, 0.0));
    }
    let mut calls = 0;
    while forest.is_pending() {
        forest.work(&mut WorkBudget::of(500), HORIZON, true);
        calls += 1;
    }
    // Some 1000 samples with 2 actions in 3 members, and growth: it cannot be done in a few calls.
    assert!(calls > 20, "{calls}");
}

/// A corridor: item `place` is on; action 1 leads on, action 0 stays; the last place brings 1.
fn corridor(watched: bool) -> Woods {
    let mut forest = Woods::new();
    forest.begin(1);
    let mut rng = Rng::new(11);
    let mut place = 0;
    let mut begins = true;
    for step in 0..4_000 {
        let action = rng.below(2) as u8;
        let arrives = action == 1 && place == 4;
        let reward = f32::from(u8::from(arrives));
        let mut sample = Sample::new(&percept(1 << place, 0), action, reward);
        if begins {
            sample = sample.beginning();
        }
        if watched {
            sample = sample.watched();
        }
        forest.remember(sample);
        begins = arrives;
        if arrives {
            forest.interrupt();
            place = 0;
        } else if action == 1 {
            place += 1;
        }
        if step % 4 == 3 {
            forest.work(&mut WorkBudget::of(20_000), HORIZON, false);
        }
    }
    forest
}

#[test]
fn rewards_are_felt_from_afar_discounted_by_every_step() {
    let forest = corridor(false);
    for place in 0..5_u32 {
        let [stay, on] = value(&forest, 1 << place, 0);
        let wanted = [0.6561, 0.729, 0.81, 0.9, 1.0][place as usize];
        assert!((on - wanted).abs() < 0.08, "{place}: {on}");
        assert!(on > stay, "{place}: {on} {stay}");
    }
}

#[test]
fn where_somebody_else_acted_a_place_is_worth_what_he_got() {
    // Who stays half of the time arrives later, so every place is worth less than it could be.
    let (own, watched) = (corridor(false), corridor(true));
    let (own, watched) = (value(&own, 1, 0)[1], value(&watched, 1, 0)[1]);
    assert!(watched < own - 0.1, "{watched} {own}");
}
