//! What the second level believes, what it holds things to be worth, and when it forgets.

use super::{
    ActionId, BeliefTable, KnowledgeBase, Level2Config, Rates, SchemaId, SecondLevel, SyntheticId,
    ValueConfig, Voice,
};
use crate::check::Config;
use crate::level2::Fallback;
use crate::map::{ActionSomBank, HarvestConfig, ResultCoding, Sample, TrainingConfig};
use crate::num::Rng;
use crate::word::{ItemId, ItemStates, SchemaText, Vocabulary};

const WORDS: Vocabulary = Vocabulary {
    items: &["a", "b", "c", "gold"],
    actions: &["go", "stay"],
};
const GO: ActionId = ActionId(0);
const STAY: ActionId = ActionId(1);
const VALUES: ValueConfig = ValueConfig {
    discount: 0.5,
    ..ValueConfig::BOOK
};
/// κ is 2, and nothing is forgotten.
const CONFIG: Level2Config = Level2Config {
    experience: 0.25,
    lambda: 0.5,
    learning_rate: 0.1,
    forgetting: 0.0,
    ..Level2Config::FORAGER
};

type Knowledge = KnowledgeBase<1, 16, 16>;
type Two = SecondLevel<2, 6, 16>;

const ITEM: [SyntheticId; 5] = [
    SyntheticId(0),
    SyntheticId(1),
    SyntheticId(2),
    SyntheticId(3),
    SyntheticId(4),
];

/// From b going brings gold in half of all cases and c in a quarter; staying brings c.
fn schemas() -> Knowledge {
    let mut it = Knowledge::new();
    it.set_inherent_value(ItemId(3), 10.0).unwrap();
    it.set_inherent_value(ItemId(2), 4.0).unwrap();
    for (text, successes) in [
        ("+a/go/+b", 4),
        ("+b/go/+gold", 2),
        ("+b/go/+c", 1),
        ("+b/stay/+c", 4),
        ("+c/go/+a", 3),
    ] {
        let text = SchemaText::parse(text, &WORDS).unwrap();
        it.insert(&text, successes, 4).unwrap();
    }
    it
}

/// An item for each schema, with the index of its schema.
fn both() -> (Knowledge, Two) {
    let (mut knowledge, mut level) = (schemas(), Two::new());
    for (schema, item) in ITEM.into_iter().enumerate() {
        let made = level.reify(&mut knowledge, SchemaId(schema as u16));
        assert_eq!(made, Some(item));
    }
    (knowledge, level)
}

fn only(item: u16) -> ItemStates<1> {
    let mut state = ItemStates::all_off(4);
    state.set(ItemId(item), Some(true)).unwrap();
    state
}

fn meet(level: &mut Two, trace: SyntheticId, action: ActionId, item: usize, times: u32) {
    for _ in 0..times {
        level.table.record(trace, action, Some(ITEM[item]), 0.0);
    }
}

fn near(value: f32, expected: f32) {
    let within = 1e-5 * expected.abs().max(1.0);
    assert!((value - expected).abs() < within, "{value}, not {expected}");
}

#[test]
fn a_belief_is_the_share_of_successes_after_its_trace_with_level_1_as_prior() {
    let (knowledge, mut level) = both();
    let belief = |level: &Two, trace: usize, schema: u16| {
        level.belief(&knowledge, ITEM[trace], SchemaId(schema), &VALUES, &CONFIG)
    };
    // Nothing was tried: what level 1 says.
    near(belief(&level, 0, 1), 0.5);
    near(belief(&level, 0, 3), 1.0);
    meet(&mut level, ITEM[0], GO, 1, 3);
    meet(&mut level, ITEM[0], GO, 2, 1);
    near(belief(&level, 0, 1), (3.0 + 2.0 * 0.5) / (4.0 + 2.0));
    near(belief(&level, 0, 2), (1.0 + 2.0 * 0.25) / (4.0 + 2.0));
    // Another action was not tried, and after another trace nothing was.
    near(belief(&level, 0, 3), 1.0);
    near(belief(&level, 4, 1), 0.5);
    assert_eq!(belief(&level, 0, 99), 0.0);
    assert_eq!((level.tried(ITEM[0], GO), level.uses(ITEM[0])), (4.0, 4.0));
    meet(&mut level, ITEM[0], STAY, 3, 1);
    assert_eq!(level.uses(ITEM[0]), 5.0);
    let nobody = SyntheticId(99);
    assert_eq!((level.tried(nobody, GO), level.uses(nobody)), (0.0, 0.0));
    assert_eq!(level.tried(ITEM[0], ActionId(7)), 0.0);
}

