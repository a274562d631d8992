//! What items, states and actions are worth, by both rules.

use super::{Appraisal, InherentValueError, ItemId, ItemStates, KnowledgeBase, ValueConfig};
use crate::knowledge::Estimate;
use crate::word::{SchemaText, SignedItems, Vocabulary};

const WORDS: Vocabulary = Vocabulary {
    items: &["a", "b", "c", "gold"],
    actions: &["go", "stay"],
};
const A: ItemId = ItemId(0);
const B: ItemId = ItemId(1);
const C: ItemId = ItemId(2);
const GOLD: ItemId = ItemId(3);
const HALF: ValueConfig = ValueConfig {
    discount: 0.5,
    ..ValueConfig::BOOK
};

type Knowledge = KnowledgeBase<1, 16, 16>;

fn knowledge(schemas: &[(&str, u32, u32)]) -> Knowledge {
    let mut it = Knowledge::new();
    it.set_inherent_value(GOLD, 10.0).unwrap();
    for &(text, successes, activations) in schemas {
        let text = SchemaText::parse(text, &WORDS).unwrap();
        it.insert(&text, successes, activations).unwrap();
    }
    it
}

fn on(items: &[ItemId]) -> ItemStates<1> {
    let mut state = ItemStates::all_off(4);
    for &item in items {
        state.set(item, Some(true)).unwrap();
    }
    state
}

fn signed(positive: &[ItemId], negative: &[ItemId]) -> SignedItems<1> {
    let mut items = SignedItems::EMPTY;
    for &item in positive {
        items.insert(item, true).unwrap();
    }
    for &item in negative {
        items.insert(item, false).unwrap();
    }
    items
}

fn near(value: f32, expected: f32) {
    assert!((value - expected).abs() < 1e-4, "{value}, not {expected}");
}

#[test]
fn a_state_is_worth_the_sum_of_what_is_on_for_its_own_sake() {
    let mut it = knowledge(&[]);
    it.set_inherent_value(C, 4.0).unwrap();
    assert_eq!(it.reward(&on(&[A, C, GOLD])), 14.0);
    assert_eq!(it.reward(&on(&[A, B])), 0.0);
    // A value can be changed, and taken away again.
    it.set_inherent_value(C, 1.0).unwrap();
    it.set_inherent_value(GOLD, 0.0).unwrap();
    assert_eq!(it.reward(&on(&[C, GOLD])), 1.0);
    assert_eq!((it.inherent_value(C), it.inherent_value(GOLD)), (1.0, 0.0));
    assert!(it.valued.contains(C) && !it.valued.contains(GOLD));
    assert_eq!(it.inherent_value(ItemId(99)), 0.0);
}

#[test]
fn values_that_are_none_are_refused_by_name_and_change_nothing() {
    let mut it = knowledge(&[]);
    for (item, value, error) in [
        (GOLD, f32::NAN, InherentValueError::NotFinite),
        (GOLD, f32::INFINITY, InherentValueError::NotFinite),
        (GOLD, -0.5, InherentValueError::Negative),
        (ItemId(32), 1.0, InherentValueError::NoSuchItem),
    ] {
        assert_eq!(it.set_inherent_value(item, value), Err(error));
        assert!(std::string::ToString::to_string(&error).len() > 20);
    }
    assert_eq!(it, knowledge(&[]));
}

#[test]
fn to_a_value_the_inherent_values_of_positive_items_are_added() {
    let mut it = knowledge(&[]);
    it.set_inherent_value(C, 4.0).unwrap();
    near(it.with_inherent(2.0, &signed(&[A, C, GOLD], &[])), 16.0);
    near(it.with_inherent(2.0, &signed(&[A, B], &[GOLD])), 2.0);
}

#[test]
fn an_item_is_worth_the_larger_of_its_own_value_and_what_it_leads_to() {
    let mut it = knowledge(&[("+b/go/+gold", 1, 1), ("+a/go/+b", 1, 1)]);
    it.set_inherent_value(B, 7.0).unwrap();
    it.defer_values(&HALF);
    let values = |it: &Knowledge| [A, B, C, GOLD].map(|item| it.deferred_value(item));
    // b leads to 5 and is worth 7; a leads to b.
    assert_eq!(values(&it), [3.5, 7.0, 0.0, 10.0]);
    it.set_inherent_value(B, 1.0).unwrap();
    it.defer_values(&HALF);
    assert_eq!(values(&it), [2.5, 5.0, 0.0, 10.0]);
    assert_eq!(it.largest_value(&signed(&[A, B], &[GOLD])), 5.0);
    assert_eq!(it.largest_value(&signed(&[GOLD, A], &[])), 10.0);
    assert_eq!(it.largest_value(&signed(&[], &[GOLD])), 0.0);
    assert_eq!(it.deferred_value(ItemId(99)), 0.0);
}

