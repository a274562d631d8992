//! Drescher's Schema Mechanism: marginal attribution (Drescher 1991; book, 5.1.1), the baseline of
//! the Microworld.
//!
//! Bare schemas watch which items an action turns on and off (extended result) and spin off schemas
//! with that result; these watch which items make them succeed (extended context) and spin off
//! schemas with that item in the context.
//! Statistics are one byte a counter and halve together when one is full: packed as tightly as ours.
//! Literally, every activation is a trial; tuned, only one where the result does not hold already,
//! so that results are transitions and staying as it is counts for nothing.
//! Unreliable schemas may be reified as synthetic items, which are tracked like primitive ones, and
//! its schemas serve composite actions.
//! The contexts of reliable schemas may become results: what an action must bring about as a whole is
//! tracked like an item, so that chains find their links.

use cla_core::growth::{SimpleSchema, SyntheticItems, Transition};
use cla_core::word::{ActionId, ItemId, ItemStates, SchemaText, SignedItems};

use crate::world::microworld::{ACTIONS, ITEMS, Items, WORDS};

const ITEM_COUNT: usize = ITEMS.len();
/// The most synthetic items and tracked conjunctions together: what is left of an item set.
pub const SYNTHETIC: usize = WORDS * 32 - ITEM_COUNT;
/// All items that may be tracked.
const TRACKED: usize = ITEM_COUNT + SYNTHETIC;
/// Trials after which an unreliable schema is reified, and a reliable one's context may be a result.
const REIFIED_AFTER: u8 = 30;

/// How schemas spin off.
///
/// ```
/// use host_sim::baseline::drescher::Variant;
/// assert_ne!(Variant::Restricted, Variant::Unrestricted);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// As Drescher restrains it: the most relevant item only, nothing from reliable schemas, and a
    /// schema learns nothing from trials that a more specific one of its line explains.
    Restricted,
    /// Every relevant item of every schema.
    Unrestricted,
}

/// What counts as a trial of a schema.
///
/// ```
/// use host_sim::baseline::drescher::Trials;
/// assert_ne!(Trials::Every, Trials::Transitions);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trials {
    /// Every activation, as Drescher says: success is that the result obtains.
    Every,
    /// Activations where the result does not hold before.
    Transitions,
}

/// The parameters of marginal attribution.
///
/// ```
/// assert!(host_sim::baseline::drescher::DrescherConfig::RESTRICTED.relevance > 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrescherConfig {
    /// Which schemas may spin off.
    pub variant: Variant,
    /// What counts as a trial.
    pub counted: Trials,
    /// From how many standard errors between the success rates with and without an item it is
    /// relevant.
    pub relevance: f32,
    /// The least trials with the item, and without it.
    pub trials: u8,
    /// From this reliability on a restricted schema needs no more context.
    pub reliable: f32,
    /// No schema is made that would take more memory than this, bytes.
    pub memory: usize,
    /// Unreliable schemas that are reified, up to [`SYNTHETIC`].
    pub synthetic: usize,
    /// Contexts of reliable schemas that are tracked as results, up to [`SYNTHETIC`] less the
    /// synthetic items.
    pub conjunctions: usize,
}

impl DrescherConfig {
    /// The restricted variant, tuned on seeds below 100, with 8 MB.
    pub const RESTRICTED: Self = Self {
        variant: Variant::Restricted,
        counted: Trials::Transitions,
        relevance: 3.0,
        trials: 2,
        reliable: 0.95,
        memory: 8_000_000,
        synthetic: 0,
        conjunctions: 0,
    };
    /// The restricted variant as Drescher words it.
    pub const LITERAL: Self = Self {
        counted: Trials::Every,
        ..Self::RESTRICTED
    };
    /// The restricted variant with synthetic items.
    pub const COMPLETE: Self = Self {
        synthetic: SYNTHETIC,
        ..Self::RESTRICTED
    };
    /// The restricted variant with conjunctive results.
    pub const CONJUNCTIVE: Self = Self {
        conjunctions: SYNTHETIC,
        ..Self::RESTRICTED
    };
    /// The unrestricted variant.
    pub const UNRESTRICTED: Self = Self {
        variant: Variant::Unrestricted,
        ..Self::RESTRICTED
    };
}

