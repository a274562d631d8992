//! The second level from maps, on a pendulum whose middle looks the same both ways.

use super::{Learning, SomLevel, SomLevelConfig};
use crate::choice::ValueConfig;
use crate::knowledge::{KnowledgeBase, SyntheticId};
use crate::level2::Reading;
use crate::num::Rng;
use crate::word::{ActionId, ItemId, ItemStates, SchemaText, Vocabulary};

const WORDS: Vocabulary = Vocabulary {
    items: &["left", "middle", "right"],
    actions: &["go"],
};
const GO: ActionId = ActionId(0);
/// A pendulum: from the middle it goes to the side that it does not come from.
const COURSE: [u16; 4] = [0, 1, 2, 1];

type Knowledge = KnowledgeBase<1, 16, 16>;
type Level<const FEATURES: usize> = SomLevel<1, 3, 1, FEATURES, 6, 6, 1, 32, 64>;

fn text(schema: &str) -> SchemaText<1> {
    SchemaText::parse(schema, &WORDS).unwrap()
}

/// Level 1 knows each swing; from the middle either side is as probable as the other.
fn knowledge() -> Knowledge {
    let mut knowledge = Knowledge::new();
    for (schema, successes) in [
        ("+left-middle-right/go/-left+middle-right", 10),
        ("-left-middle+right/go/-left+middle-right", 10),
        ("-left+middle-right/go/+left-middle-right", 5),
        ("-left+middle-right/go/-left-middle+right", 5),
    ] {
        knowledge.insert(&text(schema), successes, 10).unwrap();
    }
    knowledge
}

fn at(place: u16) -> ItemStates<1> {
    let mut state = ItemStates::all_off(3);
    state.set(ItemId(place), Some(true)).unwrap();
    state
}

fn swing<const FEATURES: usize>(
    level: &mut Level<FEATURES>,
    knowledge: &mut Knowledge,
    times: usize,
    learning: Learning,
) {
    for turn in 0..times {
        let place = |turn: usize| at(COURSE[turn % 4]);
        let (before, after) = (place(turn), place(turn + 1));
        level.learn(
            knowledge,
            &before,
            GO,
            &after,
            &ValueConfig::FORAGER,
            learning,
        );
    }
}

fn swung<const FEATURES: usize>(reading: Reading) -> (Level<FEATURES>, Knowledge) {
    let config = SomLevelConfig {
        harvest_every: 40,
        reading,
        ..SomLevelConfig::FORAGER
    };
    let (mut level, mut knowledge) = (Level::new(), knowledge());
    level.be_born(config, &mut Rng::new(5)).unwrap();
    swing(&mut level, &mut knowledge, 400, Learning::Maps);
    level.harvest();
    (level, knowledge)
}

fn item<const FEATURES: usize>(level: &Level<FEATURES>, schema: &str) -> SyntheticId {
    let items = (0..level.items()).map(SyntheticId);
    let mut found = items.filter(|&id| level.text(id) == Some(text(schema)));
    found.next().unwrap()
}

const FROM_LEFT: &str = "+left-middle-right/go/-left+middle-right";
const TO_LEFT: &str = "-left+middle-right/go/+left-middle-right";
const TO_RIGHT: &str = "-left+middle-right/go/-left-middle+right";

#[test]
fn what_has_just_succeeded_tells_which_of_two_schemas_will() {
    let (level, knowledge) = swung::<7>(SomLevelConfig::FORAGER.reading);
    let believe = |schema| {
        let (host, item) = (item(&level, FROM_LEFT), item(&level, schema));
        level.belief(&knowledge, host, None, item, &ValueConfig::FORAGER)
    };
    assert!(believe(TO_RIGHT) > 0.95, "{}", believe(TO_RIGHT));
    assert!(believe(TO_LEFT) < 0.05, "{}", believe(TO_LEFT));
    let predictions = level.predictions();
    let right = f64::from(predictions.successes()) / f64::from(predictions.activations());
    assert!(right > 0.9, "{predictions}");
}

#[test]
fn maps_are_read_into_schemas_with_and_without_their_trace() {
    let (level, _) = swung::<7>(SomLevelConfig::FORAGER.reading);
    assert_eq!(level.items(), 4);
    let special = level.schemas().filter(|(_, trace)| trace.is_some()).count();
    let general = level.schemas().filter(|(_, trace)| trace.is_none()).count();
    assert_eq!((general, special), (4, 4));
    let (host, trace) = (item(&level, TO_RIGHT), item(&level, FROM_LEFT));
    assert!(level.schemas().any(|it| it == (host, Some(trace))));
    // Every occasion counts for both.
    let tried = |trace| level.tried(host, trace, GO);
    assert!(tried(None) > 50.0 && tried(None) == tried(Some(trace)));
}

#[test]
fn the_plain_cut_believes_only_what_was_almost_always_on() {
    let (level, knowledge) = swung::<7>(Reading::Cut(0.9));
    let host = item(&level, FROM_LEFT);
    let believe = |schema| {
        level.belief(
            &knowledge,
            host,
            None,
            item(&level, schema),
            &ValueConfig::FORAGER,
        )
    };
    assert_eq!(believe(TO_RIGHT), 1.0);
    assert_eq!(believe(TO_LEFT), 0.5, "of this one nothing is known");
}

#[test]
fn a_level_that_may_learn_nothing_still_follows_what_happens() {
    let (mut level, mut knowledge) = swung::<7>(SomLevelConfig::FORAGER.reading);
    knowledge.set_inherent_value(ItemId(2), 1.0).unwrap();
    let before = level.clone();
    swing(&mut level, &mut knowledge, 5, Learning::Nothing);
    let (host, go) = (item(&level, FROM_LEFT), GO);
    assert_eq!(level.tried(host, None, go), before.tried(host, None, go));
    // Left, middle, right, middle, left, middle: the right is next, and worth something.
    let preference = level
        .prefer(&mut knowledge, &at(1), &ValueConfig::FORAGER)
        .unwrap();
    assert!(preference.value > 0.9);
    assert_eq!(
        knowledge.text(preference.schema.unwrap()).unwrap(),
        text(TO_RIGHT)
    );
    // Somewhere else than where the last schema has led, it knows nothing.
    let elsewhere = level.prefer(&mut knowledge, &at(0), &ValueConfig::FORAGER);
    assert_eq!(elsewhere, None);
}

#[test]
fn schemas_without_room_are_refused_and_counted_and_the_others_go_on() {
    let (level, _) = swung::<5>(SomLevelConfig::FORAGER.reading);
    assert_eq!(level.items(), 2);
    assert!(level.losses().refused_items > 100);
    let (host, next) = (item(&level, FROM_LEFT), item(&level, TO_RIGHT));
    assert!(level.on(host, None, next) > 50.0);
}
