//! Values: what items and states are worth (book, 6.1.1, 6.2.2).
//!
//! Two rules over the same schemas.
//! The book's: the context items of a schema get 95 % of the value of its result, the largest wins;
//! unreliable detours count as much as sure ways.
//! Expected value: a state is worth what the best action there brings on average over the
//! alternative results of its schemas, which is what the reliabilities are good for.

use core::fmt;

use crate::check::{Config, ConfigError, Range};
use crate::knowledge::{Estimate, KnowledgeBase, Others, Schema};
use crate::snapshot::{LARGEST, LARGEST_VALUE, clipped, stored};
use crate::word::{ItemId, ItemSet, ItemStates, SignedItems};

/// The most values that a step brings up to date.
pub(crate) const MOST_A_STEP: u16 = 1024;

/// The largest number below 1: the largest discount.
const MOST_DISCOUNT: f32 = 1.0 - f32::EPSILON / 2.0;

/// How values spread from results to contexts.
///
/// Nothing of it is checked where it is handed to a [`KnowledgeBase`] itself: a discount out of its
/// range counts there as the nearest in it, and one that is no number as 0; the other numbers are only
/// compared, and no share reaches one that is no number.
///
/// ```
/// use cla_core::choice::ValueConfig;
/// assert_eq!(ValueConfig::BOOK.discount, 0.95);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct ValueConfig {
    /// Share of a result's value that its context gets, in `[0, 1)` (book: .95).
    pub discount: f32,
    /// A context must make an item come at least this often for the item's value to reach it, in
    /// `[0, 1]`; 0 lets every schema pass value on, as the book says.
    pub chain_reliability: f32,
    /// And this many times as often as the action does on average; 0 asks nothing.
    ///
    /// A robot among many specimens sees each schema succeed by chance now and then.
    /// What Drescher calls relevance tells a way from an accident (book, 5.1.1).
    pub chain_relevance: f32,
    /// And at least this many times in all: a handful of trials proves no way.
    pub chain_successes: u32,
    /// Which reliability counts.
    pub estimate: Estimate,
}

impl ValueConfig {
    /// The book's: every schema passes 95 % on, reliabilities are plain shares.
    pub const BOOK: Self = Self {
        discount: 0.95,
        chain_reliability: 0.0,
        chain_relevance: 0.0,
        chain_successes: 0,
        estimate: Estimate::Plain,
    };

    /// Value passes where it is no accident, and reliabilities follow the robot's present ways.
    pub const FORAGER: Self = Self {
        chain_reliability: 0.02,
        chain_relevance: 1.5,
        chain_successes: 10,
        estimate: Estimate::Recent,
        ..Self::BOOK
    };
}

impl Config for ValueConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::BELOW_ONE.check("ValueConfig::discount", self.discount)?;
        Range::SHARE.check("ValueConfig::chain_reliability", self.chain_reliability)?;
        Range::NOT_NEGATIVE.check("ValueConfig::chain_relevance", self.chain_relevance)
    }
}

/// An inherent value that cannot be given.
///
/// ```
/// use cla_core::choice::InherentValueError;
/// use cla_core::knowledge::KnowledgeBase;
/// use cla_core::word::ItemId;
/// let mut knowledge = KnowledgeBase::<1, 4, 4>::new();
/// assert_eq!(knowledge.set_inherent_value(ItemId(0), f32::NAN), Err(InherentValueError::NotFinite));
/// assert_eq!(knowledge.set_inherent_value(ItemId(99), 1.0), Err(InherentValueError::NoSuchItem));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InherentValueError {
    /// The value is NaN or infinite.
    NotFinite,
    /// The value is below 0: there is nothing to avoid in this theory, only things to reach.
    Negative,
    /// The value is above 10⁹: sums of values must stay finite.
    TooLarge,
    /// The item does not fit the capacity.
    NoSuchItem,
}

impl fmt::Display for InherentValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "an inherent value must be a finite number",
            Self::Negative => "an inherent value must not be negative",
            Self::TooLarge => "an inherent value must be at most 1e9",
            Self::NoSuchItem => "the item does not fit the capacity",
        })
    }
}

