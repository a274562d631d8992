//! Level-2 schemas and what follows from their success: rows of counters, and the values they give.
//!
//! A level-2 schema is a schema of level 1, its *host*, with the item of another schema in its
//! context, its *trace*: the host has succeeded right after the other one.
//! Without a trace it only says that the host has succeeded.
//! What it implies about synthetic items falls back step by step: (host, trace) → host → level 1,
//! p = (on + κ · p of the step below) / (tried + κ).

use super::labels::Labels;
use crate::choice::{Appraisal, ValueConfig, state_of};
use crate::knowledge::{KnowledgeBase, Others, Schema, SchemaId, SyntheticId};
use crate::num::ordered::insert;
use crate::word::{ActionId, ItemStates, SchemaText};

/// How the counters of a level-2 schema become beliefs.
///
/// ```
/// use cla_core::level2::{Reading, SomLevelConfig};
/// assert_ne!(SomLevelConfig::FORAGER.reading, Reading::Cut(0.9));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reading {
    /// Shares, smoothed with what is known with less context.
    Counters {
        /// Occasions that the reliability of level 1 counts for; above 0.
        prior: f32,
        /// Occasions that the belief without the trace counts for; above 0.
        trace_prior: f32,
    },
    /// The plain book's: an item stands in the result of the most specific level-2 schema if its
    /// share is at least this, in `(0, 1]` (book: .9); of the others nothing is known.
    Cut(f32),
}

/// A synthetic item: what its schema says, and where that schema is stored now, if anywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Synthetic<const WORDS: usize> {
    pub(crate) text: SchemaText<WORDS>,
    pub(crate) schema: Option<SchemaId>,
}

/// A level-2 schema.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row<const ACTIONS: usize> {
    pub(crate) host: SyntheticId,
    pub(crate) trace: Option<SyntheticId>,
    /// What being where it has succeeded is worth.
    pub(crate) value: f32,
    /// How often each action was done right after its success; older times weigh less.
    pub(crate) tried: [f32; ACTIONS],
    /// Whether a node of the last harvest says it.
    pub(crate) said: bool,
}

