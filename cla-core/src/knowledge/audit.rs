//! The tables looked through for what cannot be so: a memory that lost a bit, a hand that wrote nonsense.

use super::schema::{PatternId, Schema};
use super::tables::KnowledgeBase;
use crate::snapshot::{LARGEST, LARGEST_VALUE};
use crate::word::{ActionId, ItemId};

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Drops schemas that cannot be so, forgets values that are none, and makes all links anew; answers
    /// how many entries were dropped or forgotten, or `None` when what is worth having is lost.
    ///
    /// `actions` is how many the robot has.
    /// Goes once through each table.
    pub(crate) fn audit(&mut self, actions: u16) -> Option<u32> {
        let patterns = self.patterns.len();
        let before = self.schemas.len();
        let Self {
            patterns: table,
            schemas,
            ..
        } = self;
        let is_sound = |id: PatternId| {
            let pattern = table.get(usize::from(id.0));
            pattern.is_some_and(|it| it.items.positive().is_disjoint(it.items.negative()))
        };
        schemas.retain(|schema| {
            schema.action < ActionId(actions)
                && is_sound(schema.context)
                && is_sound(schema.result)
                && schema.is_sound()
        });
        let mut mended = (before - self.schemas.len()) as u32;
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
        self.drop_unused_patterns();
        mended += (patterns - self.patterns.len()) as u32;
        self.rebuild();
        let worth = |(item, &value): (u16, &f32)| {
            let valued = self.valued.contains(ItemId(item));
            (0.0..=LARGEST_VALUE).contains(&value) && (valued == (value > 0.0))
        };
        let values = (0_u16..).zip(self.inherent.as_flattened());
        values
            .map(worth)
            .fold(true, |all, it| all & it)
            .then_some(mended)
    }
}

impl Schema {
    /// Whether its numbers can be so.
    fn is_sound(&self) -> bool {
        self.reliability.is_sound() && (0.0..=LARGEST).contains(&self.doubt.bonus)
    }
}
