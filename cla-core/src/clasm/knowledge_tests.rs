//! Tests of what the tables keep, drop and refuse.

use super::{KnowledgeBase, Losses, TableFull};
use crate::clasm::{
    ActionId, ActionSomBank, Estimate, HarvestConfig, ItemId, ItemStates, ResultCoding, Sample,
    SchemaText, TrainingConfig, ValueConfig, Vocabulary,
};
use crate::num::Rng;

const WORDS: Vocabulary = Vocabulary {
    items: &["s1", "s2", "s3", "ingrip"],
    actions: &["turnl", "forward"],
};

fn text(schema: &str) -> SchemaText<1> {
    SchemaText::parse(schema, &WORDS).unwrap()
}

fn only(on: &[u16]) -> ItemStates<1> {
    let mut states = ItemStates::all_off(4);
    for &item in on {
        states.set(ItemId(item), Some(true)).unwrap();
    }
    states
}

#[test]
fn experience_counts_for_every_applicable_schema_and_for_no_other() {
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    for schema in [
        "+s1/turnl/+s2",
        "+s1/turnl/+s1",
        "+s2/turnl/+s3",
        "+s1/forward/+s1",
    ] {
        knowledge.insert(&text(schema), 1, 2).unwrap();
    }
    let outcome = knowledge.record(&only(&[0]), ActionId(0), &only(&[1]), 0.0);
    assert_eq!((outcome.activated, outcome.succeeded), (2, 1));
    let counts: std::vec::Vec<(u32, u32)> = knowledge
        .schemas()
        .iter()
        .map(|s| (s.reliability.successes(), s.reliability.activations()))
        .collect();
    assert_eq!(counts, [(2, 3), (1, 3), (1, 2), (1, 2)]);
}

#[test]
fn a_result_that_hangs_on_an_unknown_item_is_not_counted() {
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    knowledge.insert(&text("+s1/turnl/+s2"), 1, 2).unwrap();
    let mut after = only(&[]);
    after.set(ItemId(1), None).unwrap();
    let outcome = knowledge.record(&only(&[0]), ActionId(0), &after, 0.0);
    assert_eq!(outcome.activated, 0);
    assert_eq!(knowledge.schemas()[0].reliability.activations(), 2);
}

#[test]
fn a_full_table_forgets_the_least_successful_and_counts_it() {
    let mut knowledge = KnowledgeBase::<1, 16, 2>::new();
    knowledge.insert(&text("+s1/turnl/+s2"), 9, 20).unwrap();
    knowledge.insert(&text("+s2/turnl/+s3"), 3, 20).unwrap();
    assert_eq!(
        knowledge.insert(&text("+s3/turnl/+s1"), 2, 20),
        Err(TableFull)
    );
    knowledge
        .insert(&text("+s3/forward/+ingrip"), 5, 20)
        .unwrap();
    let kept: std::vec::Vec<u32> = knowledge
        .schemas()
        .iter()
        .map(|s| s.reliability.successes())
        .collect();
    assert_eq!(kept, [9, 5]);
    let losses = Losses {
        evicted_schemas: 1,
        refused_schemas: 1,
        refused_patterns: 0,
    };
    assert_eq!(knowledge.losses(), losses);
}

#[test]
fn a_full_pattern_table_refuses_and_counts() {
    let mut knowledge = KnowledgeBase::<1, 2, 8>::new();
    knowledge.insert(&text("+s1/turnl/+s2"), 1, 1).unwrap();
    assert_eq!(
        knowledge.insert(&text("+s3/turnl/+s2"), 1, 1),
        Err(TableFull)
    );
    assert_eq!(knowledge.losses().refused_patterns, 1);
    knowledge.insert(&text("+s2/turnl/+s1"), 1, 1).unwrap();
}

