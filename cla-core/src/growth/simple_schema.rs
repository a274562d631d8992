//! Simple schemas: one result item, at most seven context items, packed into 16 bytes (book, 5.4.4).
//!
//! "Simpler schemas are easy to derive from the final product": a schema whose context says no more
//! than it must applies more often and costs less memory than a harvested one.
//! Owns the packing, the bounded table and the competition in it: the more general replaces the
//! more specific, and a full table keeps what has succeeded most.
//! How contexts are found is not its business (see `grow`).

use super::evidence::Evidence;
use crate::snapshot::stored;
use crate::word::{ActionId, ItemId, ItemSet, SchemaText, SignedItems};

/// An item index that stands for no item: a simple schema speaks of items 0 to 254.
const NONE: u8 = u8::MAX;
/// The bit of `signs` that holds the result's sign.
const RESULT: u8 = 1 << SimpleSchema::CONTEXT_ITEMS;

/// A schema with one result item, and its trials.
///
/// In the field: a decision rule with one conclusion, for one action.
///
/// ```
/// use cla_core::growth::SimpleSchema;
/// use cla_core::word::{SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["hp23", "hp33"], actions: &["handr"] };
/// let text = SchemaText::<1>::parse("+hp23-hp33/handr/+hp33", &words)?;
/// let schema = SimpleSchema::pack(&text).unwrap();
/// assert_eq!(schema.text(), text);
/// assert_eq!(core::mem::size_of::<SimpleSchema>(), 16);
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SimpleSchema {
    /// Context items in ascending order within each sign, then [`NONE`].
    context: [u8; Self::CONTEXT_ITEMS],
    result: u8,
    /// Bit i: context item i must be on; bit 7: the result item is on.
    signs: u8,
    action: u8,
    /// Successes since it last was the best explanation of a change, up to 255.
    idle: u8,
    successes: u16,
    activations: u16,
}

impl SimpleSchema {
    /// The most context items.
    pub const CONTEXT_ITEMS: usize = 7;

    /// Packs a schema without trials; `None` when it does not have exactly one result item, has
    /// more than seven context items, or names an item above 254 or an action above 255.
    #[must_use]
    pub fn pack<const WORDS: usize>(text: &SchemaText<WORDS>) -> Option<Self> {
        if text.result.len() != 1 {
            return None;
        }
        let on = text.result.positive().iter().next();
        let result = on.or_else(|| text.result.negative().iter().next())?;
        let mut it = Self {
            context: [NONE; Self::CONTEXT_ITEMS],
            result: index(result)?,
            signs: if on.is_some() { RESULT } else { 0 },
            action: u8::try_from(text.action.0).ok()?,
            idle: 0,
            successes: 0,
            activations: 0,
        };
        let positive = text.context.positive().iter().map(|item| (item, true));
        let negative = text.context.negative().iter().map(|item| (item, false));
        for (place, (item, sign)) in positive.chain(negative).enumerate() {
            *it.context.get_mut(place)? = index(item)?;
            it.signs |= u8::from(sign) << place;
        }
        Some(it)
    }

    /// What the schema says, spelled out; items that do not fit `WORDS` are left out.
    #[must_use]
    pub fn text<const WORDS: usize>(&self) -> SchemaText<WORDS> {
        let mut context = SignedItems::EMPTY;
        for (item, sign) in self.context() {
            let _ = context.insert(item, sign);
        }
        let mut result = SignedItems::EMPTY;
        let _ = result.insert(self.result_item(), self.result_sign());
        SchemaText {
            context,
            action: self.action(),
            result,
        }
    }

