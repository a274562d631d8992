//! Accommodation: schemas that grow where something was not foreseen, compete, and are dropped.
//!
//! Every schema that applies is tested by every action; what nobody foresaw, and what was foreseen
//! wrongly, goes into the reservoir of its action and grows new schemas (book, 2.1: accommodation;
//! "simpler schemas are easy to derive", 5.4.4).
//! Time and memory are bounded; the maps, when there are any, offer seeds (see `observe_seeded`).

use super::attention::Attention;
use super::evidence::{Evidence, Transition};
use super::grow::{Conclusion, GrowthConfig, grow};
use super::reservoir::Reservoir;
use super::simple_schema::{Entry, SimpleSchema, SimpleSchemas};
use crate::check::{Config, ConfigError, Range};
use crate::num::Rng;
use crate::word::{ActionId, ItemId, ItemSet};

/// How schemas accommodate.
///
/// ```
/// use cla_core::growth::AccommodationConfig;
/// assert_eq!(AccommodationConfig::EXACT.keep, 1.0);
/// assert!(AccommodationConfig::TOLERANT.keep < 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccommodationConfig {
    /// How contexts grow.
    pub growth: GrowthConfig,
    /// A schema whose reliability falls below this is dropped, in `[0, 1]`; 1 drops at the first
    /// failure.
    pub keep: f32,
    /// Failures that are forgiven before `keep` is asked; 0 in an exact world.
    pub grace: u16,
    /// Unforeseen changes that grow a schema, per action; bounds the time.
    pub unforeseen: u8,
    /// Remembered samples that grow a schema, per action.
    pub revisits: u8,
    /// While an action's reservoir has room, a change that is foreseen only by schemas with fewer
    /// successes than this is explained once more, by other items; 0 is content with the first
    /// explanation.
    ///
    /// Of what few samples allow, much is false: with another explanation more of what is true is
    /// among it, and trials tell which.
    pub untested: u16,
}

impl AccommodationConfig {
    /// For worlds whose actions always do the same.
    pub const EXACT: Self = Self {
        growth: GrowthConfig::EXACT,
        keep: 1.0,
        grace: 0,
        unforeseen: 16,
        revisits: 16,
        untested: 8,
    };
    /// For exact worlds and more memory than is needed: what has been tried thirty times needs
    /// no second explanation.
    ///
    /// More is foreseen early, and more of it wrongly.
    pub const ROOMY: Self = Self {
        untested: 30,
        ..Self::EXACT
    };
    /// For worlds whose actions sometimes fail.
    pub const TOLERANT: Self = Self {
        growth: GrowthConfig::TOLERANT,
        keep: 0.85,
        grace: 1,
        ..Self::EXACT
    };
}

impl Config for AccommodationConfig {
    fn check(&self) -> Result<(), ConfigError> {
        self.growth.check()?;
        Range::SHARE.check("AccommodationConfig::keep", self.keep)
    }
}

/// What an action showed that was not foreseen.
///
/// ```
/// assert!(!cla_core::growth::Accommodated::default().unexpected());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Accommodated {
    /// Schemas that applied.
    pub activated: u16,
    /// Those whose result did not come.
    pub failed: u16,
    /// Items that changed and that no schema had foreseen.
    pub unforeseen: u16,
    /// Schemas that were grown and found a place.
    pub grown: u16,
}

impl Accommodated {
    /// Whether anything was unforeseen or foreseen wrongly.
    #[must_use]
    pub const fn unexpected(&self) -> bool {
        self.failed > 0 || self.unforeseen > 0
    }
}

/// Schemas that one action refuted and that will be grown anew.
type Refuted = heapless::Vec<SimpleSchema, 16, u8>;

/// Simple schemas for `ACTIONS` actions, each with a reservoir of `SAMPLES` samples.
///
/// In the field: incremental rule induction from counterexamples, general to specific, with replay.
///
/// All items are known; an item that nobody knows has no place in a transition.
///
/// ```
/// use cla_core::growth::{Accommodation, AccommodationConfig, Transition};
/// use cla_core::num::Rng;
/// use cla_core::word::{ActionId, ItemSet};
/// let mut brain = Accommodation::<1, 16, 32, 1>::new();
/// let mut rng = Rng::new(1);
/// // The action turns item 0 on, whatever item 1 is.
/// for t in 0..20 {
///     let mut before = ItemSet::EMPTY;
///     if t % 2 == 0 {
///         before.insert(cla_core::word::ItemId(1))?;
///     }
///     let mut after = before;
///     after.insert(cla_core::word::ItemId(0))?;
///     let transition = Transition { before, after };
///     brain.observe(ActionId(0), &transition, &AccommodationConfig::EXACT, &mut rng);
/// }
/// let [schema] = brain.schemas() else { panic!("one schema says it all") };
/// assert_eq!((schema.context().count(), schema.result_sign()), (0, true));
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Debug)]
pub struct Accommodation<
    const WORDS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const ACTIONS: usize,
    E = Transition<WORDS>,
