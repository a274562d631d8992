//! Items: the binary states that the robot perceives, and sets of them (book, 5.1.1).
//!
//! An item is on or off, or unknown when nothing says which (a dead sensor, a synthetic item that
//! nobody has tried lately).
//! Sets are bit sets of `WORDS` 32-bit words: the capacity is chosen at compile time.

use core::fmt;

use crate::num::Ones;
use crate::snapshot::{Reader, stored, stored_as};

/// The index of an item: primitive items first, synthetic items after them.
///
/// ```
/// use cla_core::word::ItemId;
/// assert!(ItemId(2) < ItemId(3));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ItemId(pub u16);

/// An item does not fit a set's capacity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ItemOutOfRange {
    /// The item that does not fit.
    pub item: ItemId,
    /// The number of items that do.
    pub capacity: u16,
}

impl fmt::Display for ItemOutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "item {} does not fit a set of {} items",
            self.item.0, self.capacity
        )
    }
}

impl core::error::Error for ItemOutOfRange {}

/// A set of items with room for `32 · WORDS` of them.
///
/// ```
/// use cla_core::word::{ItemId, ItemSet};
/// let mut set = ItemSet::<1>::EMPTY;
/// set.insert(ItemId(3))?;
/// assert!(set.contains(ItemId(3)) && set.len() == 1);
/// assert!(set.insert(ItemId(32)).is_err());
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ItemSet<const WORDS: usize>([u32; WORDS]);

impl<const WORDS: usize> ItemSet<WORDS> {
    /// How many items fit.
    pub const CAPACITY: u16 = {
        assert!(WORDS > 0 && WORDS <= 64, "an item set has 1 to 64 words");
        (WORDS * 32) as u16
    };

    /// No item.
    pub const EMPTY: Self = {
        let _ = Self::CAPACITY;
        Self([0; WORDS])
    };

    /// The items `0..count`; all that fit when `count` is above the capacity.
    #[must_use]
    pub fn first(count: u16) -> Self {
        let mut set = Self::EMPTY;
        for (index, word) in set.0.iter_mut().enumerate() {
            let below = index as u32 * 32;
            let inside = u32::from(count).saturating_sub(below);
            *word = if inside >= 32 {
                u32::MAX
            } else {
                (1 << inside) - 1
            };
        }
        set
    }

    /// Adds an item.
    ///
    /// # Errors
    /// [`ItemOutOfRange`] when the item does not fit; the set is unchanged.
    pub fn insert(&mut self, item: ItemId) -> Result<(), ItemOutOfRange> {
        match self.0.get_mut(usize::from(item.0 / 32)) {
            Some(word) => {
                *word |= 1 << (item.0 % 32);
                Ok(())
            }
            None => Err(ItemOutOfRange {
                item,
                capacity: Self::CAPACITY,
            }),
        }
    }

    /// Takes an item out; nothing happens when it is not in the set.
    pub fn remove(&mut self, item: ItemId) {
        if let Some(word) = self.0.get_mut(usize::from(item.0 / 32)) {
            *word &= !(1 << (item.0 % 32));
        }
    }

    /// Whether the item is in the set.
    #[must_use]
    pub fn contains(&self, item: ItemId) -> bool {
        match self.0.get(usize::from(item.0 / 32)) {
            Some(word) => word >> (item.0 % 32) & 1 == 1,
            None => false,
        }
    }

    /// The number of items in the set.
    #[must_use]
    pub fn len(&self) -> u16 {
        self.0.iter().map(|word| word.count_ones() as u16).sum()
    }