    /// The context items with their signs.
    pub fn context(&self) -> impl Iterator<Item = (ItemId, bool)> + '_ {
        let items = self.context.iter().take_while(|&&item| item != NONE);
        items
            .enumerate()
            .map(|(place, &item)| (ItemId(item.into()), self.signs >> place & 1 == 1))
    }

    /// What is done.
    #[must_use]
    pub const fn action(&self) -> ActionId {
        ActionId(self.action as u16)
    }

    /// The item that it speaks of.
    #[must_use]
    pub const fn result_item(&self) -> ItemId {
        ItemId(self.result as u16)
    }

    /// Whether that item is on afterwards.
    #[must_use]
    pub const fn result_sign(&self) -> bool {
        self.signs & RESULT != 0
    }

    /// Whether the context holds when exactly these items are on.
    #[must_use]
    pub fn applies<const WORDS: usize>(&self, on: &ItemSet<WORDS>) -> bool {
        self.context().all(|(item, sign)| on.contains(item) == sign)
    }

    /// Whether the result holds when exactly these items are on.
    #[must_use]
    pub fn succeeds<const WORDS: usize>(&self, on: &ItemSet<WORDS>) -> bool {
        on.contains(self.result_item()) == self.result_sign()
    }

    /// Whether the context is known to have held before an action.
    #[must_use]
    pub fn applied<const WORDS: usize, E: Evidence<WORDS>>(&self, sample: &E) -> bool {
        self.holds_in(&sample.on_before(), &sample.off_before())
    }

    pub(crate) fn holds_in<const WORDS: usize>(
        &self,
        on: &ItemSet<WORDS>,
        off: &ItemSet<WORDS>,
    ) -> bool {
        self.context().all(|(item, sign)| {
            let side = if sign { on } else { off };
            side.contains(item)
        })
    }

    /// Whether the result came; `None` when nobody knows.
    #[must_use]
    pub fn success<const WORDS: usize, E: Evidence<WORDS>>(&self, sample: &E) -> Option<bool> {
        let outcome = sample.outcome(self.result_item())?;
        Some(outcome == self.result_sign())
    }

    /// Adds a trial; full counters are halved, so that their share is kept.
    pub fn record(&mut self, success: bool) {
        if self.activations == u16::MAX {
            self.activations /= 2;
            self.successes /= 2;
        }
        self.activations += 1;
        self.successes = self.successes.saturating_add(u16::from(success));
    }

    /// Counts remembered samples that agree, before the first trial.
    pub(crate) fn begin_with(&mut self, successes: u16, activations: u16) {
        self.successes = successes;
        self.activations = activations;
    }

    /// Successes since it last was the best explanation of a change, up to 255.
    pub(crate) const fn idle(&self) -> u8 {
        self.idle
    }

    /// It succeeded, and another explained it better, or not.
    pub(crate) const fn was_idle(&mut self, idle: bool) {
        self.idle = if idle { self.idle.saturating_add(1) } else { 0 };
    }

    /// Trials, the remembered samples that it was grown from included.
    #[must_use]
    pub const fn activations(&self) -> u16 {
        self.activations
    }

    /// Trials in which the result came.
    #[must_use]
    pub const fn successes(&self) -> u16 {
        self.successes
    }

    /// Successes / activations in `[0, 1]`; 1 before the first trial.
    #[must_use]
    pub fn reliability(&self) -> f32 {
        if self.activations == 0 {
            1.0
        } else {
            f32::from(self.successes) / f32::from(self.activations)
        }
    }

    /// Whether both say the same, whatever their trials.
    #[must_use]
    pub fn says_as(&self, other: &Self) -> bool {
        self.context == other.context
            && self.result == other.result
            && self.signs == other.signs
            && self.action == other.action
    }

    /// Whether this says the same as the other of more states: same action and result, and every
    /// context item stands in the other's context.
    #[must_use]
    pub fn covers(&self, other: &Self) -> bool {
        self.action == other.action
            && self.result == other.result
            && self.result_sign() == other.result_sign()
            && self
                .context()
                .all(|mine| other.context().any(|its| its == mine))
    }
}

fn index(item: ItemId) -> Option<u8> {
    u8::try_from(item.0).ok().filter(|&item| item != NONE)
}

/// What became of a schema that asked for a place in the table.
///
/// ```
/// use cla_core::growth::Entry;
/// assert_ne!(Entry::Covered, Entry::Stored);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entry {
    /// It has a place of its own; more specific ones have left.
    Stored,
    /// One that is at least as general was there already.
    Covered,
    /// The table is full of schemas that have succeeded.
    Refused,
}

