//! What schemas are grown against and tested by: one completed action, as far as it is known.
//!
//! A [`Transition`] knows every item before and after; a [`HindsightSample`](super::HindsightSample)
//! knows some of them, and what is unknown neither agrees nor contradicts.
//! So primitive and synthetic items are learned by one accommodation, on one kind of reservoir.

use crate::word::{ItemId, ItemSet, SignedItems};

/// One completed action as it is remembered: the items that were on before and after.
///
/// ```
/// use cla_core::growth::Transition;
/// use cla_core::word::ItemSet;
/// let it = Transition { before: ItemSet::<1>::first(2), after: ItemSet::first(3) };
/// assert_eq!(it.changed().iter().map(|item| item.0).collect::<Vec<_>>(), [2]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition<const WORDS: usize> {
    /// On before the action; all others were off.
    pub before: ItemSet<WORDS>,
    /// On after it.
    pub after: ItemSet<WORDS>,
}

impl<const WORDS: usize> Transition<WORDS> {
    /// The items whose state differs.
    #[must_use]
    pub fn changed(&self) -> ItemSet<WORDS> {
        self.before.symmetric_difference(&self.after)
    }
}

/// A completed action that may leave items unknown.
///
/// In the field: a training example with missing values.
///
/// ```
/// use cla_core::growth::{Evidence, Transition};
/// use cla_core::word::{ItemId, ItemSet};
/// let it = Transition { before: ItemSet::<1>::EMPTY, after: ItemSet::first(1) };
/// assert_eq!(it.outcome(ItemId(0)), Some(true));
/// assert_eq!(it.outcome(ItemId(1)), Some(false));
/// ```
pub trait Evidence<const WORDS: usize>: Copy {
    /// Whether a result is a change, so that its item's own state before belongs to the context.
    const CHANGES: bool;

    /// The items known to be on before.
    fn on_before(&self) -> ItemSet<WORDS>;

    /// The items known to be off before.
    fn off_before(&self) -> ItemSet<WORDS>;

    /// The state of an item afterwards; `None` when nothing is known of it.
    fn outcome(&self, item: ItemId) -> Option<bool>;

    /// The items whose state afterwards wants an explanation.
    fn telling(&self) -> ItemSet<WORDS>;

    /// What is remembered of two actions in the same context, this one and then `newer`.
    #[must_use]
    fn renewed(&self, newer: &Self) -> Self;

    /// Whether both began in the same context.
    fn began_as(&self, other: &Self) -> bool {
        self.on_before() == other.on_before() && self.off_before() == other.off_before()
    }

    /// Whether a context is known to have held before.
    fn satisfies(&self, context: &SignedItems<WORDS>) -> bool {
        context.positive().is_subset(&self.on_before())
            && context.negative().is_subset(&self.off_before())
    }

    /// Items known to have had the same state before as in `other`.
    fn shared(&self, other: &Self) -> ItemSet<WORDS> {
        let on = self.on_before().intersection(&other.on_before());
        on.union(&self.off_before().intersection(&other.off_before()))
    }
}

impl<const WORDS: usize> Evidence<WORDS> for Transition<WORDS> {
    const CHANGES: bool = true;

    fn on_before(&self) -> ItemSet<WORDS> {
        self.before
    }

    fn off_before(&self) -> ItemSet<WORDS> {
        ItemSet::first(ItemSet::<WORDS>::CAPACITY).difference(&self.before)
    }

    fn outcome(&self, item: ItemId) -> Option<bool> {
        Some(self.after.contains(item))
    }

    fn telling(&self) -> ItemSet<WORDS> {
        self.changed()
    }

    fn renewed(&self, newer: &Self) -> Self {
        *newer
    }

    fn began_as(&self, other: &Self) -> bool {
        self.before == other.before
    }

    fn satisfies(&self, context: &SignedItems<WORDS>) -> bool {
        context.positive().is_subset(&self.before) && context.negative().is_disjoint(&self.before)
    }
}

#[cfg(test)]
mod tests {
    use super::{Evidence, Transition};
    use crate::word::{ItemId, ItemSet, SignedItems};

    #[test]
    fn a_transition_knows_everything() {
        let it = Transition {
            before: ItemSet::<1>::first(2),
            after: ItemSet::first(1),
        };
        assert_eq!(it.on_before().union(&it.off_before()).len(), 32);
        assert_eq!(it.telling().iter().next(), Some(ItemId(1)));
        let mut context = SignedItems::EMPTY;
        context.insert(ItemId(1), true).unwrap();
        context.insert(ItemId(2), false).unwrap();
        assert!(it.satisfies(&context));
        context.insert(ItemId(0), false).unwrap();
        assert!(!it.satisfies(&context));
    }

    #[test]
    fn shared_are_the_items_that_agree() {
        let from = |items| Transition {
            before: ItemSet::<1>::first(items),
            after: ItemSet::EMPTY,
        };
        let differing = ItemSet::first(32).difference(&from(2).shared(&from(4)));
        let differing: std::vec::Vec<u16> = differing.iter().map(|item| item.0).collect();
        assert_eq!(differing, [2, 3]);
    }
}
