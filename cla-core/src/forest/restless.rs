//! When anything is tried: by chance, where a goal is out of sight, where nothing was earned for long.

use super::mind::{Age, Mind};
use super::step::Motive;
use crate::reason::Reasoning;

/// Random actions that follow each other where there is a reason: plans undo a single one at once.
const STROLL: u16 = 20;

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS>,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// Whether it does anything at all, and why.
    pub(super) fn restless(&mut self) -> Option<Motive> {
        if self.is_lost() {
            return Some(Motive::Chance);
        }
        if self.stroll > 0 {
            self.stroll -= 1;
            return Some(Motive::Chance);
        }
        let share = match self.age {
            Age::Acting => self.config.exploring_acting,
            _ => self.config.exploring,
        };
        let stroll = if R::THERE { STROLL } else { 1 };
        if self.rng.chance(setting_out(share, stroll)) {
            self.stroll = stroll - 1;
            return Some(Motive::Chance);
        }
        if self.burst == 0 && self.earned > 0 {
            let patience = (8.0 * self.wait).max(f32::from(self.config.patience));
            if f32::from(self.since) >= patience {
                self.burst = self.config.burst;
                self.since = 0;
            }
        }
        if self.burst > 0 {
            self.burst -= 1;
            return Some(Motive::Escape);
        }
        None
    }
}

/// The chance to set out for a stroll when none is under way, so that this share of all actions is
/// of strolls of such a length.
fn setting_out(share: f32, length: u16) -> f32 {
    let length = f32::from(length);
    share / (length * (1.0 - share) + share)
}

#[cfg(test)]
mod tests {
    use super::setting_out;

    #[test]
    fn a_share_of_random_actions_is_a_share_of_all() {
        for (share, length) in [(0.1, 1), (0.1, 20), (0.5, 20), (1.0, 20), (0.0, 20)] {
            let begun = setting_out(share, length);
            assert!((0.0..=1.0).contains(&begun));
            // A stroll begins after so many other actions that may begin one.
            let length = f32::from(length);
            let random = length * begun;
            let all = random + 1.0 - begun;
            assert!((random / all - share).abs() < 1e-6, "{share} {length}");
        }
    }
}