/// A bounded table of simple schemas, at most 65,534.
///
/// ```
/// use cla_core::growth::{Entry, SimpleSchema, SimpleSchemas};
/// use cla_core::word::{SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["vp23", "vf22", "vp33"], actions: &["eyer"] };
/// let pack = |text| SimpleSchema::pack(&SchemaText::<1>::parse(text, &words).unwrap()).unwrap();
/// let mut table = SimpleSchemas::<4>::new();
/// assert_eq!(table.enter(pack("+vp23+vf22/eyer/+vp33")), Entry::Stored);
/// assert_eq!(table.enter(pack("+vp23/eyer/+vp33")), Entry::Stored); // replaces the first
/// assert_eq!(table.enter(pack("+vp23-vf22/eyer/+vp33")), Entry::Covered);
/// assert_eq!(table.as_slice().len(), 1);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SimpleSchemas<const SCHEMAS: usize> {
    table: heapless::Vec<SimpleSchema, SCHEMAS, u16>,
    evicted: u32,
    refused: u32,
}

impl<const SCHEMAS: usize> SimpleSchemas<SCHEMAS> {
    /// An empty table.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                SCHEMAS > 0 && SCHEMAS < u16::MAX as usize,
                "1 to 65,534 schemas"
            );
        }
        Self {
            table: heapless::Vec::new(),
            evicted: 0,
            refused: 0,
        }
    }

    /// All schemas, in no order that means anything.
    #[must_use]
    pub fn as_slice(&self) -> &[SimpleSchema] {
        &self.table
    }

    /// Schemas that made room for others, and schemas that found none.
    #[must_use]
    pub const fn losses(&self) -> (u32, u32) {
        (self.evicted, self.refused)
    }

    /// Gives a schema a place unless one that is as general has it.
    ///
    /// A full table evicts the schema that has been idle longest: one that succeeds, but never
    /// where another with more successes does not.
    /// Of equally idle ones the one with the fewest successes leaves, then the first.
    pub fn enter(&mut self, new: SimpleSchema) -> Entry {
        if self.table.iter().any(|old| old.covers(&new)) {
            return Entry::Covered;
        }
        self.table.retain(|old| !new.covers(old));
        let Err(new) = self.table.push(new) else {
            return Entry::Stored;
        };
        let uselessness = |old: &&mut SimpleSchema| (u8::MAX - old.idle, old.successes);
        match self.table.iter_mut().min_by_key(uselessness) {
            Some(old) if old.idle > 0 || old.successes <= new.successes => {
                *old = new;
                self.evicted = self.evicted.saturating_add(1);
                Entry::Stored
            }
            _ => {
                self.refused = self.refused.saturating_add(1);
                Entry::Refused
            }
        }
    }

    /// Lets every schema of an action that applied see what came of it, and drops those that
    /// `keep` does not want any more; a schema whose result nobody knows has no trial.
    ///
    /// Of the schemas that foresaw the same telling item the one with the most successes explains
    /// it; the others were idle.
    pub fn record<const WORDS: usize, E: Evidence<WORDS>>(
        &mut self,
        action: ActionId,
        sample: &E,
        mut keep: impl FnMut(&SimpleSchema, bool) -> bool,
    ) {
        let (on, off, telling) = (sample.on_before(), sample.off_before(), sample.telling());
        // Successes of the best explanation of each item.
        let mut best = [[0_u16; 32]; WORDS];
        self.table.retain_mut(|schema| {
            if schema.action() != action || !schema.holds_in(&on, &off) {
                return true;
            }
            let Some(success) = schema.success(sample) else {
                return true;
            };
            schema.record(success);
            let slot = best.as_flattened_mut().get_mut(usize::from(schema.result));
            if let (true, Some(most)) = (success, slot) {
                *most = schema.successes.max(*most);
            }
            keep(schema, success)
        });
        for schema in &mut self.table {
            if schema.action() != action || !telling.contains(schema.result_item()) {
                continue;
            }
            let slot = best.as_flattened_mut().get_mut(usize::from(schema.result));
            let Some(most) = slot else { continue };
            if schema.holds_in(&on, &off) && schema.success(sample) == Some(true) {
                let explains = schema.successes == *most;
                schema.was_idle(!explains);
                if explains {
                    // Of equally successful ones the first explains.
                    *most = u16::MAX;
                }
            }
        }
    }

    /// Forgets all schemas; counted losses stay.
    pub fn clear(&mut self) {
        self.table.clear();
    }
}

