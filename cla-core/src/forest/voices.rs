//! Who decides: voices lead in turn, and the one under whom most was earned leads on.
//!
//! A voice leads for a block of actions; its track record is a moving average of what its blocks
//! brought: of every reward so much as the actions before it may claim, discounted, so that short
//! episodes and long ones, and worlds without episodes, are judged by one measure.
//! All voices learn from everything, whoever leads.

use crate::num::Rng;
use crate::snapshot::stored;

/// How much of a track record a new block makes, at least.
const NEWEST: f32 = 0.1;

/// Of what comes, in the judgement of a voice.
const DISCOUNT: f32 = 0.98;

/// The track records of `VOICES` voices.
#[derive(Clone, Debug)]
pub(super) struct Voices<const VOICES: usize> {
    earned: [f32; VOICES],
    blocks: [u16; VOICES],
    leader: u8,
    /// Actions of the present block that are left, and how many it had.
    left: u16,
    done: u16,
    gathered: f32,
    /// What a reward counts now: one for every action before it, discounted, that it may be due to.
    reach: f32,
}

impl<const VOICES: usize> Voices<VOICES> {
    pub(super) const fn new() -> Self {
        Self {
            earned: [0.0; VOICES],
            blocks: [0; VOICES],
            leader: 0,
            left: 0,
            done: 0,
            gathered: 0.0,
            reach: 0.0,
        }
    }

    /// What a voice has earned an action, and in how many blocks.
    pub(super) fn record(&self, voice: u8) -> (f32, u16) {
        let at = usize::from(voice);
        (
            self.earned.get(at).copied().unwrap_or(0.0),
            self.blocks.get(at).copied().unwrap_or(0),
        )
    }

    /// The voice that leads the next action; when a block is over, or its leader is not heard any
    /// more, the best leads the next one, or with the chance `other` any.
    pub(super) fn lead(&mut self, block: u16, other: f32, heard: u8, rng: &mut Rng) -> u8 {
        // A leader that there is not, after a bit turned, is heard by nobody.
        let led = heard.checked_shr(u32::from(self.leader)).unwrap_or(0) & 1 == 1;
        if self.left == 0 || !led {
            self.judge();
            self.leader = if rng.chance(other) {
                let mut drawn = rng.below(heard.count_ones());
                let mut voice = 0;
                while voice < VOICES as u8 {
                    if heard >> voice & 1 == 1 {
                        if drawn == 0 {
                            break;
                        }
                        drawn -= 1;
                    }
                    voice += 1;
                }
                voice
            } else {
                self.best(heard)
            };
            self.left = block;
            self.done = 0;
            self.gathered = 0.0;
            self.reach = 0.0;
        }
        self.left = self.left.saturating_sub(1);
        self.leader
    }

    fn judge(&mut self) {
        let at = usize::from(self.leader);
        if self.done == 0 {
            return;
        }
        if let (Some(earned), Some(blocks)) = (self.earned.get_mut(at), self.blocks.get_mut(at)) {
            *blocks = blocks.saturating_add(1);
            let share = (1.0 / f32::from(*blocks)).max(NEWEST);
            *earned += share * (self.gathered / f32::from(self.done) - *earned);
        }
    }

    /// The best of those that have led; who never has goes first, ties to the first.
    fn best(&self, heard: u8) -> u8 {
        let mut best: Option<(f32, u8)> = None;
        for (voice, (earned, blocks)) in self.earned.iter().zip(&self.blocks).enumerate() {
            if heard >> voice & 1 == 0 {
                continue;
            }
            if *blocks == 0 {
                return voice as u8;
            }
            if best.is_none_or(|(most, _)| *earned > most) {
                best = Some((*earned, voice as u8));
            }
        }
        best.map_or(0, |(_, voice)| voice)
    }

    /// The episode is over: what comes is not due to what was.
    pub(super) const fn interrupt(&mut self) {
        self.reach = 0.0;
    }

    /// An action has brought this.
    pub(super) fn gather(&mut self, reward: f32) {
        self.done = self.done.saturating_add(1);
        self.reach = DISCOUNT * self.reach + 1.0;
        self.gathered += reward * self.reach;
    }
}

stored! {
    impl[const VOICES: usize] Voices<VOICES> {
        earned, blocks, leader, left, done, gathered, reach
    }
}

#[cfg(test)]
#[path = "voices_tests.rs"]
mod tests;
