//! How the context of a schema grows from one sample against a memory of samples.
//!
//! Begin with the item's own prior state, where results are changes; while remembered samples contradict, add the signed item
//! of the sample that rules out contradictions at the least cost; then take out what is not needed.
//! Nothing here is stored, and the work is bounded by samples × context items.

use super::attention::Attention;
use super::evidence::Evidence;
use super::simple_schema::SimpleSchema;
use crate::check::{Config, ConfigError, Range};
use crate::snapshot::stored;
use crate::word::{ActionId, ItemId, ItemSet, SchemaText, SignedItems};

/// How contexts grow.
///
/// ```
/// use cla_core::growth::GrowthConfig;
/// assert_eq!(GrowthConfig::EXACT.tolerance, 0.0);
/// assert!(GrowthConfig::TOLERANT.tolerance > 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrowthConfig {
    /// Share of the remembered samples to which a schema applies that may contradict it, in
    /// `[0, 1)`; above 0 in a world where actions fail.
    pub tolerance: f32,
    /// Weight of a negative item's gain against a positive one's, in `[0, 1]`: what is there says
    /// more than what is not. 0 grows no negative items.
    pub negatives: f32,
    /// How much the agreement that an item leaves weighs against the contradictions that it rules
    /// out, as a power: the higher, the more general the contexts.
    pub generality: u8,
    /// The least number of remembered samples that agree with a schema; at least 1.
    pub support: u16,
    /// By how much the item that most well-tried contexts of the action name outweighs one that none
    /// names; 0 looks at all items alike.
    pub attention: f32,
}

impl GrowthConfig {
    /// For worlds whose actions always do the same.
    pub const EXACT: Self = Self {
        tolerance: 0.0,
        negatives: 0.5,
        generality: 2,
        support: 1,
        attention: 3.0,
    };
    /// For worlds whose actions sometimes fail.
    pub const TOLERANT: Self = Self {
        tolerance: 0.1,
        ..Self::EXACT
    };
}

impl Config for GrowthConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::BELOW_ONE.check("GrowthConfig::tolerance", self.tolerance)?;
        Range::SHARE.check("GrowthConfig::negatives", self.negatives)?;
        Range::AT_LEAST_ONE.check("GrowthConfig::support", f32::from(self.support))?;
        Range::NOT_NEGATIVE.check("GrowthConfig::attention", self.attention)
    }
}

/// A conclusion to explain: this item was that afterwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Conclusion {
    pub(crate) action: ActionId,
    pub(crate) item: ItemId,
    pub(crate) sign: bool,
}

/// The state of a growing context.
struct Growth<'a, const WORDS: usize, E> {
    samples: &'a [E],
    conclusion: Conclusion,
    config: &'a GrowthConfig,
    attention: Attention<WORDS>,
}

/// Samples that a context applies to: agreeing and contradicting.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Tally {
    pub(crate) agree: u16,
    pub(crate) contradict: u16,
}

/// The simplest context found that `seed` satisfies and the samples do not contradict; `None` when
/// seven items are not enough or too few samples agree.
///
/// Only items of `eligible` whose state was known may stand in the context.
pub(crate) fn grow<const WORDS: usize, E: Evidence<WORDS>>(
    seed: &E,
    conclusion: Conclusion,
    samples: &[E],
    eligible: &ItemSet<WORDS>,
    attention: Attention<WORDS>,
    config: &GrowthConfig,
) -> Option<SimpleSchema> {
    let growth = Growth {
        samples,
        conclusion,
        config,
        attention,
    };
    let mut context = SignedItems::EMPTY;
    let (on, off) = (seed.on_before(), seed.off_before());
    let eligible = eligible.intersection(&on.union(&off));
    if E::CHANGES && eligible.contains(conclusion.item) {
        let prior = on.contains(conclusion.item);
        context.insert(conclusion.item, prior).ok()?;
    }
    let mut tally = growth.tally(&context);
    while !growth.accepts(tally) {
        if usize::from(context.len()) >= SimpleSchema::CONTEXT_ITEMS {
            return None;
        }
        let best = growth.best_item(seed, &eligible, &context, tally)?;
        context.insert(best, on.contains(best)).ok()?;
        tally = growth.tally(&context);
    }
    if tally.agree < config.support {
        return None;
    }
    let context = growth.prune(context);
    growth.schema(context)
}

/// A harvested context reduced to what the samples need; `None` when even the whole context is
/// contradicted, or what is left is more than seven items.
pub(crate) fn reduce<const WORDS: usize, E: Evidence<WORDS>>(
    context: SignedItems<WORDS>,
    conclusion: Conclusion,
    samples: &[E],
    config: &GrowthConfig,
) -> Option<SimpleSchema> {
    let growth = Growth {
        samples,
        conclusion,
        config,
        attention: Attention::NONE,
    };
    let tally = growth.tally(&context);
    if !growth.accepts(tally) || tally.agree < config.support {
        return None;
    }
    let context = growth.prune(context);
    growth.schema(context)
}

