//! Tests of what the tables keep, drop and refuse.

use super::{KnowledgeBase, Losses, TableFull};
use crate::choice::ValueConfig;
use crate::knowledge::{Estimate, PatternId, SchemaId};
use crate::map::{ActionSomBank, HarvestConfig, ResultCoding, Sample, TrainingConfig};
use crate::num::Rng;
use crate::word::{ActionId, ItemId, ItemStates, SchemaText, Vocabulary};

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
    use crate::choice::InherentValueError;
    let mut knowledge = KnowledgeBase::<1, 8, 1>::new();
    let refused = knowledge.set_inherent_value(ItemId(0), -1.0);
    assert_eq!(refused, Err(InherentValueError::Negative));
    assert_eq!(knowledge.inherent_value(ItemId(0)), 0.0);
}

fn insert<const PATTERNS: usize, const SCHEMAS: usize>(
    knowledge: &mut KnowledgeBase<1, PATTERNS, SCHEMAS>,
    schemas: &[(&str, u32, u32)],
) {
    for &(schema, successes, activations) in schemas {
        let _ = knowledge.insert(&text(schema), successes, activations);
    }
}

/// All schemas in the order of the table, by number of successes.
fn successes<const PATTERNS: usize, const SCHEMAS: usize>(
    knowledge: &KnowledgeBase<1, PATTERNS, SCHEMAS>,
) -> std::vec::Vec<u32> {
    let schemas = knowledge.schemas().iter();
    schemas.map(|it| it.reliability.successes()).collect()
}

#[test]
fn a_schema_that_is_known_is_stored_once_with_the_new_record() {
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    let first = knowledge.insert(&text("+s1/turnl/+s2"), 3, 9).unwrap();
    let other = knowledge.insert(&text("+s1/forward/+s2"), 1, 9).unwrap();
    let result = knowledge.insert(&text("+s1/turnl/+s3"), 1, 9).unwrap();
    let context = knowledge.insert(&text("+s2/turnl/+s2"), 1, 9).unwrap();
    let ids = [first, other, result, context].map(|id| id.0);
    assert_eq!(ids, [0, 1, 2, 3]);
    assert_eq!(knowledge.patterns(), 3);
    assert_eq!(knowledge.insert(&text("+s1/turnl/+s2"), 4, 8), Ok(first));
    assert_eq!(knowledge.schemas().len(), 4);
    let record = knowledge.schemas()[0];
    assert_eq!(
        (
            record.reliability.successes(),
            record.reliability.activations()
        ),
        (4, 8)
    );
    assert_eq!(record.support, 3 + 4);
    assert_eq!(knowledge.text(result), Some(text("+s1/turnl/+s3")));
    assert_eq!(knowledge.text(SchemaId(4)), None);
    assert_eq!(knowledge.pattern(PatternId(3)), None);
}

#[test]
fn forgotten_schemas_are_gone_with_what_they_were_worth() {
    let mut knowledge = KnowledgeBase::<1, 4, 1>::new();
    knowledge.set_inherent_value(ItemId(1), 10.0).unwrap();
    insert(
        &mut knowledge,
        &[("+s1/turnl/+s2", 3, 9), ("+s2/turnl/+s3", 1, 9)],
    );
    knowledge.defer_values(&ValueConfig::BOOK);
    knowledge.settle_values::<1>(3, &ValueConfig::BOOK);
    assert!(knowledge.deferred_value(ItemId(0)) > 9.0);
    knowledge.forget_schemas();
    assert_eq!((knowledge.schemas().len(), knowledge.patterns()), (0, 0));
    assert_eq!(knowledge.deferred_value(ItemId(0)), 0.0);
    assert_eq!(
        knowledge.deferred_value(ItemId(1)),
        10.0,
        "its own value stays"
    );
    assert_eq!(
        knowledge.losses().refused_schemas,
        1,
        "and so do counted losses"
    );
    let outcome = knowledge.record(&only(&[0]), ActionId(0), &only(&[1]), 0.0);
    assert_eq!(outcome.activated, 0);
}