#[test]
fn a_harvest_keeps_the_trials_of_what_is_still_said_and_drops_the_rest() {
    let mut bank = ActionSomBank::<6, 6, 4, 2>::new();
    bank.randomize(&mut Rng::new(1));
    let config = TrainingConfig::FORAGER;
    let turn = Sample::new(&only(&[0]), &only(&[1]), ResultCoding::EndState, 4);
    let stay = Sample::new(&only(&[0]), &only(&[0]), ResultCoding::EndState, 4);
    for _ in 0..30 {
        bank.train(ActionId(0), &turn, &config);
    }
    for _ in 0..10 {
        bank.train(ActionId(0), &stay, &config);
    }
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    knowledge
        .insert(&text("+s3/forward/+ingrip"), 5, 9)
        .unwrap();
    let harvest = |knowledge: &mut KnowledgeBase<1, 16, 16>| {
        knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
    };
    harvest(&mut knowledge);
    let shares: std::vec::Vec<f32> = knowledge
        .schemas()
        .iter()
        .map(|s| s.reliability.value(Estimate::Plain))
        .collect();
    assert_eq!(
        shares,
        [0.75, 0.25],
        "wins of the nodes are the first record"
    );
    assert_eq!(
        knowledge.patterns(),
        2,
        "patterns of dropped schemas leave with them"
    );
    knowledge.record(&only(&[0]), ActionId(0), &only(&[0]), 0.0);
    harvest(&mut knowledge);
    assert_eq!(knowledge.schemas()[1].reliability.successes(), 11);
    assert_eq!(knowledge.schemas()[1].reliability.activations(), 41);
}

#[test]
fn value_flows_along_ways_and_not_along_accidents() {
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    knowledge.set_inherent_value(ItemId(3), 10.0).unwrap();
    for (schema, successes) in [
        ("+s3/forward/+ingrip", 20),
        ("+s3/forward/+s3", 80),
        ("+s1/forward/+ingrip", 1),
        ("+s1/forward/+s1", 99),
        ("+s1/turnl/+s2", 30),
        ("+s1/turnl/+s1", 70),
    ] {
        knowledge.insert(&text(schema), successes, 100).unwrap();
    }
    let values = |knowledge: &KnowledgeBase<1, 16, 16>| {
        [0, 2].map(|item| knowledge.deferred_value(ItemId(item)))
    };
    knowledge.defer_values(&ValueConfig::FORAGER);
    assert_eq!(values(&knowledge), [0.0, 9.5]);
    knowledge.defer_values(&ValueConfig::BOOK);
    assert_eq!(
        values(&knowledge),
        [9.5, 9.5],
        "read literally, one accident is a way"
    );
}

#[test]
fn a_harvest_makes_room_before_it_refuses_anything() {
    let mut bank = ActionSomBank::<6, 6, 4, 2>::new();
    bank.randomize(&mut Rng::new(1));
    for to in [1, 2] {
        let sample = Sample::new(&only(&[0]), &only(&[to]), ResultCoding::EndState, 4);
        bank.train(ActionId(0), &sample, &TrainingConfig::FORAGER);
    }
    let mut knowledge = KnowledgeBase::<1, 3, 2>::new();
    knowledge
        .insert(&text("+s3/forward/+ingrip"), 90, 99)
        .unwrap();
    knowledge
        .insert(&text("+ingrip/forward/+s3"), 90, 99)
        .unwrap();
    knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
    assert_eq!(
        knowledge.schemas().len(),
        2,
        "both of what the maps say now"
    );
    assert!(
        knowledge
            .schemas()
            .iter()
            .all(|schema| schema.action == ActionId(0))
    );
    assert_eq!(knowledge.losses(), Losses::default());
}

#[test]
fn a_refused_schema_leaves_no_conjunction_behind() {
    let mut knowledge = KnowledgeBase::<1, 8, 1>::new();
    knowledge.insert(&text("+s1/turnl/+s2"), 9, 9).unwrap();
    for schema in ["+s2/turnl/+s3", "+s3/turnl/+ingrip", "+ingrip/turnl/+s1"] {
        assert_eq!(knowledge.insert(&text(schema), 1, 9), Err(TableFull));
    }
    assert_eq!(
        (knowledge.patterns(), knowledge.losses().refused_schemas),
        (2, 3)
    );
}

#[test]
fn nothing_can_be_worth_less_than_nothing() {
    use crate::clasm::InherentValueError;
    let mut knowledge = KnowledgeBase::<1, 8, 1>::new();
    let refused = knowledge.set_inherent_value(ItemId(0), -1.0);
    assert_eq!(refused, Err(InherentValueError::Negative));
    assert_eq!(knowledge.inherent_value(ItemId(0)), 0.0);
}
