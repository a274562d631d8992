//! What a node of a map says, and when.

use super::{HarvestConfig, harvest_node};
use crate::check::Config;
use crate::map::{ActionSomBank, Recruitment, ResultCoding, Sample, TrainingConfig};
use crate::num::{Rng, Schedule};
use crate::som::NodeId;
use crate::word::{ActionId, ItemId, ItemStates};

/// A map of one node that holds exactly one sample: item 0 on → items 0 and 1 on, 2 unknown.
fn one_node(coding: ResultCoding) -> ActionSomBank<1, 1, 3, 1> {
    let mut bank = ActionSomBank::new();
    bank.randomize(&mut Rng::new(8));
    let mut before = ItemStates::<1>::all_off(2);
    before.set(ItemId(0), Some(true)).unwrap();
    let mut after = before;
    after.set(ItemId(1), Some(true)).unwrap();
    let mut config = TrainingConfig::FORAGER;
    config.recruitment = Some(Recruitment {
        vigilance: 0.0,
        after: 0,
    });
    bank.train(
        ActionId(0),
        &Sample::new(&before, &after, coding, 3),
        &config,
    );
    bank
}

#[test]
fn end_states_and_changes_read_differently() {
    let read = |coding| {
        let bank = one_node(coding);
        harvest_node::<1, 1, 1, 3, _, _>(&bank.maps()[0], NodeId(0), coding, &HarvestConfig::BOOK)
            .unwrap()
    };
    let end = read(ResultCoding::EndState);
    assert_eq!(end.result.positive().iter().count(), 2);
    let change = read(ResultCoding::Change);
    assert_eq!(
        change
            .result
            .positive()
            .iter()
            .map(|i| i.0)
            .collect::<std::vec::Vec<_>>(),
        [1]
    );
    assert!(change.result.negative().is_empty());
    for node in [end, change] {
        assert!(node.context.positive().contains(ItemId(0)));
        assert!(node.context.negative().contains(ItemId(1)));
        assert!(
            !node.context.positive().contains(ItemId(2)),
            "an unknown item was never seen"
        );
    }
}

#[test]
fn a_node_that_never_won_is_passed_over_on_request() {
    let mut bank = ActionSomBank::<2, 2, 3, 1>::new();
    bank.randomize(&mut Rng::new(8));
    let node = harvest_node::<1, 2, 2, 3, _, _>(
        &bank.maps()[0],
        NodeId(0),
        ResultCoding::EndState,
        &HarvestConfig::FORAGER,
    );
    assert_eq!(node, None);
}

/// A map of one node that stood for `items` (on or off, before and after) until, by `alpha`, it
/// moved towards the opposite.
fn moved(alpha: f32, coding: ResultCoding) -> ActionSomBank<1, 1, 2, 1> {
    let mut bank = ActionSomBank::new();
    bank.randomize(&mut Rng::new(8));
    let state = |first: bool| {
        let mut it = ItemStates::<1>::all_off(2);
        it.set(ItemId(0), Some(first)).unwrap();
        it.set(ItemId(1), Some(!first)).unwrap();
        it
    };
    let mut config = TrainingConfig::FORAGER;
    config.recruitment = Some(Recruitment {
        vigilance: 0.0,
        after: 0,
    });
    let whole = Sample::new(&state(true), &state(false), coding, 2);
    bank.train(ActionId(0), &whole, &config);
    config.recruitment = None;
    config.alpha = Schedule::constant(alpha).unwrap();
    let opposite = match coding {
        ResultCoding::EndState => Sample::new(&state(false), &state(true), coding, 2),
        ResultCoding::Change => Sample::new(&state(false), &state(false), coding, 2),
    };
    bank.train(ActionId(0), &opposite, &config);
    bank
}

#[test]
fn a_weight_above_nine_tenths_is_on_one_below_a_tenth_is_off_and_others_say_nothing() {
    let read = |alpha, coding| {
        let bank = moved(alpha, coding);
        let read =
            |config| harvest_node::<1, 1, 1, 2, _, _>(&bank.maps()[0], NodeId(0), coding, config);
        let (book, forager) = (read(&HarvestConfig::BOOK), read(&HarvestConfig::FORAGER));
        assert_eq!(book, forager);
        book
    };
    for coding in [ResultCoding::EndState, ResultCoding::Change] {
        // Weights of .92 and .08 (in change coding .92 and −.92).
        let node = read(0.08, coding).unwrap();
        assert!(node.context.positive().contains(ItemId(0)));
        assert!(node.context.negative().contains(ItemId(1)));
        assert!(node.result.negative().contains(ItemId(0)));
        assert!(node.result.positive().contains(ItemId(1)));
        assert_eq!((node.context.len(), node.result.len()), (2, 2));
        // Weights of .88 and .12 say nothing, and a node without a result is no schema.
        assert_eq!(read(0.12, coding), None);
    }
}

#[test]
fn a_threshold_itself_is_not_passed() {
    let mut bank = ActionSomBank::<1, 1, 2, 1>::new();
    bank.randomize(&mut Rng::new(8));
    let mut config = TrainingConfig::FORAGER;
    config.recruitment = Some(Recruitment {
        vigilance: 0.0,
        after: 0,
    });
    let mut before = ItemStates::<1>::all_off(2);
    before.set(ItemId(0), Some(true)).unwrap();
    let sample = |coding| Sample::new(&before, &ItemStates::all_off(2), coding, 2);
    let read = |bank: &ActionSomBank<1, 1, 2, 1>, coding, on, off| {
        let config = HarvestConfig {
            on,
            off,
            minimum_wins: 1,
        };
        let map = &bank.maps()[0];
        harvest_node::<1, 1, 1, 2, _, _>(map, NodeId(0), coding, &config)
    };
    bank.train(ActionId(0), &sample(ResultCoding::EndState), &config);
    // Weights are exactly 1 and 0.
    let all = read(&bank, ResultCoding::EndState, 0.9, 0.1).unwrap();
    assert_eq!((all.context.len(), all.result.len(), all.wins), (2, 2, 1));
    let some = read(&bank, ResultCoding::EndState, 1.0, 0.1).unwrap();
    assert!(some.context.positive().is_empty() && some.context.len() == 1);
    assert_eq!(read(&bank, ResultCoding::EndState, 0.9, 0.0), None);
    // The first has turned off: −1.
    bank.train(ActionId(0), &sample(ResultCoding::Change), &config);
    let change = read(&bank, ResultCoding::Change, 0.9, 0.1).unwrap();
    assert!(change.result.negative().contains(ItemId(0)) && change.result.len() == 1);
    assert_eq!(read(&bank, ResultCoding::Change, 1.0, 0.1), None);
}

#[test]
fn thresholds_are_shares_and_off_lies_below_on() {
    let check = |on, off| {
        let config = HarvestConfig {
            on,
            off,
            minimum_wins: 0,
        };
        config.check().is_ok()
    };
    assert!(check(1.0, 0.0) && check(0.5, 0.49));
    assert!(!check(0.5, 0.5) && !check(0.4, 0.5));
    assert!(!check(1.1, 0.1) && !check(0.9, -0.1));
    assert!(!check(f32::NAN, 0.1) && !check(0.9, f32::NAN));
}
