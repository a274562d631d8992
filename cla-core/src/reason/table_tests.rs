//! Places in the table: those of an action stay together, the general replaces the special, a full
//! table gives up what explains nothing of its own.

use std::vec::Vec;

use super::Table;
use crate::growth::{Entry, SimpleSchema};
use crate::num::Rng;
use crate::reason::Experience;
use crate::word::{ActionId, ItemId, ItemSet, ItemStates, SchemaText, Vocabulary};

const WORDS: Vocabulary = Vocabulary {
    items: &["a", "b", "c", "d", "e", "f", "g", "h"],
    actions: &["x", "y", "z"],
};

fn pack(text: &str) -> SimpleSchema {
    SimpleSchema::pack(&SchemaText::<1>::parse(text, &WORDS).unwrap()).unwrap()
}

fn on(items: &[u16]) -> ItemSet<1> {
    let mut set = ItemSet::EMPTY;
    for &item in items {
        set.insert(ItemId(item)).unwrap();
    }
    set
}

fn states(items: &[u16]) -> ItemStates<1> {
    ItemStates::from_sets(&on(items), &ItemSet::first(8))
}

fn from_to(before: &[u16], after: &[u16]) -> Experience<1> {
    Experience {
        before: states(before),
        after: states(after),
    }
}

#[test]
fn schemas_of_an_action_stay_together_whatever_comes_and_goes() {
    let mut table = Table::<16, 3>::new();
    let mut model: [Vec<SimpleSchema>; 3] = [const { Vec::new() }; 3];
    let mut rng = Rng::new(3);
    for round in 0..3_000 {
        let action = rng.below(3) as usize;
        if rng.chance(0.6) {
            let text = std::format!(
                "+{}/{}/{}{}",
                WORDS.items[rng.below(8) as usize],
                WORDS.actions[action],
                if rng.chance(0.5) { "+" } else { "-" },
                WORDS.items[rng.below(8) as usize],
            );
            let new = pack(&text);
            let known = model[action].iter().any(|it| it.says_as(&new));
            if table.all().len() == 16 {
                continue;
            }
            let entry = table.enter(new);
            assert_eq!(entry == Entry::Covered, known);
            if !known {
                model[action].push(new);
            }
        } else if !model[action].is_empty() {
            // What is on by the first schema's context fails all that it applies to.
            let leaving = model[action][rng.below(model[action].len() as u32) as usize];
            table.retain(action as u8, |it| !it.says_as(&leaving));
            model[action].retain(|it| !it.says_as(&leaving));
        }
        for (action, kept) in model.iter().enumerate() {
            let of = table.of(action as u8);
            assert_eq!(of.len(), kept.len(), "{round}");
            assert!(kept.iter().all(|it| of.iter().any(|its| its.says_as(it))));
        }
    }
}

#[test]
fn the_general_replaces_the_special_of_the_same_action_and_result() {
    let mut table = Table::<8, 3>::new();
    assert_eq!(table.enter(pack("+a-b/x/+c")), Entry::Stored);
    assert_eq!(table.enter(pack("+a/y/+c")), Entry::Stored);
    assert_eq!(table.enter(pack("+a/x/+c")), Entry::Stored);
    assert_eq!(table.enter(pack("+a+d/x/+c")), Entry::Covered);
    assert_eq!(table.of(0), [pack("+a/x/+c")]);
    assert_eq!(table.of(1), [pack("+a/y/+c")]);
}

#[test]
fn a_full_table_gives_up_what_explains_nothing_of_its_own() {
    let mut table = Table::<2, 3>::new();
    table.enter(pack("+a/x/+b"));
    table.enter(pack("+c/x/+b"));
    let x = ActionId(0);
    table.record(x, &from_to(&[0], &[0, 1]), |_, ok| ok);
    for _ in 0..3 {
        table.record(x, &from_to(&[0, 2], &[0, 1, 2]), |_, ok| ok);
    }
    assert_eq!(table.enter(pack("+e/z/+f")), Entry::Stored);
    assert_eq!(table.of(0).len(), 1);
    assert_eq!(table.of(0)[0].successes(), 4);
    table.record(ActionId(2), &from_to(&[4], &[4, 5]), |_, ok| ok);
    assert_eq!(table.enter(pack("+g/x/+h")), Entry::Refused);
    assert_eq!(table.losses(), (1, 1));
}

#[test]
fn what_fails_is_dropped_and_what_nobody_knows_is_no_trial() {
    let mut table = Table::<8, 3>::new();
    table.enter(pack("+a/x/+b"));
    table.enter(pack("+a/x/+c"));
    let mut after = states(&[0, 1]);
    after.set(ItemId(2), None).unwrap();
    let sample = Experience {
        before: states(&[0]),
        after,
    };
    table.record(ActionId(0), &sample, |_, ok| ok);
    let trials: Vec<u16> = table.of(0).iter().map(SimpleSchema::activations).collect();
    assert_eq!(trials, [1, 0]);
    table.record(ActionId(0), &from_to(&[0], &[0]), |_, ok| ok);
    assert!(table.all().is_empty());
}

#[test]
fn of_two_that_contradict_the_one_with_more_successes_is_believed() {
    let mut table = Table::<8, 3>::new();
    table.enter(pack("+a/x/+b"));
    table.enter(pack("+c/x/-b"));
    assert_eq!(table.predict(&on(&[0]), 0), on(&[0, 1]));
    assert_eq!(table.predict(&on(&[0]), 1), on(&[0]));
    table.record(ActionId(0), &from_to(&[2], &[2]), |_, ok| ok);
    assert_eq!(table.predict(&on(&[0, 2]), 0), on(&[0, 2]));
}
