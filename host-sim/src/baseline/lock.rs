//! The controller `lock`: follows the nearest blob, with hysteresis.
//!
//! Steers by the exclusive percept: once it drives it drives on while the blob stays in s2 to s4,
//! and turns again only when the blob is far out.
//! The Stage runs' `lock` is described in a sentence only (`host-sim/data/stage/README.md`): this
//! is a reading of it.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::sector::Sector;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::pioneer::{FORWARD, S1};

/// A [`Sector`] that tolerates a blob beside the middle while it drives.
#[derive(Clone, Debug)]
pub struct Lock {
    servo: Sector,
    driving: bool,
}

impl Lock {
    /// A servo for a robot that drives `forward` metres in one action.
    #[must_use]
    pub fn new(forward: f64) -> Self {
        Self {
            servo: Sector::new(forward),
            driving: false,
        }
    }
}

impl Controller for Lock {
    fn choose(&mut self, percept: &Percept, rng: &mut Rng) -> usize {
        let on = |sector: u16| percept.get(ItemId(S1 + sector)) == Some(true);
        let action = self.servo.choose(percept, rng);
        let inner = on(1) || on(2) || on(3);
        let choice = if self.driving && inner {
            FORWARD
        } else {
            action
        };
        self.driving = choice == FORWARD && on(2);
        choice
    }
}
