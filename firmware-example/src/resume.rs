//! A life that is broken off on one machine and goes on on another, along the recording.
//!
//! The host lives the beginning and saves the brain; the board loads the image, lives on and saves it
//! again; the host takes it back.
//! Equal fingerprints and equal bytes mean that nobody could tell where it lived.

use cla_core::agent::{AgentError, Reason};

use crate::fingerprint::Fingerprint;
use crate::profile::VOCABULARY;
use crate::replay::Forager;
use crate::trace;
use cla_core::snapshot::Names;
use cla_core::som::Prototypes;

/// Own actions before the brain goes to the board, and before it comes back.
pub const THERE: u32 = 3_000;
/// See [`THERE`].
pub const BACK: u32 = 4_000;

/// The file that the board reads, and the one that it writes.
pub const TO_BOARD: &str = "to-board.brain";
/// See [`TO_BOARD`].
pub const FROM_BOARD: &str = "from-board.brain";

/// Slots for generations of the brain in flash, and the bytes of each: whole pages, and room for the
/// largest image.
pub const SLOTS: usize = 3;
/// See [`SLOTS`].
pub const SLOT: u32 = if cfg!(feature = "small") { 96 } else { 256 } * 1024;

/// What the items and actions of the brain are called, for its image; the same in both profiles.
#[must_use]
pub fn names() -> Names {
    VOCABULARY.names()
}

/// Lives the recorded actions from one to another; answers a number that stands for every choice and
/// every lesson.
///
/// # Errors
/// [`AgentError`] when the brain refuses.
pub fn live<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    from: u32,
    to: u32,
) -> Result<Fingerprint, AgentError> {
    let mut print = Fingerprint::new();
    let mut begun = 0;
    for step in trace::steps(to) {
        begun += u32::from(!step.reflex);
        // The reflexes of the last action before belong to it.
        if begun <= from {
            continue;
        }
        if step.reflex {
            brain.observe(&step.before, step.action, &step.after)?;
            continue;
        }
        let choice = brain.choose(&step.before)?;
        print.number(u32::from(choice.action.0));
        print.number(u32::from(choice.reason == Reason::Value));
        print.float(choice.value);
        brain.redirect(step.action)?;
        let lesson = brain.learn(&step.after)?;
        print.float(lesson.reward);
        print.number(u32::from(lesson.outcome.succeeded));
    }
    Ok(print)
}
