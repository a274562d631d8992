//! A moment: what is perceived now, what was perceived before, and the action that lies between.
//!
//! Everything that a context can ask about is a [`Feature`] of a moment; the two parts that are past
//! are what a second level's hidden state is made of (book, 5.1.1), without a table of its own.

use crate::word::{ItemId, ItemStates};

/// No action: nothing was done before this moment, or nobody knows what.
pub(super) const NO_ACTION: u8 = u8::MAX;

/// What is known at one moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment<const WORDS: usize> {
    pub(super) now: ItemStates<WORDS>,
    /// Unknown when an episode has just begun.
    pub(super) before: ItemStates<WORDS>,
    /// The action between the two, or [`NO_ACTION`].
    pub(super) action: u8,
}

impl<const WORDS: usize> Moment<WORDS> {
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self {
        now: ItemStates::UNKNOWN,
        before: ItemStates::UNKNOWN,
        action: NO_ACTION,
    };

    /// The first moment of an episode.
    pub(super) const fn first(now: &ItemStates<WORDS>) -> Self {
        Self {
            now: *now,
            before: ItemStates::UNKNOWN,
            action: NO_ACTION,
        }
    }

    /// Whether the feature holds; `None` when that is not known.
    pub(super) fn holds<const ITEMS: usize>(&self, feature: u8) -> Option<bool> {
        let index = usize::from(feature);
        if index < ITEMS {
            return self.now.get(ItemId(index as u16));
        }
        let index = index - ITEMS;
        if index < ITEMS {
            return self.before.get(ItemId(index as u16));
        }
        if self.action == NO_ACTION {
            return None;
        }
        Some(usize::from(self.action) == index - ITEMS)
    }
}

/// What a context asks about.
///
/// ```
/// use cla_core::word::ItemId;
/// use cla_core::forest::Feature;
/// assert_ne!(Feature::Now(ItemId(0)), Feature::Before(ItemId(0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// An item is on.
    Now(ItemId),
    /// An item was on when the last action was chosen.
    Before(ItemId),
    /// The last action was this one.
    After(crate::word::ActionId),
}

impl Feature {
    /// The feature with this number.
    pub(super) fn of<const ITEMS: usize>(number: u8) -> Self {
        let index = u16::from(number);
        let items = ITEMS as u16;
        if index < items {
            Self::Now(ItemId(index))
        } else if index < 2 * items {
            Self::Before(ItemId(index - items))
        } else {
            Self::After(crate::word::ActionId(index - 2 * items))
        }
    }
}
