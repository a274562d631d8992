//! Synthetic items with three values: hypothetical states in which a schema would succeed (book,
//! 5.1.1, 5.3.1; after Drescher 1991).
//!
//! `[schema]` is off where the schema's context does not hold, on or off by its last trial for a
//! limited time, then unknown; a schema that predicts it may set it too.
//! Owns the items, their values now (prospective: nothing of the future), and what an action
//! revealed about the moment before it; the waiting for that is `hindsight`'s work.

use core::fmt;

use crate::growth::evidence::Evidence;
use crate::growth::simple_schema::SimpleSchema;
use crate::word::{ActionId, ItemId, ItemSet, ItemStates, SchemaText};

/// The table of synthetic items is full, or the item's index does not fit the item sets; nothing
/// has changed.
///
/// ```
/// assert_eq!(cla_core::growth::NoRoomForItem.to_string(), "there is no room for another synthetic item");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoRoomForItem;

impl fmt::Display for NoRoomForItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("there is no room for another synthetic item")
    }
}

impl core::error::Error for NoRoomForItem {}

/// One synthetic item: the schema that it stands for, and what was last known of it.
///
/// In the field: a latent state variable, defined by the test that reveals it (a predictive state).
///
/// ```
/// use cla_core::growth::SyntheticItems;
/// use cla_core::word::{SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["door", "open"], actions: &["push"] };
/// let mut items = SyntheticItems::<1, 4>::new(2);
/// items.reify(&SchemaText::parse("+door/push/+open", &words)?).unwrap();
/// assert_eq!(items.as_slice()[0].last(), None); // nobody has pushed
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SyntheticItem<const WORDS: usize> {
    schema: SchemaText<WORDS>,
    last: Option<bool>,
    /// Actions since it was set.
    age: u8,
}

impl<const WORDS: usize> SyntheticItem<WORDS> {
    /// The schema whose success it stands for.
    #[must_use]
    pub const fn schema(&self) -> &SchemaText<WORDS> {
        &self.schema
    }

    /// What the last trial or prediction said, `None` when that is too long ago.
    #[must_use]
    pub const fn last(&self) -> Option<bool> {
        self.last
    }

    /// Whether the schema succeeded; `None` when it was not tried: another action, a context that
    /// did not hold or that nobody knew, a result that nobody knows.
    #[must_use]
    pub fn tried(
        &self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> Option<bool> {
        let applied = self.schema.action == action && self.schema.context.truth(before)?;
        if applied {
            self.schema.result.truth(after)
        } else {
            None
        }
    }
}

/// Up to `ITEMS` synthetic items, numbered after the primitive ones in sets of `WORDS` words.
///
/// ```
/// use cla_core::growth::SyntheticItems;
/// use cla_core::word::{ActionId, ItemId, ItemStates, SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["door", "open"], actions: &["push", "wait"] };
/// let mut items = SyntheticItems::<1, 4>::new(2);
/// let openable = items.reify(&SchemaText::parse("+door/push/+open", &words)?).unwrap();
/// let away = ItemStates::all_off(2);
/// let mut at_door = away;
/// at_door.set(ItemId(0), Some(true))?;
/// let mut opened = at_door;
/// opened.set(ItemId(1), Some(true))?;
/// assert_eq!(items.view(&away).get(openable), Some(false)); // no door, nothing to open
/// assert_eq!(items.view(&at_door).get(openable), None);
/// items.complete(&at_door, ActionId(0), &opened);
/// assert_eq!(items.view(&opened).get(openable), Some(true));
/// for _ in 0..10 {
///     items.complete(&opened, ActionId(1), &opened);
/// }
/// assert_eq!(items.view(&opened).get(openable), None); // that was long ago
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntheticItems<const WORDS: usize, const ITEMS: usize> {
    items: heapless::Vec<SyntheticItem<WORDS>, ITEMS, u16>,
    /// The primitive items: the first synthetic item has this index.
    first: u16,
}

impl<const WORDS: usize, const ITEMS: usize> SyntheticItems<WORDS, ITEMS> {
    /// Actions for which a trial says what an item is.
    pub const HORIZON: u8 = 10;

    /// No synthetic item, `primitive` items before the first.
    #[must_use]
    pub const fn new(primitive: u16) -> Self {
        Self {
            items: heapless::Vec::new(),
            first: primitive,
        }
    }

    /// The items in the order of their indices.
    #[must_use]
    pub fn as_slice(&self) -> &[SyntheticItem<WORDS>] {
        &self.items
    }

    /// The index of the first synthetic item.
    #[must_use]
    pub const fn first(&self) -> ItemId {
        ItemId(self.first)
    }

    /// The indices of all of them.
    #[must_use]
    pub fn ids(&self) -> ItemSet<WORDS> {
        let all = ItemSet::first(self.first + self.items.len() as u16);
        all.difference(&ItemSet::first(self.first))
    }

