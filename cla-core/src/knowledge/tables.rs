//! The knowledge base: every schema, in tables of fixed size (book, 5.3.1, 6.2.4).
//!
//! Filled by harvest, corrected by experience, read by the choice of actions.
//! It is all that a robot needs to act; maps are needed only to learn new schemas.

use super::reliability::{Estimate, Reliability};
use super::schema::{NONE, PatternId, Schema, SchemaId};
use crate::snapshot::{LARGEST, LARGEST_VALUE, stored};
use crate::word::{ActionId, Cost, ItemSet, ItemStates, SchemaText, SignedItems};

/// A conjunction that stands in schemas, with what being there is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pattern<const WORDS: usize> {
    pub(crate) items: SignedItems<WORDS>,
    /// Expected discounted value of acting well from here (see `value`).
    pub(crate) value: f32,
    /// That value times the discount: kept, because it is read more often than it changes.
    pub(crate) then: f32,
    /// The first schema of which it is the context (see `applicable`).
    pub(crate) first: u16,
    /// Whether it held in the state that was looked at last.
    pub(crate) holds: bool,
}

/// What did not fit, counted since the tables were made.
///
/// ```
/// use cla_core::knowledge::KnowledgeBase;
/// assert_eq!(KnowledgeBase::<1, 8, 8>::new().losses().refused_schemas, 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Losses {
    /// Schemas with the fewest successes that made room for better supported ones.
    pub evicted_schemas: u32,
    /// New schemas that found the table full of better supported ones.
    pub refused_schemas: u32,
    /// New schemas whose context or result found no room in the pattern table.
    pub refused_patterns: u32,
}

/// Schemas and the conjunctions they are made of, in fixed memory.
///
/// In the field: the learned model of a model-based learner, as a set of rules.
///
/// `PATTERNS` bounds the distinct contexts and results, `SCHEMAS` the schemas; both at most 65,534.
///
/// ```
/// use cla_core::knowledge::KnowledgeBase;
/// use cla_core::word::{ActionId, SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["s3", "ingrip"], actions: &["forward"] };
/// let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
/// let schema = SchemaText::parse("+s3/forward/+ingrip", &words)?;
/// knowledge.insert(&schema, 3, 10).unwrap();
/// assert_eq!(knowledge.schemas().len(), 1);
/// assert_eq!(knowledge.schemas()[0].reliability.activations(), 10);
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KnowledgeBase<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize> {
    pub(crate) patterns: heapless::Vec<Pattern<WORDS>, PATTERNS, u16>,
    pub(crate) schemas: heapless::Vec<Schema, SCHEMAS, u16>,
    pub(crate) inherent: [[f32; 32]; WORDS],
    /// The items whose inherent value is not 0.
    pub(crate) valued: ItemSet<WORDS>,
    pub(crate) deferred: [[f32; 32]; WORDS],
    /// The discount by which the patterns' `then` was computed.
    pub(crate) discount: f32,
    /// The pattern whose value is computed next.
    pub(crate) next_value: u16,
    pub(super) losses: Losses,
    /// While schemas are read in: no schema of a full table stands below this.
    pub(super) least_standing: u32,
    /// Schemas, and beliefs about them, gone through in this step.
    pub(crate) cost: Cost,
}

/// What a new schema finds when the table is full.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum WhenFull {
    /// No room: the caller will come again.
    Refuse,
    /// The least successful schema leaves, if it is less successful than the newcomer.
    Evict,
}

/// A schema was not stored: the table is full of better supported ones (counted in [`Losses`]).
///
/// ```
/// assert_eq!(cla_core::knowledge::TableFull.to_string(), "the schema tables are full");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TableFull;

impl core::fmt::Display for TableFull {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the schema tables are full")
    }
}