#[test]
fn an_expected_value_goes_from_what_level_1_says_to_what_followed_the_trace() {
    let values = ValueConfig {
        discount: 0.0,
        ..VALUES
    };
    let (mut knowledge, mut level) = both();
    let expect = |level: &Two, knowledge: &mut Knowledge| {
        level.expected_values(knowledge, &only(1), ITEM[0], &values, &CONFIG)
    };
    // Alternatives that leave something open are scaled up to certainty.
    let [go, stay] = expect(&level, &mut knowledge);
    near(go, (0.5 * 10.0 + 0.25 * 4.0) / 0.75);
    near(stay, 4.0);
    meet(&mut level, ITEM[0], GO, 1, 3);
    meet(&mut level, ITEM[0], GO, 2, 1);
    let [go, stay] = expect(&level, &mut knowledge);
    near(go, 8.0 * (2.0 / 6.0) + (3.0 * 10.0 + 1.0 * 4.0) / 6.0);
    near(stay, 4.0);
    // What followed another trace counts only there.
    let [go, _] = level.expected_values(&mut knowledge, &only(1), ITEM[4], &values, &CONFIG);
    near(go, 8.0);
    // Where no schema applies only what followed is left.
    let [go, stay] = level.expected_values(&mut knowledge, &only(3), ITEM[0], &values, &CONFIG);
    near(go, (3.0 * 10.0 + 1.0 * 4.0) / 6.0);
    assert_eq!(stay, 0.0);
}

#[test]
fn overlapping_contexts_promise_no_more_than_certainty() {
    let (mut knowledge, level) = both();
    let text = SchemaText::parse("+b-a/go/+gold", &WORDS).unwrap();
    knowledge.insert(&text, 4, 4).unwrap();
    let values = ValueConfig {
        discount: 0.0,
        ..VALUES
    };
    let [go, _] = level.expected_values(&mut knowledge, &only(1), ITEM[0], &values, &CONFIG);
    near(go, (1.5 * 10.0 + 0.25 * 4.0) / 1.75);
}

#[test]
fn what_follows_a_success_is_worth_its_value_moved_towards_experience_and_discounted() {
    let (mut knowledge, mut level) = both();
    let row = &mut level.table.rows[1];
    (row.value, row.experienced) = (8.0, 4.0);
    let rates = Rates::of(&VALUES, &CONFIG);
    near(rates.then(row), 0.5 * (8.0 + 0.25 * (4.0 - 8.0)));
    row.value = 0.0;
    near(rates.then(row), 0.5 * 1.0);
    // Kept or computed on the way, it is the same: gold's own value and what follows it.
    let expect = |level: &Two, knowledge: &mut Knowledge, values: &ValueConfig| {
        level.expected_values(knowledge, &only(1), ITEM[0], values, &CONFIG)
    };
    let fresh = expect(&level, &mut knowledge, &VALUES);
    near(fresh[0], (0.5 * (10.0 + 0.5) + 0.25 * 4.0) / 0.75);
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &CONFIG);
    knowledge.improve_values::<2>(0, &VALUES);
    assert_eq!(expect(&level, &mut knowledge, &VALUES), fresh);
    // Another discount counts at once, for the items and for schemas that have none.
    let other = ValueConfig {
        discount: 0.8,
        ..VALUES
    };
    let [go, _] = expect(&level, &mut knowledge, &other);
    near(go, (0.5 * (10.0 + 0.8) + 0.25 * 4.0) / 0.75);
    let patient = Level2Config {
        experience: 1.0,
        ..CONFIG
    };
    let [go, _] = level.expected_values(&mut knowledge, &only(1), ITEM[0], &VALUES, &patient);
    near(go, (0.5 * (10.0 + 2.0) + 0.25 * 4.0) / 0.75);
}