> {
    schemas: SimpleSchemas<SCHEMAS>,
    reservoirs: [Reservoir<WORDS, SAMPLES, E>; ACTIONS],
}

impl<
    const WORDS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const ACTIONS: usize,
    E: Evidence<WORDS>,
> Accommodation<WORDS, SAMPLES, SCHEMAS, ACTIONS, E>
{
    /// Nothing known, nothing remembered.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            schemas: SimpleSchemas::new(),
            reservoirs: [const { Reservoir::new() }; ACTIONS],
        }
    }

    /// The schemas that are believed now.
    #[must_use]
    pub fn schemas(&self) -> &[SimpleSchema] {
        self.schemas.as_slice()
    }

    /// The table of the schemas.
    #[must_use]
    pub const fn table(&self) -> &SimpleSchemas<SCHEMAS> {
        &self.schemas
    }

    /// What is remembered of each action.
    #[must_use]
    pub const fn reservoirs(&self) -> &[Reservoir<WORDS, SAMPLES, E>; ACTIONS] {
        &self.reservoirs
    }

    /// Learns from one completed action; an action that the brain does not have changes nothing.
    ///
    /// Each unforeseen change grows a schema from the action itself, and a few remembered samples
    /// grow one for a change of theirs.
    pub fn observe(
        &mut self,
        action: ActionId,
        sample: &E,
        config: &AccommodationConfig,
        rng: &mut Rng,
    ) -> Accommodated {
        let (mut found, unforeseen, refuted) = self.compare(action, sample, config, rng);
        for schema in &refuted {
            found.grown += self.regrow(schema, config, rng);
        }
        for item in unforeseen.iter().take(usize::from(config.unforeseen)) {
            found.grown += self.grow(action, sample, item, config);
        }
        if self.remembers_all(action) {
            for item in sample.telling().difference(&unforeseen).iter() {
                found.grown += self.grow_alternative(action, sample, item, config);
            }
        }
        for _ in 0..config.revisits {
            let Some(reservoir) = self.reservoirs.get(usize::from(action.0)) else {
                return found;
            };
            let which = rng.below(reservoir.samples().len() as u32) as usize;
            let Some(seed) = reservoir.samples().get(which).copied() else {
                return found;
            };
            found.grown += self.grow_from(action, &seed, config, rng);
        }
        found
    }

    /// As [`observe`](Self::observe), but schemas grow only from `seeds`: what the nodes of an
    /// Action SOM stand for, rounded to on and off.
    ///
    /// The sample itself only tests schemas and enters the reservoir.
    pub fn observe_seeded(
        &mut self,
        action: ActionId,
        sample: &E,
        seeds: impl IntoIterator<Item = E>,
        config: &AccommodationConfig,
        rng: &mut Rng,
    ) -> Accommodated {
        let (mut found, _, _) = self.compare(action, sample, config, rng);
        for seed in seeds {
            for item in seed.telling().iter().take(usize::from(config.unforeseen)) {
                if !self.foresees(action, &seed, item) {
                    found.grown += self.grow(action, &seed, item, config);
                }
            }
        }
        found
    }

    /// Files a sample without testing schemas or growing any; the first step of
    /// [`explain`](Self::explain).
    pub fn remember(&mut self, action: ActionId, sample: &E, rng: &mut Rng) {
        if let Some(reservoir) = self.reservoirs.get_mut(usize::from(action.0)) {
            reservoir.offer(sample, 0, rng);
        }
    }

    /// Grows a schema for the end state of one item in `seed`, from the items of `mode` alone.
    ///
    /// With a mode that the item does not belong to the schema is cross-modal: what is felt there
    /// explains what is seen here (book, p. 140 of Drescher).
    pub fn explain(
        &mut self,
        action: ActionId,
        seed: &E,
        item: ItemId,
        mode: &ItemSet<WORDS>,
        growth: &GrowthConfig,
    ) -> Option<Entry> {
        let reservoir = self.reservoirs.get(usize::from(action.0))?;
        let conclusion = Conclusion {
            action,
            item,
            sign: seed.outcome(item)?,
        };
        let schema = grow(
            seed,
            conclusion,
            reservoir.samples(),
            mode,
            Attention::NONE,
            growth,
        )?;
        Some(self.schemas.enter(schema))
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.schemas.clear();
        for reservoir in &mut self.reservoirs {
            reservoir.clear();
        }
    }

    /// Tests the schemas and files the sample; also the changes that no schema foresaw.
    fn compare(
        &mut self,
        action: ActionId,
        sample: &E,
        config: &AccommodationConfig,
        rng: &mut Rng,
    ) -> (Accommodated, ItemSet<WORDS>, Refuted) {
        let mut refuted = Refuted::new();
        let mut found = Accommodated::default();
        let mut foreseen = ItemSet::EMPTY;
        self.schemas.record(action, sample, |schema, success| {
            found.activated = found.activated.saturating_add(1);
            if success {
                let _ = foreseen.insert(schema.result_item());
                return true;
            }
            found.failed = found.failed.saturating_add(1);
            let failures = schema.activations() - schema.successes();
            let kept = failures <= config.grace || schema.reliability() >= config.keep;
            if !kept {
                // More than fit find their way back through unforeseen changes.
                let _ = refuted.push(*schema);
            }
            kept
        });
        let unforeseen = sample.telling().difference(&foreseen);
        found.unforeseen = unforeseen.len();
        if let Some(reservoir) = self.reservoirs.get_mut(usize::from(action.0)) {
            let hardness = found.failed.saturating_add(found.unforeseen);
            reservoir.offer(sample, u8::try_from(hardness).unwrap_or(u8::MAX), rng);
        }
        (found, unforeseen, refuted)
    }

    /// Grows what a refuted schema meant from a remembered sample that it had explained.
    fn regrow(
        &mut self,
        refuted: &SimpleSchema,
        config: &AccommodationConfig,
        rng: &mut Rng,
    ) -> u16 {
        let Some(reservoir) = self.reservoirs.get(usize::from(refuted.action().0)) else {
            return 0;
        };
        let samples = reservoir.samples();
        let start = rng.below(samples.len() as u32) as usize;
        let explained = |it: &&E| {
            it.telling().contains(refuted.result_item())
                && refuted.applied(*it)
                && refuted.success(*it) == Some(true)
        };
        let mut from_start = samples.iter().cycle().skip(start).take(samples.len());
        match from_start.find(explained).copied() {
            Some(seed) => self.grow(refuted.action(), &seed, refuted.result_item(), config),
            None => 0,
        }
    }

    /// Grows a schema for a random change of `seed`; how many found a place.
    fn grow_from(
        &mut self,
        action: ActionId,
        seed: &E,
        config: &AccommodationConfig,
        rng: &mut Rng,
    ) -> u16 {
        let telling = seed.telling();
        let which = rng.below(u32::from(telling.len())) as usize;
        match telling.iter().nth(which) {
            Some(item) if !self.foresees(action, seed, item) => {
                self.grow(action, seed, item, config)
            }
            _ => 0,
        }
    }

    /// Whether everything that an action did is still in memory, so that explanations may multiply:
    /// later the unforeseen samples that are kept tell which of them hold.
    fn remembers_all(&self, action: ActionId) -> bool {
        let reservoir = self.reservoirs.get(usize::from(action.0));
        reservoir.is_some_and(|it| it.samples().len() < SAMPLES)
    }

    /// Grows another explanation of a change whose explanations have hardly been tried, without the
    /// items that they name.
    fn grow_alternative(
        &mut self,
        action: ActionId,
        seed: &E,
        item: ItemId,
        config: &AccommodationConfig,
    ) -> u16 {
        let mut eligible = ItemSet::first(ItemSet::<WORDS>::CAPACITY);
        let explains = |schema: &&SimpleSchema| {
            schema.action() == action
                && schema.result_item() == item
                && schema.applied(seed)
                && schema.success(seed) == Some(true)
        };
        for schema in self.schemas().iter().filter(explains) {
            if schema.successes() >= config.untested {
                return 0;
            }
            for (named, _) in schema.context().filter(|&(named, _)| named != item) {
                eligible.remove(named);
            }
        }
        self.grow_among(action, seed, item, &eligible, config)
    }

    /// Whether a schema predicts this change of `seed`: growing another would only crowd the table.
    fn foresees(&self, action: ActionId, seed: &E, item: ItemId) -> bool {
        self.schemas().iter().any(|schema| {
            schema.action() == action
                && schema.result_item() == item
                && schema.applied(seed)
                && schema.success(seed) == Some(true)
        })
    }

    fn grow(
        &mut self,
        action: ActionId,
        seed: &E,
        item: ItemId,
        config: &AccommodationConfig,
    ) -> u16 {
        let everything = ItemSet::first(ItemSet::<WORDS>::CAPACITY);
        self.grow_among(action, seed, item, &everything, config)
    }

    /// Grows a schema for a change of `seed` with a context of `eligible` items.
    fn grow_among(
        &mut self,
        action: ActionId,
        seed: &E,
        item: ItemId,
        eligible: &ItemSet<WORDS>,
        config: &AccommodationConfig,
    ) -> u16 {
        let Some(reservoir) = self.reservoirs.get(usize::from(action.0)) else {
            return 0;
        };
        let Some(sign) = seed.outcome(item) else {
            return 0;
        };
        let conclusion = Conclusion { action, item, sign };
        let samples = reservoir.samples();
        let attention = Attention::of(action, self.schemas());
        let growth = &config.growth;
        match grow(seed, conclusion, samples, eligible, attention, growth) {
            Some(schema) => u16::from(self.schemas.enter(schema) == Entry::Stored),
            None => 0,
        }
    }
}

