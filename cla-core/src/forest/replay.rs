//! Experience replay (Lin 1992): habits feel once more what was lived before.
//!
//! A stretch of the memory is gone through from its last sample to its first, so that what was felt
//! at its end reaches its beginning at once; what was felt and the best that is known of the next
//! moment are mixed as in Q(λ) (Peng and Williams 1996).
//! After a doubt every replay ends in what was lived since, as soon as there is some, and goes no
//! farther back than that.

use super::memory::Memory;
use super::sarsa::{Replaying, Sarsa, Scene};
use crate::num::Rng;
use crate::word::ItemSet;

/// Fewer samples of the world as it is are not replayed for themselves.
const FEW: u16 = 64;

/// Units of a sample, without its features.
const SAMPLE: u32 = 10;
/// Features of an action that are one unit.
const AT_ONCE: u32 = 4;

/// Where a replay ends that begins anywhere in the memory, or in what is known of the world as it is.
pub(super) fn drawn<const WORDS: usize, const STRETCHES: usize>(
    memory: &Memory<WORDS, STRETCHES>,
    rng: &mut Rng,
) -> Option<u16> {
    let recent = memory.recent();
    let among = if recent < FEW { memory.len() } else { recent };
    if among == 0 {
        return None;
    }
    memory.back_by(rng.below(u32::from(among)) as u16)
}

/// Replays so many samples that end at a place of the memory; answers the units.
pub(super) fn replay<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const STRETCHES: usize,
>(
    habits: &mut Sarsa<WORDS, ITEMS, ACTIONS, ROWS>,
    memory: &Memory<WORDS, STRETCHES>,
    mask: &ItemSet<WORDS>,
    mut at: u16,
    samples: u16,
    how: &Replaying,
) -> u32 {
    let scene = |at| Scene::of(&memory.moment(at), mask, ROWS as u16);
    let Some(later) = memory.later(at) else {
        // What the newest sample has led to is not known yet.
        return 1;
    };
    let mut next = scene(later);
    // What was felt from the next moment on.
    let mut felt: Option<f32> = None;
    let mut units = 0;
    // What was lived since a doubt begins where that doubt began.
    let is_recent = memory.is_recent(at);
    for _ in 0..samples {
        if is_recent && !memory.is_recent(at) {
            break;
        }
        let Some(sample) = memory.get(at) else {
            break;
        };
        let here = scene(at);
        let follows = if sample.ends() {
            0.0
        } else {
            let best = habits.best(&next, how.discount);
            let felt = felt.unwrap_or(best);
            (1.0 - how.lambda) * best + how.lambda * felt
        };
        let target = sample.reward + how.discount * follows;
        habits.approach(&here, sample.action, target, how);
        units += SAMPLE + (2 + u32::from(here.on.len())) * ACTIONS as u32 / AT_ONCE;
        felt = Some(target);
        next = here;
        match memory.earlier(at) {
            Some(earlier) => at = earlier,
            None => break,
        }
    }
    units
}

#[cfg(test)]
#[path = "replay_tests.rs"]
mod tests;