impl DrescherConfig {
    /// Items, synthetic items and conjunctions that results are attributed to.
    const fn tracked(&self) -> usize {
        ITEM_COUNT + self.synthetic + self.conjunctions
    }
}

/// Successes among trials, a byte each.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    trials: u8,
    successes: u8,
}

impl Count {
    fn halve(&mut self) {
        self.trials /= 2;
        self.successes /= 2;
    }
}

/// A schema with its extended context.
#[derive(Clone, Debug)]
struct Attributing {
    schema: SimpleSchema,
    all: Count,
    /// Trials with the item on; those with the item off are the rest of `all`.
    on: [Count; TRACKED],
    /// Items that have spun off, on and off.
    spun_on: Items,
    spun_off: Items,
}

/// What one action does to each item, whatever the context (extended result).
#[derive(Clone, Debug, Default)]
struct Bare {
    trials: u32,
    turned: Vec<[u32; 2]>,
}

/// The mechanism.
///
/// ```
/// use cla_core::growth::Transition;
/// use cla_core::word::ActionId;
/// use host_sim::baseline::drescher::{Drescher, DrescherConfig};
/// use host_sim::world::microworld::{Items, item};
/// let mut mechanism = Drescher::new(DrescherConfig::RESTRICTED);
/// let mut closed = Items::EMPTY;
/// closed.insert(item("hcl").unwrap())?;
/// for _ in 0..5 {
///     mechanism.learn(ActionId(8), &Transition { before: Items::EMPTY, after: closed });
///     mechanism.learn(ActionId(9), &Transition { before: closed, after: Items::EMPTY });
/// }
/// assert_eq!(mechanism.schemas().len(), 2); // /grasp/+hcl and /ungrasp/-hcl
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Debug)]
pub struct Drescher {
    config: DrescherConfig,
    bare: Vec<Bare>,
    schemas: Vec<Attributing>,
    items: SyntheticItems<WORDS, SYNTHETIC>,
    /// Contexts that are tracked as results; the first one's id follows the synthetic items.
    conjunctions: Vec<SignedItems<WORDS>>,
}

impl Drescher {
    /// A mechanism with one bare schema for each action.
    #[must_use]
    pub fn new(config: DrescherConfig) -> Self {
        let bare = Bare {
            trials: 0,
            turned: vec![[0; 2]; config.tracked()],
        };
        assert!(config.tracked() <= TRACKED, "more items than fit their set");
        Self {
            config,
            bare: vec![bare; ACTIONS.len()],
            schemas: Vec::new(),
            items: SyntheticItems::new(ITEM_COUNT as u16),
            conjunctions: Vec::new(),
        }
    }

    /// Bytes of one schema with its statistics: the packed schema, a trial and a success counter for
    /// each item and one pair for all, two bits an item for what has spun off.
    #[must_use]
    pub const fn schema_bytes(&self) -> usize {
        let items = ITEM_COUNT + self.config.synthetic;
        size_of::<SimpleSchema>() + 2 * (items + 1) + 2 * size_of::<Items>()
    }

    /// Bytes of one bare schema: turned on and turned off, with two-byte counters.
    const fn bare_bytes(&self) -> usize {
        4 * self.config.tracked() + 4
    }

