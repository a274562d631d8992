//! What a leaf's samples say about every feature, and which question splits them best.
//!
//! Sums are of differences to the parent's value, so that nothing is lost to cancellation.

use super::moment::Moment;
use super::relevance::Relevance;
use super::step::MOST_SQUARES;
use crate::snapshot::stored;
use crate::word::ItemSet;

/// Samples that a split leaves on each side, at least.
const LEAST: u16 = 8;
/// How clearly a question tells values apart, at least (F statistic).
const CLEAR: f32 = 5.0;
/// The same for an item outside of the mask.
const CLEAR_OUTSIDE: f32 = 12.0;
/// What a sample that may be of another world weighs in a leaf.
const OLD: f32 = 0.1;
/// Of the sum of squares: what is less may be rounding, and explains nothing.
const ROUNDING: f32 = 1.0e-5;

/// Of one feature: samples in which it holds, and samples in which nobody knows.
#[derive(Clone, Copy, Debug)]
struct Share {
    on: u16,
    unknown: u16,
    on_sum: f32,
    unknown_sum: f32,
}

impl Share {
    const ZERO: Self = Self {
        on: 0,
        unknown: 0,
        on_sum: 0.0,
        unknown_sum: 0.0,
    };

    fn hold(&mut self, value: f32) {
        self.on = self.on.saturating_add(1);
        self.on_sum += value;
    }

    fn miss(&mut self, value: f32) {
        self.unknown = self.unknown.saturating_add(1);
        self.unknown_sum += value;
    }
}

/// A question, and how much squared error it takes away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Split {
    pub(super) gain: f32,
    pub(super) feature: u8,
    /// The share of the samples that answer yes, in 1/256.
    pub(super) share: u8,
}

/// Counts and sums of the leaf in work.
#[derive(Clone, Debug)]
pub(super) struct Tally<const ITEMS: usize, const ACTIONS: usize> {
    count: u16,
    sum: f32,
    squares: f32,
    /// Of the samples that may be of another world.
    old: u16,
    old_sum: f32,
    now: [Share; ITEMS],
    before: [Share; ITEMS],
    after: [Share; ACTIONS],
}

impl<const ITEMS: usize, const ACTIONS: usize> Tally<ITEMS, ACTIONS> {
    pub(super) const fn new() -> Self {
        Self {
            count: 0,
            sum: 0.0,
            squares: 0.0,
            old: 0,
            old_sum: 0.0,
            now: [Share::ZERO; ITEMS],
            before: [Share::ZERO; ITEMS],
            after: [Share::ZERO; ACTIONS],
        }
    }

    pub(super) const fn clear(&mut self) {
        *self = Self::new();
    }

    /// Adds a sample whose target differs from the parent's value by `value`; answers the units.
    pub(super) fn add<const WORDS: usize>(
        &mut self,
        moment: &Moment<WORDS>,
        value: f32,
        recent: bool,
    ) -> u32 {
        self.count = self.count.saturating_add(1);
        self.sum += value;
        self.squares += value * value;
        if !recent {
            self.old = self.old.saturating_add(1);
            self.old_sum += value;
        }
        let all = ItemSet::<WORDS>::first(ITEMS as u16);
        let mut counted = 14;
        for (states, shares) in [
            (&moment.now, &mut self.now),
            (&moment.before, &mut self.before),
        ] {
            for item in states.on().iter() {
                if let Some(share) = shares.get_mut(usize::from(item.0)) {
                    share.hold(value);
                    counted += 1;
                }
            }
            for item in all.difference(&states.known()).iter() {
                if let Some(share) = shares.get_mut(usize::from(item.0)) {
                    share.miss(value);
                    counted += 1;
                }
            }
        }
        match self.after.get_mut(usize::from(moment.action)) {
            Some(share) => share.hold(value),
            None => {
                for share in &mut self.after {
                    share.miss(value);
                    counted += 1;
                }
            }
        }
        counted
    }

    /// The mean difference to the parent's value, drawn to 0 as if `prior` more samples had none.
    pub(super) fn shift(&self, prior: f32) -> f32 {
        let (count, old) = (f32::from(self.count), f32::from(self.old));
        let forgotten = 1.0 - OLD;
        let doubtful = if self.old > 0 { 1.0 } else { prior };
        (self.sum - forgotten * self.old_sum) / (count - forgotten * old + doubtful)
    }

    /// The question that takes away most squared error, if any is clear; notes what items could
    /// tell apart, all of them where the leaf is a root.
    pub(super) fn best<const WORDS: usize>(
        &self,
        is_root: bool,
        relevance: &mut Relevance<WORDS, ITEMS>,
    ) -> Option<Split> {
        if self.count < 2 * LEAST {
            return None;
        }
        let all = f32::from(self.count);
        let spread = self.squares - self.sum * self.sum / all;
        let floor = ROUNDING * self.squares;
        let mut best: Option<(Split, f32)> = None;
        let shares = self.now.iter().chain(&self.before).chain(&self.after);
        for (feature, share) in shares.enumerate() {
            let feature = feature as u8;
            let off = self
                .count
                .saturating_sub(share.on.saturating_add(share.unknown));
            if share.on < LEAST || off < LEAST {
                continue;
            }
            let (on, off) = (f32::from(share.on), f32::from(off));
            let off_sum = self.sum - share.on_sum - share.unknown_sum;
            let difference = share.on_sum / on - off_sum / off;
            let gain = difference * difference * (on * off / (on + off));
            // What sums that cannot be so tell apart, after a bit turned, is nothing.
            let tells = gain > floor && gain <= MOST_SQUARES;
            if !tells {
                continue;
            }
            let rest = (spread - gain).max(floor);
            let clear = gain * (all - 1.0) / rest;
            if is_root {
                relevance.note(feature, clear);
            }
            let asked = if relevance.is_doubtful(feature) {
                CLEAR_OUTSIDE
            } else {
                CLEAR
            };
            if clear > asked && best.is_none_or(|(split, _)| gain > split.gain) {
                let share = (256.0 * on / (on + off)).min(255.0) as u8;
                let split = Split {
                    gain,
                    feature,
                    share,
                };
                best = Some((split, clear));
            }
        }
        let (split, clear) = best?;
        relevance.note(split.feature, clear);
        Some(split)
    }
}

stored! { impl[] Share { on, unknown, on_sum, unknown_sum } }
stored! {
    impl[const ITEMS: usize, const ACTIONS: usize] Tally<ITEMS, ACTIONS> {
        count, sum, squares => up_to MOST_SQUARES, old, old_sum, now, before, after
    }
}