impl core::error::Error for InherentValueError {}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Says what being on is worth for an item, for its own sake.
    ///
    /// # Errors
    /// [`InherentValueError`]; nothing changes then.
    pub fn set_inherent_value(
        &mut self,
        item: ItemId,
        value: f32,
    ) -> Result<(), InherentValueError> {
        if !value.is_finite() {
            return Err(InherentValueError::NotFinite);
        }
        if value < 0.0 {
            return Err(InherentValueError::Negative);
        }
        if value > LARGEST_VALUE {
            return Err(InherentValueError::TooLarge);
        }
        let slot = self
            .inherent
            .as_flattened_mut()
            .get_mut(usize::from(item.0));
        *slot.ok_or(InherentValueError::NoSuchItem)? = value;
        if value > 0.0 {
            // It has a slot, so it has a bit.
            let _ = self.valued.insert(item);
        } else {
            self.valued.remove(item);
        }
        Ok(())
    }

    /// These items alone are worth something for their own sake; what was checked fits.
    pub(crate) fn set_inherent_values(&mut self, values: &[(ItemId, f32)]) {
        self.inherent = [[0.0; 32]; WORDS];
        self.valued = ItemSet::EMPTY;
        for &(item, value) in values {
            // A refusal would have been an error before birth.
            let _ = self.set_inherent_value(item, value);
        }
    }

    /// `value` and the inherent values of the positive items.
    #[inline]
    pub(crate) fn with_inherent(&self, value: f32, items: &SignedItems<WORDS>) -> f32 {
        if items.positive().is_disjoint(&self.valued) {
            value
        } else {
            self.add_inherent(value, items)
        }
    }

    #[inline(never)]
    fn add_inherent(&self, value: f32, items: &SignedItems<WORDS>) -> f32 {
        let mut total = value;
        for item in items.positive().intersection(&self.valued).iter() {
            total += self.inherent_value(item);
        }
        total
    }

    /// What being on is worth for an item, for its own sake; 0 for an item outside the capacity.
    #[must_use]
    pub fn inherent_value(&self, item: ItemId) -> f32 {
        self.inherent
            .as_flattened()
            .get(usize::from(item.0))
            .copied()
            .unwrap_or(0.0)
    }

    /// The book's value of an item: the larger of its inherent value and what it leads to.
    ///
    /// Up to date after [`defer_values`](Self::defer_values).
    #[must_use]
    pub fn deferred_value(&self, item: ItemId) -> f32 {
        let inherent = self.inherent_value(item);
        let deferred = self
            .deferred
            .as_flattened()
            .get(usize::from(item.0))
            .copied();
        deferred.map_or(
            inherent,
            |value| if value > inherent { value } else { inherent },
        )
    }

    /// The book's value of a conjunction: the largest of its positive items'.
    #[must_use]
    pub fn largest_value(&self, items: &SignedItems<WORDS>) -> f32 {
        let mut largest = 0.0;
        for item in items.positive().iter() {
            let value = self.deferred_value(item);
            if value > largest {
                largest = value;
            }
        }
        largest
    }

    /// What a state is worth for its own sake: the sum of the inherent values of what is on.
    #[must_use]
    pub fn reward(&self, state: &ItemStates<WORDS>) -> f32 {
        let mut total = 0.0;
        for item in state.on().intersection(&self.valued).iter() {
            total += self.inherent_value(item);
        }
        total
    }

    /// Spreads values backwards through the schemas until nothing changes (book, 6.2.2).
    ///
    /// At most one pass an item, because a chain visits each item once; each pass compares schemas
    /// in pairs, so this is for harvest time and reports, not for every control step.
    /// A discount out of its range counts as the nearest in it, NaN as 0.
    pub fn defer_values(&mut self, config: &ValueConfig) {
        self.deferred = [[0.0; 32]; WORDS];
        for _ in 0..WORDS * 32 {
            if !self.defer_once(config) {
                return;
            }
        }
    }

    fn defer_once(&mut self, config: &ValueConfig) -> bool {
        let discount = clipped(config.discount, MOST_DISCOUNT);
        let mut changed = false;
        for index in 0..self.schemas.len() {
            let Some(schema) = self.schemas.get(index).copied() else {
                continue;
            };
            let (Some(context), Some(result)) =
                (self.pattern(schema.context), self.pattern(schema.result))
            else {
                continue;
            };
            for item in result.positive().iter() {
                let value = discount * self.deferred_value(item);
                let gains = |other: ItemId| value > self.deferred_value(other);
                if context.positive().iter().any(gains) && self.leads_to(&schema, item, config) {
                    for other in context.positive().iter() {
                        changed |= self.raise(other, value);
                    }
                }
            }
        }
        changed
    }

    /// Whether a schema's context and action bring the item often enough to be no accident.
    fn leads_to(&self, schema: &Schema, item: ItemId, config: &ValueConfig) -> bool {
        let (mut here, mut all_here) = (0_u32, 0_u32);
        let (mut anywhere, mut all_anywhere) = (0_u32, 0_u32);
        for other in self
            .schemas
            .iter()
            .filter(|other| other.action == schema.action)
        {
            let successes = other.reliability.successes();
            let result = self.pattern(other.result);
            let brings = result.is_some_and(|result| result.positive().contains(item));
            let brought = if brings { successes } else { 0 };
            anywhere = anywhere.saturating_add(brought);
            all_anywhere = all_anywhere.saturating_add(successes);
            if other.context == schema.context {
                here = here.saturating_add(brought);
                all_here = all_here.saturating_add(successes);
            }
        }
        let share = |part: u32, whole: u32| {
            if whole == 0 {
                0.0
            } else {
                part as f32 / whole as f32
            }
        };
        let p = share(here, all_here);
        here >= config.chain_successes
            && p >= config.chain_reliability
            && p >= config.chain_relevance * share(anywhere, all_anywhere)
    }

    /// Raises a deferred value; whether that changed it.
    fn raise(&mut self, item: ItemId, value: f32) -> bool {
        match self
            .deferred
            .as_flattened_mut()
            .get_mut(usize::from(item.0))
        {
            Some(slot) if value > *slot => {
                *slot = value;
                true
            }
            _ => false,
        }
    }

    /// Brings the expected value of the next `count` patterns up to date, in turn.
    ///
    /// Each is one look at the tables: call it every control step with a small count, and values
    /// follow the reliabilities at a bounded cost.
    /// A discount out of its range counts as the nearest in it, NaN as 0.
    pub fn improve_values<const ACTIONS: usize>(&mut self, count: u16, config: &ValueConfig) {
        let discount = self.follow_discount(config);
        for _ in 0..count {
            if usize::from(self.next_value) >= self.patterns.len() {
                self.next_value = 0;
            }
            let index = usize::from(self.next_value);
            let Some(pattern) = self.patterns.get(index) else {
                return;
            };
            let state = state_of(&pattern.items);
            let mut best = 0.0;
            for appraisal in self.expected_values::<ACTIONS>(&state, config) {
                if appraisal.value > best {
                    best = appraisal.value;
                }
            }
            let best = if best < LARGEST { best } else { LARGEST };
            if let Some(pattern) = self.patterns.get_mut(index) {
                pattern.value = best;
                pattern.then = discount * best;
            }
            self.next_value += 1;
        }
    }

    /// Brings what the patterns keep up to date after a change of the discount; answers what counts as
    /// the discount.
    fn follow_discount(&mut self, config: &ValueConfig) -> f32 {
        let discount = clipped(config.discount, MOST_DISCOUNT);
        if self.discount.to_bits() != discount.to_bits() {
            self.discount = discount;
            for pattern in &mut self.patterns {
                pattern.then = discount * pattern.value;
            }
        }
        discount
    }

    /// Repeats [`improve_values`](Self::improve_values) over all patterns `sweeps` times.
    ///
    /// For the host, or once after a harvest: with a discount of .95 a value is settled to 1 %
    /// after about 90 sweeps, the order of actions long before.
    /// A discount out of its range counts as the nearest in it, NaN as 0.
    pub fn settle_values<const ACTIONS: usize>(&mut self, sweeps: u16, config: &ValueConfig) {
        for _ in 0..sweeps {
            self.improve_values::<ACTIONS>(self.patterns(), config);
        }
    }

    /// What each action can be expected to bring in `state`.
    ///
    /// The reliabilities of the applicable schemas of one action weigh the values of their results;
    /// where overlapping contexts make them add up to more than 1 they are scaled down.
    /// A discount out of its range counts as the nearest in it, NaN as 0.
    pub fn expected_values<const ACTIONS: usize>(
        &mut self,
        state: &ItemStates<WORDS>,
        config: &ValueConfig,
    ) -> [Appraisal; ACTIONS] {
        let discount = self.follow_discount(config);
        let mut appraisals = [Appraisal::default(); ACTIONS];
        let mut bonuses = [0.0; ACTIONS];
        let mut others = Others::none();
        let mut applicable = self.applicable(state, &mut others);
        while let Some(index) = applicable.next(self) {
            let Some(schema) = self.schemas.get(index) else {
                continue;
            };
            let Some(appraisal) = appraisals.get_mut(usize::from(schema.action.0)) else {
                continue;
            };
            let Some(result) = self.patterns.get(usize::from(schema.result.0)) else {
                continue;
            };
            debug_assert!(result.then == discount * result.value);
            let p = schema.reliability.value(config.estimate);
            let value = self.with_inherent(result.then, &result.items);
            appraisal.value += p * value;
            appraisal.reliability += p;
            appraisal.applicable = true;
            let bonus = schema.doubt.bonus;
            // Mostly there is none, and a zero is told faster by its bits.
            if bonus.to_bits() != 0
                && let Some(most) = bonuses.get_mut(usize::from(schema.action.0))
                && bonus > *most
            {
                *most = bonus;
            }
        }
        self.count_schemas(applicable.seen());
        for (appraisal, bonus) in appraisals.iter_mut().zip(bonuses) {
            // The bits of positive floats are in their order.
            if appraisal.reliability.to_bits() > 1.0_f32.to_bits() {
                appraisal.value /= appraisal.reliability;
            }
            if bonus.to_bits() != 0 {
                appraisal.value += bonus;
            }
        }
        appraisals
    }
}

/// What one action can be expected to bring.
///
/// In the field: the action's Q value under the learned model; improving a value is one asynchronous
/// backup of value iteration.
///
/// ```
/// assert!(!cla_core::choice::Appraisal::default().applicable);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Appraisal {
    /// Expected discounted value.
    pub value: f32,
    /// The sum of the reliabilities behind it.
    pub reliability: f32,
    /// Whether any schema of this action applies.
    pub applicable: bool,
}

pub(crate) fn state_of<const WORDS: usize>(items: &SignedItems<WORDS>) -> ItemStates<WORDS> {
    ItemStates::from_sets(items.positive(), items.negative())
}

stored! {
    impl[] ValueConfig { discount, chain_reliability, chain_relevance, chain_successes, estimate }
}

#[cfg(test)]
#[path = "value_tests.rs"]
mod tests;
