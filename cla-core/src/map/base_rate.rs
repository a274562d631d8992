//! How often each item is on: which negative items of a context say anything.
//!
//! An item that is hardly ever on is off before nearly every action, so its weight is near 0 in
//! every node and literal harvest writes it as a negative item everywhere (11 items of the
//! Microworld are never on).

use crate::word::{ItemId, ItemSet, SignedItems};

/// Counts, for each item, the moments at which it was on.
///
/// In the field: marginal frequencies of the features.
///
/// ```
/// use cla_core::map::BaseRates;
/// use cla_core::word::ItemSet;
/// let mut rates = BaseRates::<1>::new();
/// for items in [2, 2, 3, 2] {
///     rates.observe(&ItemSet::first(items));
/// }
/// assert_eq!(rates.at_least(0.25), ItemSet::first(3));
/// assert_eq!(rates.at_least(0.5), ItemSet::first(2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BaseRates<const WORDS: usize> {
    on: [[u32; 32]; WORDS],
    moments: u32,
}

impl<const WORDS: usize> BaseRates<WORDS> {
    /// Nothing seen.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            on: [[0; 32]; WORDS],
            moments: 0,
        }
    }

    /// Adds a moment at which exactly these items were on.
    ///
    /// At the end of the counters' range all are halved, so their shares are kept.
    pub fn observe(&mut self, on: &ItemSet<WORDS>) {
        if self.moments == u32::MAX {
            self.halve();
        }
        self.moments += 1;
        for item in on.iter() {
            let counts = self.on.as_flattened_mut();
            if let Some(count) = counts.get_mut(usize::from(item.0)) {
                *count += 1;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn halve(&mut self) {
        self.moments /= 2;
        for count in self.on.as_flattened_mut() {
            *count /= 2;
        }
    }

    /// The items that were on at this share of the moments or more; none before the first moment.
    #[must_use]
    pub fn at_least(&self, rate: f32) -> ItemSet<WORDS> {
        let mut items = ItemSet::first(ItemSet::<WORDS>::CAPACITY);
        let needed = rate * self.moments as f32;
        for (item, &count) in (0_u16..).zip(self.on.as_flattened()) {
            if self.moments == 0 || (count as f32) < needed {
                items.remove(ItemId(item));
            }
        }
        items
    }
}

impl<const WORDS: usize> Default for BaseRates<WORDS> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const WORDS: usize> SignedItems<WORDS> {
    /// The same conjunction without the negative items that are not in `telling`.
    #[must_use]
    pub fn with_negatives_among(&self, telling: &ItemSet<WORDS>) -> Self {
        let mut kept = *self;
        for item in self.negative().difference(telling).iter() {
            kept.remove(item);
        }
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::BaseRates;
    use crate::word::{ItemId, ItemSet, SignedItems};

    #[test]
    fn only_negatives_of_items_that_are_often_on_stay() {
        let mut rates = BaseRates::<1>::new();
        assert!(rates.at_least(0.0).is_empty());
        for _ in 0..10 {
            rates.observe(&ItemSet::first(2));
        }
        let mut context = SignedItems::EMPTY;
        context.insert(ItemId(1), false).unwrap();
        context.insert(ItemId(2), false).unwrap();
        context.insert(ItemId(3), true).unwrap();
        let kept = context.with_negatives_among(&rates.at_least(0.1));
        assert!(kept.negative().contains(ItemId(1)) && !kept.negative().contains(ItemId(2)));
        assert!(kept.positive().contains(ItemId(3)));
    }

    #[test]
    fn full_counters_keep_their_shares_and_count_on() {
        let mut rates = BaseRates::<1>::new();
        rates.moments = u32::MAX;
        rates.on[0][0] = u32::MAX;
        rates.on[0][1] = u32::MAX / 4;
        for _ in 0..3 {
            rates.observe(&ItemSet::first(1));
        }
        let half = u32::MAX / 2;
        assert_eq!((rates.moments, rates.on[0][0]), (half + 3, half + 3));
        assert_eq!(rates.on[0][1], half / 4);
        assert_eq!(rates.at_least(0.24), ItemSet::first(2));
        assert_eq!(rates.at_least(0.26), ItemSet::first(1));
    }
}
