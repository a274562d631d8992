//! Chains: every conjunction knows the first schema of which it is the context, and every schema how far
//! it is to the next one, in ascending order.
//!
//! What is asked of one context walks its chain and no table; a schema that comes or goes mends one
//! chain.
//! A link that was damaged leads onwards, too, so that every walk ends.

use super::schema::{NONE, PatternId, Schema};
use super::tables::KnowledgeBase;
use crate::word::ActionId;

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Chains the schemas of each context; due whenever schemas were added, moved or dropped.
    pub(crate) fn link(&mut self) {
        for pattern in &mut self.patterns {
            pattern.first = NONE;
        }
        for (index, schema) in self.schemas.iter_mut().enumerate().rev() {
            if let Some(context) = self.patterns.get_mut(usize::from(schema.context.0)) {
                schema.skip = distance(index, context.first);
                context.first = index as u16;
            }
        }
    }

    /// The schemas of a context in the order of the table, by its chain.
    pub(crate) fn of_context(&self, context: PatternId) -> impl Iterator<Item = (usize, &Schema)> {
        let first = self.patterns.get(usize::from(context.0));
        let mut next = usize::from(first.map_or(NONE, |it| it.first));
        core::iter::from_fn(move || {
            let index = next;
            let schema = self.schemas.get(index)?;
            next = index + 1 + usize::from(schema.skip);
            Some((index, schema))
        })
        // A link that was damaged may lead into another chain.
        .filter(move |(_, schema)| schema.context == context)
    }

    /// As [`of_context`](Self::of_context), of one action only.
    pub(crate) fn of_group(
        &self,
        context: PatternId,
        action: ActionId,
    ) -> impl Iterator<Item = (usize, &Schema)> {
        self.of_context(context)
            .filter(move |(_, schema)| schema.action == action)
    }

    /// Changes the schemas of a context and action.
    pub(crate) fn change_group(
        &mut self,
        context: PatternId,
        action: ActionId,
        mut change: impl FnMut(&mut Schema),
    ) {
        let first = self.patterns.get(usize::from(context.0));
        let mut next = usize::from(first.map_or(NONE, |it| it.first));
        while let Some(schema) = self.schemas.get_mut(next) {
            next += 1 + usize::from(schema.skip);
            if schema.context == context && schema.action == action {
                change(schema);
            }
        }
    }

    /// Takes a schema into the chain of its context.
    pub(super) fn enchain(&mut self, index: u16) {
        let Some(context) = self.schemas.get(usize::from(index)).map(|it| it.context) else {
            return;
        };
        let place = usize::from(index);
        let before = self.of_context(context).map(|(index, _)| index);
        let before = before.take_while(|&other| other < place).last();
        let next = match before {
            Some(before) => self.after(before),
            None => {
                let first = self.patterns.get(usize::from(context.0));
                first.map_or(NONE, |it| it.first)
            }
        };
        if let Some(schema) = self.schemas.get_mut(place) {
            schema.skip = distance(place, next);
        }
        self.set_after(before, context, index);
    }

    /// Takes a schema out of the chain of its context.
    pub(super) fn unchain(&mut self, index: u16) {
        let place = usize::from(index);
        let Some(context) = self.schemas.get(place).map(|it| it.context) else {
            return;
        };
        let before = self.of_context(context).map(|(index, _)| index);
        let before = before.take_while(|&other| other < place).last();
        let next = self.after(place);
        self.set_after(before, context, next);
    }

    /// The schema that follows in a chain, or [`NONE`].
    fn after(&self, index: usize) -> u16 {
        let skip = self.schemas.get(index).map_or(NONE, |it| it.skip);
        let next = index + 1 + usize::from(skip);
        if next < self.schemas.len() {
            next as u16
        } else {
            NONE
        }
    }

    /// Lets a schema, or nothing, follow another of a context, or be the first.
    fn set_after(&mut self, before: Option<usize>, context: PatternId, next: u16) {
        match before {
            Some(before) => {
                if let Some(schema) = self.schemas.get_mut(before) {
                    schema.skip = distance(before, next);
                }
            }
            None => {
                if let Some(pattern) = self.patterns.get_mut(usize::from(context.0)) {
                    pattern.first = next;
                }
            }
        }
    }
}

/// How many schemas lie between one and the next of its chain, or [`NONE`].
fn distance(index: usize, next: u16) -> u16 {
    match next {
        NONE => NONE,
        next => next.saturating_sub(index as u16 + 1),
    }
}

#[cfg(test)]
mod tests {
    use super::{KnowledgeBase, Schema};
    use crate::knowledge::tables::WhenFull;
    use crate::num::Rng;
    use crate::word::{ActionId, ItemId, SchemaText, SignedItems};
    use std::vec::Vec;

    fn some(rng: &mut Rng) -> SignedItems<1> {
        let mut some = SignedItems::EMPTY;
        some.insert(ItemId(rng.below(5) as u16), rng.chance(0.5))
            .unwrap();
        some
    }

    /// First schemas of all contexts, and what every schema says of the next one.
    fn links(knowledge: &KnowledgeBase<1, 16, 24>) -> (Vec<u16>, Vec<u16>) {
        let first = knowledge.patterns.iter().map(|it| it.first).collect();
        let skip = |it: &Schema| it.skip;
        (first, knowledge.schemas.iter().map(skip).collect())
    }

    #[test]
    fn a_schema_that_comes_or_goes_leaves_the_chains_that_are_made_of_the_whole_table() {
        let mut rng = Rng::new(3);
        let (mut pushed, mut evicted) = (0, 0);
        for _ in 0..30 {
            let mut knowledge = KnowledgeBase::<1, 16, 24>::new();
            for _ in 0..80 {
                let before = (knowledge.schemas.len(), knowledge.losses.evicted_schemas);
                let wins = 1 + rng.below(40) as u16;
                let (context, result) = (some(&mut rng), some(&mut rng));
                let action = ActionId(rng.below(3) as u16);
                let _ = knowledge.support(&context, action, &result, wins, WhenFull::Evict);
                knowledge.least_standing = 0;
                pushed += knowledge.schemas.len() - before.0;
                evicted += knowledge.losses.evicted_schemas - before.1;
                let kept = links(&knowledge);
                knowledge.link();
                assert_eq!(kept, links(&knowledge));
            }
        }
        assert!(pushed > 500 && evicted > 50, "{pushed} {evicted}");
    }

    #[test]
    fn a_group_is_what_a_walk_over_the_table_finds() {
        let mut rng = Rng::new(4);
        let mut knowledge = KnowledgeBase::<1, 16, 64>::new();
        for _ in 0..60 {
            let text = SchemaText {
                context: some(&mut rng),
                action: ActionId(rng.below(3) as u16),
                result: some(&mut rng),
            };
            let _ = knowledge.insert(&text, 1, 2);
        }
        for schema in knowledge.schemas.clone() {
            let (context, action) = (schema.context, schema.action);
            let alike = |it: &Schema| it.context == context && it.action == action;
            let all = knowledge.schemas.iter().enumerate();
            let walked: Vec<_> = all.filter(|(_, it)| alike(it)).map(|it| it.0).collect();
            let found: Vec<_> = knowledge.of_group(context, action).map(|it| it.0).collect();
            assert_eq!(found, walked);
            let mut changed = 0;
            knowledge.change_group(context, action, |_| changed += 1);
            assert_eq!(changed, walked.len());
        }
    }
}