    /// Its memory, bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let items = self.items.as_slice();
        ACTIONS.len() * self.bare_bytes()
            + self.schemas.len() * self.schema_bytes()
            + size_of_val(items)
            + size_of_val(self.conjunctions.as_slice())
    }

    /// All schemas, those about synthetic items included.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.schemas.len()
    }

    /// Whether there is no schema yet.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.schemas.is_empty()
    }

    /// Its synthetic items.
    #[must_use]
    pub const fn items(&self) -> &SyntheticItems<WORDS, SYNTHETIC> {
        &self.items
    }

    /// Its schemas with at least `trials` trials, as composite actions chain them.
    #[must_use]
    pub fn chainable(&self, trials: u8) -> Vec<SimpleSchema> {
        let tried = self.schemas.iter().filter(|it| it.all.trials >= trials);
        let packed = tried.flat_map(|it| {
            let text = self.text(it);
            let single = single_results(&text).filter_map(|text| SimpleSchema::pack(&text));
            single
                .map(|mut schema| {
                    for trial in 0..it.all.trials {
                        schema.record(trial < it.all.successes);
                    }
                    schema
                })
                .collect::<Vec<_>>()
        });
        packed.collect()
    }

    /// Its schemas with a conjunction for their result.
    #[must_use]
    pub fn conjunctive(&self) -> Vec<SchemaText<WORDS>> {
        let texts = self.schemas.iter().map(|it| self.text(it));
        texts.filter(|text| text.result.len() > 1).collect()
    }

    /// What a schema says; a conjunction is spelled out.
    fn text(&self, schema: &Attributing) -> SchemaText<WORDS> {
        let mut text = schema.text(self.config.counted);
        let result = schema.schema.result_item();
        if let Some(conjunction) = self.conjunction(result) {
            // That not all of it held before cannot be said in a context.
            text.context.remove(result);
            text.result = *conjunction;
        }
        text
    }

    /// The conjunction that an id stands for.
    fn conjunction(&self, item: ItemId) -> Option<&SignedItems<WORDS>> {
        let first = ITEM_COUNT + self.config.synthetic;
        self.conjunctions
            .get(usize::from(item.0).checked_sub(first)?)
    }

    /// Whether a schema names no synthetic item.
    fn is_primitive(&self, schema: &Attributing) -> bool {
        let text = self.text(schema);
        let primitive = Items::first(ITEM_COUNT as u16);
        [&text.context, &text.result].into_iter().all(|side| {
            side.positive().is_subset(&primitive) && side.negative().is_subset(&primitive)
        })
    }

    /// What each schema of primitive items says; where it speaks of transitions, with the prior state of its result
    /// item in its context.
    #[must_use]
    pub fn schemas(&self) -> Vec<SchemaText<WORDS>> {
        let primitive = self.schemas.iter().filter(|it| self.is_primitive(it));
        primitive.map(|it| self.text(it)).collect()
    }

    /// The schemas that it holds reliable itself after at least `trials` trials.
    #[must_use]
    pub fn believed(&self, reliability: f32, trials: u8) -> Vec<SchemaText<WORDS>> {
        let believed = self
            .schemas
            .iter()
            .filter(|it| self.is_primitive(it))
            .filter(|it| it.all.trials >= trials && it.reliability() >= reliability);
        believed.map(|it| self.text(it)).collect()
    }

    /// Learns from one action; synthetic items that nobody knows count as off.
    pub fn learn(&mut self, action: ActionId, step: &Transition<WORDS>) {
        if self.config.synthetic == 0 {
            self.learn_completed(action, *step);
            return;
        }
        let sensed = |on: &Items| ItemStates::from_sets(on, &Items::first(ITEM_COUNT as u16));
        let (before, after) = (sensed(&step.before), sensed(&step.after));
        let before = self.items.view(&before);
        self.items.complete(&before, action, &after);
        let after = self.items.view(&after);
        let (before, after) = (*before.on(), *after.on());
        self.learn_completed(action, Transition { before, after });
        self.reify();
    }

    /// Adds the conjunctions that hold.
    fn learn_completed(&mut self, action: ActionId, mut step: Transition<WORDS>) {
        if self.config.conjunctions > 0 {
            let first = ITEM_COUNT + self.config.synthetic;
            for (place, conjunction) in self.conjunctions.iter().enumerate() {
                for on in [&mut step.before, &mut step.after] {
                    let holds = conjunction.positive().is_subset(on)
                        && conjunction.negative().is_disjoint(on);
                    if holds {
                        let id = ItemId((first + place) as u16);
                        on.insert(id).expect("the item sets have room for it");
                    }
                }
            }
        }
        self.learn_all(action, &step);
        self.track();
    }

    /// Tracks the first context of several items that many trials show to be enough.
    fn track(&mut self) {
        if self.conjunctions.len() >= self.config.conjunctions {
            return;
        }
        let reliable = self.schemas.iter().find_map(|it| {
            let context = it.schema.text().context;
            let is_new = context.len() > 1 && !self.conjunctions.contains(&context);
            let proved = it.all.trials >= REIFIED_AFTER && it.reliability() >= self.config.reliable;
            (is_new && proved && self.is_primitive(it)).then_some(context)
        });
        self.conjunctions.extend(reliable);
    }

    /// Makes a synthetic item of the first schema that many trials show to be unreliable.
    fn reify(&mut self) {
        if self.items.as_slice().len() >= self.config.synthetic {
            return;
        }
        let reliable = self.config.reliable;
        let unreliable = self.schemas.iter().find(|it| {
            let between = (1.0 - reliable..reliable).contains(&it.reliability());
            let text = it.text(self.config.counted);
            let known = self.items.as_slice();
            it.all.trials >= REIFIED_AFTER
                && between
                && self.is_primitive(it)
                && known.iter().all(|item| *item.schema() != text)
        });
        if let Some(text) = unreliable.map(|it| it.text(self.config.counted)) {
            self.items
                .reify(&text)
                .expect("the item sets have room for it");
        }
    }

    fn learn_all(&mut self, action: ActionId, step: &Transition<WORDS>) {
        self.attribute_results(action, step);
        let applicable: Vec<usize> = (0..self.schemas.len())
            .filter(|&index| {
                let schema = &self.schemas[index].schema;
                let counts = self.config.counted == Trials::Every || !schema.succeeds(&step.before);
                counts && schema.action() == action && schema.applies(&step.before)
            })
            .collect();
        let mut born = Vec::new();
        for &index in &applicable {
            let own = &self.schemas[index];
            // A more specific schema of the same line explains this trial.
            let deferred = self.config.variant == Variant::Restricted
                && applicable
                    .iter()
                    .any(|&other| other != index && own.schema.covers(&self.schemas[other].schema));
            let success = own.schema.succeeds(&step.after);
            let own = &mut self.schemas[index];
            own.count(&step.before, success, deferred);
            if !deferred {
                own.spin_off(&self.config, &mut born);
            }
        }
        for schema in born {
            self.add(schema);
        }
    }

    /// Spins off `/action/±item` for what the action does more often than the other actions.
    fn attribute_results(&mut self, action: ActionId, step: &Transition<WORDS>) {
        let own = usize::from(action.0);
        self.bare[own].trials += 1;
        for item in step.changed().iter() {
            let sign = step.after.contains(item);
            // That a conjunction has ended is no conjunction.
            if !sign && self.conjunction(item).is_some() {
                continue;
            }
            let item = usize::from(item.0);
            self.bare[own].turned[item][usize::from(sign)] += 1;
            let rate = |bare: &Bare| {
                f64::from(bare.turned[item][usize::from(sign)]) / f64::from(bare.trials.max(1))
            };
            let others: f64 = self.bare.iter().map(rate).sum::<f64>() - rate(&self.bare[own]);
            let mean = others / (ACTIONS.len() - 1) as f64;
            if self.bare[own].turned[item][usize::from(sign)] >= 2 && rate(&self.bare[own]) > mean {
                let mut result = SignedItems::EMPTY;
                result
                    .insert(ItemId(item as u16), sign)
                    .expect("the Microworld's items fit its words");
                self.add(SchemaText {
                    context: SignedItems::EMPTY,
                    action,
                    result,
                });
            }
        }
    }

    fn add(&mut self, text: SchemaText<WORDS>) {
        let Some(schema) = SimpleSchema::pack(&text) else {
            return;
        };
        let known = self.schemas.iter().any(|it| it.schema.says_as(&schema));
        if !known && self.bytes() + self.schema_bytes() <= self.config.memory {
            self.schemas.push(Attributing {
                schema,
                all: Count::default(),
                on: [Count::default(); TRACKED],
                spun_on: Items::EMPTY,
                spun_off: Items::EMPTY,
            });
        }
    }
}

