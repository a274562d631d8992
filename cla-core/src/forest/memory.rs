//! The memory of samples: what was perceived, what was done there, what it brought.
//!
//! Samples lie in stretches of sixteen, in the order in which they were lived, so that the moment
//! before and the moment after are neighbours and need no memory of their own.
//! A full memory gives up its oldest stretch.

use super::moment::{Moment, NO_ACTION};
use super::step::{MOST_EARNED, MOST_WORTH};
use crate::snapshot::{Reader, Stored, Writer, bounded, stored};
use crate::word::{ItemId, ItemStates};

/// Samples of a stretch.
pub(super) const STRETCH: usize = 16;

/// Nothing follows: the episode has ended here.
const ENDS: u8 = 1;
/// Nothing was before: an episode begins here.
const BEGINS: u8 = 2;
/// It was not the learner's own choice.
const WATCHED: u8 = 4;
/// Its target is known.
const TARGET: u8 = 8;

/// One action, where it was done, and what it brought.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<const WORDS: usize> {
    pub(super) now: ItemStates<WORDS>,
    pub(super) reward: f32,
    target: f32,
    pub(super) action: u8,
    marks: u8,
}

impl<const WORDS: usize> Sample<WORDS> {
    const NONE: Self = Self {
        now: ItemStates::UNKNOWN,
        reward: 0.0,
        target: 0.0,
        action: 0,
        marks: 0,
    };

    pub(super) const fn new(now: &ItemStates<WORDS>, action: u8, reward: f32) -> Self {
        Self {
            now: *now,
            reward,
            target: 0.0,
            action,
            marks: 0,
        }
    }

    pub(super) const fn watched(mut self) -> Self {
        self.marks |= WATCHED;
        self
    }

    pub(super) const fn beginning(mut self) -> Self {
        self.marks |= BEGINS;
        self
    }

    pub(super) const fn is_watched(&self) -> bool {
        self.marks & WATCHED != 0
    }

    pub(super) const fn ends(&self) -> bool {
        self.marks & ENDS != 0
    }

    const fn begins(&self) -> bool {
        self.marks & BEGINS != 0
    }

    /// Whether it can be so, of a robot of so many actions.
    fn can_be(&self, actions: u16) -> bool {
        u16::from(self.action) < actions
            && self.reward.abs() <= MOST_EARNED
            && self.target.abs() <= MOST_WORTH
    }

    /// What it was worth, reward and what followed; `None` while nobody knows.
    pub(super) fn target(&self) -> Option<f32> {
        (self.marks & TARGET != 0).then_some(self.target)
    }
}

/// The last samples, in a ring of stretches.
#[derive(Clone, Debug)]
pub(super) struct Memory<const WORDS: usize, const STRETCHES: usize> {
    samples: [[Sample<WORDS>; STRETCH]; STRETCHES],
    /// Where the next sample goes.
    head: u16,
    /// How many there are.
    len: u16,
    /// How many of the newest tell of the world as it is.
    recent: u16,
}

impl<const WORDS: usize, const STRETCHES: usize> Memory<WORDS, STRETCHES> {
    pub(super) const CAPACITY: u16 = {
        assert!(
            STRETCHES >= 2 && STRETCHES < 4096,
            "a memory has 2 to 4095 stretches of 16 samples"
        );
        (STRETCHES * STRETCH) as u16
    };

    pub(super) const fn new() -> Self {
        let _ = Self::CAPACITY;
        Self {
            samples: [[Sample::NONE; STRETCH]; STRETCHES],
            head: 0,
            len: 0,
            recent: 0,
        }
    }

    /// Forgets everything, in place.
    pub(super) const fn clear(&mut self) {
        self.head = 0;
        self.len = 0;
        self.recent = 0;
    }

    pub(super) const fn len(&self) -> u16 {
        self.len
    }

