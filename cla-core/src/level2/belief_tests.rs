//! What the counters of beliefs keep, forget and drop.

use super::{ActionId, BeliefTable, SchemaId, SyntheticId, uses};

const GO: ActionId = ActionId(0);
const STAY: ActionId = ActionId(1);

fn table() -> BeliefTable<2, 3, 4> {
    let mut table = BeliefTable::new();
    for (schema, action) in [(0, GO), (1, GO), (2, STAY)] {
        table.add(SchemaId(schema), action, 0.0).unwrap();
    }
    table
}

#[test]
fn labels_are_kept_per_trace_and_only_for_the_action_that_was_done() {
    let mut it = table();
    it.record(SyntheticId(0), GO, Some(SyntheticId(1)), 0.0);
    it.record(SyntheticId(0), GO, Some(SyntheticId(0)), 0.0);
    it.record(SyntheticId(0), GO, Some(SyntheticId(1)), 0.0);
    it.record(SyntheticId(1), STAY, None, 0.0);
    let after: std::vec::Vec<_> = it
        .after(SyntheticId(0))
        .iter()
        .map(|belief| (belief.item.0, belief.on))
        .collect();
    assert_eq!(after, [(0, 1.0), (1, 2.0)]);
    assert_eq!(it.row(SyntheticId(0)).unwrap().tried, [3.0, 0.0]);
    assert_eq!(it.row(SyntheticId(1)).unwrap().tried, [0.0, 1.0]);
    assert!(it.after(SyntheticId(1)).is_empty());
}

#[test]
fn at_most_one_over_forgetting_labels_count() {
    let mut it = table();
    for _ in 0..100 {
        it.record(SyntheticId(0), GO, Some(SyntheticId(0)), 0.1);
    }
    for _ in 0..30 {
        it.record(SyntheticId(0), GO, Some(SyntheticId(1)), 0.1);
    }
    let tried = it.row(SyntheticId(0)).unwrap().tried[0];
    assert!((tried - 10.0).abs() < 0.01, "{tried}");
    let [old, new] = it.after(SyntheticId(0)) else {
        panic!("two beliefs")
    };
    assert!((old.on + new.on - tried).abs() < 1e-3);
    assert!(old.on < 0.05 * tried && new.on > 0.9 * tried);
}

#[test]
fn full_tables_evict_what_is_hardly_used_and_count_it() {
    let mut it = table();
    for item in [0, 1, 2, 0] {
        it.record(SyntheticId(0), GO, Some(SyntheticId(item)), 0.0);
        it.record(SyntheticId(1), GO, Some(SyntheticId(item)), 0.0);
    }
    // Seven times a belief that had no counter, four places.
    assert_eq!(it.all().len(), 4);
    assert_eq!(it.losses.evicted_beliefs, 3);
    // The third item was never a trace: it makes room, and every belief about it goes.
    assert_eq!(it.add(SchemaId(9), STAY, 0.0), Some(SyntheticId(2)));
    assert_eq!(it.losses.evicted_items, 1);
    assert!(it.all().iter().all(|belief| belief.item != SyntheticId(2)));
    for _ in 0..3 {
        it.record(SyntheticId(2), GO, None, 0.0);
    }
    assert_eq!(it.add(SchemaId(10), STAY, 0.0), None);
    assert_eq!(it.losses.refused_items, 1);
}

#[test]
fn an_item_that_is_no_longer_met_makes_room_however_much_it_was_used() {
    let mut it = table();
    let live = |it: &mut BeliefTable<2, 3, 4>, item: u16, times: u32| {
        for _ in 0..times {
            it.meet(SyntheticId(item));
            it.record(SyntheticId(item), GO, None, 0.0);
        }
    };
    for item in [2, 1, 0] {
        live(&mut it, item, 10);
    }
    assert_eq!(it.add(SchemaId(8), STAY, 0.0), None);
    live(&mut it, 0, super::OUT_OF_USE + 1);
    // Both others are out of use; the last has been for longer.
    assert_eq!(it.add(SchemaId(9), STAY, 0.0), Some(SyntheticId(2)));
    assert_eq!((it.losses.evicted_items, it.losses.refused_items), (1, 1));
    // What has just come is in use.
    live(&mut it, 2, 3);
    assert_eq!(it.add(SchemaId(10), STAY, 0.0), Some(SyntheticId(1)));
    live(&mut it, 1, 3);
    assert_eq!(it.add(SchemaId(11), STAY, 0.0), None);
}

