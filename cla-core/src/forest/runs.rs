//! Senses that got stuck: an item that is on for more than twice as long as it ever was tells
//! nothing any more, and counts as off until it goes off.
//!
//! Two counters an item: its present run and its longest.
//! A run that ends is believed, however long it was; what was never seen to end is not judged.

use crate::snapshot::{Reader, Stored, stored};
use crate::word::{ItemId, ItemStates};

/// Runs shorter than this are never doubted.
const SHORT: u16 = 16;

/// The runs of every item.
#[derive(Clone, Debug)]
pub(super) struct Runs<const ITEMS: usize> {
    present: [u16; ITEMS],
    longest: [u16; ITEMS],
}

impl<const ITEMS: usize> Runs<ITEMS> {
    pub(super) const fn new() -> Self {
        Self {
            present: [0; ITEMS],
            longest: [0; ITEMS],
        }
    }

    fn is_stuck(present: u16, longest: u16) -> bool {
        longest > 0 && present > SHORT && present > longest.saturating_mul(2)
    }

    /// A percept in which stuck items are off.
    pub(super) fn believed<const WORDS: usize>(
        &self,
        now: &ItemStates<WORDS>,
    ) -> ItemStates<WORDS> {
        let mut believed = *now;
        let runs = self.present.iter().zip(&self.longest);
        for (index, (present, longest)) in runs.enumerate() {
            let item = ItemId(index as u16);
            if Self::is_stuck(*present, *longest) && now.get(item) == Some(true) {
                // An item of this learner fits its set.
                let _ = believed.set(item, Some(false));
            }
        }
        believed
    }

    /// Counts a percept; unknown items neither go on nor end.
    pub(super) fn count<const WORDS: usize>(&mut self, now: &ItemStates<WORDS>) {
        let runs = self.present.iter_mut().zip(&mut self.longest);
        for (index, (present, longest)) in runs.enumerate() {
            match now.get(ItemId(index as u16)) {
                Some(true) => *present = present.saturating_add(1),
                Some(false) => {
                    *longest = (*longest).max(*present);
                    *present = 0;
                }
                None => {}
            }
        }
    }

    /// How many items are stuck.
    pub(super) fn stuck(&self) -> u16 {
        let mut stuck = 0;
        for (present, longest) in self.present.iter().zip(&self.longest) {
            stuck += u16::from(Self::is_stuck(*present, *longest));
        }
        stuck
    }
}

stored! { impl[const ITEMS: usize] Runs<ITEMS> { present, longest } }

impl<const ITEMS: usize> Runs<ITEMS> {
    /// Reads runs of so many items, over what is there if there is anybody; no run goes on between two
    /// lives.
    pub(super) fn take(mut into: Option<&mut Self>, items: usize, from: &mut Reader<'_>) {
        for run in 0..2 * items {
            let mut actions = 0;
            actions.restore(from);
            if run >= items
                && let Some(it) = &mut into
                && let Some(place) = it.longest.get_mut(run - items)
            {
                *place = actions;
            }
        }
        if let Some(it) = into {
            it.present = [0; ITEMS];
        }
    }
}

#[cfg(test)]
#[path = "runs_tests.rs"]
mod tests;