    pub(super) fn get(&self, at: u16) -> Option<&Sample<WORDS>> {
        if at >= self.len {
            return None;
        }
        let at = usize::from(at);
        self.samples.get(at / STRETCH)?.get(at % STRETCH)
    }

    fn get_mut(&mut self, at: u16) -> Option<&mut Sample<WORDS>> {
        if at >= self.len {
            return None;
        }
        let at = usize::from(at);
        self.samples.get_mut(at / STRETCH)?.get_mut(at % STRETCH)
    }

    /// Enters a sample, in the place of the oldest when there is no room.
    pub(super) fn push(&mut self, sample: Sample<WORDS>) {
        if self.len < Self::CAPACITY {
            self.len += 1;
        }
        if self.recent < Self::CAPACITY {
            self.recent += 1;
        }
        let head = self.head;
        if let Some(place) = self.get_mut(head) {
            *place = sample;
        }
        let next = head.saturating_add(1);
        self.head = if next >= Self::CAPACITY { 0 } else { next };
    }

    /// Nothing that comes has to do with the newest sample.
    pub(super) fn interrupt(&mut self) {
        let newest = self.back(self.head);
        if let Some(sample) = self.get_mut(newest) {
            sample.marks |= ENDS;
        }
    }

    /// What was lived until now may be of another world.
    pub(super) const fn doubt(&mut self) {
        self.recent = 0;
    }

    /// Whether a sample is of the world as it is.
    pub(super) fn is_recent(&self, at: u16) -> bool {
        let newest = self.back(self.head);
        let age = if newest >= at {
            newest - at
        } else {
            newest.wrapping_add(self.len).wrapping_sub(at)
        };
        age < self.recent
    }

    /// How many of the newest are of the world as it is.
    pub(super) fn recent(&self) -> u16 {
        self.recent.min(self.len)
    }

    /// So many samples before the newest, when there are as many.
    pub(super) fn back_by(&self, samples: u16) -> Option<u16> {
        let newest = self.newest()?;
        if samples >= self.len {
            return None;
        }
        Some(if newest >= samples {
            newest - samples
        } else {
            newest.wrapping_add(self.len).wrapping_sub(samples)
        })
    }

    const fn back(&self, at: u16) -> u16 {
        if at == 0 {
            self.len.saturating_sub(1)
        } else {
            at - 1
        }
    }

    /// Where the newest sample is, when there is one.
    pub(super) const fn newest(&self) -> Option<u16> {
        if self.len == 0 {
            None
        } else {
            Some(self.back(self.head))
        }
    }

    /// The sample before this one in time, when it is still there.
    pub(super) const fn earlier(&self, at: u16) -> Option<u16> {
        let oldest = if self.len < Self::CAPACITY {
            0
        } else {
            self.head
        };
        if at == oldest {
            None
        } else {
            Some(self.back(at))
        }
    }

    /// The sample after this one in time, when there is one.
    pub(super) const fn later(&self, at: u16) -> Option<u16> {
        let next = at.saturating_add(1);
        let next = if next >= Self::CAPACITY { 0 } else { next };
        if next == self.head { None } else { Some(next) }
    }

    /// The moment of a sample: what was perceived there and just before.
    pub(super) fn moment(&self, at: u16) -> Moment<WORDS> {
        let Some(sample) = self.get(at) else {
            return Moment::UNKNOWN;
        };
        let mut moment = Moment::first(&sample.now);
        if !sample.begins()
            && let Some(before) = self.earlier(at).and_then(|before| self.get(before))
        {
            moment.before = before.now;
            moment.action = before.action;
        }
        debug_assert!(moment.action == NO_ACTION || !sample.begins());
        moment
    }

