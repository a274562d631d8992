//! The tables looked through for what cannot be so: a memory that lost a bit, a hand that wrote nonsense.

use super::schema::{PatternId, Schema};
use super::tables::KnowledgeBase;
use crate::snapshot::{LARGEST, LARGEST_VALUE};
use crate::word::{ActionId, ItemId, ItemSet};

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// What is lost of it and cannot be found again: what is worth having, or every schema.
    ///
    /// `actions` is how many the robot has.
    pub(crate) fn lost(&self, actions: u16) -> Option<&'static str> {
        let mut values = self.inherent.as_flattened().iter();
        if !values.all(|value| (0.0..=LARGEST_VALUE).contains(value)) {
            return Some("what is worth having");
        }
        let known =
            self.schemas.is_empty() || self.schemas.iter().any(|it| self.can_be(it, actions));
        (!known).then_some("all that was known")
    }

    /// Whether a schema can be so.
    fn can_be(&self, schema: &Schema, actions: u16) -> bool {
        let is_sound = |id: PatternId| {
            let pattern = self.patterns.get(usize::from(id.0));
            pattern.is_some_and(|it| it.items.positive().is_disjoint(it.items.negative()))
        };
        schema.action < ActionId(actions)
            && is_sound(schema.context)
            && is_sound(schema.result)
            && schema.is_sound()
    }

    /// Drops schemas that cannot be so, forgets values that are none, and makes all links anew; answers
    /// how many entries were dropped or forgotten.
    ///
    /// `actions` is how many the robot has.
    /// Goes once through each table.
    pub(crate) fn audit(&mut self, actions: u16) -> u32 {
        let mut mended = self.drop_unsound(actions);
        for pattern in &mut self.patterns {
            if !(0.0..=LARGEST).contains(&pattern.value) {
                pattern.value = 0.0;
                mended += 1;
            }
        }
        for value in self.deferred.as_flattened_mut() {
            if !(0.0..=LARGEST_VALUE).contains(value) {
                *value = 0.0;
                mended += 1;
            }
        }
        if !(0.0..1.0).contains(&self.discount) {
            self.discount = 0.0;
            mended += 1;
        }
        // Patterns that no schema needs are no fault.
        if mended > 0 {
            self.drop_unused_patterns();
        }
        let valued = self.valued;
        self.rebuild();
        mended + u32::from(self.valued != valued)
    }

    /// Marks the items that are worth something for their own sake.
    pub(super) fn mark_valued(&mut self) {
        self.valued = ItemSet::EMPTY;
        for (item, value) in (0_u16..).zip(self.inherent.as_flattened()) {
            if *value > 0.0 {
                // It has a slot, so it has a bit.
                let _ = self.valued.insert(ItemId(item));
            }
        }
    }

    fn drop_unsound(&mut self, actions: u16) -> u32 {
        let before = self.schemas.len();
        let mut kept = 0;
        for index in 0..before {
            let Some(schema) = self.schemas.get(index).copied() else {
                break;
            };
            if self.can_be(&schema, actions) {
                if let Some(place) = self.schemas.get_mut(kept) {
                    *place = schema;
                }
                kept += 1;
            }
        }
        self.schemas.truncate(kept);
        (before - kept) as u32
    }
}

impl Schema {
    /// Whether its numbers can be so.
    fn is_sound(&self) -> bool {
        self.reliability.is_sound() && (0.0..=LARGEST).contains(&self.doubt.bonus)
    }
}