/// All synthetic items and level-2 schemas of a brain, in fixed memory.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Implications<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const LABELS: usize,
> {
    pub(crate) items: heapless::Vec<Synthetic<WORDS>, ITEMS, u16>,
    /// In ascending order of (host, trace), without a trace first.
    pub(crate) rows: heapless::Vec<Row<ACTIONS>, ROWS, u16>,
    pub(crate) labels: Labels<LABELS>,
    /// Level-2 schemas that found no room.
    pub(crate) refused: u32,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const LABELS: usize,
> Implications<WORDS, ITEMS, ACTIONS, ROWS, LABELS>
{
    pub(crate) const fn new() -> Self {
        const {
            assert!(
                ROWS > 0 && ROWS < u16::MAX as usize,
                "1 to 65,534 level-2 schemas"
            );
        }
        Self {
            items: heapless::Vec::new(),
            rows: heapless::Vec::new(),
            labels: Labels::new(),
            refused: 0,
        }
    }

    pub(crate) fn clear(&mut self) {
        self.items.clear();
        self.rows.clear();
        self.labels.clear();
    }

    pub(crate) fn item(&self, id: SyntheticId) -> Option<&Synthetic<WORDS>> {
        self.items.get(usize::from(id.0))
    }

    /// The item of a schema that is spelled out.
    pub(crate) fn item_of(&self, text: &SchemaText<WORDS>) -> Option<SyntheticId> {
        let index = self.items.iter().position(|it| it.text == *text)?;
        Some(SyntheticId(index as u16))
    }

    /// The place of a level-2 schema.
    pub(crate) fn place(&self, host: SyntheticId, trace: Option<SyntheticId>) -> Option<u16> {
        let found = self
            .rows
            .binary_search_by_key(&(host, trace), |row| (row.host, row.trace));
        found.ok().map(|index| index as u16)
    }

    pub(crate) fn row(&self, place: u16) -> Option<&Row<ACTIONS>> {
        self.rows.get(usize::from(place))
    }

    /// Counts that `item` was on when `action` was done where `host` had succeeded after `trace`:
    /// with the trace, if that is a level-2 schema of its own, and without.
    pub(crate) fn record(
        &mut self,
        host: SyntheticId,
        trace: Option<SyntheticId>,
        action: ActionId,
        item: SyntheticId,
        forgetting: f32,
    ) {
        let general = self.place(host, None);
        let special = trace.and_then(|trace| self.place(host, Some(trace)));
        for place in [general, special].into_iter().flatten() {
            let row = self.rows.get_mut(usize::from(place));
            if let Some(tried) = row.and_then(|it| it.tried.get_mut(usize::from(action.0))) {
                self.labels.record(place, action, item, tried, forgetting);
            }
        }
    }

    /// Makes sure that there is a row; what is new has no counters and the value `value`.
    ///
    /// Places move: to be called while there are no labels.
    pub(crate) fn say(&mut self, host: SyntheticId, trace: Option<SyntheticId>, value: f32) {
        let key = |row: &Row<ACTIONS>| (row.host, row.trace);
        match self.rows.binary_search_by_key(&(host, trace), key) {
            Ok(index) => {
                if let Some(row) = self.rows.get_mut(index) {
                    row.said = true;
                }
            }
            Err(index) => {
                let row = Row {
                    host,
                    trace,
                    value,
                    tried: [0.0; ACTIONS],
                    said: true,
                };
                if !insert(&mut self.rows, index, row) {
                    self.refused = self.refused.saturating_add(1);
                }
            }
        }
    }

    /// Lets every action of every row count for at most `most` occasions.
    pub(crate) fn limit(&mut self, most: f32) {
        for (place, row) in self.rows.iter_mut().enumerate() {
            for (action, tried) in row.tried.iter_mut().enumerate() {
                if *tried > most {
                    let share = most / *tried;
                    self.labels
                        .weaken(place as u16, ActionId(action as u16), share);
                    *tried = most;
                }
            }
        }
    }

    /// What each action brings in `state` by level 1 alone, as shares that sum to at most 1.
    fn by_level_1<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        state: &ItemStates<WORDS>,
        values: &ValueConfig,
    ) -> [Appraisal; ACTIONS] {
        let mut appraisals = [Appraisal::default(); ACTIONS];
        let mut others = Others::none();
        let mut applicable = knowledge.applicable(state, &mut others);
        while let Some(index) = applicable.next(knowledge) {
            if let Some(schema) = knowledge.schemas.get(index)
                && let Some(appraisal) = appraisals.get_mut(usize::from(schema.action.0))
            {
                let p = schema.reliability.value(values.estimate);
                appraisal.value += p * self.worth_of_schema(knowledge, schema, values);
                appraisal.reliability += p;
                appraisal.applicable = true;
            }
        }
        for appraisal in &mut appraisals {
            if appraisal.reliability > 0.0 {
                appraisal.value /= appraisal.reliability;
                appraisal.reliability = 1.0;
            }
        }
        appraisals
    }

    fn worth_of_schema<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        schema: &Schema,
        values: &ValueConfig,
    ) -> f32 {
        let Some(result) = knowledge.patterns.get(usize::from(schema.result.0)) else {
            return 0.0;
        };
        let general = schema.synthetic().and_then(|item| self.place(item, None));
        let then = general.and_then(|place| self.row(place));
        let then = then.map_or(result.value, |row| row.value);
        knowledge.with_inherent(values.discount * then, &result.items)
    }

    /// What it is worth that `item`'s schema succeeds right after `trace`'s.
    fn worth<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        item: SyntheticId,
        trace: SyntheticId,
        values: &ValueConfig,
    ) -> f32 {
        let place = self
            .place(item, Some(trace))
            .or_else(|| self.place(item, None));
        let then = place.and_then(|place| self.row(place));
        let value = values.discount * then.map_or(0.0, |row| row.value);
        self.item(item).map_or(value, |item| {
            knowledge.with_inherent(value, &item.text.result)
        })
    }

    /// What each action can be expected to bring where `host` has succeeded after `trace`.
    fn after<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        level1: &[Appraisal; ACTIONS],
        host: SyntheticId,
        trace: Option<SyntheticId>,
        values: &ValueConfig,
        reading: Reading,
    ) -> [Appraisal; ACTIONS] {
        let mut appraisals = *level1;
        let general = self.place(host, None);
        let special = trace.and_then(|trace| self.place(host, Some(trace)));
        let (steps, least) = match reading {
            Reading::Counters { prior, trace_prior } => {
                ([(general, prior), (special, trace_prior)], None)
            }
            Reading::Cut(least) => ([(special.or(general), 0.0), (None, 0.0)], Some(least)),
        };
        for (place, prior) in steps {
            let Some((place, row)) = place.and_then(|it| Some((it, self.row(it)?))) else {
                continue;
            };
            for (action, (appraisal, &tried)) in appraisals.iter_mut().zip(&row.tried).enumerate() {
                if tried <= 0.0 {
                    continue;
                }
                let (mut value, mut on) = (0.0, 0.0);
                for label in self.labels.after(place, ActionId(action as u16)) {
                    if least.is_none_or(|least| label.on >= least * tried) {
                        value += label.on * self.worth(knowledge, label.item, host, values);
                        on += label.on;
                    }
                }
                if least.is_some() {
                    if on > 0.0 {
                        appraisal.value = value / on;
                        appraisal.reliability = 1.0;
                        appraisal.applicable = true;
                    }
                    continue;
                }
                let n = tried + prior;
                appraisal.value = (value + prior * appraisal.value) / n;
                appraisal.reliability = (on + prior * appraisal.reliability) / n;
                appraisal.applicable = true;
            }
        }
        appraisals
    }

    /// What each action can be expected to bring in `state`, which `host` led to after `trace`.
    #[allow(clippy::too_many_arguments)]
    pub(crate) fn expected_values<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        state: &ItemStates<WORDS>,
        host: SyntheticId,
        trace: Option<SyntheticId>,
        values: &ValueConfig,
        reading: Reading,
    ) -> [Appraisal; ACTIONS] {
        let level1 = self.by_level_1(knowledge, state, values);
        self.after(knowledge, &level1, host, trace, values, reading)
    }

    /// Brings the values of a host's rows up to date.
    pub(crate) fn improve<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        host: SyntheticId,
        values: &ValueConfig,
        reading: Reading,
    ) {
        let Some(item) = self.item(host) else { return };
        let state = state_of(&item.text.result);
        let level1 = self.by_level_1(knowledge, &state, values);
        let from = self.rows.partition_point(|row| row.host < host);
        let to = self.rows.partition_point(|row| row.host <= host);
        for index in from..to {
            let trace = self.rows.get(index).and_then(|row| row.trace);
            let mut best = 0.0;
            for appraisal in self.after(knowledge, &level1, host, trace, values, reading) {
                if appraisal.value > best {
                    best = appraisal.value;
                }
            }
            if let Some(row) = self.rows.get_mut(index) {
                row.value = best;
            }
        }
    }

    /// How probable it is that `item` is on where `host` has succeeded after `trace`, in `[0, 1]`;
    /// `below` is what level 1 thinks of its schema.
    pub(crate) fn belief(
        &self,
        host: SyntheticId,
        trace: Option<SyntheticId>,
        item: SyntheticId,
        below: f32,
        reading: Reading,
    ) -> f32 {
        let Some(action) = self.item(item).map(|item| item.text.action) else {
            return below;
        };
        let general = self.place(host, None);
        let special = trace.and_then(|trace| self.place(host, Some(trace)));
        let share = |place: u16| {
            let row = self.row(place)?;
            let tried = *row.tried.get(usize::from(action.0))?;
            let mut labels = self.labels.after(place, action).iter();
            let on = labels.find(|label| label.item == item);
            Some((on.map_or(0.0, |label| label.on), tried))
        };
        match reading {
            Reading::Counters { prior, trace_prior } => {
                let mut p = below;
                for (place, prior) in [(general, prior), (special, trace_prior)] {
                    if let Some((on, tried)) = place.and_then(share) {
                        p = (on + prior * p) / (tried + prior);
                    }
                }
                p
            }
            Reading::Cut(least) => match special.or(general).and_then(share) {
                Some((on, tried)) if tried > 0.0 && on >= least * tried => 1.0,
                _ => below,
            },
        }
    }
}