impl core::error::Error for TableFull {}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// A knowledge base that knows nothing.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                PATTERNS > 0 && PATTERNS < u16::MAX as usize,
                "1 to 65,534 patterns"
            );
            assert!(
                SCHEMAS > 0 && SCHEMAS < u16::MAX as usize,
                "1 to 65,534 schemas"
            );
        }
        Self {
            patterns: heapless::Vec::new(),
            schemas: heapless::Vec::new(),
            inherent: [[0.0; 32]; WORDS],
            valued: ItemSet::EMPTY,
            deferred: [[0.0; 32]; WORDS],
            discount: 0.0,
            next_value: 0,
            losses: Losses {
                evicted_schemas: 0,
                refused_schemas: 0,
                refused_patterns: 0,
            },
            least_standing: 0,
            cost: Cost::NONE,
        }
    }

    /// The schemas; a [`SchemaId`] is an index here.
    #[must_use]
    pub fn schemas(&self) -> &[Schema] {
        &self.schemas
    }

    /// The number of distinct contexts and results.
    #[must_use]
    pub fn patterns(&self) -> u16 {
        self.patterns.len() as u16
    }

    /// What did not fit so far.
    #[must_use]
    pub const fn losses(&self) -> Losses {
        self.losses
    }

    /// A schema spelled out; `None` for an id that is not in the table.
    #[must_use]
    pub fn text(&self, schema: SchemaId) -> Option<SchemaText<WORDS>> {
        let schema = self.schemas.get(usize::from(schema.0))?;
        Some(SchemaText {
            context: self.pattern(schema.context)?,
            action: schema.action,
            result: self.pattern(schema.result)?,
        })
    }

    /// A conjunction; `None` for an id that is not in the table.
    #[must_use]
    pub fn pattern(&self, id: PatternId) -> Option<SignedItems<WORDS>> {
        self.patterns
            .get(usize::from(id.0))
            .map(|pattern| pattern.items)
    }

    /// What being where a conjunction holds is worth: the expected discounted value of acting well
    /// from there, without what it is worth itself; `None` for an id that is not in the table.
    #[must_use]
    pub fn value(&self, id: PatternId) -> Option<f32> {
        self.patterns
            .get(usize::from(id.0))
            .map(|pattern| pattern.value)
    }

    /// Forgets everything but inherent values.
    pub(crate) fn clear(&mut self) {
        self.forget_schemas();
        self.discount = 0.0;
        self.losses = Losses::default();
    }

    /// Forgets all schemas and deferred values; inherent values and counted losses stay.
    pub(crate) fn forget_schemas(&mut self) {
        self.schemas.clear();
        self.patterns.clear();
        self.deferred = [[0.0; 32]; WORDS];
        self.next_value = 0;
        self.link();
    }

    /// Stores a schema with a record of trials, or adds support to the one that says the same.
    ///
    /// A full table makes room by evicting the schema with the fewest successes, if it has fewer
    /// than the newcomer.
    ///
    /// # Errors
    /// [`TableFull`] when there is no room; nothing but the count of losses has changed.
    pub fn insert(
        &mut self,
        text: &SchemaText<WORDS>,
        successes: u32,
        activations: u32,
    ) -> Result<SchemaId, TableFull> {
        let support = u16::try_from(successes).unwrap_or(u16::MAX).max(1);
        let found = self.support(
            &text.context,
            text.action,
            &text.result,
            support,
            WhenFull::Evict,
        );
        self.least_standing = 0;
        // A refusal or an eviction may leave conjunctions that no schema uses.
        self.drop_unused_patterns();
        self.link();
        let id = found?;
        if let Some(schema) = self.schemas.get_mut(usize::from(id.0)) {
            schema.reliability = Reliability::from_counts(successes, activations);
        }
        Ok(id)
    }

    /// Counts that all conjunctions are held against a state.
    pub(crate) fn count_look(&mut self) {
        let patterns = self.patterns.len() as u32;
        self.cost.patterns = self.cost.patterns.wrapping_add(patterns);
    }

    /// Counts schemas that are gone through.
    pub(crate) fn count_schemas(&mut self, schemas: usize) {
        self.cost.schemas = self.cost.schemas.wrapping_add(schemas as u32);
    }

    /// Notes for every conjunction whether it holds in `state`, and counts that all schemas are then
    /// gone through.
    pub(crate) fn look_at(&mut self, state: &ItemStates<WORDS>) {
        self.count_look();
        self.count_schemas(self.schemas.len());
        for pattern in &mut self.patterns {
            pattern.holds = pattern.items.holds_in(state);
        }
    }

    /// The mean reliability of the schemas that have been tried; 0 when none has.
    #[must_use]
    pub fn mean_reliability(&self, estimate: Estimate) -> f32 {
        let mut total = 0.0;
        let mut count = 0_u32;
        for schema in self
            .schemas
            .iter()
            .filter(|schema| schema.reliability.activations() > 0)
        {
            total += schema.reliability.value(estimate);
            count += 1;
        }
        if count == 0 {
            0.0
        } else {
            total / count as f32
        }
    }

    /// Adds support to a schema, or stores it; chains are up to date before and after.
    pub(super) fn support(
        &mut self,
        context: &SignedItems<WORDS>,
        action: ActionId,
        result: &SignedItems<WORDS>,
        wins: u16,
        when_full: WhenFull,
    ) -> Result<SchemaId, TableFull> {
        let context = self.intern(context)?;
        let result = self.intern(result)?;
        let found = self
            .of_group(context, action)
            .find(|(_, schema)| schema.result == result)
            .map(|(index, _)| index);
        if let Some(index) = found
            && let Some(schema) = self.schemas.get_mut(index)
        {
            schema.support = schema.support.saturating_add(wins);
            return Ok(SchemaId(index as u16));
        }
        let new = Schema::new(context, action, result, wins);
        match self.schemas.push(new) {
            Ok(()) => {
                let index = self.schemas.len() as u16 - 1;
                self.enchain(index);
                Ok(SchemaId(index))
            }
            Err(new) if when_full == WhenFull::Evict => self.evict_for(new),
            Err(_) => Err(TableFull),
        }
    }

    fn evict_for(&mut self, new: Schema) -> Result<SchemaId, TableFull> {
        let standing = |schema: &Schema| {
            schema
                .reliability
                .successes()
                .max(u32::from(schema.support))
        };
        let mut least = (standing(&new), None);
        // Nothing in the table stands below what it was found to: who is not above is not looked for.
        if least.0 > self.least_standing {
            let mut lowest = u32::MAX;
            for (index, schema) in self.schemas.iter().enumerate() {
                let standing = standing(schema);
                if standing < least.0 {
                    least = (standing, Some(index));
                }
                lowest = lowest.min(standing);
            }
            self.least_standing = lowest;
        }
        if let (_, Some(index)) = least {
            self.unchain(index as u16);
            if let Some(schema) = self.schemas.get_mut(index) {
                *schema = new;
            }
            self.enchain(index as u16);
            self.losses.evicted_schemas = self.losses.evicted_schemas.saturating_add(1);
            return Ok(SchemaId(index as u16));
        }
        self.losses.refused_schemas = self.losses.refused_schemas.saturating_add(1);
        Err(TableFull)
    }

    fn intern(&mut self, items: &SignedItems<WORDS>) -> Result<PatternId, TableFull> {
        if let Some(index) = self
            .patterns
            .iter()
            .position(|pattern| pattern.items == *items)
        {
            return Ok(PatternId(index as u16));
        }
        let new = Pattern {
            items: *items,
            value: 0.0,
            then: 0.0,
            first: NONE,
            holds: false,
        };
        match self.patterns.push(new) {
            Ok(()) => Ok(PatternId(self.patterns.len() as u16 - 1)),
            Err(_) => {
                self.losses.refused_patterns = self.losses.refused_patterns.saturating_add(1);
                Err(TableFull)
            }
        }
    }

    /// Drops the conjunctions that stand in no schema; what was last takes a free place.
    ///
    /// Chains are to be made anew: here their beginnings say where conjunctions have moved to.
    pub(super) fn drop_unused_patterns(&mut self) {
        for pattern in &mut self.patterns {
            pattern.holds = false;
        }
        for schema in &self.schemas {
            for id in [schema.context, schema.result] {
                if let Some(pattern) = self.patterns.get_mut(usize::from(id.0)) {
                    pattern.holds = true;
                }
            }
        }
        let mut length = self.patterns.len();
        for index in (0..self.patterns.len()).rev() {
            if self.patterns.get(index).is_none_or(|it| it.holds) {
                continue;
            }
            length -= 1;
            if let Some(last) = self.patterns.get(length).copied()
                && let Some(place) = self.patterns.get_mut(index)
            {
                *place = last;
            }
            if let Some(left) = self.patterns.get_mut(length) {
                left.first = index as u16;
            }
        }
        // What has moved to a place that was left later has moved on; that place is an earlier one.
        for left in length..self.patterns.len() {
            let moved = self.patterns.get(left).map_or(NONE, |it| it.first);
            if usize::from(moved) >= length
                && let Some(on) = self.patterns.get(usize::from(moved)).map(|it| it.first)
                && let Some(left) = self.patterns.get_mut(left)
            {
                left.first = on;
            }
        }
        for schema in &mut self.schemas {
            for reference in [&mut schema.context, &mut schema.result] {
                let index = usize::from(reference.0);
                if index >= length
                    && let Some(left) = self.patterns.get(index)
                {
                    reference.0 = left.first;
                }
            }
        }
        self.patterns.truncate(length);
        for pattern in &mut self.patterns {
            pattern.holds = false;
        }
    }

    /// Gives schemas without trials the wins of their nodes among those of their context and action;
    /// chains are up to date.
    pub(super) fn start_new_records(&mut self) {
        for index in 0..self.schemas.len() {
            let Some(new) = self.schemas.get(index).copied() else {
                continue;
            };
            if new.reliability.activations() > 0 {
                continue;
            }
            let mut total = 0_u32;
            for (_, other) in self.of_group(new.context, new.action) {
                total = total.saturating_add(u32::from(other.support));
            }
            if let Some(schema) = self.schemas.get_mut(index) {
                schema.reliability = Reliability::from_counts(u32::from(new.support), total);
            }
        }
    }
}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize> Default
    for KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    fn default() -> Self {
        Self::new()
    }
}

// What a value is worth a step before, which schema is the first of a context and whether it holds
// are found again.
stored! {
    impl[const WORDS: usize] Pattern<WORDS> {
        items, value => up_to LARGEST;
        then: 0.0, first: NONE, holds: false
    }
    counted patterns
}

stored! { impl[] Losses { evicted_schemas, refused_schemas, refused_patterns } }

stored! {
    impl[const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize]
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS> {
        patterns, schemas, inherent => up_to LARGEST_VALUE, valued,
        deferred => up_to LARGEST_VALUE, discount if |it: &f32| (0.0..1.0).contains(it),
        next_value, losses, cost;
        least_standing: 0
    }
}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Makes what an image does not keep.
    pub(crate) fn rebuild(&mut self) {
        for pattern in &mut self.patterns {
            pattern.then = self.discount * pattern.value;
        }
        self.mark_valued();
        self.link();
    }
}

#[cfg(test)]
#[path = "tables_tests.rs"]
mod tests;
