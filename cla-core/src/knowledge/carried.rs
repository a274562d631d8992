//! Schemas and values as knowledge alone: for tables and item sets of another size.

use super::schema::{NONE, Schema};
use super::tables::{KnowledgeBase, Pattern};
use crate::snapshot::{LARGEST, LARGEST_VALUE, Reader, Stored, Writer};
use crate::word::SignedItems;

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Writes what is known, of so many items: what they are worth by the way, conjunctions with their
    /// values, and schemas.
    pub(crate) fn carry(&self, items: usize, to: &mut Writer<'_>) {
        to.require((0.0..1.0).contains(&self.discount));
        self.discount.store(to);
        to.limits.up_to(LARGEST_VALUE);
        for deferred in self.deferred.as_flattened().iter().take(items) {
            deferred.store(to);
        }
        to.limits.up_to(LARGEST);
        self.patterns().store(to);
        to.limits.patterns = self.patterns();
        for pattern in &self.patterns {
            pattern.items.store(to);
            pattern.value.store(to);
        }
        to.limits.within(LARGEST);
        self.schemas.store(to);
    }

    /// Reads that from a brain of so many words and items, over what is there if there is anybody.
    ///
    /// Of one action there may be at most as many schemas as its map has `nodes` for them.
    pub(crate) fn take<const ACTIONS: usize>(
        mut into: Option<&mut Self>,
        (words, items): (usize, usize),
        nodes: usize,
        from: &mut Reader<'_>,
    ) {
        if let Some(it) = &mut into {
            it.forget_schemas();
        }
        let discount = number(from);
        from.require((0.0..1.0).contains(&discount));
        if let Some(it) = &mut into {
            it.discount = discount;
        }
        from.limits.up_to(LARGEST_VALUE);
        for item in 0..items {
            let value = number(from);
            let place = into.as_mut();
            let place = place.and_then(|it| it.deferred.as_flattened_mut().get_mut(item));
            if let Some(place) = place {
                *place = value;
            }
        }
        from.limits.up_to(LARGEST);
        let patterns = from.count("patterns", PATTERNS);
        from.limits.patterns = patterns as u16;
        for _ in 0..patterns {
            let items = SignedItems::take(words, from);
            let value = number(from);
            if from.is_wrong() {
                return;
            }
            if let Some(it) = &mut into {
                let full = it.patterns.push(Pattern {
                    items,
                    value,
                    then: 0.0,
                    first: NONE,
                    holds: false,
                });
                from.require(full.is_ok());
            }
        }
        from.limits.within(LARGEST);
        let schemas = from.count("schemas", SCHEMAS);
        from.limits.schemas = schemas as u16;
        let mut of_actions = [0_u32; ACTIONS];
        for _ in 0..schemas {
            let mut schema = Schema::BLANK;
            schema.restore(from);
            if from.is_wrong() {
                return;
            }
            if let Some(many) = of_actions.get_mut(usize::from(schema.action.0)) {
                *many += 1;
            }
            // Nothing is doubted yet in the other life.
            schema.doubt = super::schema::Doubt::default();
            if let Some(it) = &mut into {
                from.require(it.schemas.push(schema).is_ok());
            }
        }
        for many in of_actions {
            from.fit("schemas of an action", many, nodes);
        }
    }
}

fn number(from: &mut Reader<'_>) -> f32 {
    let mut number = 0.0;
    number.restore(from);
    number
}