#[test]
fn a_result_without_an_item_is_worth_what_level_1_holds_it_to_be() {
    let (mut knowledge, mut level) = (schemas(), Two::new());
    level.reify(&mut knowledge, SchemaId(0)).unwrap();
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &CONFIG);
    knowledge.settle_values::<2>(50, &VALUES);
    let text = SchemaText::parse("+gold/go/+b", &WORDS).unwrap();
    knowledge.insert(&text, 1, 1).unwrap();
    let b = knowledge.patterns[1].value;
    assert!(b > 6.0, "half of gold, a quarter of c and what follows c");
    // Both where level 1 has just used another discount and where it has not.
    for other in [0.25, 0.5] {
        let other = ValueConfig {
            discount: other,
            ..VALUES
        };
        knowledge.improve_values::<2>(0, &other);
        let [go, _] = level.expected_values(&mut knowledge, &only(3), ITEM[0], &VALUES, &CONFIG);
        near(go, 0.5 * b);
    }
}

#[test]
fn a_reward_is_felt_back_along_the_way_the_less_the_longer_ago() {
    let (mut knowledge, mut level) = both();
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &CONFIG);
    let experienced = |level: &Two| [0, 1, 2].map(|item| level.table.rows[item].experienced);
    let mut live = |from: usize, to: usize, reward| {
        level.experience(ITEM[from], ITEM[to], reward, 0.5, &CONFIG);
        experienced(&level)
    };
    assert_eq!(live(0, 1, 0.0), [0.0, 0.0, 0.0]);
    // 8 for the state before, a quarter (discount · λ) of that for the one before it.
    assert_eq!(live(1, 2, 8.0), [2.0, 8.0, 0.0]);
    // Half of 8 was to be had, 2 were expected; the second visit has half the weight of the first.
    assert_eq!(live(0, 1, 0.0), [3.0, 8.5, 0.0]);
    // Less than expected counts as much as more.
    assert_eq!(live(0, 3, 0.0), [3.0 - 3.0 / 3.0, 8.5 - 3.0 / 16.0, 0.0]);
    assert_eq!(level.table.rows[0].visits, 3.0);
    // One state felt the first reward, two felt each of the others.
    assert_eq!(level.table.cost.items, 1 + 2 + 2 + 2);
    // A way that leads nowhere teaches nothing.
    let before = level.clone();
    level.experience(SyntheticId(99), ITEM[0], 5.0, 0.5, &CONFIG);
    level.experience(ITEM[0], SyntheticId(99), 5.0, 0.5, &CONFIG);
    assert_eq!(level, before);
}

