//! Level 2: synthetic items made from the schemas of level 1, and what believing in them is worth.
//!
//! Level 1 asks how often a schema succeeds where its context holds; level 2 asks how often it does
//! so right after another schema has succeeded (book, 5.1.1 and 6.2.6), and falls back on level 1
//! as far as experience is missing: p = (on + κ · reliability) / (tried + κ).
//! The state is then the schema that has succeeded last; its value is half what the beliefs promise
//! and half what has really followed it.

use super::belief::{Belief, BeliefLosses, BeliefTable, uses};
use super::config::Level2Config;
use super::rates::Rates;
use crate::choice::{Appraisal, Preference, ValueConfig, Voice, most_worth, state_of};
use crate::knowledge::{
    KnowledgeBase, Others, PatternId, Reliability, Schema, SchemaId, SyntheticId,
};
use crate::snapshot::{LARGEST, MOST_CHANGE, bounded, clipped, stored};
use crate::word::{ActionId, Cost, ItemStates};

/// Weights of a new prediction in the slow and the fast share of right ones.
const SLOW: f32 = 0.000_5;
const FAST: f32 = 0.02;
/// The most that a share of right predictions is, rounding included.
pub(super) const MOST_SHARE: f32 = 1.1;
/// Eligibility below which a state no longer feels a reward.
const FELT: f32 = 0.01;

