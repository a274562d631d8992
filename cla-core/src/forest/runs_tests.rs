//! When a sense counts as stuck, and when it is believed again.

use super::Runs;
use crate::word::{ItemId, ItemStates};

fn percept(on: Option<bool>) -> ItemStates<1> {
    let mut now = ItemStates::all_off(1);
    now.set(ItemId(0), on).unwrap();
    now
}

fn after(history: &[(bool, u16)]) -> Runs<1> {
    let mut runs = Runs::new();
    for &(on, times) in history {
        for _ in 0..times {
            runs.count(&percept(Some(on)));
        }
    }
    runs
}

fn believed(runs: &Runs<1>) -> Option<bool> {
    runs.believed(&percept(Some(true))).get(ItemId(0))
}

#[test]
fn an_item_that_is_on_for_more_than_twice_its_longest_run_counts_as_off() {
    let runs = after(&[(true, 10), (false, 1), (true, 20)]);
    assert_eq!(believed(&runs), Some(true));
    let runs = after(&[(true, 10), (false, 1), (true, 21)]);
    assert_eq!((believed(&runs), runs.stuck()), (Some(false), 1));
}

#[test]
fn it_is_believed_again_when_it_goes_off_and_its_run_was_no_mistake() {
    let runs = after(&[(true, 10), (false, 1), (true, 30), (false, 1)]);
    assert_eq!((believed(&runs), runs.stuck()), (Some(true), 0));
    // The long run has ended, so runs of that length are known now.
    let runs = after(&[(true, 10), (false, 1), (true, 30), (false, 1), (true, 60)]);
    assert_eq!(believed(&runs), Some(true));
}

#[test]
fn what_never_went_off_and_what_is_short_is_not_judged() {
    assert_eq!(believed(&after(&[(true, 60_000)])), Some(true));
    assert_eq!(
        believed(&after(&[(true, 1), (false, 1), (true, 16)])),
        Some(true)
    );
    assert_eq!(
        believed(&after(&[(true, 1), (false, 1), (true, 17)])),
        Some(false)
    );
}

#[test]
fn counters_stay_where_they_are_full_and_unknown_readings_change_nothing() {
    let mut runs = after(&[(true, 10), (false, 1), (true, u16::MAX)]);
    for _ in 0..10 {
        runs.count(&percept(Some(true)));
        runs.count(&percept(None));
    }
    assert_eq!(runs.stuck(), 1);
    assert_eq!(runs.believed(&percept(None)).get(ItemId(0)), None);
}