    /// Whether the set has no item.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(|&word| word == 0)
    }

    /// Items in both sets.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a & b)
    }

    /// Items in either set.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a | b)
    }

    /// Items of this set that are not in the other.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a & !b)
    }

    /// Items in exactly one of the sets.
    #[must_use]
    pub fn symmetric_difference(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a ^ b)
    }

    /// Whether every item of this set is in the other.
    #[must_use]
    pub fn is_subset(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| a & !b == 0)
    }

    /// Whether no item is in both sets.
    #[must_use]
    pub fn is_disjoint(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| a & b == 0)
    }

    /// The items in ascending order.
    #[must_use]
    pub const fn iter(&self) -> Items<'_> {
        Items(Ones::of(&self.0))
    }

    /// The words of the set, item 0 in the lowest bit of the first.
    #[must_use]
    pub const fn words(&self) -> &[u32; WORDS] {
        &self.0
    }

    /// Reads a set that was stored with so many words; none of its items may be beyond this one's.
    pub(crate) fn take(words: usize, from: &mut Reader<'_>) -> Self {
        let mut it = Self::EMPTY;
        for at in 0..words {
            let word = u32::from_le_bytes(from.bytes());
            match it.0.get_mut(at) {
                Some(place) => *place = word,
                None => from.require(word == 0),
            }
            if from.is_wrong() {
                break;
            }
        }
        it
    }

    fn combine(&self, other: &Self, with: impl Fn(u32, u32) -> u32) -> Self {
        let mut out = *self;
        for (word, &theirs) in out.0.iter_mut().zip(&other.0) {
            *word = with(*word, theirs);
        }
        out
    }
}

impl<const WORDS: usize> Default for ItemSet<WORDS> {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// The items of an [`ItemSet`] in ascending order.
///
/// ```
/// use cla_core::word::ItemSet;
/// let ids: Vec<u16> = ItemSet::<1>::first(3).iter().map(|item| item.0).collect();
/// assert_eq!(ids, [0, 1, 2]);
/// ```
#[derive(Clone, Debug)]
pub struct Items<'a>(Ones<'a>);

impl Iterator for Items<'_> {
    type Item = ItemId;

    fn next(&mut self) -> Option<ItemId> {
        self.0.next().map(ItemId)
    }
}

/// What is known of every item at one moment: on, off or unknown.
///
/// In the field: an observation of binary features with missing values (Kleene's three values).
///
/// ```
/// use cla_core::word::{ItemId, ItemStates};
/// let mut now = ItemStates::<1>::all_off(7);
/// now.set(ItemId(2), Some(true))?;
/// now.set(ItemId(6), None)?;
/// assert_eq!(now.get(ItemId(2)), Some(true));
/// assert_eq!(now.get(ItemId(0)), Some(false));
/// assert_eq!(now.get(ItemId(6)), None);
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ItemStates<const WORDS: usize> {
    on: ItemSet<WORDS>,
    off: ItemSet<WORDS>,
}

impl<const WORDS: usize> ItemStates<WORDS> {
    /// Nothing is known of any item.
    pub const UNKNOWN: Self = Self {
        on: ItemSet::EMPTY,
        off: ItemSet::EMPTY,
    };

    /// Reads states that were stored with so many words an item set.
    pub(crate) fn take(words: usize, from: &mut Reader<'_>) -> Self {
        let it = Self {
            on: ItemSet::take(words, from),
            off: ItemSet::take(words, from),
        };
        from.require(it.on.is_disjoint(&it.off));
        it
    }

    /// The items `0..count` are off, all others unknown.
    #[must_use]
    pub fn all_off(count: u16) -> Self {
        Self {
            on: ItemSet::EMPTY,
            off: ItemSet::first(count),
        }
    }

    /// What is in `on` is on, what is in `off` and not in `on` is off, all others unknown.
    #[must_use]
    pub fn from_sets(on: &ItemSet<WORDS>, off: &ItemSet<WORDS>) -> Self {
        Self {
            on: *on,
            off: off.difference(on),
        }
    }

    /// Sets an item on (`Some(true)`), off (`Some(false)`) or unknown (`None`).
    ///
    /// # Errors
    /// [`ItemOutOfRange`] when the item does not fit; the states are unchanged.
    pub fn set(&mut self, item: ItemId, state: Option<bool>) -> Result<(), ItemOutOfRange> {
        match state {
            Some(true) => self.on.insert(item)?,
            Some(false) => self.off.insert(item)?,
            None if item.0 >= ItemSet::<WORDS>::CAPACITY => {
                return Err(ItemOutOfRange {
                    item,
                    capacity: ItemSet::<WORDS>::CAPACITY,
                });
            }
            None => {}
        }
        if state != Some(true) {
            self.on.remove(item);
        }
        if state != Some(false) {
            self.off.remove(item);
        }
        Ok(())
    }