#[test]
fn value_flows_against_the_order_of_the_table_round_circles_and_into_every_positive_item() {
    let mut it = knowledge(&[
        ("+a+c-gold/go/+b", 1, 1),
        ("+b/go/+gold", 1, 1),
        ("+b/go/+a", 1, 1),
        ("-gold/stay/+gold", 1, 1),
        ("+gold/stay/-b", 1, 1),
    ]);
    it.defer_values(&HALF);
    let values = [A, B, C, GOLD].map(|item| it.deferred_value(item));
    assert_eq!(values, [2.5, 5.0, 2.5, 10.0]);
}

/// How often going from a must bring gold, and how often going from c does.
fn way(here: u32, there: u32) -> Knowledge {
    knowledge(&[
        ("+a/go/+gold", here, 100),
        ("+a/go/+a", 100 - here, 100),
        ("+c/go/+gold", there, 100),
        ("+c/go/+c", 100 - there, 100),
        ("+c/stay/+gold", 100, 100),
    ])
}

#[test]
fn a_way_is_what_brings_an_item_often_enough_in_all_in_share_and_beside_the_average() {
    let leads = |it: &mut Knowledge, config: &ValueConfig| {
        it.defer_values(config);
        it.deferred_value(A) > 0.0
    };
    let successes = |chain_successes| ValueConfig {
        chain_successes,
        ..HALF
    };
    assert!(leads(&mut way(20, 0), &successes(20)));
    assert!(!leads(&mut way(20, 0), &successes(21)));
    let reliability = |chain_reliability| ValueConfig {
        chain_reliability,
        ..HALF
    };
    assert!(leads(&mut way(20, 0), &reliability(0.2)));
    assert!(!leads(&mut way(20, 0), &reliability(0.21)));
    // On average going brings gold in 30 of 200 cases: a in 4/3 as many.
    let relevance = |chain_relevance| ValueConfig {
        chain_relevance,
        ..HALF
    };
    assert!(leads(&mut way(20, 10), &relevance(1.33)));
    assert!(!leads(&mut way(20, 10), &relevance(1.34)));
    // Another action's successes are no part of the average.
    assert!(leads(&mut way(20, 0), &relevance(1.9)));
    // Two schemas of one context and action that both bring it count together.
    let mut two = knowledge(&[("+a/go/+gold", 10, 20), ("+a/go/+gold+b", 10, 20)]);
    assert!(leads(&mut two, &successes(20)));
}

#[test]
fn a_pattern_is_worth_what_the_best_action_there_brings() {
    let mut it = knowledge(&[
        ("+a/go/+b", 1, 2),
        ("+a/stay/+b", 3, 4),
        ("+b/go/+gold", 1, 2),
        ("+gold/go/+a", 1, 1),
    ]);
    let values = |it: &Knowledge| -> std::vec::Vec<f32> {
        it.patterns.iter().map(|pattern| pattern.value).collect()
    };
    // Two in turn: a (b is not known to be worth anything yet), b.
    it.improve_values::<2>(2, &HALF);
    assert_eq!(values(&it), [0.0, 5.0, 0.0]);
    // Gold, and again a: three quarters of half of b's value.
    it.improve_values::<2>(2, &HALF);
    assert_eq!(values(&it), [1.875, 5.0, 0.0]);
    it.improve_values::<2>(2, &HALF);
    assert_eq!(values(&it), [1.875, 5.0, 0.937_5]);
    let thens = it.patterns.iter().map(|pattern| pattern.then);
    assert!(thens.eq(values(&it).iter().map(|value| 0.5 * value)));
    // Settled, b is worth half of gold's own value and what follows gold.
    it.settle_values::<2>(60, &HALF);
    let settled = values(&it);
    near(settled[0], 0.75 * 0.5 * settled[1]);
    near(settled[1], 0.5 * (10.0 + 0.5 * settled[2]));
    near(settled[2], 0.5 * settled[0]);
    // Without conjunctions there is nothing to improve.
    Knowledge::new().improve_values::<2>(3, &HALF);
}