#[test]
fn a_state_long_ago_no_longer_feels_a_reward() {
    let (mut knowledge, mut level) = both();
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &CONFIG);
    level.experience(ITEM[0], ITEM[1], 0.0, 0.5, &CONFIG);
    // 1/4, 1/16, 1/64 of a reward are felt; 1/256 is below one in a hundred.
    let mut shares = [0.0; 5];
    for share in &mut shares {
        let before = level.table.rows[0].experienced;
        let promised = 0.5 * level.table.rows[2].experienced - level.table.rows[1].experienced;
        level.experience(ITEM[1], ITEM[2], 64.0 - promised, 0.5, &CONFIG);
        *share = level.table.rows[0].experienced - before;
    }
    assert_eq!(shares, [16.0, 4.0, 1.0, 0.0, 0.0]);
    assert_eq!(level.table.rows[0].eligibility, 0.0);
    // One in a hundred exactly is still felt.
    let steep = Level2Config {
        lambda: 1.0,
        ..CONFIG
    };
    let mut level = Two::new();
    for schema in 0..2 {
        level.reify(&mut knowledge, SchemaId(schema)).unwrap();
    }
    level.experience(ITEM[0], ITEM[1], 0.0, 0.01, &steep);
    level.experience(ITEM[1], ITEM[1], 100.0, 0.01, &steep);
    near(level.table.rows[0].experienced, 1.0);
}

#[test]
fn a_visit_weighs_less_than_the_one_before_but_never_less_than_the_learning_rate() {
    let mut knowledge = schemas();
    let mut level = Two::new();
    for schema in 0..2 {
        level.reify(&mut knowledge, SchemaId(schema)).unwrap();
    }
    let config = Level2Config {
        learning_rate: 0.3,
        ..CONFIG
    };
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &config);
    for weight in [1.0, 1.0 / 2.0, 1.0 / 3.0, 0.3, 0.3, 0.3] {
        let before = level.table.rows[0].experienced;
        level.experience(ITEM[0], ITEM[1], 10.0 + before, 0.0, &config);
        near(level.table.rows[0].experienced - before, 10.0 * weight);
    }
}

#[test]
fn an_item_begins_with_the_value_of_its_schemas_result_and_marks_its_schema() {
    let (mut knowledge, mut level) = (schemas(), Two::new());
    knowledge.settle_values::<2>(50, &VALUES);
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &CONFIG);
    let b = knowledge.patterns[1].value;
    assert!(b > 5.0);
    let seen = knowledge.cost.schemas;
    assert_eq!(level.reify(&mut knowledge, SchemaId(0)), Some(ITEM[0]));
    assert_eq!(knowledge.cost.schemas, seen + 5);
    assert_eq!(level.value(ITEM[0]), b);
    assert_eq!(level.table.rows[0].then, 0.5 * b);
    assert_eq!(level.schema(ITEM[0]), Some(SchemaId(0)));
    assert_eq!(level.item_of(&knowledge, SchemaId(0)), Some(ITEM[0]));
    assert_eq!(level.item_of(&knowledge, SchemaId(1)), None);
    assert_eq!(level.items(), 1);
    assert_eq!(level.reify(&mut knowledge, SchemaId(99)), None);
    let nobody = SyntheticId(99);
    assert_eq!((level.value(nobody), level.schema(nobody)), (0.0, None));
}

#[test]
fn an_item_that_is_taken_for_another_schema_is_no_longer_its_first_ones() {
    let (mut knowledge, mut level) = (schemas(), SecondLevel::<2, 1, 4>::new());
    level.reify(&mut knowledge, SchemaId(2)).unwrap();
    assert_eq!(level.reify(&mut knowledge, SchemaId(4)), Some(ITEM[0]));
    let marks = knowledge.schemas().iter().map(|schema| schema.synthetic());
    assert_eq!(
        marks.collect::<std::vec::Vec<_>>(),
        [None, None, None, None, Some(ITEM[0])]
    );
    assert_eq!(level.losses().evicted_items, 1);
    // A mark that points to an item of another schema is none.
    level.table.rows[0].schema = Some(SchemaId(1));
    assert_eq!(level.item_of(&knowledge, SchemaId(4)), None);
}

