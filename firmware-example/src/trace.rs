//! What a robot sensed and did, recorded: three bytes an action.
//!
//! The percept before, the action, the percept after it and before its reflexes; a percept is one
//! bit an item, item 0 lowest.
//! The recording is that of a brain with the seed [`SEED`] in the reference world; make it again
//! with `cargo run --release -p host-sim --example record_trace`.

use cla_core::clasm::{ActionId, ItemId};
use cla_core::forager::pioneer::{ITEMS, Percept};

/// The seed of the recorded brain's life.
pub const SEED: u64 = 7;

/// Recorded actions.
pub const ACTIONS: usize = 2_000;

/// The recording.
pub static RECORDED: &[u8; 3 * ACTIONS] = include_bytes!("../trace.bin");

/// One recorded action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What the robot sensed when it chose.
    pub before: Percept,
    /// What it did.
    pub action: ActionId,
    /// What it sensed afterwards.
    pub after: Percept,
}

impl Step {
    /// The step as it is recorded.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; 3] {
        [bits(&self.before), self.action.0 as u8, bits(&self.after)]
    }

    /// The step that was recorded so.
    #[must_use]
    pub fn from_bytes([before, action, after]: [u8; 3]) -> Self {
        Self {
            before: percept(before),
            action: ActionId(action.into()),
            after: percept(after),
        }
    }
}

/// All recorded steps, in order.
pub fn steps() -> impl Iterator<Item = Step> {
    let (steps, _) = RECORDED.as_chunks::<3>();
    steps.iter().map(|&bytes| Step::from_bytes(bytes))
}

fn bits(percept: &Percept) -> u8 {
    percept.on().words()[0] as u8
}

fn percept(bits: u8) -> Percept {
    let mut now = Percept::all_off(ITEMS.len() as u16);
    for item in (0..ITEMS.len() as u16).filter(|item| bits >> item & 1 == 1) {
        // The ids below the number of items always fit.
        let _ = now.set(ItemId(item), Some(true));
    }
    now
}