#[test]
fn forgetting_a_part_touches_no_other_action() {
    let mut it = table();
    it.record(SyntheticId(0), GO, Some(SyntheticId(1)), 0.0);
    it.record(SyntheticId(0), STAY, Some(SyntheticId(2)), 0.0);
    it.forget(SyntheticId(0), GO, 0.5);
    assert_eq!(it.row(SyntheticId(0)).unwrap().tried, [0.5, 1.0]);
    assert_eq!(uses(it.row(SyntheticId(0)).unwrap()), 1.5);
    assert_eq!(it.after(SyntheticId(0))[0].on, 0.5);
    assert_eq!(it.after(SyntheticId(0))[1].on, 1.0);
}

#[test]
fn a_brain_without_a_second_level_has_empty_tables() {
    let mut it = BeliefTable::<2, 0, 0>::new();
    assert_eq!(it.add(SchemaId(0), GO, 0.0), None);
    it.record(SyntheticId(0), GO, Some(SyntheticId(0)), 0.1);
    assert!(it.all().is_empty());
}

const FIRST: SyntheticId = SyntheticId(0);

/// Lets an item of the table be a trace so many times.
fn live(it: &mut BeliefTable<2, 3, 4>, item: u16, times: u32) {
    for _ in 0..times {
        it.record(SyntheticId(item), GO, None, 0.0);
    }
}

#[test]
fn a_free_row_is_taken_before_any_item_has_to_go() {
    let mut it = table();
    for item in [0, 1, 2] {
        live(&mut it, item, 5);
    }
    it.free(SyntheticId(1));
    assert_eq!(it.add(SchemaId(7), STAY, 3.0), Some(SyntheticId(1)));
    assert_eq!((it.losses.evicted_items, it.losses.refused_items), (0, 0));
    let row = it.row(SyntheticId(1)).unwrap();
    assert_eq!((row.schema, row.action), (Some(SchemaId(7)), STAY));
    assert_eq!((row.value, row.experienced), (3.0, 3.0));
    assert_eq!((row.visits, row.tried), (0.0, [0.0, 0.0]));
}

#[test]
fn of_two_free_rows_and_of_two_hardly_used_ones_the_first_is_taken() {
    let mut it = table();
    it.free(SyntheticId(1));
    it.free(SyntheticId(2));
    assert_eq!(it.add(SchemaId(7), GO, 0.0), Some(SyntheticId(1)));
    assert_eq!(it.add(SchemaId(8), GO, 0.0), Some(SyntheticId(2)));
    // Used three times, once and once.
    live(&mut it, 0, 3);
    live(&mut it, 1, 1);
    live(&mut it, 2, 1);
    assert_eq!(it.add(SchemaId(9), GO, 0.0), Some(SyntheticId(1)));
    // Two uses are hardly any, three are some.
    live(&mut it, 1, 3);
    live(&mut it, 2, 1);
    assert_eq!(it.add(SchemaId(10), GO, 0.0), Some(SyntheticId(2)));
    live(&mut it, 2, 3);
    assert_eq!(it.add(SchemaId(11), GO, 0.0), None);
    assert_eq!((it.losses.evicted_items, it.losses.refused_items), (2, 1));
}

#[test]
fn an_item_out_of_use_goes_before_one_that_is_hardly_used() {
    let unmet = |occasions: u32| {
        let mut it = table();
        it.meet(SyntheticId(0));
        live(&mut it, 0, occasions);
        it.meet(SyntheticId(1));
        it.meet(SyntheticId(2));
        live(&mut it, 2, 1);
        it.add(SchemaId(9), STAY, 0.0)
    };
    // So many occasions after the first was met, and one more for the third.
    assert_eq!(unmet(super::OUT_OF_USE), Some(SyntheticId(0)));
    assert_eq!(unmet(super::OUT_OF_USE - 1), Some(SyntheticId(1)));
    // Of two that were not met for as long the first goes.
    let mut it = table();
    for _ in 0..=super::OUT_OF_USE {
        it.meet(SyntheticId(0));
        live(&mut it, 0, 1);
    }
    assert_eq!(it.add(SchemaId(9), STAY, 0.0), Some(SyntheticId(1)));
}

