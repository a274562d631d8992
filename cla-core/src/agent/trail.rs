//! The trail: which schema has just succeeded, and where that has led.

use crate::knowledge::SyntheticId;
use crate::snapshot::stored;
use crate::word::ItemStates;

/// The item of the schema that has succeeded last, and the state that it led to; all zero at first.
#[derive(Clone, Debug)]
pub(super) struct Trail<const WORDS: usize> {
    item: Option<SyntheticId>,
    arrived: ItemStates<WORDS>,
}

impl<const WORDS: usize> Trail<WORDS> {
    pub(super) const NONE: Self = Self {
        item: None,
        arrived: ItemStates::UNKNOWN,
    };

    /// The item, wherever the robot is.
    pub(super) const fn item(&self) -> Option<SyntheticId> {
        self.item
    }

    /// The item, if the robot is still where its schema has led.
    pub(super) fn item_in(&self, state: &ItemStates<WORDS>) -> Option<SyntheticId> {
        self.item.filter(|_| self.arrived == *state)
    }

    /// A schema has led there; or none that is known.
    pub(super) fn arrive(&mut self, item: Option<SyntheticId>, state: &ItemStates<WORDS>) {
        self.item = item;
        self.arrived = *state;
    }

    /// Loses the item unless it is still one.
    pub(super) fn keep(&mut self, is: impl FnOnce(SyntheticId) -> bool) {
        self.item = self.item.filter(|&item| is(item));
    }

    /// What has succeeded no longer matters.
    pub(super) const fn leave(&mut self) {
        self.item = None;
    }
}

stored! { impl[const WORDS: usize] Trail<WORDS> { item, arrived } }
