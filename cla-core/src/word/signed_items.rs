//! Conjunctions of signed items: the contexts and results of schemas, `+s3-bump` (book, 5.1.1).

use super::item::{ItemId, ItemSet, ItemStates};
use crate::snapshot::{Reader, stored};

/// Items that must be on and items that must be off.
///
/// The empty conjunction always holds.
///
/// ```
/// use cla_core::word::{ItemId, ItemStates, SignedItems};
/// let mut context = SignedItems::<1>::EMPTY;
/// context.insert(ItemId(2), true)?;
/// context.insert(ItemId(6), false)?;
/// let mut now = ItemStates::all_off(7);
/// now.set(ItemId(2), Some(true))?;
/// assert_eq!(context.truth(&now), Some(true));
/// now.set(ItemId(6), None)?;
/// assert_eq!(context.truth(&now), None); // nobody knows
/// now.set(ItemId(2), Some(false))?;
/// assert_eq!(context.truth(&now), Some(false));
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SignedItems<const WORDS: usize> {
    positive: ItemSet<WORDS>,
    negative: ItemSet<WORDS>,
}

impl<const WORDS: usize> SignedItems<WORDS> {
    /// No item: holds always.
    pub const EMPTY: Self = Self {
        positive: ItemSet::EMPTY,
        negative: ItemSet::EMPTY,
    };

    /// What is known of every item: on is positive, off is negative.
    #[must_use]
    pub fn of(state: &super::ItemStates<WORDS>) -> Self {
        Self {
            positive: *state.on(),
            negative: *state.off(),
        }
    }

    /// Reads a conjunction that was stored with so many words an item set.
    pub(crate) fn take(words: usize, from: &mut Reader<'_>) -> Self {
        let it = Self {
            positive: ItemSet::take(words, from),
            negative: ItemSet::take(words, from),
        };
        from.require(it.positive.is_disjoint(&it.negative));
        it
    }

    /// Adds an item with its sign (`true` for `+`), in place of an opposite one.
    ///
    /// # Errors
    /// [`ItemOutOfRange`](super::ItemOutOfRange) when the item does not fit; nothing changes.
    pub fn insert(&mut self, item: ItemId, positive: bool) -> Result<(), super::ItemOutOfRange> {
        if positive {
            self.positive.insert(item)?;
            self.negative.remove(item);
        } else {
            self.negative.insert(item)?;
            self.positive.remove(item);
        }
        Ok(())
    }

    /// Takes an item out, whatever its sign.
    pub fn remove(&mut self, item: ItemId) {
        self.positive.remove(item);
        self.negative.remove(item);
    }

    /// Items that must be on.
    #[must_use]
    pub const fn positive(&self) -> &ItemSet<WORDS> {
        &self.positive
    }

    /// Items that must be off.
    #[must_use]
    pub const fn negative(&self) -> &ItemSet<WORDS> {
        &self.negative
    }

    /// Whether there is no item at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.positive.is_empty() && self.negative.is_empty()
    }

    /// The number of signed items.
    #[must_use]
    pub fn len(&self) -> u16 {
        self.positive.len() + self.negative.len()
    }

    /// Whether the conjunction holds now; `None` when that hangs on an unknown item.
    #[must_use]
    pub fn truth(&self, now: &ItemStates<WORDS>) -> Option<bool> {
        if !self.positive.is_disjoint(now.off()) || !self.negative.is_disjoint(now.on()) {
            Some(false)
        } else if self.positive.is_subset(now.on()) && self.negative.is_subset(now.off()) {
            Some(true)
        } else {
            None
        }
    }

    /// Whether the conjunction is known to hold: [`truth`](Self::truth) is `Some(true)`.
    #[inline]
    pub(crate) fn holds_in(&self, now: &ItemStates<WORDS>) -> bool {
        // No item is on and off at once, so what is on is not off.
        self.positive.is_subset(now.on()) && self.negative.is_subset(now.off())
    }

    /// Whether this conjunction follows from the other: every signed item stands in it.
    #[must_use]
    pub fn follows_from(&self, other: &Self) -> bool {
        self.positive.is_subset(&other.positive) && self.negative.is_subset(&other.negative)
    }
}

stored! {
    impl[const WORDS: usize] SignedItems<WORDS> { positive, negative }
    sound |it, _limits| it.positive.is_disjoint(&it.negative)
}

#[cfg(test)]
mod tests {
    use super::{ItemId, SignedItems};

    #[test]
    fn an_item_has_one_sign_at_a_time() {
        let mut items = SignedItems::<1>::EMPTY;
        items.insert(ItemId(4), true).unwrap();
        items.insert(ItemId(4), false).unwrap();
        assert!(items.positive().is_empty() && items.negative().contains(ItemId(4)));
        assert_eq!(items.len(), 1);
    }

    #[test]
    fn the_weaker_conjunction_follows_from_the_stronger() {
        let mut weak = SignedItems::<1>::EMPTY;
        weak.insert(ItemId(1), true).unwrap();
        let mut strong = weak;
        strong.insert(ItemId(2), false).unwrap();
        assert!(weak.follows_from(&strong) && !strong.follows_from(&weak));
        assert!(SignedItems::EMPTY.follows_from(&weak));
    }
}