/// The second level of a brain: `SYNTHETIC` items and `BELIEFS` counters.
///
/// In the field: the state is the last success, a history of one; beliefs are bigram counts smoothed
/// with a Dirichlet prior of κ whose mean is level 1, and what followed is learned by TD(λ).
///
/// It reads the knowledge base of the first level and changes nothing there but the mark which
/// schema has an item.
///
/// ```
/// use cla_core::level2::SecondLevel;
/// let level = SecondLevel::<6, 64, 512>::new();
/// assert_eq!(level.items(), 0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SecondLevel<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize> {
    pub(crate) table: BeliefTable<ACTIONS, SYNTHETIC, BELIEFS>,
    /// By which discount and share of experience the rows' `then` was computed.
    pub(super) rates: Rates,
    /// The item whose value is computed next.
    pub(super) next_value: u16,
    /// Shares of right predictions: since the beginning, slowly and quickly forgetting.
    pub(super) predictions: Reliability,
    pub(crate) slow: f32,
    pub(crate) fast: f32,
}

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize>
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    /// A level without items, of all-zero memory.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            table: BeliefTable::new(),
            rates: Rates::NONE,
            next_value: 0,
            predictions: Reliability::ZERO,
            slow: 0.0,
            fast: 0.0,
        }
    }

    /// The number of synthetic items.
    #[must_use]
    pub fn items(&self) -> u16 {
        let rows = self.table.rows.iter();
        rows.filter(|row| row.schema.is_some()).count() as u16
    }

    /// What did not fit so far.
    #[must_use]
    pub const fn losses(&self) -> BeliefLosses {
        self.table.losses
    }

    /// All counters, in ascending order of (trace, item).
    #[must_use]
    pub fn beliefs(&self) -> &[Belief] {
        self.table.all()
    }

    /// The schema that an item stands for.
    #[must_use]
    pub fn schema(&self, item: SyntheticId) -> Option<SchemaId> {
        self.table.row(item)?.schema
    }

    /// How often an action was done right after the item's schema had succeeded, newer times
    /// weighing more.
    #[must_use]
    pub fn tried(&self, trace: SyntheticId, action: ActionId) -> f32 {
        let row = self.table.row(trace);
        let tried = row.and_then(|row| row.tried.get(usize::from(action.0)));
        tried.copied().unwrap_or(0.0)
    }

    /// What being in the state after the item's schema has succeeded is worth.
    #[must_use]
    pub fn value(&self, item: SyntheticId) -> f32 {
        self.table.row(item).map_or(0.0, |row| row.value)
    }

    pub(crate) fn clear(&mut self) {
        self.table.clear();
        self.rates = Rates::NONE;
        self.next_value = 0;
        self.predictions = Reliability::ZERO;
        self.slow = 0.0;
        self.fast = 0.0;
    }

    /// How often what was believed most before an action came true: predicted first, then done,
    /// then compared.
    #[must_use]
    pub const fn predictions(&self) -> Reliability {
        self.predictions
    }

    /// Whether the predictions have lately been right less often than `share` of what they were.
    #[must_use]
    pub fn is_overloaded(&self, share: f32) -> bool {
        self.fast < share * self.slow
    }

    /// Counts a prediction that was right or wrong.
    fn count_prediction(&mut self, right: bool) {
        self.predictions.record(right, 0.0);
        let outcome = if right { 1.0 } else { 0.0 };
        self.slow += SLOW * (outcome - self.slow);
        self.fast += FAST * (outcome - self.fast);
    }

    /// The item of a schema, if it has one.
    pub(crate) fn item_of<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        id: SchemaId,
    ) -> Option<SyntheticId> {
        let item = knowledge.schemas.get(usize::from(id.0))?.synthetic()?;
        let row = self.table.row(item)?;
        (row.schema == Some(id)).then_some(item)
    }

    /// An item for a schema that has none yet, if there is room.
    pub(crate) fn reify<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        id: SchemaId,
    ) -> Option<SyntheticId> {
        let schema = *knowledge.schemas.get(usize::from(id.0))?;
        let result = knowledge.patterns.get(usize::from(schema.result.0));
        let value = result.map_or(0.0, |pattern| pattern.value);
        let item = self.table.add(id, schema.action, value)?;
        let rates = self.rates;
        if let Some(row) = self.table.rows.get_mut(usize::from(item.0)) {
            row.then = rates.then(row);
        }
        knowledge.count_schemas(knowledge.schemas.len());
        for (index, schema) in knowledge.schemas.iter_mut().enumerate() {
            if index == usize::from(id.0) {
                schema.set_synthetic(Some(item));
            } else if schema.synthetic() == Some(item) {
                // The item was evicted for this one.
                schema.set_synthetic(None);
            }
        }
        Some(item)
    }

    /// Counts whether what was believed most before an action came true; that no known schema
    /// succeeded is a miss.
    pub(crate) fn judge(
        &mut self,
        trace: SyntheticId,
        action: ActionId,
        item: Option<SyntheticId>,
    ) {
        if let Some(believed) = self.most_believed(trace, action) {
            self.count_prediction(Some(believed) == item);
        }
    }

    /// Learns what came of an action done after `trace`: a prediction was right or wrong, and if a
    /// known schema succeeded, its item was on and its reward is felt.
    pub(crate) fn learn(
        &mut self,
        trace: SyntheticId,
        action: ActionId,
        item: Option<SyntheticId>,
        reward: f32,
        discount: f32,
        config: &Level2Config,
    ) {
        self.judge(trace, action, item);
        if let Some(to) = item {
            self.experience(trace, to, reward, discount, config);
            self.table.record(trace, action, item, config.forgetting);
        }
    }

    /// An item's schema has just succeeded.
    pub(crate) fn meet(&mut self, item: SyntheticId) {
        self.table.meet(item);
    }

    /// Rows of the table, free ones too.
    pub(crate) fn rows(&self) -> u16 {
        self.table.rows.len() as u16
    }

    /// What the table has touched in this step.
    pub(crate) const fn cost(&self) -> Cost {
        self.table.cost
    }

    pub(crate) const fn set_cost(&mut self, cost: Cost) {
        self.table.cost = cost;
    }

    /// In a doubt: lets no more occasions count than the evidence leaves of what was known.
    ///
    /// Where the world has changed, level 1 decides until there is new evidence; where it has not,
    /// nothing is lost.
    ///
    /// `hold` is how many occasions the evidence leaves to a context and action.
    pub(crate) fn doubt<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        hold: impl Fn(PatternId, ActionId) -> f32,
    ) {
        for context in 0..knowledge.patterns() {
            let context = PatternId(context);
            // What the evidence leaves is asked once an action, and only where something was tried.
            let mut holds = [None; ACTIONS];
            for index in 0..self.table.rows.len() {
                let item = SyntheticId(index as u16);
                let schema = self.schema(item);
                let schema = schema.and_then(|id| knowledge.schemas.get(usize::from(id.0)));
                if schema.is_none_or(|schema| schema.result != context) {
                    continue;
                }
                for (action, kept) in (0..).zip(&mut holds) {
                    let action = ActionId(action);
                    let tried = self.tried(item, action);
                    // No evidence leaves less than nothing.
                    if tried > 0.0 {
                        let hold = *kept.get_or_insert_with(|| hold(context, action));
                        if tried > hold {
                            self.table.forget(item, action, hold / tried);
                        }
                    }
                }
            }
        }
    }

    /// After a doubt: what followed a state in the old world no longer says what it is worth.
    pub(crate) fn forget_experience(&mut self) {
        for row in &mut self.table.rows {
            row.experienced = row.value;
            row.then = self.rates.then(row);
            row.visits = 0.0;
            row.eligibility = 0.0;
        }
    }

    /// Learns from a reward on the way from one state to the next what the states before were
    /// worth: temporal differences with eligibility traces, TD(λ).
    pub(crate) fn experience(
        &mut self,
        from: SyntheticId,
        to: SyntheticId,
        reward: f32,
        discount: f32,
        config: &Level2Config,
    ) {
        let (Some(before), Some(after)) = (self.table.row(from), self.table.row(to)) else {
            return;
        };
        let error = reward + discount * after.experienced - before.experienced;
        let error = bounded(error, MOST_CHANGE);
        let mut felt = 0;
        let fading = discount * config.lambda;
        // From so many visits on a visit's share is below the learning rate, whatever the rounding.
        let many = 1.01 / config.learning_rate;
        for (index, row) in self.table.rows.iter_mut().enumerate() {
            if index == usize::from(from.0) {
                row.eligibility = 1.0;
                row.visits += 1.0;
            } else if row.eligibility.to_bits() == 0 {
                // Most feel nothing, and a zero is told faster by its bits.
                continue;
            } else {
                row.eligibility *= fading;
            }
            felt += 1;
            // Here and below: the bits of positive floats are in their order.
            if row.eligibility.to_bits() < FELT.to_bits() {
                row.eligibility = 0.0;
                continue;
            }
            let step = if row.visits.to_bits() <= 1.0_f32.to_bits() {
                1.0
            } else if row.visits.to_bits() > many.to_bits() {
                config.learning_rate
            } else {
                let share = 1.0 / row.visits;
                if share > config.learning_rate {
                    share
                } else {
                    config.learning_rate
                }
            };
            row.experienced += step * row.eligibility * error;
            row.then = self.rates.then(row);
        }
        let cost = &mut self.table.cost;
        cost.items = cost.items.wrapping_add(felt);
    }

    /// After a harvest: follows schemas that moved and drops the items of those that left; an item of
    /// another action is none of a schema's.
    pub(crate) fn follow<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    ) {
        self.table.lose_all();
        for (place, schema) in knowledge.schemas.iter().enumerate().rev() {
            let item = schema.synthetic();
            let row = item.and_then(|item| self.table.rows.get_mut(usize::from(item.0)));
            if let Some(row) = row
                && row.action == schema.action
            {
                row.schema = Some(SchemaId(place as u16));
            }
        }
        self.table.free_lost();
    }

    /// What each action can be expected to bring in `state`, where `trace` has just succeeded.
    pub(crate) fn expected_values<
        const WORDS: usize,
        const PATTERNS: usize,
        const SCHEMAS: usize,
    >(
        &self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        state: &ItemStates<WORDS>,
        trace: SyntheticId,
        values: &ValueConfig,
        config: &Level2Config,
    ) -> [f32; ACTIONS] {
        let rates = Rates::of(values, config);
        // What rows and patterns keep is true unless the configuration has just changed.
        let kept = rates == self.rates && rates.discount == knowledge.discount;
        let rates = (rates, kept);
        let mut level1 = [Appraisal::default(); ACTIONS];
        let mut others = Others::none();
        let mut applicable = knowledge.applicable(state, &mut others);
        while let Some(index) = applicable.next(knowledge) {
            if let Some(schema) = knowledge.schemas.get(index)
                && let Some(appraisal) = level1.get_mut(usize::from(schema.action.0))
            {
                let p = schema.reliability.value(values.estimate);
                appraisal.value += p * self.worth(knowledge, schema, rates);
                appraisal.reliability += p;
            }
        }
        knowledge.count_schemas(applicable.seen());
        // Occasions that count, those of level 1 among them.
        let mut occasions = [config.prior; ACTIONS];
        if let Some(row) = self.table.row(trace) {
            for (occasions, tried) in occasions.iter_mut().zip(row.tried) {
                *occasions = tried + config.prior;
            }
        }
        let mut expected = [0.0; ACTIONS];
        for ((expected, level1), occasions) in expected.iter_mut().zip(level1).zip(occasions) {
            // Nothing applies, or nothing that ever succeeded or that has not failed for ten thousand
            // times; a smaller number has no finite inverse.
            if level1.reliability.to_bits() < f32::MIN_POSITIVE.to_bits() {
                continue;
            }
            // What level 1 leaves open it says in the proportions of what it does not; where
            // nothing was tried that is all, without a division.
            let left = if occasions.to_bits() == config.prior.to_bits() {
                1.0
            } else {
                config.prior / occasions
            };
            *expected = level1.value * (left / level1.reliability);
        }
        let after = self.table.after(trace);
        knowledge.cost.beliefs = knowledge.cost.beliefs.wrapping_add(after.len() as u32);
        for belief in after {
            let Some(row) = self.table.row(belief.item) else {
                continue;
            };
            let schema = row
                .schema
                .and_then(|id| knowledge.schemas.get(usize::from(id.0)));
            let action = usize::from(row.action.0);
            let (Some(schema), Some(expected), Some(occasions)) =
                (schema, expected.get_mut(action), occasions.get(action))
            else {
                continue;
            };
            if schema.synthetic() == Some(belief.item) {
                *expected += belief.on / occasions * self.worth(knowledge, schema, rates);
            }
        }
        expected
    }

    /// What it is worth that a schema succeeds: its result's own value, and what follows.
    fn worth<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        schema: &Schema,
        (rates, kept): (Rates, bool),
    ) -> f32 {
        let Some(result) = knowledge.patterns.get(usize::from(schema.result.0)) else {
            return 0.0;
        };
        let row = schema.synthetic().and_then(|item| self.table.row(item));
        debug_assert!(
            !kept || row.is_none_or(|row| row.then == rates.then(row)),
            "a row changed and its worth a step before did not"
        );
        let then = match row {
            Some(row) if kept => row.then,
            Some(row) => rates.then(row),
            None if kept => result.then,
            None => rates.discount * result.value,
        };
        knowledge.with_inherent(then, &result.items)
    }

    /// The best action in `state` after `trace`, or `None` when none promises anything.
    pub(crate) fn prefer<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        state: &ItemStates<WORDS>,
        trace: SyntheticId,
        values: &ValueConfig,
        config: &Level2Config,
        voice: Option<&Voice<ACTIONS>>,
    ) -> Option<Preference> {
        let promised = self.expected_values(knowledge, state, trace, values, config);
        let (action, value) = most_worth(&promised, voice)?;
        let believed = self.most_believed(trace, action);
        let schema = believed
            .and_then(|item| self.schema(item))
            .or_else(|| knowledge.most_reliable_applicable(state, action, values));
        Some(Preference {
            action,
            schema,
            value,
        })
    }

    /// Of the items of an action, the one that was most often on after `trace`; of equals the
    /// first.
    #[must_use]
    pub fn most_believed(&self, trace: SyntheticId, action: ActionId) -> Option<SyntheticId> {
        let mut best: Option<(f32, SyntheticId)> = None;
        for belief in self.table.after(trace) {
            let row = self.table.row(belief.item);
            if row.is_some_and(|row| row.action == action)
                && best.is_none_or(|(on, _)| belief.on > on)
            {
                best = Some((belief.on, belief.item));
            }
        }
        best.map(|(_, item)| item)
    }

    /// Brings the value of the next `count` items up to date, in turn.
    pub(crate) fn improve_values<
        const WORDS: usize,
        const PATTERNS: usize,
        const SCHEMAS: usize,
    >(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        count: u16,
        values: &ValueConfig,
        config: &Level2Config,
    ) {
        for _ in 0..count {
            if usize::from(self.next_value) >= self.table.rows.len() {
                self.next_value = 0;
            }
            self.improve(knowledge, SyntheticId(self.next_value), values, config);
            self.next_value = self.next_value.saturating_add(1);
        }
    }

    /// Brings one item's value up to date.
    pub(crate) fn improve<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        item: SyntheticId,
        values: &ValueConfig,
        config: &Level2Config,
    ) {
        self.follow_rates(Rates::of(values, config));
        let Some(row) = self.table.row(item) else {
            return;
        };
        let Some(schema) = row
            .schema
            .and_then(|id| knowledge.schemas.get(usize::from(id.0)))
        else {
            return;
        };
        let Some(result) = knowledge.pattern(schema.result) else {
            return;
        };
        let state = state_of(&result);
        let mut best = 0.0;
        for value in self.expected_values(knowledge, &state, item, values, config) {
            if value > best {
                best = value;
            }
        }
        let best = if best < LARGEST { best } else { LARGEST };
        if let Some(row) = self.table.rows.get_mut(usize::from(item.0)) {
            row.value = best;
            row.then = self.rates.then(row);
        }
    }

    /// Brings what the rows keep up to date after a change of configuration.
    fn follow_rates(&mut self, rates: Rates) {
        if self.rates != rates {
            self.rates = rates;
            for row in &mut self.table.rows {
                row.then = rates.then(row);
            }
        }
    }

    /// How probable the success of `schema` is where `trace` has just succeeded and its context
    /// holds, in `[0, 1]`: the belief in its synthetic item.
    ///
    /// A `prior` out of its range counts as the nearest in it, NaN as one that is hardly above 0: level 1
    /// speaks where nothing was tried, and nowhere else.
    #[must_use]
    pub fn belief<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        trace: SyntheticId,
        schema: SchemaId,
        values: &ValueConfig,
        config: &Level2Config,
    ) -> f32 {
        let Some(schema) = knowledge.schemas.get(usize::from(schema.0)) else {
            return 0.0;
        };
        let reliability = schema.reliability.value(values.estimate);
        let on = self
            .table
            .after(trace)
            .iter()
            .find(|belief| Some(belief.item) == schema.synthetic());
        let tried = self.tried(trace, schema.action);
        let on = on.map_or(0.0, |belief| belief.on);
        let prior = clipped(config.prior, LARGEST);
        let prior = if prior > 0.0 {
            prior
        } else {
            f32::MIN_POSITIVE
        };
        (on + prior * reliability) / (tried + prior)
    }

    /// How often the second level has seen anything follow the item's schema.
    #[must_use]
    pub fn uses(&self, item: SyntheticId) -> f32 {
        self.table.row(item).map_or(0.0, uses)
    }
}

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize> Default
    for SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    fn default() -> Self {
        Self::new()
    }
}

stored! {
    impl[const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize]
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS> {
        table, rates, next_value, predictions, slow => up_to MOST_SHARE,
        fast => up_to MOST_SHARE
    }
}

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize>
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    /// Makes what an image does not keep.
    pub(crate) fn rebuild(&mut self) {
        for row in &mut self.table.rows {
            row.then = self.rates.then(row);
        }
    }
}

#[cfg(test)]
#[path = "second_level_tests.rs"]
mod tests;
