//! Which items matter: a running mean of how clearly each tells values apart, and a mask.
//!
//! What is keyed by whole percepts (the trace of the habits) looks through this mask, so that items
//! which blink at random fill no table; contexts ask more of an item outside of it.

use super::moment::Feature;
use crate::snapshot::{LARGEST, Reader, Stored, Writer, bounded, stored};
use crate::word::{ItemId, ItemSet};

/// An item above this joins the mask.
const JOINS: f32 = 30.0;
/// An item below this leaves it.
const LEAVES: f32 = 15.0;
/// How much of the running mean stays.
const KEPT: f32 = 0.8;

/// The relevance of every item.
#[derive(Clone, Debug)]
pub(super) struct Relevance<const WORDS: usize, const ITEMS: usize> {
    /// The clearest split of each item while the present trees grow, an F statistic.
    clearest: [f32; ITEMS],
    mean: [f32; ITEMS],
    mask: ItemSet<WORDS>,
    /// Whether any trees were grown yet.
    told: bool,
}

impl<const WORDS: usize, const ITEMS: usize> Relevance<WORDS, ITEMS> {
    pub(super) const fn new() -> Self {
        Self {
            clearest: [0.0; ITEMS],
            mean: [0.0; ITEMS],
            mask: ItemSet::EMPTY,
            told: false,
        }
    }

    /// Every item matters until more is known.
    pub(super) fn begin(&mut self) {
        *self = Self::new();
        self.mask = ItemSet::first(ITEMS as u16);
    }

    pub(super) const fn mask(&self) -> &ItemSet<WORDS> {
        &self.mask
    }

    pub(super) fn mean(&self, item: ItemId) -> f32 {
        self.mean.get(usize::from(item.0)).copied().unwrap_or(0.0)
    }

    /// Whether a feature is about an item outside of the mask.
    pub(super) fn is_doubtful(&self, feature: u8) -> bool {
        match Feature::of::<ITEMS>(feature) {
            Feature::Now(item) | Feature::Before(item) => !self.mask.contains(item),
            Feature::After(_) => false,
        }
    }

    /// A split of this feature would tell values apart this clearly.
    pub(super) fn note(&mut self, feature: u8, clear: f32) {
        if let Feature::Now(item) | Feature::Before(item) = Feature::of::<ITEMS>(feature)
            && let Some(clearest) = self.clearest.get_mut(usize::from(item.0))
            && clear > *clearest
        {
            *clearest = bounded(clear, LARGEST);
        }
    }

    /// Trees have grown; answers whether the mask has changed.
    ///
    /// Items leave only where tables are crowded: elsewhere it costs nothing to look at them.
    pub(super) fn settle(&mut self, crowded: bool) -> bool {
        let before = self.mask;
        for (index, (mean, clearest)) in self.mean.iter_mut().zip(&mut self.clearest).enumerate() {
            *mean = if self.told {
                KEPT * *mean + (1.0 - KEPT) * *clearest
            } else {
                *clearest
            };
            *clearest = 0.0;
            let item = ItemId(index as u16);
            if *mean > JOINS {
                // An item of this learner fits its set.
                let _ = self.mask.insert(item);
            } else if crowded && *mean < LEAVES {
                self.mask.remove(item);
            }
        }
        self.told = true;
        self.mask != before
    }
}

stored! {
    impl[const WORDS: usize, const ITEMS: usize] Relevance<WORDS, ITEMS> {
        clearest => up_to LARGEST, mean => up_to LARGEST, mask, told
    }
}

impl<const WORDS: usize, const ITEMS: usize> Relevance<WORDS, ITEMS> {
    pub(super) fn carry(&self, to: &mut Writer<'_>) {
        to.limits.up_to(LARGEST);
        self.mean.store(to);
        to.limits.within(LARGEST);
        self.mask.store(to);
        self.told.store(to);
    }

    /// Reads it from a robot of so many words and items; items that it has more matter until more is
    /// known.
    pub(super) fn take(
        mut into: Option<&mut Self>,
        (words, items, _): (usize, usize, usize),
        from: &mut Reader<'_>,
    ) {
        from.limits.up_to(LARGEST);
        for item in 0..items {
            let mut mean = 0.0;
            mean.restore(from);
            if let Some(place) = into.as_mut().and_then(|it| it.mean.get_mut(item)) {
                *place = mean;
            }
        }
        from.limits.within(LARGEST);
        let known = ItemSet::first(items as u16);
        let mask = ItemSet::take(words, from).intersection(&known);
        let mut told = false;
        told.restore(from);
        if let Some(it) = into {
            let added = ItemSet::first(ITEMS as u16).difference(&known);
            it.mask = mask.union(&added);
            it.told = told;
        }
    }
}

#[cfg(test)]
#[path = "relevance_tests.rs"]
mod tests;