#[test]
fn what_explains_an_outcome_is_the_schema_that_says_most_and_of_equals_the_first() {
    let explain = |schemas: &[(&str, u32, u32)]| {
        let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
        insert(&mut knowledge, schemas);
        let before = knowledge.schemas().to_vec();
        let outcome = knowledge.explain(&only(&[0]), ActionId(0), &only(&[1]));
        assert_eq!(knowledge.schemas(), before, "nothing is learned");
        (
            outcome.activated,
            outcome.succeeded,
            outcome.schema.map(|id| id.0),
        )
    };
    let (short, long) = (("+s1/turnl/+s2", 1, 1), ("+s1-s3/turnl/+s2-s1", 1, 1));
    assert_eq!(explain(&[short, long]), (2, 2, Some(1)));
    assert_eq!(explain(&[long, short]), (2, 2, Some(0)));
    // Context and result count alike.
    let (in_context, in_result) = (("+s1-s3/turnl/+s2", 1, 1), ("+s1/turnl/+s2-s3", 1, 1));
    assert_eq!(explain(&[in_context, in_result]), (2, 2, Some(0)));
    assert_eq!(explain(&[in_result, in_context]), (2, 2, Some(0)));
    // What failed explains nothing, however much it says.
    let wrong = ("+s1-s3-ingrip/turnl/+s3-ingrip", 1, 1);
    assert_eq!(explain(&[wrong, short]), (2, 1, Some(1)));
    assert_eq!(explain(&[wrong]), (1, 0, None));
    let foreseen = |succeeded| {
        crate::knowledge::Outcome {
            activated: 2,
            succeeded,
            schema: None,
        }
        .foreseen()
    };
    assert!(foreseen(1) && foreseen(2) && !foreseen(0));
}

#[test]
fn what_is_gone_through_is_counted() {
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    insert(
        &mut knowledge,
        &[
            ("+s1/turnl/+s2", 1, 1),
            ("+s1/forward/+s2", 1, 1),
            ("+s2/turnl/+s2", 1, 1),
        ],
    );
    knowledge.record(&only(&[0]), ActionId(0), &only(&[1]), 0.0);
    assert_eq!((knowledge.cost.patterns, knowledge.cost.schemas), (2, 2));
    knowledge.look_at(&only(&[0]));
    assert_eq!((knowledge.cost.patterns, knowledge.cost.schemas), (4, 5));
    let holds = knowledge.patterns.iter().map(|pattern| pattern.holds);
    assert_eq!(holds.collect::<std::vec::Vec<_>>(), [true, false]);
}

#[test]
fn the_mean_reliability_is_that_of_the_schemas_that_were_tried() {
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    assert_eq!(knowledge.mean_reliability(Estimate::Plain), 0.0);
    insert(&mut knowledge, &[("+s3/turnl/+s2", 0, 0)]);
    assert_eq!(knowledge.mean_reliability(Estimate::Plain), 0.0);
    insert(
        &mut knowledge,
        &[("+s1/turnl/+s2", 1, 2), ("+s2/turnl/+s2", 1, 4)],
    );
    assert_eq!(knowledge.mean_reliability(Estimate::Plain), 0.375);
    knowledge.record(&only(&[0]), ActionId(0), &only(&[1]), 0.5);
    assert_eq!(knowledge.mean_reliability(Estimate::Recent), 0.5);
}

#[test]
fn of_the_least_successful_schemas_the_first_leaves_for_a_more_successful_one() {
    let mut knowledge = KnowledgeBase::<1, 16, 3>::new();
    insert(
        &mut knowledge,
        &[
            ("+s1/turnl/+s2", 7, 20),
            ("+s2/turnl/+s3", 3, 20),
            ("+s3/turnl/+s1", 3, 20),
        ],
    );
    // As successful is not more successful.
    insert(&mut knowledge, &[("+s1/forward/+s1", 3, 20)]);
    assert_eq!(successes(&knowledge), [7, 3, 3]);
    assert_eq!(knowledge.losses().refused_schemas, 1);
    let id = knowledge.insert(&text("+s1/forward/+s1"), 4, 20);
    assert_eq!(id, Ok(SchemaId(1)));
    assert_eq!(successes(&knowledge), [7, 4, 3]);
    assert_eq!(knowledge.text(SchemaId(1)), Some(text("+s1/forward/+s1")));
    // What experience has proved since it was stored counts as much as what nodes have said.
    for _ in 0..9 {
        knowledge.record(&only(&[2]), ActionId(0), &only(&[0]), 0.0);
    }
    insert(&mut knowledge, &[("+s2/forward/+s2", 5, 20)]);
    assert_eq!(successes(&knowledge), [7, 5, 12]);
}

