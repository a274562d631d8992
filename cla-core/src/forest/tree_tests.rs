//! Descents through trees built by hand, with known and unknown items.

use super::super::moment::Moment;
use super::{Place, Trees};
use crate::word::{ItemId, ItemStates};

/// Item 0 decides between 8 and a second question; item 1 then between 2 and 0; three of four samples
/// had item 0 on.
fn trees() -> Trees<2, 1, 4> {
    let mut trees = Trees::<2, 1, 4>::new();
    trees.clear();
    let first = trees.split(Place::Root(0), 0, 191).unwrap();
    trees.settle(Place::Yes(first), 8.0);
    let second = trees.split(Place::No(first), 1, 127).unwrap();
    trees.settle(Place::Yes(second), 2.0);
    trees.settle(Place::No(second), 0.0);
    trees
}

fn moment(first: Option<bool>, second: Option<bool>) -> Moment<1> {
    let mut now = ItemStates::UNKNOWN;
    now.set(ItemId(0), first).unwrap();
    now.set(ItemId(1), second).unwrap();
    Moment::first(&now)
}

#[test]
fn what_is_known_leads_to_one_leaf() {
    let trees = trees();
    let say = |first, second| trees.value(0, &moment(Some(first), Some(second))).0;
    assert_eq!(say(true, false), 8.0);
    assert_eq!(say(false, true), 2.0);
    assert_eq!(say(false, false), 0.0);
    assert_eq!(trees.leaves(), 3);
}

#[test]
fn an_unknown_item_is_worth_what_it_was_on_average() {
    let trees = trees();
    let say = |first, second| trees.value(0, &moment(first, second)).0;
    assert!((say(None, Some(false)) - 0.75 * 8.0).abs() < 0.02);
    assert!((say(Some(false), None) - 1.0).abs() < 0.01);
    assert!((say(None, None) - (0.75 * 8.0 + 0.25 * 1.0)).abs() < 0.02);
    // What is not asked for costs nothing.
    assert_eq!(say(Some(true), None), 8.0);
}

#[test]
fn a_full_table_of_nodes_splits_no_more_and_says_what_it_said() {
    let mut trees = trees();
    let (mut place, mut made) = (Place::Root(0), 2);
    trees.clear();
    while let Some(pair) = trees.split(place, 0, 128) {
        place = Place::No(pair);
        made += 1;
    }
    assert_eq!(made, 2 + 4);
    assert!(!trees.has_room());
    assert_eq!(trees.value(0, &moment(None, None)).0, 0.0);
}

#[test]
fn more_unknown_items_than_branches_can_be_kept_still_end() {
    // A chain of forty questions about as many unknown items.
    let mut trees = Trees::<40, 1, 64>::new();
    trees.clear();
    let mut place = Place::Root(0);
    for feature in 0..40 {
        let pair = trees.split(place, feature, 128).unwrap();
        trees.settle(Place::No(pair), 1.0);
        trees.settle(Place::Yes(pair), 1.0);
        place = Place::Yes(pair);
    }
    let (value, passed) = trees.value(0, &Moment::first(&ItemStates::<2>::UNKNOWN));
    assert!((value - 1.0).abs() < 1e-5, "{value}");
    assert!(passed <= 2 * 40 + 1 + super::BEGUN, "{passed}");
}
