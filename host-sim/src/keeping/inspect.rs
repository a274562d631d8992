//! What a kept brain knows, for people.

use std::fmt::Write as _;
use std::path::Path;

use cla_core::agent::Agent;
use cla_core::forager::{pioneer, small};
use cla_core::knowledge::{Estimate, SchemaId, SyntheticId};
use cla_core::snapshot::Stored;
use cla_core::som::Prototypes;
use cla_core::word::{ActionId, Detail, ItemId, ItemSet, Vocabulary};

use super::file::recall;
use crate::failure::Failure;

/// Says what the brain of a forager knows: sizes, items, schemas by value and reliability, habits,
/// beliefs; of each table the first `most` rows.
///
/// # Errors
/// When the file is no whole image of a forager, with the book's maps or with small ones.
pub fn inspect(path: &Path, most: usize) -> Result<String, Failure> {
    let names = pioneer::VOCABULARY.names();
    let mut large = Box::new(pioneer::brain());
    match recall(&mut *large, names, path) {
        Ok(bytes) => Ok(told(&large, &pioneer::VOCABULARY, bytes, most)),
        Err(refused) => {
            let mut little = Box::new(small::brain());
            match recall(&mut *little, names, path) {
                Ok(bytes) => Ok(told(&little, &small::VOCABULARY, bytes, most)),
                // What kept it from being the usual brain says more.
                Err(_) => Err(refused),
            }
        }
    }
}

fn told<
    const WORDS: usize,
    const ITEMS: usize,
    const W: usize,
    const H: usize,
    const ACTIONS: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored,
>(
    brain: &Agent<WORDS, ITEMS, W, H, ACTIONS, P, S, Y, B, M>,
    words: &Vocabulary,
    bytes: u32,
    most: usize,
) -> String {
    let knowledge = brain.knowledge();
    let level2 = brain.second_level();
    let samples: u64 = brain
        .bank()
        .maps()
        .iter()
        .map(|map| u64::from(map.samples()))
        .sum();
    let mut text = String::new();
    let mut line = |it: String| {
        let _ = writeln!(text, "{it}");
    };
    line(format!(
        "{bytes} bytes; {:?}; {samples} samples; {} alarms",
        brain.stage(),
        brain.alarms()
    ));
    line(format!(
        "patterns {}/{P}, schemas {}/{S}, synthetic items {}/{Y}, beliefs {}/{B}",
        knowledge.patterns(),
        knowledge.schemas().len(),
        level2.items(),
        level2.beliefs().len(),
    ));
    line(format!(
        "losses: {:?}; {:?}",
        knowledge.losses(),
        level2.losses()
    ));

    line("\nitem             inherent   deferred   habit of each action".to_owned());
    for item in 0..ITEMS as u16 {
        let item = ItemId(item);
        let mut alone = ItemSet::EMPTY;
        let _ = alone.insert(item);
        let always = brain.habits().worth(&ItemSet::EMPTY, None);
        let worth = brain.habits().worth(&alone, None);
        let habits = worth
            .iter()
            .zip(always)
            .map(|(worth, always)| worth - always);
        let habits: Vec<String> = habits.map(|it| format!("{it:7.2}")).collect();
        let (inherent, deferred) = (
            knowledge.inherent_value(item),
            knowledge.deferred_value(item),
        );
        let name = words.item_name(item);
        line(format!(
            "{name:14} {inherent:10.2} {deferred:10.2}   {}",
            habits.join(" ")
        ));
    }

    let value = |schema: usize| {
        let result = knowledge.schemas().get(schema).map(|it| it.result);
        result
            .and_then(|id| knowledge.value(id))
            .unwrap_or_default()
    };
    let reliability = |schema: usize| {
        let schema = knowledge.schemas().get(schema);
        schema.map_or(0.0, |it| it.reliability.value(Estimate::Recent))
    };
    let mut order: Vec<usize> = (0..knowledge.schemas().len()).collect();
    order.sort_by(|&a, &b| {
        let worth = |it: usize| value(it) * reliability(it);
        worth(b)
            .total_cmp(&worth(a))
            .then(reliability(b).total_cmp(&reliability(a)))
    });
    line("\n   value reliability  trials   schema".to_owned());
    for &index in order.iter().take(most) {
        let id = SchemaId(index as u16);
        let (Some(schema), Some(said)) = (knowledge.schemas().get(index), knowledge.text(id))
        else {
            continue;
        };
        let trials = schema.reliability.activations();
        let said = said.display(words, Detail::Abbreviated);
        line(format!(
            "{:8.2} {:11.3} {trials:7}   {said}",
            value(index),
            reliability(index)
        ));
    }

    let mut beliefs: Vec<_> = level2.beliefs().to_vec();
    beliefs.sort_by(|a, b| b.on.total_cmp(&a.on));
    let named = |item: SyntheticId| {
        let said = level2
            .schema(item)
            .and_then(|schema| knowledge.text(schema));
        said.map_or("?".to_owned(), |it| {
            it.display(words, Detail::Abbreviated).to_string()
        })
    };
    if !beliefs.is_empty() {
        line("\n      on   tried   after → next".to_owned());
    }
    for belief in beliefs.iter().take(most) {
        let action = level2.schema(belief.item);
        let action = action.and_then(|it| knowledge.schemas().get(usize::from(it.0)));
        let tried = level2.tried(belief.trace, action.map_or(ActionId(0), |it| it.action));
        let (trace, item) = (named(belief.trace), named(belief.item));
        line(format!("{:8.1} {tried:7.1}   {trace} → {item}", belief.on));
    }
    text.trim_end().to_owned()
}