#[test]
fn a_conjunction_that_no_schema_names_leaves_and_the_others_keep_their_names() {
    let mut knowledge = KnowledgeBase::<1, 5, 2>::new();
    insert(
        &mut knowledge,
        &[("+s1/turnl/+s2", 2, 9), ("+s3/turnl/+ingrip", 9, 9)],
    );
    assert_eq!(knowledge.patterns(), 4);
    // The first leaves with its conjunctions, one of which the new one uses again.
    insert(&mut knowledge, &[("-s1/turnl/+s2", 5, 9)]);
    assert_eq!(knowledge.patterns(), 4);
    let texts = [0, 1].map(|id| knowledge.text(SchemaId(id)).unwrap());
    assert_eq!(texts, [text("-s1/turnl/+s2"), text("+s3/turnl/+ingrip")]);
    // Applicable schemas are found by the new names.
    let outcome = knowledge.explain(&only(&[2]), ActionId(0), &only(&[3]));
    assert_eq!((outcome.activated, outcome.schema), (2, Some(SchemaId(1))));
    insert(&mut knowledge, &[("-s1/turnl/-s1", 8, 9)]);
    assert_eq!(knowledge.patterns(), 3, "one may be context and result");
}

/// A bank whose maps of two actions have seen these ways so often.
fn bank(ways: &[(u16, u16, u16, u32)]) -> ActionSomBank<6, 6, 4, 2> {
    let mut bank = ActionSomBank::new();
    bank.randomize(&mut Rng::new(1));
    for &(action, from, to, times) in ways {
        for _ in 0..times {
            let sample = Sample::new(&only(&[from]), &only(&[to]), ResultCoding::EndState, 4);
            bank.train(ActionId(action), &sample, &TrainingConfig::FORAGER);
        }
    }
    bank
}

#[test]
fn a_new_schema_starts_from_its_share_among_those_of_its_context_and_action() {
    let bank = bank(&[(0, 0, 1, 6), (0, 0, 2, 2), (0, 3, 1, 5), (1, 0, 1, 7)]);
    let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
    knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
    let records = knowledge.schemas().iter().map(|it| {
        let record = it.reliability;
        let turn = it.action == ActionId(0);
        (turn, record.successes(), record.activations())
    });
    let mut records: std::vec::Vec<_> = records.collect();
    records.sort_unstable();
    assert_eq!(
        records,
        [(false, 7, 7), (true, 2, 8), (true, 5, 5), (true, 6, 8)]
    );
    // Supports are what nodes say now, and do not add up over harvests.
    let supports = |knowledge: &KnowledgeBase<1, 16, 16>| {
        let schemas = knowledge.schemas().iter();
        schemas.map(|it| it.support).collect::<std::vec::Vec<_>>()
    };
    let once = supports(&knowledge);
    knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
    assert_eq!(supports(&knowledge), once);
}

#[test]
fn a_harvest_into_too_small_a_table_keeps_what_nodes_say_most_often() {
    let bank = bank(&[(0, 0, 1, 2), (0, 1, 2, 9), (1, 2, 1, 5), (1, 1, 0, 1)]);
    let mut knowledge = KnowledgeBase::<1, 16, 2>::new();
    knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
    let mut kept = successes(&knowledge);
    kept.sort_unstable();
    assert_eq!(kept, [5, 9]);
    let losses = knowledge.losses();
    assert_eq!((losses.evicted_schemas, losses.refused_schemas), (1, 1));
    assert_eq!(losses.refused_patterns, 0);
}

#[test]
fn a_full_table_says_so() {
    assert_eq!(std::format!("{TableFull}"), "the schema tables are full");
}