#[test]
fn what_was_believed_most_is_compared_with_what_came() {
    let (_, mut level) = both();
    // Without a belief there is no prediction.
    level.judge(ITEM[0], GO, Some(ITEM[1]));
    assert_eq!(level.predictions().activations(), 0);
    meet(&mut level, ITEM[0], GO, 1, 2);
    meet(&mut level, ITEM[0], GO, 2, 3);
    meet(&mut level, ITEM[0], STAY, 3, 9);
    assert_eq!(level.most_believed(ITEM[0], GO), Some(ITEM[2]));
    assert_eq!(level.most_believed(ITEM[0], STAY), Some(ITEM[3]));
    assert_eq!(level.most_believed(ITEM[1], GO), None);
    level.judge(ITEM[0], GO, Some(ITEM[2]));
    level.judge(ITEM[0], GO, Some(ITEM[1]));
    level.judge(ITEM[0], GO, None);
    level.judge(ITEM[0], STAY, None);
    let predictions = level.predictions();
    assert_eq!((predictions.successes(), predictions.activations()), (1, 4));
    // Of equally strong beliefs the first counts.
    meet(&mut level, ITEM[0], GO, 1, 1);
    assert_eq!(level.most_believed(ITEM[0], GO), Some(ITEM[1]));
}

#[test]
fn a_level_is_overloaded_when_it_is_right_less_often_than_it_was() {
    let mut level = Two::new();
    assert!(!level.is_overloaded(0.7), "nothing was predicted yet");
    for _ in 0..3000 {
        level.count_prediction(true);
    }
    assert!((level.slow - 0.776_9).abs() < 1e-3, "1 - 0.9995³⁰⁰⁰");
    near(level.fast, 1.0);
    assert!(!level.is_overloaded(1.0));
    let slow = level.slow;
    for _ in 0..50 {
        level.count_prediction(false);
    }
    // The fast share has lost most of what it was, the slow one hardly anything.
    near(level.fast, 0.98_f32.powi(50));
    assert!((level.slow - slow * 0.975_3).abs() < 1e-3);
    assert!(level.is_overloaded(0.7) && !level.is_overloaded(0.4));
    assert_eq!(level.predictions().successes(), 3000);
}

#[test]
fn a_doubt_leaves_no_more_occasions_than_the_evidence_does() {
    let (mut knowledge, mut level) = both();
    // Item 0 stands for a schema that ends in b: a hundred goings and ten stayings were seen there.
    meet(&mut level, ITEM[0], GO, 1, 60);
    meet(&mut level, ITEM[0], GO, 2, 40);
    meet(&mut level, ITEM[0], STAY, 3, 10);
    // Item 4 stands for one that ends in a, of which going on is known too.
    meet(&mut level, ITEM[4], GO, 0, 30);
    knowledge.begin_doubt();
    // From b going now brings c, again and again.
    for _ in 0..12 {
        knowledge.count_hits(&only(1), GO, &only(2));
    }
    let [a, b] = [0, 1].map(|schema| knowledge.schemas()[schema].context);
    let (elsewhere, hold) = (knowledge.hold(a, GO), knowledge.hold(b, GO));
    assert!(
        elsewhere > 40.0 && (10.0..25.0).contains(&hold),
        "{elsewhere} {hold}"
    );
    level.doubt(&knowledge, |context, action| {
        knowledge.hold(context, action)
    });
    near(level.tried(ITEM[0], GO), hold);
    near(level.beliefs()[0].on, 0.6 * hold);
    near(level.beliefs()[1].on, 0.4 * hold);
    assert_eq!(level.tried(ITEM[0], STAY), 10.0);
    assert_eq!(
        (level.tried(ITEM[4], GO), level.beliefs()[3].on),
        (30.0, 30.0)
    );
    // As much as the evidence leaves is left alone.
    let before = level.clone();
    level.doubt(&knowledge, |context, action| {
        knowledge.hold(context, action)
    });
    near(level.tried(ITEM[0], GO), before.tried(ITEM[0], GO));
}

