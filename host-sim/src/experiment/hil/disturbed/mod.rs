//! A body and a brain over a wire that is disturbed: do they stay in step, and does nothing move wrongly?
//!
//! Both sides are the machines that firmware and host have, with bytes in between and a clock that
//! goes on by milliseconds; the brain is a witness that notes what it is told.
//! A session is disturbed for a while, then the wire is clean, and at its end there are no orders any
//! more, but silence, noise or an old frame for ever.
//! What disturbs is drawn from a [`Fate`]: a generator, or the bytes of a fuzzer.

mod session;
mod sides;
mod witness;

pub use session::session;
pub use witness::PATIENCE;

use std::collections::VecDeque;

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

/// Frames of earlier sessions and of this one, which may be played back.
const TAPE: usize = 96;

/// Where chance comes from.
pub trait Fate {
    /// A number in `0..bound`; 0 means that nothing is disturbed.
    fn below(&mut self, bound: u32) -> u32;

    /// Whether something happens that happens so many times in a thousand.
    fn hits(&mut self, per_mille: u32) -> bool {
        self.below(1000) >= 1000 - per_mille.min(1000)
    }
}

impl Fate for Rng {
    fn below(&mut self, bound: u32) -> u32 {
        Self::below(self, bound)
    }
}

/// A fate that was written down: two bytes a draw, and nothing happens any more at its end.
#[derive(Clone, Copy, Debug)]
pub struct Written<'a>(pub &'a [u8]);

impl Fate for Written<'_> {
    fn below(&mut self, bound: u32) -> u32 {
        let Some((two, rest)) = self.0.split_first_chunk() else {
            return 0;
        };
        self.0 = rest;
        (u32::from(u16::from_be_bytes(*two)) * bound) >> 16
    }
}

/// What outlives a session: frames on a tape, and how often anything began.
#[derive(Clone, Debug, Default)]
pub struct Past {
    frames: VecDeque<Vec<u8>>,
    begun: u64,
    /// Whether a firmware that was reset names its sessions as it did before: what must not be.
    pub forgetful: bool,
}

impl Past {
    fn record(&mut self, frame: &[u8]) {
        if self.frames.len() == TAPE {
            self.frames.pop_front();
        }
        self.frames.push_back(frame.to_vec());
    }

    /// A number that nobody has had.
    fn fresh(&mut self) -> u64 {
        self.begun += 1;
        self.begun
    }
}

/// What came of sessions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tally {
    /// Sessions.
    pub sessions: u64,
    /// Orders that were followed, reports left out.
    pub followed: u64,
    /// Frames that a side sent.
    pub frames: u64,
    /// Frames that were lost, damaged, late, or came twice.
    pub disturbed: u64,
    /// Bursts of noise, and frames played back.
    pub intruded: u64,
    /// Resets of the brain's side and of the body's.
    pub resets: u64,
    /// Times that the robot was stopped while it moved.
    pub stops: u64,
    /// Orders followed that nobody gave, or too old, or twice, or out of turn, or after a stop, or
    /// after their body had been told that they were not followed; and answers of another order.
    pub wrong: u64,
    /// Sessions with a clean wire that needed more than three calls to an answer, or then more than one.
    pub astray: u64,
    /// Sessions whose first answer over the clean wire took one, two, three calls, or more.
    pub calls: [u64; 4],
    /// The longest time from the last order followed to the stop, in milliseconds.
    pub longest: u32,
}

impl Tally {
    /// Adds what came of others.
    pub fn merge(&mut self, other: &Self) {
        self.sessions += other.sessions;
        self.followed += other.followed;
        self.frames += other.frames;
        self.disturbed += other.disturbed;
        self.intruded += other.intruded;
        self.resets += other.resets;
        self.stops += other.stops;
        self.wrong += other.wrong;
        self.astray += other.astray;
        for (mine, theirs) in self.calls.iter_mut().zip(other.calls) {
            *mine += theirs;
        }
        self.longest = self.longest.max(other.longest);
    }
}

/// So many sessions, one after the other, all of a seed.
#[must_use]
pub fn many(seed: u64, sessions: u32, forgetful: bool) -> Tally {
    let mut fate = Rng::stream(seed, 17);
    let mut tally = Tally::default();
    let mut past = Past {
        forgetful,
        ..Past::default()
    };
    for _ in 0..sessions {
        session(&mut fate, &mut past, &mut tally);
    }
    tally
}