impl<const WORDS: usize, E: Evidence<WORDS>> Growth<'_, WORDS, E> {
    fn schema(&self, context: SignedItems<WORDS>) -> Option<SimpleSchema> {
        let mut result = SignedItems::EMPTY;
        result
            .insert(self.conclusion.item, self.conclusion.sign)
            .ok()?;
        let mut schema = SimpleSchema::pack(&SchemaText {
            context,
            action: self.conclusion.action,
            result,
        })?;
        let Tally { agree, contradict } = self.tally(&context);
        schema.begin_with(agree, agree.saturating_add(contradict));
        Some(schema)
    }

    /// Samples to which a context applies and that know the item's state afterwards, each with
    /// whether it agrees.
    fn told<'b>(&'b self, context: &'b SignedItems<WORDS>) -> impl Iterator<Item = (&'b E, bool)> {
        self.samples.iter().filter_map(move |sample| {
            if !sample.satisfies(context) {
                return None;
            }
            let outcome = sample.outcome(self.conclusion.item)?;
            Some((sample, outcome == self.conclusion.sign))
        })
    }

    fn tally(&self, context: &SignedItems<WORDS>) -> Tally {
        let mut tally = Tally::default();
        for (_, agrees) in self.told(context) {
            if agrees {
                tally.agree = tally.agree.saturating_add(1);
            } else {
                tally.contradict = tally.contradict.saturating_add(1);
            }
        }
        tally
    }

    fn accepts(&self, tally: Tally) -> bool {
        let all = f32::from(tally.agree) + f32::from(tally.contradict);
        f32::from(tally.contradict) <= self.config.tolerance * all
    }

    /// The item of the seed whose state rules out contradictions at the least loss of agreement;
    /// `None` when no item rules out any.
    fn best_item(
        &self,
        seed: &E,
        eligible: &ItemSet<WORDS>,
        context: &SignedItems<WORDS>,
        tally: Tally,
    ) -> Option<ItemId> {
        let on = seed.on_before();
        let used = context.positive().union(context.negative());
        let open = eligible.difference(&used);
        let mut agree = [[0_u16; 32]; WORDS];
        let mut contradict = [[0_u16; 32]; WORDS];
        for (sample, agrees) in self.told(context) {
            let shared = seed.shared(sample);
            let counts = if agrees { &mut agree } else { &mut contradict };
            for item in open.intersection(&shared).iter() {
                let counts = counts.as_flattened_mut();
                if let Some(count) = counts.get_mut(usize::from(item.0)) {
                    *count = count.saturating_add(1);
                }
            }
        }
        let mut best: Option<(f32, ItemId)> = None;
        for item in open.iter() {
            let count = |counts: &[[u16; 32]; WORDS]| {
                let counts = counts.as_flattened();
                counts.get(usize::from(item.0)).copied().unwrap_or(0)
            };
            let left = Tally {
                agree: count(&agree),
                contradict: count(&contradict),
            };
            if left.contradict >= tally.contradict {
                continue;
            }
            let weight = if on.contains(item) {
                1.0
            } else {
                self.config.negatives
            };
            let familiar = self.attention.weight(item, self.config.attention);
            let gain = weight * familiar * gain(tally, left, self.config.generality);
            if gain > best.map_or(0.0, |(other, _)| other) {
                best = Some((gain, item));
            }
        }
        best.map(|(_, item)| item)
    }

    /// Takes out every item without which the samples still do not contradict, negatives first.
    fn prune(&self, mut context: SignedItems<WORDS>) -> SignedItems<WORDS> {
        for negatives in [true, false] {
            let all = context;
            let items = if negatives {
                all.negative()
            } else {
                all.positive()
            };
            for item in items.iter() {
                let mut without = context;
                without.remove(item);
                if self.accepts(self.tally(&without)) {
                    context = without;
                }
            }
        }
        context
    }
}

/// What is won by going from one tally to a smaller one: the share of contradictions ruled out,
/// times a power of the share of agreement that is left.
///
/// Squared rather than plain, a third fewer schemas cover the same changes of the Microworld.
pub(crate) fn gain(before: Tally, after: Tally, generality: u8) -> f32 {
    let agreement = (f32::from(after.agree) + 1.0) / (f32::from(before.agree) + 1.0);
    let ruled_out = f32::from(before.contradict - after.contradict) / f32::from(before.contradict);
    let mut gain = ruled_out;
    for _ in 0..generality {
        gain *= agreement;
    }
    gain
}

stored! { impl[] Tally { agree, contradict } }