    /// The item of an index; `None` for a primitive one and beyond the last.
    #[must_use]
    pub fn get(&self, item: ItemId) -> Option<&SyntheticItem<WORDS>> {
        let place = item.0.checked_sub(self.first)?;
        self.items.get(usize::from(place))
    }

    /// Makes an item that stands for the success of a schema; the same schema is the same item.
    ///
    /// # Errors
    /// [`NoRoomForItem`].
    pub fn reify(&mut self, schema: &SchemaText<WORDS>) -> Result<ItemId, NoRoomForItem> {
        let same = |it: &SyntheticItem<WORDS>| it.schema == *schema;
        let place = match self.items.iter().position(same) {
            Some(place) => place,
            None => self.items.len(),
        };
        let id = ItemId(self.first + place as u16);
        if place < self.items.len() {
            return Ok(id);
        }
        if id.0 >= ItemSet::<WORDS>::CAPACITY {
            return Err(NoRoomForItem);
        }
        let item = SyntheticItem {
            schema: *schema,
            last: None,
            age: 0,
        };
        self.items.push(item).map_err(|_| NoRoomForItem)?;
        Ok(id)
    }

    /// What is sensed, and of every synthetic item what can be known now: off where its context
    /// does not hold, else what was last said of it, else unknown.
    #[must_use]
    pub fn view(&self, sensed: &ItemStates<WORDS>) -> ItemStates<WORDS> {
        let (mut on, mut off) = (*sensed.on(), *sensed.off());
        for (id, item) in self.numbered() {
            let value = match item.schema.context.truth(sensed) {
                Some(false) => Some(false),
                Some(true) | None => item.last,
            };
            // Every index was checked when the item was made.
            let _ = match value {
                Some(true) => on.insert(id),
                Some(false) => off.insert(id),
                None => Ok(()),
            };
        }
        ItemStates::from_sets(&on, &off)
    }

    /// The synthetic items whose context does not hold: off for certain.
    #[must_use]
    pub fn ruled_out(&self, sensed: &ItemStates<WORDS>) -> ItemSet<WORDS> {
        let mut out = ItemSet::EMPTY;
        for (id, item) in self.numbered() {
            if item.schema.context.truth(sensed) == Some(false) {
                let _ = out.insert(id);
            }
        }
        out
    }

    /// What an action showed about the moment before it: on where a schema succeeded, off where one
    /// failed, all else unknown.
    #[must_use]
    pub fn revealed(
        &self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> ItemStates<WORDS> {
        let (mut on, mut off) = (ItemSet::EMPTY, ItemSet::EMPTY);
        for (id, item) in self.numbered() {
            let _ = match item.tried(before, action, after) {
                Some(true) => on.insert(id),
                Some(false) => off.insert(id),
                None => Ok(()),
            };
        }
        ItemStates::from_sets(&on, &off)
    }

    /// A primitive action has ended: all items age, those of its schemas that were tried are set.
    pub fn complete(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) {
        for item in &mut self.items {
            item.age = item.age.saturating_add(1);
            if item.age >= Self::HORIZON {
                item.last = None;
            }
        }
        self.try_out(before, action, after);
    }

    /// A composite action has reached its goal: those of its schemas that were tried are set; time
    /// has passed with the primitive actions that it ran.
    pub fn try_out(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) {
        for item in &mut self.items {
            if let Some(success) = item.tried(before, action, after) {
                item.last = Some(success);
                item.age = 0;
            }
        }
    }

    /// Sets the items that reliable schemas of a completed action promised, where the action itself
    /// showed nothing; of several promises about one item the best supported counts, the first of
    /// equal ones.
    ///
    /// `sample` is what was known before the action (see
    /// [`HindsightSample`](super::HindsightSample)); its labels are not looked at.
    pub fn expect<E: Evidence<WORDS>>(
        &mut self,
        sample: &E,
        action: ActionId,
        schemas: &[SimpleSchema],
        reliable: f32,
        trials: u16,
    ) {
        let mut best = [[0_u16; 32]; WORDS];
        let promising = schemas.iter().filter(|it| {
            it.action() == action
                && it.activations() >= trials
                && it.reliability() >= reliable
                && it.applied(sample)
        });
        for schema in promising {
            let Some(place) = schema.result_item().0.checked_sub(self.first) else {
                continue;
            };
            let support = best.as_flattened_mut();
            let Some(support) = support.get_mut(usize::from(schema.result_item().0)) else {
                continue;
            };
            let Some(item) = self.items.get_mut(usize::from(place)) else {
                continue;
            };
            let shown = item.schema.action == action && item.age == 0;
            if !shown && schema.successes() > *support {
                *support = schema.successes();
                item.last = Some(schema.result_sign());
                item.age = 0;
            }
        }
    }

    fn numbered(&self) -> impl Iterator<Item = (ItemId, &SyntheticItem<WORDS>)> {
        (self.first..).map(ItemId).zip(&self.items)
    }
}

#[cfg(test)]
mod tests {
    use super::{NoRoomForItem, SyntheticItems};
    use crate::growth::{HindsightSample, SimpleSchema};
    use crate::word::{ActionId, ItemId, ItemStates, SchemaText, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["near", "felt", "far", "s3", "s4"],
        actions: &["reach", "turn"],
    };
    const REACH: ActionId = ActionId(0);
    const TURN: ActionId = ActionId(1);