    /// Sets an item from a sensor's reading: on above `threshold`, off at it and below, unknown when
    /// the reading (or the threshold) is NaN; answers what it was set to.
    ///
    /// A broken sensor says nothing, so it must not say *off*: what is unknown is left out of maps,
    /// satisfies no context and settles no prediction, and what was learned stays as it was.
    /// Count the `None`s: they are the sensor's failures.
    ///
    /// ```
    /// use cla_core::word::{ItemId, ItemStates};
    /// let mut now = ItemStates::<1>::all_off(2);
    /// assert_eq!(now.set_above(ItemId(0), 0.8, 0.5), Ok(Some(true)));
    /// assert_eq!(now.set_above(ItemId(1), f32::NAN, 0.5), Ok(None));
    /// assert_eq!((now.get(ItemId(0)), now.get(ItemId(1))), (Some(true), None));
    /// ```
    ///
    /// # Errors
    /// [`ItemOutOfRange`] when the item does not fit; the states are unchanged.
    pub fn set_above(
        &mut self,
        item: ItemId,
        reading: f32,
        threshold: f32,
    ) -> Result<Option<bool>, ItemOutOfRange> {
        let state = reading
            .partial_cmp(&threshold)
            .map(core::cmp::Ordering::is_gt);
        self.set(item, state)?;
        Ok(state)
    }

    /// The state of an item; unknown when it is outside the capacity.
    #[must_use]
    pub fn get(&self, item: ItemId) -> Option<bool> {
        if self.on.contains(item) {
            Some(true)
        } else if self.off.contains(item) {
            Some(false)
        } else {
            None
        }
    }

    /// The items known to be on.
    #[must_use]
    pub const fn on(&self) -> &ItemSet<WORDS> {
        &self.on
    }

    /// The items known to be off.
    #[must_use]
    pub const fn off(&self) -> &ItemSet<WORDS> {
        &self.off
    }

    /// The items whose state is known.
    #[must_use]
    pub fn known(&self) -> ItemSet<WORDS> {
        self.on.union(&self.off)
    }
}

stored_as!(impl[] ItemId);
stored_as!(impl[const WORDS: usize] ItemSet<WORDS>);
stored! {
    impl[const WORDS: usize] ItemStates<WORDS> { on, off }
    sound |it, _limits| it.on.is_disjoint(&it.off)
}

#[cfg(test)]
mod tests {
    use super::{ItemId, ItemSet, ItemStates};

    #[test]
    fn iteration_crosses_words_in_order() {
        let mut set = ItemSet::<3>::EMPTY;
        for id in [95, 0, 31, 32, 64] {
            set.insert(ItemId(id)).unwrap();
        }
        let ids: std::vec::Vec<u16> = set.iter().map(|item| item.0).collect();
        assert_eq!(ids, [0, 31, 32, 64, 95]);
        assert_eq!(set.len(), 5);
    }

    #[test]
    fn the_first_items_stop_at_word_borders_and_at_the_capacity() {
        assert_eq!(ItemSet::<2>::first(0).len(), 0);
        assert_eq!(ItemSet::<2>::first(32).len(), 32);
        assert_eq!(ItemSet::<2>::first(33).len(), 33);
        assert_eq!(ItemSet::<2>::first(9999).len(), 64);
    }

    #[test]
    fn a_state_is_never_on_and_off_at_once() {
        let mut states = ItemStates::<1>::all_off(4);
        for state in [Some(true), Some(false), None, Some(true), None] {
            states.set(ItemId(3), state).unwrap();
            assert_eq!(states.get(ItemId(3)), state);
            assert!(states.on().is_disjoint(states.off()));
        }
        assert!(states.set(ItemId(32), None).is_err());
    }
}
