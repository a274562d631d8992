//! The knowledge base: every schema, in tables of fixed size (book, 5.3.1, 6.2.4).
//!
//! Filled by harvest, corrected by experience, read by the choice of actions.
//! It is all that a robot needs to act; maps are needed only to learn new schemas.

use super::action::ActionId;
use super::action_som::ActionSom;
use super::harvest::{HarvestConfig, HarvestedNode, harvest_node};
use super::item::ItemStates;
use super::notation::SchemaText;
use super::reliability::{Estimate, Reliability};
use super::sample::ResultCoding;
use super::schema::{PatternId, Schema, SchemaId};
use super::signed_items::SignedItems;
use crate::som::Prototypes;

/// A conjunction that stands in schemas, with what being there is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pattern<const WORDS: usize> {
    pub(super) items: SignedItems<WORDS>,
    /// Expected discounted value of acting well from here (see `value`).
    pub(super) value: f32,
    /// Whether it held in the state that was looked at last.
    pub(super) holds: bool,
}

/// What did not fit, counted since the tables were made.
///
/// ```
/// use cla_core::clasm::KnowledgeBase;
/// assert_eq!(KnowledgeBase::<1, 8, 8>::new().losses().refused_schemas, 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Losses {
    /// Schemas with the fewest successes that made room for better supported ones.
    pub evicted_schemas: u32,
    /// New schemas that found the table full of better supported ones.
    pub refused_schemas: u32,
    /// New schemas whose context or result found no room in the pattern table.
    pub refused_patterns: u32,
}

/// What experience said about the predictions for one completed action.
///
/// ```
/// assert!(!cla_core::clasm::Outcome::default().foreseen());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Schemas that were applicable and whose result could be checked.
    pub activated: u16,
    /// Those whose result came.
    pub succeeded: u16,
}

impl Outcome {
    /// Whether some schema had foreseen the result.
    #[must_use]
    pub const fn foreseen(&self) -> bool {
        self.succeeded > 0
    }
}

/// Schemas and the conjunctions they are made of, in fixed memory.
///
/// `PATTERNS` bounds the distinct contexts and results, `SCHEMAS` the schemas; both at most 65,535.
///
/// ```
/// use cla_core::clasm::{ActionId, KnowledgeBase, Vocabulary, SchemaText};
/// let words = Vocabulary { items: &["s3", "ingrip"], actions: &["forward"] };
/// let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
/// let schema = SchemaText::parse("+s3/forward/+ingrip", &words)?;
/// knowledge.insert(&schema, 3, 10).unwrap();
/// assert_eq!(knowledge.schemas().len(), 1);
/// assert_eq!(knowledge.schemas()[0].reliability.activations(), 10);
/// # Ok::<(), cla_core::clasm::NotationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KnowledgeBase<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize> {
    pub(super) patterns: heapless::Vec<Pattern<WORDS>, PATTERNS, u16>,
    pub(super) schemas: heapless::Vec<Schema, SCHEMAS, u16>,
    pub(super) inherent: [[f32; 32]; WORDS],
    pub(super) deferred: [[f32; 32]; WORDS],
    /// The pattern whose value is computed next.
    pub(super) next_value: u16,
    losses: Losses,
}

/// What a new schema finds when the table is full.
#[derive(Clone, Copy, PartialEq, Eq)]
enum WhenFull {
    /// No room: the caller will come again.
    Refuse,
    /// The least successful schema leaves, if it is less successful than the newcomer.
    Evict,
}