#[test]
fn after_a_doubt_what_followed_in_the_old_world_says_nothing() {
    let (mut knowledge, mut level) = both();
    level.improve(&mut knowledge, SyntheticId(99), &VALUES, &CONFIG);
    level.experience(ITEM[0], ITEM[1], 8.0, 0.5, &CONFIG);
    level.table.rows[0].value = 2.0;
    level.forget_experience();
    let row = level.table.rows[0];
    assert_eq!((row.value, row.experienced), (2.0, 2.0));
    assert_eq!((row.visits, row.eligibility, row.then), (0.0, 0.0, 1.0));
}

#[test]
fn items_follow_schemas_that_moved_and_leave_with_those_that_left() {
    let mut bank = ActionSomBank::<6, 6, 4, 2>::new();
    bank.randomize(&mut Rng::new(1));
    for from in [0, 1] {
        let sample = Sample::new(&only(from), &only(2), ResultCoding::EndState, 4);
        bank.train(GO, &sample, &TrainingConfig::FORAGER);
    }
    let (mut knowledge, mut level) = (Knowledge::new(), Two::new());
    for text in [
        "+gold/go/+a",
        "+a-b-c-gold/go/-a-b+c-gold",
        "-a+b-c-gold/go/-a-b+c-gold",
    ] {
        let text = SchemaText::parse(text, &WORDS).unwrap();
        let id = knowledge.insert(&text, 1, 1).unwrap();
        level.reify(&mut knowledge, id).unwrap();
    }
    meet(&mut level, ITEM[0], GO, 1, 1);
    meet(&mut level, ITEM[1], GO, 2, 1);
    knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
    assert_eq!(knowledge.schemas().len(), 2, "no node says the first");
    level.follow(&knowledge);
    let of = [0, 1, 2].map(|item| level.schema(ITEM[item]));
    assert_eq!(of, [None, Some(SchemaId(0)), Some(SchemaId(1))]);
    assert_eq!(level.items(), 2);
    let [left] = level.beliefs() else {
        panic!("beliefs after an item leave with it")
    };
    assert_eq!((left.trace, left.item), (ITEM[1], ITEM[2]));
    // Free rows stay free.
    level.follow(&knowledge);
    assert_eq!(level.items(), 2);
}

#[test]
fn values_are_brought_up_to_date_in_turn_and_each_is_that_of_the_best_action() {
    let (mut knowledge, mut level) = both();
    // After item 0 the robot is in b, after items 2 and 3 in c, after item 4 in a, after 1 at gold.
    meet(&mut level, ITEM[0], GO, 2, 18);
    let values = |level: &Two| ITEM.map(|item| level.value(item));
    level.improve_values(&mut knowledge, 2, &VALUES, &CONFIG);
    // Going has led to c 18 times; for two occasions level 1 speaks, and for gold.
    let first = 0.1 * 8.0 + 0.9 * 4.0;
    near(level.value(ITEM[0]), first);
    assert_eq!(values(&level)[1..], [0.0; 4]);
    level.improve_values(&mut knowledge, 3, &VALUES, &CONFIG);
    let [b, gold, c, also_c, a] = values(&level);
    near(b, first);
    assert_eq!((gold, c, also_c), (0.0, 0.0, 0.0));
    // In a going leads to b: half of its value, of which three quarters are what was inferred.
    near(a, 0.5 * 0.75 * b);
    level.improve_values(&mut knowledge, 3, &VALUES, &CONFIG);
    let [_, gold, c, also_c, still] = values(&level);
    // c leads to a.
    near(c, 0.5 * 0.75 * a);
    assert_eq!((gold, also_c, still), (0.0, 0.0, a));
    // One more in turn: the second c.
    level.improve_values(&mut knowledge, 1, &VALUES, &CONFIG);
    assert_eq!(level.value(ITEM[3]), level.value(ITEM[2]));
    level.improve(&mut knowledge, ITEM[0], &VALUES, &CONFIG);
    assert!(level.value(ITEM[0]) > b, "c has become worth more");
}

