//! Which items join and leave the mask, and when.

use super::Relevance;
use crate::word::{ItemId, ItemSet};

fn begun() -> Relevance<1, 3> {
    let mut relevance = Relevance::new();
    relevance.begin();
    relevance
}

#[test]
fn items_leave_only_where_tables_are_crowded_and_come_back_when_they_are_clear() {
    let mut relevance = begun();
    relevance.note(0, 100.0);
    assert!(!relevance.settle(false));
    assert_eq!(*relevance.mask(), ItemSet::first(3));
    relevance.note(0, 100.0);
    assert!(relevance.settle(true));
    assert_eq!(*relevance.mask(), ItemSet::first(1));
    // Features 3 to 5 are the items of the moment before; 6 is an action, and nobody's.
    relevance.note(4, 400.0);
    relevance.note(6, 400.0);
    assert!(relevance.settle(false));
    assert!(relevance.mask().contains(ItemId(1)));
    assert!(!relevance.mask().contains(ItemId(2)));
}

#[test]
fn one_lucky_split_does_not_make_an_item_matter_for_long() {
    let mut relevance = begun();
    relevance.settle(true);
    assert!(relevance.mask().is_empty());
    relevance.note(2, 100.0);
    relevance.settle(true);
    assert!((relevance.mean(ItemId(2)) - 20.0).abs() < 1e-4);
    // Between the thresholds it stays where it was: outside.
    assert!(!relevance.mask().contains(ItemId(2)));
    assert!(relevance.is_doubtful(2) && relevance.is_doubtful(5) && !relevance.is_doubtful(6));
}