    fn text(text: &str) -> SchemaText<1> {
        SchemaText::parse(text, &WORDS).unwrap()
    }

    fn sensed(on: &[&str]) -> ItemStates<1> {
        let mut states = ItemStates::all_off(3);
        for name in on {
            states.set(WORDS.item(name).unwrap(), Some(true)).unwrap();
        }
        states
    }

    fn items() -> SyntheticItems<1, 2> {
        let mut items = SyntheticItems::new(3);
        assert_eq!(items.reify(&text("+near/reach/+felt")), Ok(ItemId(3)));
        items
    }

    #[test]
    fn a_failure_turns_an_item_off_and_ten_actions_make_it_unknown() {
        let mut items = items();
        let near = sensed(&["near"]);
        items.complete(&near, REACH, &near);
        for age in 0..10 {
            assert_eq!(items.view(&near).get(ItemId(3)), Some(false), "{age}");
            items.complete(&near, TURN, &near);
        }
        assert_eq!(items.view(&near).get(ItemId(3)), None);
    }

    #[test]
    fn where_the_context_does_not_hold_an_item_is_off_whatever_the_last_trial_said() {
        let mut items = items();
        items.complete(&sensed(&["near"]), REACH, &sensed(&["near", "felt"]));
        assert_eq!(items.view(&sensed(&["near"])).get(ItemId(3)), Some(true));
        assert_eq!(items.view(&sensed(&["far"])).get(ItemId(3)), Some(false));
    }

    #[test]
    fn only_its_own_action_in_its_own_context_reveals_an_item() {
        let items = items();
        let (near, felt) = (sensed(&["near"]), sensed(&["near", "felt"]));
        assert!(items.revealed(&near, REACH, &felt).on().contains(ItemId(3)));
        assert!(
            items
                .revealed(&near, REACH, &near)
                .off()
                .contains(ItemId(3))
        );
        for (before, action) in [(sensed(&["far"]), REACH), (near, TURN)] {
            assert!(items.revealed(&before, action, &felt).known().is_empty());
        }
    }

    #[test]
    fn a_reliable_schema_of_another_action_sets_an_item_and_a_rare_one_does_not() {
        let near = sensed(&["near"]);
        let promise = |trials: u16| {
            let mut schema = SimpleSchema::pack(&text("+far/turn/+s3")).unwrap();
            for _ in 0..trials {
                schema.record(true);
            }
            let mut items = items();
            let before = items.view(&sensed(&["far"]));
            let sample = HindsightSample::waiting(&before, &near, &items);
            items.complete(&before, TURN, &near);
            items.expect(&sample, TURN, &[schema], 0.9, 4);
            items.view(&near).get(ItemId(3))
        };
        assert_eq!(promise(4), Some(true));
        assert_eq!(promise(3), None);
    }

    #[test]
    fn an_items_own_trial_counts_more_than_a_promise_about_it() {
        let (near, mut items) = (sensed(&["near"]), items());
        let mut wrong = SimpleSchema::pack(&text("+near/reach/+s3")).unwrap();
        (0..9).for_each(|_| wrong.record(true));
        let before = items.view(&near);
        let sample = HindsightSample::waiting(&before, &near, &items);
        items.complete(&before, REACH, &near);
        items.expect(&sample, REACH, &[wrong], 0.9, 4);
        assert_eq!(items.view(&near).get(ItemId(3)), Some(false));
    }

    #[test]
    fn a_full_table_refuses_and_the_same_schema_is_the_same_item() {
        let mut items = items();
        assert_eq!(items.reify(&text("+far/turn/+near")), Ok(ItemId(4)));
        assert_eq!(items.reify(&text("+near/reach/+felt")), Ok(ItemId(3)));
        assert_eq!(items.reify(&text("/turn/+far")), Err(NoRoomForItem));
        assert_eq!(
            items.ids().iter().collect::<std::vec::Vec<_>>(),
            [ItemId(3), ItemId(4)]
        );
        let mut beyond = SyntheticItems::<1, 4>::new(32);
        assert_eq!(beyond.reify(&text("/turn/+far")), Err(NoRoomForItem));
    }
}
