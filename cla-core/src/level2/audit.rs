//! The second level looked through for what cannot be so.

use super::belief::{BeliefTable, Row};
use super::second_level::{MOST_SHARE, SecondLevel};
use crate::knowledge::{KnowledgeBase, SyntheticId};
use crate::snapshot::{LARGEST, LARGEST_COUNT, Stored};
use crate::word::ActionId;

/// Whether a number is at least 0 and at most another.
fn within(number: f32, most: f32) -> bool {
    (0.0..=most).contains(&number)
}

impl<const ACTIONS: usize> Row<ACTIONS> {
    fn is_sound(&self) -> bool {
        self.action < ActionId(ACTIONS as u16)
            && within(self.value, LARGEST)
            && self.experienced.abs() <= LARGEST
            && within(self.visits, LARGEST_COUNT)
            && within(self.eligibility, 1.0)
            && self
                .tried
                .iter()
                .fold(true, |all, &it| all & within(it, LARGEST_COUNT))
    }
}

impl<const ACTIONS: usize, const ITEMS: usize, const BELIEFS: usize>
    BeliefTable<ACTIONS, ITEMS, BELIEFS>
{
    /// Frees rows and drops beliefs that cannot be so; answers how many.
    fn audit<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    ) -> u32 {
        let mut mended = 0;
        for index in 0..self.rows.len() {
            let id = SyntheticId(index as u16);
            let Some(row) = self.rows.get_mut(index) else {
                break;
            };
            let schemas = knowledge.schemas.len();
            let points = row.schema.is_none_or(|it| usize::from(it.0) < schemas);
            let sound = row.is_sound();
            if !sound {
                *row = Row {
                    used: row.used,
                    ..Row::BLANK
                };
            }
            if !(sound && points) {
                self.free(id);
                mended += 1;
            }
        }
        let (rows, before) = (self.rows.len(), self.beliefs.len());
        let mut last = None;
        self.beliefs.retain(|it| {
            let key = (it.trace, it.item);
            let sound = usize::from(it.trace.0) < rows
                && usize::from(it.item.0) < rows
                && within(it.on, LARGEST_COUNT)
                && last.is_none_or(|last| last < key);
            if sound {
                last = Some(key);
            }
            sound
        });
        mended + (before - self.beliefs.len()) as u32
    }
}

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize>
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    /// Frees rows and drops beliefs that cannot be so, and lets schemas lose items that are none;
    /// answers how many. Schemas may have `moved` in their table.
    pub(crate) fn audit<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        moved: bool,
    ) -> u32 {
        if moved {
            self.follow(knowledge);
        }
        let mut mended = self.table.audit(knowledge);
        let rows = self.table.rows.len();
        for schema in &mut knowledge.schemas {
            let item = schema.synthetic().map(|item| self.table.row(item));
            let free = item.is_some_and(|row| row.is_none_or(|row| row.schema.is_none()));
            if rows > 0 && free {
                schema.set_synthetic(None);
                mended += 1;
            }
        }
        for share in [
            &mut self.slow,
            &mut self.fast,
            &mut self.rates.discount,
            &mut self.rates.experience,
        ] {
            if !within(*share, MOST_SHARE) {
                *share = 0.0;
                mended += 1;
            }
        }
        self.rebuild();
        mended
    }
}