/// The same schema once for each of its result items.
fn single_results(text: &SchemaText<WORDS>) -> impl Iterator<Item = SchemaText<WORDS>> + use<> {
    let on = text.result.positive().iter().map(|item| (item, true));
    let off = text.result.negative().iter().map(|item| (item, false));
    let all: Vec<_> = on.chain(off).collect();
    let text = *text;
    all.into_iter().map(move |(item, sign)| {
        let mut result = SignedItems::EMPTY;
        result
            .insert(item, sign)
            .expect("it was in a set of the same size");
        SchemaText { result, ..text }
    })
}

impl Attributing {
    fn text(&self, counted: Trials) -> SchemaText<WORDS> {
        let mut text = self.schema.text();
        if counted == Trials::Every {
            return text;
        }
        text.context
            .insert(self.schema.result_item(), !self.schema.result_sign())
            .expect("the Microworld's items fit its words");
        text
    }

    fn reliability(&self) -> f32 {
        f32::from(self.all.successes) / f32::from(self.all.trials.max(1))
    }

    fn count(&mut self, before: &Items, success: bool, deferred: bool) {
        if self.all.trials == u8::MAX {
            self.all.halve();
            self.on.iter_mut().for_each(Count::halve);
        }
        if deferred {
            return;
        }
        self.all.trials += 1;
        self.all.successes += u8::from(success);
        for item in before.iter() {
            let count = &mut self.on[usize::from(item.0)];
            count.trials += 1;
            count.successes += u8::from(success);
        }
    }