impl<const SCHEMAS: usize> Default for SimpleSchemas<SCHEMAS> {
    fn default() -> Self {
        Self::new()
    }
}

impl SimpleSchema {
    /// Whether its trials and its action, one of so many, can be so.
    pub(crate) fn can_be(&self, actions: u16) -> bool {
        self.successes <= self.activations && u16::from(self.action) < actions
    }
}

stored! {
    impl[] SimpleSchema { context, result, signs, action, idle, successes, activations }
    sound |it, limits| it.can_be(limits.actions)
}

#[cfg(test)]
mod tests {
    use super::{Entry, SimpleSchema, SimpleSchemas};
    use crate::growth::Transition;
    use crate::word::{ItemId, ItemSet, SchemaText, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["a", "b", "c", "d", "e", "f", "g", "h", "i"],
        actions: &["x", "y"],
    };

    fn pack(text: &str) -> Option<SimpleSchema> {
        SimpleSchema::pack(&SchemaText::<1>::parse(text, &WORDS).unwrap())
    }

    fn on(items: &[u16]) -> ItemSet<1> {
        let mut set = ItemSet::EMPTY;
        for &item in items {
            set.insert(ItemId(item)).unwrap();
        }
        set
    }

    fn from_to(before: &[u16], after: &[u16]) -> Transition<1> {
        Transition {
            before: on(before),
            after: on(after),
        }
    }

    #[test]
    fn seven_context_items_fit_and_eight_do_not() {
        let seven = pack("+a-b+c-d+e-f+g/y/-i").unwrap();
        assert_eq!(
            seven.text(),
            SchemaText::<1>::parse("+a-b+c-d+e-f+g/y/-i", &WORDS).unwrap()
        );
        assert_eq!(pack("+a+b+c+d+e+f+g+h/x/+i"), None);
        assert_eq!(pack("+a/x/+b+c"), None, "two results");
    }

    #[test]
    fn a_negative_item_must_be_off() {
        let schema = pack("+a-b/x/-a").unwrap();
        assert!(schema.applies(&on(&[0, 2])) && !schema.applies(&on(&[0, 1])));
        assert!(schema.succeeds(&on(&[1])) && !schema.succeeds(&on(&[0])));
    }

    #[test]
    fn schemas_of_other_actions_or_results_do_not_compete() {
        let mut table = SimpleSchemas::<8>::new();
        for text in ["/x/+a", "+b/y/+a", "+b/x/-a", "+b/x/+c"] {
            assert_eq!(table.enter(pack(text).unwrap()), Entry::Stored, "{text}");
        }
        assert_eq!(table.enter(pack("+b/x/+a").unwrap()), Entry::Covered);
    }

    #[test]
    fn a_full_table_evicts_what_explains_nothing_of_its_own() {
        let mut table = SimpleSchemas::<2>::new();
        table.enter(pack("+a/x/+b").unwrap());
        table.enter(pack("+c/x/+b").unwrap());
        let x = crate::word::ActionId(0);
        table.record(x, &from_to(&[0], &[0, 1]), |_, ok| ok);
        for _ in 0..3 {
            table.record(x, &from_to(&[0, 2], &[0, 1, 2]), |_, ok| ok);
        }
        assert_eq!(table.enter(pack("+e/x/+f").unwrap()), Entry::Stored);
        assert_eq!(
            table.as_slice(),
            [table.as_slice()[0], pack("+e/x/+f").unwrap()]
        );
        assert_eq!(table.as_slice()[0].successes(), 4);
        table.record(x, &from_to(&[4], &[4, 5]), |_, ok| ok);
        assert_eq!(table.enter(pack("+g/x/+h").unwrap()), Entry::Refused);
        assert_eq!(table.losses(), (1, 1));
    }
}