#[test]
fn the_weakest_belief_makes_room_and_of_equals_the_first() {
    let mut it = table();
    let mut on = |trace: u16, item: u16, times: u32| {
        for _ in 0..times {
            it.record(SyntheticId(trace), GO, Some(SyntheticId(item)), 0.0);
        }
        let kept = it.all().iter();
        let kept = kept.map(|belief| (belief.trace.0, belief.item.0, belief.on));
        kept.collect::<std::vec::Vec<_>>()
    };
    on(0, 0, 2);
    on(0, 2, 1);
    on(2, 0, 1);
    assert_eq!(
        on(1, 1, 3),
        [(0, 0, 2.0), (0, 2, 1.0), (1, 1, 3.0), (2, 0, 1.0)]
    );
    // In order of trace and item, wherever it belongs.
    assert_eq!(
        on(1, 0, 1),
        [(0, 0, 2.0), (1, 0, 1.0), (1, 1, 3.0), (2, 0, 1.0)]
    );
    assert_eq!(
        on(2, 2, 2),
        [(0, 0, 2.0), (1, 1, 3.0), (2, 0, 1.0), (2, 2, 2.0)]
    );
    assert_eq!(it.losses.evicted_beliefs, 2);
    let after = |it: &BeliefTable<2, 3, 4>, trace| it.after(SyntheticId(trace)).len();
    assert_eq!([0, 1, 2, 3].map(|trace| after(&it, trace)), [1, 1, 2, 0]);
}

#[test]
fn a_full_count_makes_room_for_one_label_and_not_before() {
    let mut it = table();
    for _ in 0..3 {
        it.record(FIRST, GO, Some(FIRST), 0.25);
    }
    it.record(FIRST, GO, None, 0.25);
    // Four of at most four labels count whole.
    assert_eq!(it.row(FIRST).unwrap().tried, [4.0, 0.0]);
    assert_eq!(it.after(FIRST)[0].on, 3.0);
    it.record(FIRST, STAY, Some(SyntheticId(2)), 0.25);
    it.record(FIRST, GO, Some(FIRST), 0.25);
    assert_eq!(it.row(FIRST).unwrap().tried, [4.0, 1.0]);
    assert_eq!(it.after(FIRST)[0].on, 3.0 * 0.75 + 1.0);
    // What followed another action keeps its weight.
    assert_eq!(it.after(FIRST)[1].on, 1.0);
}

#[test]
fn labels_of_no_item_and_of_no_action_change_nothing_but_the_clock() {
    let mut it = table();
    it.record(SyntheticId(9), GO, Some(FIRST), 0.0);
    it.record(FIRST, super::ActionId(9), Some(FIRST), 0.0);
    it.forget(SyntheticId(9), GO, 0.5);
    it.meet(SyntheticId(9));
    it.free(SyntheticId(9));
    assert!(it.all().is_empty());
    assert_eq!(it.clock, 2);
    it.clear();
    assert_eq!((it.rows.len(), it.clock), (0, 0));
}

#[test]
fn what_the_tables_go_through_is_counted() {
    let mut it = table();
    for item in [0, 1, 2] {
        it.record(FIRST, GO, Some(SyntheticId(item)), 0.0);
    }
    // Each belongs behind the others.
    assert_eq!(it.cost.beliefs, 0);
    it.record(SyntheticId(1), GO, Some(FIRST), 0.0);
    assert_eq!(it.cost.beliefs, 0);
    // No room: twice through the table for the weakest, which was the first of all.
    it.record(SyntheticId(1), STAY, Some(SyntheticId(1)), 0.0);
    assert_eq!(it.cost.beliefs, 2 * 4);
    it.forget(FIRST, GO, 0.5);
    assert_eq!(it.cost.beliefs, 8 + 2);
    // Three that stand behind move.
    it.free(SyntheticId(1));
    it.record(FIRST, GO, Some(FIRST), 0.0);
    assert_eq!(it.cost.beliefs, 10 + 1);
    // For room all rows and, for what is said of the one that goes, all beliefs.
    it.add(SchemaId(9), GO, 0.0).unwrap();
    assert_eq!((it.cost.items, it.cost.beliefs), (3, 11 + 2));
}