#[test]
fn the_best_action_is_spoken_for_by_what_is_believed_most_or_by_level_1() {
    let (mut knowledge, mut level) = both();
    let prefer = |level: &Two, knowledge: &mut Knowledge, voice: Option<&Voice<2>>| {
        level.prefer(knowledge, &only(1), ITEM[0], &VALUES, &CONFIG, voice)
    };
    let best = prefer(&level, &mut knowledge, None).unwrap();
    assert_eq!((best.action, best.schema), (GO, Some(SchemaId(1))));
    near(best.value, 8.0);
    meet(&mut level, ITEM[0], GO, 2, 3);
    let best = prefer(&level, &mut knowledge, None).unwrap();
    assert_eq!((best.action, best.schema), (GO, Some(SchemaId(2))));
    near(best.value, 8.0 * 0.4 + 4.0 * 0.6);
    let voice = Voice {
        weight: 0.5,
        worth: [0.0, 20.0],
    };
    let best = prefer(&level, &mut knowledge, Some(&voice)).unwrap();
    assert_eq!((best.action, best.schema), (STAY, Some(SchemaId(3))));
    near(best.value, 12.0);
    // From gold nothing leads on.
    let nowhere = level.prefer(&mut knowledge, &only(3), ITEM[1], &VALUES, &CONFIG, None);
    assert_eq!(nowhere, None);
}

#[test]
fn looking_for_what_to_do_counts_what_it_looks_at() {
    let (mut knowledge, mut level) = both();
    meet(&mut level, ITEM[0], GO, 1, 1);
    meet(&mut level, ITEM[0], GO, 2, 1);
    let before = knowledge.cost;
    level.expected_values(&mut knowledge, &only(1), ITEM[0], &VALUES, &CONFIG);
    // Three schemas apply in b, two beliefs follow the trace.
    assert_eq!(knowledge.cost.schemas - before.schemas, 3);
    assert_eq!(knowledge.cost.beliefs - before.beliefs, 2);
    assert_eq!(knowledge.cost.patterns - before.patterns, 4);
}

#[test]
fn a_cleared_level_is_as_new_but_for_what_it_has_lost() {
    let (mut knowledge, mut level) = both();
    meet(&mut level, ITEM[0], GO, 1, 3);
    level.improve_values(&mut knowledge, 3, &VALUES, &CONFIG);
    level.count_prediction(true);
    level.clear();
    assert_eq!((level.items(), level.beliefs()), (0, &[][..]));
    assert_eq!(level.predictions().activations(), 0);
    assert_eq!((level.slow, level.fast, level.next_value), (0.0, 0.0, 0));
    level.table.cost = crate::word::Cost::NONE;
    assert_eq!(level.table, BeliefTable::new());
}

#[test]
fn a_configuration_of_level_2_is_sound_when_every_number_is_in_range() {
    let bad: [fn(&mut Level2Config); 12] = [
        |it| it.prior = 0.0,
        |it| it.prior = -1.0,
        |it| it.prior = f32::INFINITY,
        |it| it.forgetting = 1.0,
        |it| it.forgetting = -0.1,
        |it| it.experience = 1.5,
        |it| it.experience = f32::NAN,
        |it| it.lambda = -0.5,
        |it| it.learning_rate = 2.0,
        |it| it.fallback = Fallback::MeanReliability(1.5),
        |it| it.fallback = Fallback::MeanReliability(-0.5),
        |it| it.prior = f32::NAN,
    ];
    for (index, spoil) in bad.into_iter().enumerate() {
        let mut config = Level2Config::FORAGER;
        assert!(config.check().is_ok());
        spoil(&mut config);
        assert!(config.check().is_err(), "{index}");
    }
    for fallback in [
        Fallback::MeanReliability(0.7),
        Fallback::ValueThenReliability,
    ] {
        let good = Level2Config {
            fallback,
            ..Level2Config::FORAGER
        };
        assert!(good.check().is_ok());
    }
}