    /// Every action that led to an item's being on has brought what that is worth now: one after which
    /// it was perceived, and where nobody knows what was, one that brought just the `old` value if that is
    /// the item's `alone`. Answers the least and the greatest reward, 0 among them.
    pub(super) fn revalue(
        &mut self,
        item: ItemId,
        (old, value): (f32, f32),
        alone: bool,
    ) -> (f32, f32) {
        let mut ends = (0.0_f32, 0.0_f32);
        for at in 0..self.len {
            let next = self.later(at).and_then(|next| self.get(next));
            let told = next.filter(|next| !next.begins());
            let seen = told.and_then(|next| next.now.get(item));
            if let Some(sample) = self.get_mut(at) {
                let seen = seen.filter(|_| !sample.ends());
                let exactly = alone && old != 0.0 && sample.reward == old;
                if seen.unwrap_or(exactly) {
                    // Not by a difference where it can be met again: it has to be met to the bit.
                    sample.reward = if sample.reward == old {
                        value
                    } else {
                        bounded(sample.reward + (value - old), MOST_EARNED)
                    };
                }
                ends = (ends.0.min(sample.reward), ends.1.max(sample.reward));
            }
        }
        ends
    }

    /// Says what a sample was worth; a value that is no number says nothing.
    pub(super) fn set_target(&mut self, at: u16, target: f32) {
        if let Some(sample) = self.get_mut(at)
            && target.is_finite()
        {
            sample.target = bounded(target, MOST_WORTH);
            sample.marks |= TARGET;
        }
    }
}

stored! {
    impl[const WORDS: usize] Sample<WORDS> { now, reward, target, action, marks }
    sound |it, limits| it.can_be(limits.actions)
}
stored! {
    impl[const WORDS: usize, const STRETCHES: usize] Memory<WORDS, STRETCHES> {
        samples, head, len, recent
    }
}

impl<const WORDS: usize, const STRETCHES: usize> Memory<WORDS, STRETCHES> {
    /// Makes the ring one again where it is none; whether it was not.
    pub(super) fn audit(&mut self) -> bool {
        let most = Self::CAPACITY;
        let ring = if self.len < most {
            self.head == self.len
        } else {
            self.len == most && self.head < most
        };
        let sound = ring && self.recent <= most;
        if !sound {
            self.len = self.len.min(most);
            self.head = if self.len < most { self.len } else { 0 };
            self.recent = self.recent.min(most);
        }
        !sound
    }
}

impl<const WORDS: usize, const STRETCHES: usize> Memory<WORDS, STRETCHES> {
    /// Writes the samples, the oldest first.
    pub(super) fn carry(&self, to: &mut Writer<'_>) {
        to.require(self.len <= Self::CAPACITY);
        self.len.store(to);
        self.recent().store(to);
        for back in (0..self.len).rev() {
            match self.back_by(back).and_then(|at| self.get(at)) {
                Some(sample) => {
                    to.require(sample.can_be(to.limits.actions));
                    sample.now.store(to);
                    sample.reward.store(to);
                    (sample.action, sample.marks & !TARGET).store(to);
                }
                None => to.refuse(),
            }
        }
    }

    /// Reads them from a robot of so many words and actions, over what is there if there is anybody;
    /// nobody knows yet what they were worth.
    pub(super) fn take(
        mut into: Option<&mut Self>,
        (words, _, actions): (usize, usize, usize),
        from: &mut Reader<'_>,
    ) {
        if let Some(it) = &mut into {
            it.clear();
        }
        let samples = from.count("samples", usize::from(Self::CAPACITY));
        let mut recent = 0;
        recent.restore(from);
        for _ in 0..samples {
            let mut sample = Sample::new(&ItemStates::take(words, from), 0, 0.0);
            sample.reward.restore(from);
            sample.action.restore(from);
            sample.marks.restore(from);
            from.require(sample.can_be(actions as u16));
            if from.is_wrong() {
                return;
            }
            if let Some(it) = &mut into {
                it.push(sample);
            }
        }
        if let Some(it) = into {
            // An episode ends between two lives.
            it.interrupt();
            it.recent = it.recent.min(recent);
        }
    }
}

#[cfg(test)]
#[path = "memory_tests.rs"]
mod tests;