impl<
    const WORDS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const ACTIONS: usize,
    E: Evidence<WORDS>,
> Default for Accommodation<WORDS, SAMPLES, SCHEMAS, ACTIONS, E>
{
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::{Accommodation, AccommodationConfig};
    use crate::growth::Transition;
    use crate::num::Rng;
    use crate::word::{ActionId, ItemId, ItemSet};

    /// A switch: the action toggles item 0, but only while item 1 is on; items 2 to 5 are noise.
    fn toggle(rng: &mut Rng, slip: f32) -> Transition<1> {
        let mut before = ItemSet::EMPTY;
        for item in 0..6 {
            if rng.chance(0.5) {
                before.insert(ItemId(item)).unwrap();
            }
        }
        let mut after = before;
        if before.contains(ItemId(1)) && !rng.chance(slip) {
            if before.contains(ItemId(0)) {
                after.remove(ItemId(0));
            } else {
                after.insert(ItemId(0)).unwrap();
            }
        }
        Transition { before, after }
    }

    fn learned(config: &AccommodationConfig, slip: f32) -> std::vec::Vec<(u16, bool, bool)> {
        let mut brain = Accommodation::<1, 32, 32, 1>::new();
        let mut rng = Rng::new(5);
        for _ in 0..600 {
            let sample = toggle(&mut rng, slip);
            brain.observe(ActionId(0), &sample, config, &mut rng);
        }
        let mut found: std::vec::Vec<_> = brain
            .schemas()
            .iter()
            .filter(|schema| schema.activations() > 100)
            .map(|it| {
                let text = it.text::<1>();
                let noise = text.context.positive().words()[0] >> 2 != 0
                    || text.context.negative().words()[0] >> 2 != 0;
                (text.context.len(), it.result_sign(), noise)
            })
            .collect();
        found.sort_unstable();
        found
    }

    #[test]
    fn a_switch_is_two_schemas_of_two_items_and_noise_stands_in_neither() {
        let expected = [(2, false, false), (2, true, false)];
        assert_eq!(learned(&AccommodationConfig::EXACT, 0.0), expected);
    }

    #[test]
    fn who_doubts_explains_a_change_twice_while_little_is_known() {
        // Items 0 and 1 are always on together before the action turns item 2 on.
        let explanations = |untested: u16| {
            let mut brain = Accommodation::<1, 32, 32, 1>::new();
            let (mut rng, config) = (
                Rng::new(5),
                AccommodationConfig {
                    untested,
                    ..AccommodationConfig::EXACT
                },
            );
            for step in 0..20 {
                let mut before = ItemSet::first(if step % 2 == 0 { 2 } else { 0 });
                before.insert(ItemId(3 + step / 2 % 4)).unwrap();
                let mut after = before;
                if step % 2 == 0 {
                    after.insert(ItemId(2)).unwrap();
                }
                let sample = Transition { before, after };
                brain.observe(ActionId(0), &sample, &config, &mut rng);
            }
            let named = |item| {
                let mut schemas = brain.schemas().iter();
                schemas.any(|it| it.context().any(|named| named == (ItemId(item), true)))
            };
            [named(0), named(1)]
        };
        assert_eq!(
            explanations(0),
            [true, false],
            "the first item is good enough"
        );
        assert_eq!(explanations(8), [true, true]);
    }

    #[test]
    fn where_actions_slip_only_the_tolerant_form_keeps_what_mostly_holds() {
        assert_eq!(learned(&AccommodationConfig::EXACT, 0.05), []);
        let tolerant = learned(&AccommodationConfig::TOLERANT, 0.05);
        let pure = tolerant
            .iter()
            .any(|&(items, _, noise)| items == 2 && !noise);
        assert!(pure, "{tolerant:?}");
    }

    #[test]
    fn an_action_that_the_brain_does_not_have_teaches_nothing() {
        let mut brain = Accommodation::<1, 4, 4, 1>::new();
        let mut rng = Rng::new(5);
        let sample = Transition {
            before: ItemSet::EMPTY,
            after: ItemSet::first(1),
        };
        brain.observe(ActionId(3), &sample, &AccommodationConfig::EXACT, &mut rng);
        assert!(brain.schemas().is_empty());
    }
}
