//! The portrait of the one learner.

use cla_core::forest::{Feature, Mind, Voice as Speaker};
use cla_core::word::{ActionId, ItemId, Vocabulary};

use super::portrait::{Count, Filling, Item, Portrait, Schema, Sign, Voice, by_worth, written};

pub(super) fn portrait<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
>(
    mind: &Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS>,
    words: &Vocabulary,
) -> Portrait {
    let filled = mind.filled();
    let tables = [
        ("samples", filled.samples),
        ("leaves of the newest trees", filled.leaves),
        ("rows of habits", filled.rows),
        ("states of the model", filled.states),
        ("links of the model", filled.links),
    ];
    let (_, _, grown) = mind.size();
    let item = |number: u16| {
        let id = ItemId(number);
        Item {
            name: words.item_name(id).to_string(),
            inherent: mind.value(id).into(),
            deferred: None,
            relevance: Some(mind.relevance(id).into()),
            habits: mind.habit(id).map(f64::from).to_vec(),
        }
    };
    let voice = |speaker: Speaker| {
        let (brought, blocks) = mind.record(speaker);
        Voice {
            name: format!("{speaker:?}"),
            brought: brought.into(),
            blocks: blocks.into(),
        }
    };
    Portrait {
        kind: "mind".to_owned(),
        stage: if mind.acts() { "Acting" } else { "Training" }.to_owned(),
        samples: filled.samples.0.into(),
        alarms: mind.alarms(),
        actions: words.actions.iter().map(|&it| it.to_owned()).collect(),
        items: (0..ITEMS as u16).map(item).collect(),
        schemas: contexts(mind, words),
        voices: Speaker::ALL.map(voice).to_vec(),
        tables: tables
            .map(|(name, (used, most))| Filling::new(name, used, most))
            .to_vec(),
        losses: vec![
            Count::new("states or links given up for others", mind.given_up()),
            Count::new("trees grown", grown),
            Count::new("items that count as off, being stuck", mind.stuck()),
            Count::new(
                "share of habits' rows taken by other steps",
                mind.crowding(),
            ),
            Count::new("doubts now", u8::from(mind.doubts())),
        ],
        ..Portrait::default()
    }
}

/// The leaves of the newest tree of each action, which say no result.
fn contexts<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
>(
    mind: &Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS>,
    words: &Vocabulary,
) -> Vec<Schema> {
    let mut all = Vec::new();
    for number in 0..ACTIONS as u16 {
        let action = words.action_name(ActionId(number)).to_string();
        mind.contexts(ActionId(number), |path, value| {
            let sign = |&(feature, on): &(Feature, bool)| Sign {
                item: match feature {
                    Feature::Now(item) => words.item_name(item).to_string(),
                    Feature::Before(item) => format!("was_{}", words.item_name(item)),
                    Feature::After(action) => format!("did_{}", words.action_name(action)),
                },
                on,
            };
            let context: Vec<Sign> = path.iter().map(sign).collect();
            all.push(Schema {
                text: format!("{}/{action}/", written(&context, true)),
                brief: format!("{}/{action}/", written(&context, false)),
                context,
                action: action.clone(),
                result: Vec::new(),
                value: value.into(),
                reliability: None,
                trials: None,
            });
        });
    }
    by_worth(&mut all);
    all
}
