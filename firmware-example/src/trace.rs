//! What a robot sensed and did, recorded: three bytes a step.
//!
//! The percept before, the action, the percept after it; a percept is one bit an item, item 0
//! lowest, and an action that was a reflex has bit 7.
//! The recording is that of a brain with the seed [`SEED`] in the reference world, which lives as
//! [`relive`](crate::replay::relive) says; make it again with
//! `cargo run --release -p host-sim --example record_trace`.

use cla_core::forager::pioneer::{ITEMS, Percept};
use cla_core::word::{ActionId, ItemId};

/// The seed of the recorded brain's life.
pub const SEED: u64 = 7;

/// Recorded actions; the steps of reflexes come on top.
pub const ACTIONS: u32 = 20_000;

/// The recording.
pub static RECORDED: &[u8] = include_bytes!("../trace.bin");

/// Marks the action of a step as a reflex.
const REFLEX: u8 = 0x80;

/// One recorded action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What the robot sensed when it chose.
    pub before: Percept,
    /// What it did.
    pub action: ActionId,
    /// What it sensed afterwards.
    pub after: Percept,
    /// Whether its body did it, unasked.
    pub reflex: bool,
}

impl Step {
    /// The step as it is recorded.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; 3] {
        let reflex = if self.reflex { REFLEX } else { 0 };
        let action = self.action.0 as u8 | reflex;
        [to_bits(&self.before), action, to_bits(&self.after)]
    }

    /// The step that was recorded so.
    #[must_use]
    pub fn from_bytes([before, action, after]: [u8; 3]) -> Self {
        Self {
            before: from_bits(before),
            action: ActionId((action & !REFLEX).into()),
            after: from_bits(after),
            reflex: action & REFLEX != 0,
        }
    }
}

/// The steps of the first `actions` recorded actions, in order, each with its reflexes.
pub fn steps(actions: u32) -> impl Iterator<Item = Step> {
    let (steps, _) = RECORDED.as_chunks::<3>();
    let mut begun = 0;
    let steps = steps.iter().map(|&bytes| Step::from_bytes(bytes));
    steps.take_while(move |step| {
        begun += u32::from(!step.reflex);
        begun <= actions
    })
}

/// A percept as one bit an item, item 0 lowest.
#[must_use]
pub fn to_bits(percept: &Percept) -> u8 {
    percept.on().words()[0] as u8
}

/// The percept of these bits; those above the last item say nothing.
#[must_use]
pub fn from_bits(bits: u8) -> Percept {
    let mut now = Percept::all_off(ITEMS.len() as u16);
    for item in (0..ITEMS.len() as u16).filter(|item| bits >> item & 1 == 1) {
        // The ids below the number of items always fit.
        let _ = now.set(ItemId(item), Some(true));
    }
    now
}