    /// Schemas with one more context item, for the items that are relevant now.
    fn spin_off(&mut self, config: &DrescherConfig, born: &mut Vec<SchemaText<WORDS>>) {
        let restricted = config.variant == Variant::Restricted;
        if restricted && self.reliability() >= config.reliable {
            return;
        }
        let mut best: Option<(f32, ItemId, bool)> = None;
        for item in (0..(ITEM_COUNT + config.synthetic) as u16).map(ItemId) {
            let Some((z, sign)) = self.relevance(item, config.trials) else {
                continue;
            };
            let spun = if sign { &self.spun_on } else { &self.spun_off };
            if z < config.relevance || spun.contains(item) {
                continue;
            }
            if !restricted {
                self.spin(item, sign, born);
            } else if best.is_none_or(|(most, _, _)| z > most) {
                best = Some((z, item, sign));
            }
        }
        if let Some((_, item, sign)) = best {
            self.spin(item, sign, born);
        }
    }

    fn spin(&mut self, item: ItemId, sign: bool, born: &mut Vec<SchemaText<WORDS>>) {
        let spun = if sign {
            &mut self.spun_on
        } else {
            &mut self.spun_off
        };
        let fits = "the Microworld's items fit its words";
        spun.insert(item).expect(fits);
        let mut text = self.schema.text();
        text.context.insert(item, sign).expect(fits);
        born.push(text);
    }

    /// Standard errors between the success rates with the item on and off, and with which it is
    /// higher; `None` with too few trials.
    fn relevance(&self, item: ItemId, trials: u8) -> Option<(f32, bool)> {
        let on = self.on[usize::from(item.0)];
        let off = Count {
            trials: self.all.trials.saturating_sub(on.trials),
            successes: self.all.successes.saturating_sub(on.successes),
        };
        if on.trials < trials || off.trials < trials {
            return None;
        }
        let rate = |it: Count| (f32::from(it.successes) + 0.5) / (f32::from(it.trials) + 1.0);
        let variance = |it: Count| rate(it) * (1.0 - rate(it)) / (f32::from(it.trials) + 1.0);
        let difference = rate(on) - rate(off);
        let z = difference.abs() / (variance(on) + variance(off)).sqrt();
        Some((z, difference > 0.0))
    }
}

#[cfg(test)]
#[path = "drescher_tests.rs"]
mod tests;
