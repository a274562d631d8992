//! What a knowledge base says about the book's schemas, 6.1 and its neighbours.
//!
//! The book abbreviates: of items that exclude each other only the positive one is written (6.2.6).
//! So a printed schema stands for every stored one with the same positive items.

use cla_core::knowledge::{KnowledgeBase, SchemaId};
use cla_core::word::{SchemaText, SignedItems};
use serde::{Deserialize, Serialize};

/// The record of all stored schemas that the book would print the same way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Stored schemas that read so.
    pub schemas: u32,
    /// Times that one of their contexts held when the action was done.
    pub activations: u32,
    /// Times that the result came.
    pub successes: u32,
}

impl Record {
    /// Successes / activations; `None` without a schema or a trial.
    #[must_use]
    pub fn reliability(&self) -> Option<f64> {
        (self.schemas > 0 && self.activations > 0)
            .then(|| f64::from(self.successes) / f64::from(self.activations))
    }
}

/// Adds up the schemas whose positive items are those of `text`.
///
/// Alternatives of one context share their trials, so each context counts once.
#[must_use]
pub fn record_of<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
    knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    text: &SchemaText<WORDS>,
) -> Record {
    let mut record = Record::default();
    let mut contexts: Vec<(SignedItems<WORDS>, u32)> = Vec::new();
    for (index, schema) in knowledge.schemas().iter().enumerate() {
        let Some(stored) = knowledge.text(SchemaId(index as u16)) else {
            continue;
        };
        if stored.action != text.action || stored.context.positive() != text.context.positive() {
            continue;
        }
        let trials = schema.reliability.activations();
        match contexts
            .iter_mut()
            .find(|(context, _)| *context == stored.context)
        {
            Some((_, most)) => *most = trials.max(*most),
            None => contexts.push((stored.context, trials)),
        }
        if stored.result.positive() == text.result.positive() {
            record.schemas += 1;
            record.successes += schema.reliability.successes();
        }
    }
    record.activations = contexts.iter().map(|(_, trials)| trials).sum();
    record
}

/// Whether some schema promises the item: the result has it on, the context has not.
#[must_use]
pub fn promises<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
    knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    item: cla_core::word::ItemId,
) -> bool {
    (0..knowledge.schemas().len())
        .filter_map(|index| knowledge.text(SchemaId(index as u16)))
        .any(|text| {
            text.result.positive().contains(item) && !text.context.positive().contains(item)
        })
}

#[cfg(test)]
mod tests {
    use super::{promises, record_of};
    use cla_core::knowledge::KnowledgeBase;
    use cla_core::word::{ItemId, SchemaText, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["s1", "s2", "ingrip"],
        actions: &["turnl", "forward"],
    };

    fn text(schema: &str) -> SchemaText<1> {
        SchemaText::parse(schema, &WORDS).unwrap()
    }

    #[test]
    fn schemas_that_differ_in_negative_items_count_as_one_printed_schema() {
        let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
        for (schema, successes, trials) in [
            ("+s1-s2/turnl/+s2", 3, 10),
            ("+s1-s2/turnl/+s2-s1", 2, 10),
            ("+s1/turnl/+s2", 1, 5),
            ("+s1-s2/turnl/+s1", 5, 10),
            ("+s2/turnl/+s1", 9, 9),
        ] {
            knowledge.insert(&text(schema), successes, trials).unwrap();
        }
        let record = record_of(&knowledge, &text("+s1/turnl/+s2"));
        assert_eq!(
            (record.schemas, record.successes, record.activations),
            (3, 6, 15)
        );
        assert_eq!(record.reliability(), Some(0.4));
        assert_eq!(
            record_of(&knowledge, &text("/forward/+s1")).reliability(),
            None
        );
        assert!(!promises(&knowledge, ItemId(2)) && promises(&knowledge, ItemId(1)));
    }
}