#[test]
fn a_change_of_the_discount_counts_at_once() {
    let mut it = knowledge(&[("+a/go/+b", 1, 1), ("+b/go/+gold", 1, 1)]);
    it.settle_values::<2>(9, &HALF);
    let mut expected = |discount| {
        let config = ValueConfig { discount, ..HALF };
        it.expected_values::<2>(&on(&[A]), &config)[0].value
    };
    assert_eq!(
        [expected(0.5), expected(0.25), expected(0.0), expected(0.5)],
        [5.0, 2.5, 0.0, 5.0]
    );
}

#[test]
fn an_appraisal_weighs_what_schemas_promise_by_their_reliabilities() {
    let mut it = knowledge(&[
        ("+a/go/+gold", 1, 4),
        ("+a/go/+c", 1, 2),
        ("+a-b/stay/+gold", 3, 4),
        ("+a-c/stay/+gold", 3, 4),
        ("+a-c-b/stay/-a", 1, 2),
        ("+b/go/+gold", 1, 1),
    ]);
    it.set_inherent_value(C, 4.0).unwrap();
    let [go, stay, none] = it.expected_values::<3>(&on(&[A]), &HALF);
    near(go.value, 0.25 * 10.0 + 0.5 * 4.0);
    near(go.reliability, 0.75);
    // What adds up to more than certainty is scaled down to it.
    near(stay.value, 15.0 / 2.0);
    near(stay.reliability, 2.0);
    assert!(go.applicable && stay.applicable);
    assert_eq!(none, Appraisal::default());
    // Of fewer actions the others are left out.
    assert_eq!(it.expected_values::<1>(&on(&[A]), &HALF), [go]);
}

#[test]
fn of_the_hopes_for_an_action_the_largest_is_added() {
    let mut it = knowledge(&[
        ("+a/go/+gold", 1, 2),
        ("+a/go/+b", 1, 2),
        ("+a/go/+c", 0, 2),
        ("+a/stay/+gold", 1, 4),
        ("+b/stay/+gold", 1, 4),
    ]);
    for (index, bonus) in [1.0, 3.0, 2.0, 0.0, 9.0].into_iter().enumerate() {
        it.schemas[index].doubt.bonus = bonus;
    }
    let [go, stay] = it.expected_values::<2>(&on(&[A]), &HALF);
    near(go.value, 5.0 + 3.0);
    near(stay.value, 2.5);
}

#[test]
fn the_estimate_that_counts_is_the_configured_one() {
    let mut it = knowledge(&[("+a/go/+gold", 3, 4)]);
    it.record(&on(&[A]), crate::word::ActionId(0), &on(&[]), 0.5);
    let recent = ValueConfig {
        estimate: Estimate::Recent,
        ..HALF
    };
    near(it.expected_values::<1>(&on(&[A]), &HALF)[0].value, 6.0);
    near(it.expected_values::<1>(&on(&[A]), &recent)[0].value, 3.75);
}

#[test]
fn an_appraisal_counts_what_it_looks_at() {
    let mut it = knowledge(&[
        ("+a/go/+gold", 3, 4),
        ("+a/stay/+b", 3, 4),
        ("+b/go/+gold", 3, 4),
    ]);
    it.expected_values::<2>(&on(&[A]), &HALF);
    assert_eq!((it.cost.patterns, it.cost.schemas), (3, 2));
}

#[test]
fn for_the_forager_a_way_needs_ten_successes_one_in_fifty_and_half_more_than_the_average() {
    let leads = |here: u32, all: u32, average: u32| {
        let mut it = knowledge(&[
            ("+a/go/+gold", here, all),
            ("+a/go/+a", all - here, all),
            ("+c/go/+gold", average, all),
            ("+c/go/+c", all - average, all),
        ]);
        it.defer_values(&ValueConfig::FORAGER);
        it.deferred_value(A) > 0.0
    };
    assert!(leads(10, 100, 0));
    assert!(!leads(9, 100, 0), "nine successes are a handful");
    assert!(leads(20, 1000, 0));
    assert!(!leads(19, 1000, 0), "less than one in fifty");
    assert!(leads(31, 100, 10), "31 of 100 where 41 of 200 is usual");
    assert!(!leads(29, 100, 10));
    // What comes now counts, not what came in all.
    let mut it = knowledge(&[("+a/go/+gold", 90, 100)]);
    it.record(&on(&[A]), crate::word::ActionId(0), &on(&[]), 0.5);
    let [go] = it.expected_values::<1>(&on(&[A]), &ValueConfig::FORAGER);
    near(go.value, 4.5);
}