/// A schema was not stored: the table is full of better supported ones (counted in [`Losses`]).
///
/// ```
/// assert_eq!(cla_core::clasm::TableFull.to_string(), "the schema tables are full");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
            deferred: [[0.0; 32]; WORDS],
            next_value: 0,
            losses: Losses {
                evicted_schemas: 0,
                refused_schemas: 0,
                refused_patterns: 0,
            },
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

    /// Forgets all schemas and deferred values; inherent values and counted losses stay.
    pub fn forget_schemas(&mut self) {
        self.schemas.clear();
        self.patterns.clear();
        self.deferred = [[0.0; 32]; WORDS];
        self.next_value = 0;
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
        // A refusal or an eviction may leave conjunctions that no schema uses.
        self.drop_unused_patterns();
        let id = found?;
        if let Some(schema) = self.schemas.get_mut(usize::from(id.0)) {
            schema.reliability = Reliability::from_counts(successes, activations);
        }
        Ok(id)
    }

    /// Replaces the schemas by what the maps say now; those that were known keep their trials.
    ///
    /// Reads every node of every map once.
    /// A new schema starts from the wins of its nodes among those of its context and action.
    /// Schemas that no node says any more leave.
    pub fn harvest<
        const WIDTH: usize,
        const HEIGHT: usize,
        const ITEMS: usize,
        M: Prototypes<WIDTH, HEIGHT>,
    >(
        &mut self,
        maps: &[ActionSom<WIDTH, HEIGHT, ITEMS, M>],
        coding: ResultCoding,
        config: &HarvestConfig,
    ) {
        // What is still said is marked before anything is evicted for something new: only what no
        // node says any more makes room.
        let before = self.losses;
        if !self.support_all(maps, coding, config, WhenFull::Refuse) {
            self.losses = before;
            self.support_all(maps, coding, config, WhenFull::Evict);
        }
        self.start_new_records();
    }

    /// Corrects the reliability of every applicable schema of an action that was completed.
    ///
    /// A schema whose result hangs on an unknown item is not counted.
    pub fn record(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        forgetting: f32,
    ) -> Outcome {
        self.look_at(before);
        let mut outcome = Outcome::default();
        let Self {
            patterns, schemas, ..
        } = self;
        for schema in schemas.iter_mut().filter(|schema| schema.action == action) {
            let held = |id: PatternId| patterns.get(usize::from(id.0));
            if !held(schema.context).is_some_and(|pattern| pattern.holds) {
                continue;
            }
            let truth = held(schema.result).and_then(|pattern| pattern.items.truth(after));
            if let Some(success) = truth {
                schema.reliability.record(success, forgetting);
                outcome.activated = outcome.activated.saturating_add(1);
                outcome.succeeded = outcome.succeeded.saturating_add(u16::from(success));
            }
        }
        outcome
    }

    /// Notes for every conjunction whether it holds in `state`.
    pub(super) fn look_at(&mut self, state: &ItemStates<WORDS>) {
        for pattern in &mut self.patterns {
            pattern.holds = pattern.items.truth(state) == Some(true);
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

    /// Supports the schemas of all nodes and drops what none says; whether everything found room.
    fn support_all<
        const WIDTH: usize,
        const HEIGHT: usize,
        const ITEMS: usize,
        M: Prototypes<WIDTH, HEIGHT>,
    >(
        &mut self,
        maps: &[ActionSom<WIDTH, HEIGHT, ITEMS, M>],
        coding: ResultCoding,
        config: &HarvestConfig,
        when_full: WhenFull,
    ) -> bool {
        for schema in &mut self.schemas {
            schema.support = 0;
        }
        let mut complete = true;
        for (action, map) in maps.iter().enumerate() {
            let action = ActionId(action as u16);
            for node in map.nodes() {
                let Some(node) = harvest_node(map, node, coding, config) else {
                    continue;
                };
                let HarvestedNode {
                    context,
                    result,
                    wins,
                } = node;
                let found = self.support(&context, action, &result, wins.max(1), when_full);
                complete &= found.is_ok();
            }
        }
        self.schemas.retain(|schema| schema.support > 0);
        self.drop_unused_patterns();
        complete
    }

    fn support(
        &mut self,
        context: &SignedItems<WORDS>,
        action: ActionId,
        result: &SignedItems<WORDS>,
        wins: u16,
        when_full: WhenFull,
    ) -> Result<SchemaId, TableFull> {
        let context = self.intern(context)?;
        let result = self.intern(result)?;
        let same = |schema: &Schema| {
            schema.context == context && schema.action == action && schema.result == result
        };
        if let Some(index) = self.schemas.iter().position(same)
            && let Some(schema) = self.schemas.get_mut(index)
        {
            schema.support = schema.support.saturating_add(wins);
            return Ok(SchemaId(index as u16));
        }
        let reliability = Reliability::default();
        let new = Schema {
            context,
            action,
            result,
            support: wins,
            reliability,
        };
        match self.schemas.push(new) {
            Ok(()) => Ok(SchemaId(self.schemas.len() as u16 - 1)),
            Err(new) if when_full == WhenFull::Evict => self.evict_for(new),
            Err(_) => Err(TableFull),
        }
    }

    fn evict_for(&mut self, new: Schema) -> Result<SchemaId, TableFull> {
        let evidence = |schema: &Schema| {
            schema
                .reliability
                .successes()
                .max(u32::from(schema.support))
        };
        let mut least = (evidence(&new), None);
        for (index, schema) in self.schemas.iter().enumerate() {
            if evidence(schema) < least.0 {
                least = (evidence(schema), Some(index));
            }
        }
        if let (_, Some(index)) = least
            && let Some(schema) = self.schemas.get_mut(index)
        {
            *schema = new;
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

    fn drop_unused_patterns(&mut self) {
        for index in (0..self.patterns.len()).rev() {
            let id = PatternId(index as u16);
            if self
                .schemas
                .iter()
                .any(|schema| schema.context == id || schema.result == id)
            {
                continue;
            }
            let last = PatternId(self.patterns.len() as u16 - 1);
            self.patterns.swap_remove(index);
            for schema in &mut self.schemas {
                for reference in [&mut schema.context, &mut schema.result] {
                    if *reference == last {
                        *reference = id;
                    }
                }
            }
        }
    }

    fn start_new_records(&mut self) {
        for index in 0..self.schemas.len() {
            let Some(new) = self.schemas.get(index).copied() else {
                continue;
            };
            if new.reliability.activations() > 0 {
                continue;
            }
            let alike =
                |other: &&Schema| other.context == new.context && other.action == new.action;
            let mut total = 0_u32;
            for other in self.schemas.iter().filter(alike) {
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

#[cfg(test)]
mod tests {
    use super::{KnowledgeBase, Losses, TableFull};
    use crate::clasm::{
        ActionId, ActionSomBank, Estimate, HarvestConfig, ItemId, ItemStates, ResultCoding, Sample,
        SchemaText, TrainingConfig, ValueConfig, Vocabulary,
    };
    use crate::num::Rng;

    const WORDS: Vocabulary = Vocabulary {
        items: &["s1", "s2", "s3", "ingrip"],
        actions: &["turnl", "forward"],
    };

    fn text(schema: &str) -> SchemaText<1> {
        SchemaText::parse(schema, &WORDS).unwrap()
    }

    fn only(on: &[u16]) -> ItemStates<1> {
        let mut states = ItemStates::all_off(4);
        for &item in on {
            states.set(ItemId(item), Some(true)).unwrap();
        }
        states
    }

    #[test]
    fn experience_counts_for_every_applicable_schema_and_for_no_other() {
        let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
        for schema in [
            "+s1/turnl/+s2",
            "+s1/turnl/+s1",
            "+s2/turnl/+s3",
            "+s1/forward/+s1",
        ] {
            knowledge.insert(&text(schema), 1, 2).unwrap();
        }
        let outcome = knowledge.record(&only(&[0]), ActionId(0), &only(&[1]), 0.0);
        assert_eq!((outcome.activated, outcome.succeeded), (2, 1));
        let counts: std::vec::Vec<(u32, u32)> = knowledge
            .schemas()
            .iter()
            .map(|s| (s.reliability.successes(), s.reliability.activations()))
            .collect();
        assert_eq!(counts, [(2, 3), (1, 3), (1, 2), (1, 2)]);
    }

    #[test]
    fn a_result_that_hangs_on_an_unknown_item_is_not_counted() {
        let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
        knowledge.insert(&text("+s1/turnl/+s2"), 1, 2).unwrap();
        let mut after = only(&[]);
        after.set(ItemId(1), None).unwrap();
        let outcome = knowledge.record(&only(&[0]), ActionId(0), &after, 0.0);
        assert_eq!(outcome.activated, 0);
        assert_eq!(knowledge.schemas()[0].reliability.activations(), 2);
    }

    #[test]
    fn a_full_table_forgets_the_least_successful_and_counts_it() {
        let mut knowledge = KnowledgeBase::<1, 16, 2>::new();
        knowledge.insert(&text("+s1/turnl/+s2"), 9, 20).unwrap();
        knowledge.insert(&text("+s2/turnl/+s3"), 3, 20).unwrap();
        assert_eq!(
            knowledge.insert(&text("+s3/turnl/+s1"), 2, 20),
            Err(TableFull)
        );
        knowledge
            .insert(&text("+s3/forward/+ingrip"), 5, 20)
            .unwrap();
        let kept: std::vec::Vec<u32> = knowledge
            .schemas()
            .iter()
            .map(|s| s.reliability.successes())
            .collect();
        assert_eq!(kept, [9, 5]);
        let losses = Losses {
            evicted_schemas: 1,
            refused_schemas: 1,
            refused_patterns: 0,
        };
        assert_eq!(knowledge.losses(), losses);
    }

    #[test]
    fn a_full_pattern_table_refuses_and_counts() {
        let mut knowledge = KnowledgeBase::<1, 2, 8>::new();
        knowledge.insert(&text("+s1/turnl/+s2"), 1, 1).unwrap();
        assert_eq!(
            knowledge.insert(&text("+s3/turnl/+s2"), 1, 1),
            Err(TableFull)
        );
        assert_eq!(knowledge.losses().refused_patterns, 1);
        knowledge.insert(&text("+s2/turnl/+s1"), 1, 1).unwrap();
    }

    #[test]
    fn a_harvest_keeps_the_trials_of_what_is_still_said_and_drops_the_rest() {
        let mut bank = ActionSomBank::<6, 6, 4, 2>::new();
        bank.randomize(&mut Rng::new(1));
        let config = TrainingConfig::FORAGER;
        let turn = Sample::new(&only(&[0]), &only(&[1]), ResultCoding::EndState, 4);
        let stay = Sample::new(&only(&[0]), &only(&[0]), ResultCoding::EndState, 4);
        for _ in 0..30 {
            bank.train(ActionId(0), &turn, &config);
        }
        for _ in 0..10 {
            bank.train(ActionId(0), &stay, &config);
        }
        let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
        knowledge
            .insert(&text("+s3/forward/+ingrip"), 5, 9)
            .unwrap();
        let harvest = |knowledge: &mut KnowledgeBase<1, 16, 16>| {
            knowledge.harvest(bank.maps(), ResultCoding::EndState, &HarvestConfig::FORAGER);
        };
        harvest(&mut knowledge);
        let shares: std::vec::Vec<f32> = knowledge
            .schemas()
            .iter()
            .map(|s| s.reliability.value(Estimate::Plain))
            .collect();
        assert_eq!(
            shares,
            [0.75, 0.25],
            "wins of the nodes are the first record"
        );
        assert_eq!(
            knowledge.patterns(),
            2,
            "patterns of dropped schemas leave with them"
        );
        knowledge.record(&only(&[0]), ActionId(0), &only(&[0]), 0.0);
        harvest(&mut knowledge);
        assert_eq!(knowledge.schemas()[1].reliability.successes(), 11);
        assert_eq!(knowledge.schemas()[1].reliability.activations(), 41);
    }

    #[test]
    fn value_flows_along_ways_and_not_along_accidents() {
        let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
        knowledge.set_inherent_value(ItemId(3), 10.0).unwrap();
        for (schema, successes) in [
            ("+s3/forward/+ingrip", 20),
            ("+s3/forward/+s3", 80),
            ("+s1/forward/+ingrip", 1),
            ("+s1/forward/+s1", 99),
            ("+s1/turnl/+s2", 30),
            ("+s1/turnl/+s1", 70),
        ] {
            knowledge.insert(&text(schema), successes, 100).unwrap();
        }
        let values = |knowledge: &KnowledgeBase<1, 16, 16>| {
            [0, 2].map(|item| knowledge.deferred_value(ItemId(item)))
        };
        knowledge.defer_values(&ValueConfig::FORAGER);
        assert_eq!(values(&knowledge), [0.0, 9.5]);
        knowledge.defer_values(&ValueConfig::BOOK);
        assert_eq!(
            values(&knowledge),
            [9.5, 9.5],
            "read literally, one accident is a way"
        );
    }
}
