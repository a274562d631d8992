//! A robot that circles a lamp, small enough for a thousand lives, and the brains it may have.

use cla_core::agent::Agent;
use cla_core::num::Rng;
use cla_core::snapshot::Stored;
use cla_core::som::Prototypes;
use cla_core::word::{ActionId, ItemId, ItemStates};

macro_rules! robot {
    ($name:ident, $patterns:literal, $($maps:tt)+) => {
        cla_core::brain! {
            /// A robot that wants to stand in the light.
            pub mod $name {
                items: [light_left, light_ahead, light_right, at_lamp],
                actions: [left, forward, right],
                values: [at_lamp = 10.0],
                maps: $($maps)+,
                patterns: $patterns,
                schemas: 32,
                synthetic: 12,
                beliefs: 24,
                ram: 20_000,
            }
        }
    };
}

robot!(floats, 16, 4 x 3);
robot!(bytes, 16, 4 x 3 of bytes);
robot!(larger, 24, 4 x 3 of bytes);

/// The world; `turned`, its actions are exchanged.
#[derive(Clone, Debug)]
pub(crate) struct Lamp {
    rng: Rng,
    bearing: i32,
    distance: i32,
    pub(crate) turned: bool,
}

impl Lamp {
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            rng: Rng::new(seed),
            bearing: 1,
            distance: 3,
            turned: false,
        }
    }

    pub(crate) fn sense(&self) -> ItemStates<1> {
        let mut now = ItemStates::all_off(4);
        for (item, on) in [
            (0, self.bearing == 1),
            (1, self.bearing == 0),
            (2, self.bearing == -1),
            (3, self.distance == 0),
        ] {
            now.set(ItemId(item), Some(on)).unwrap();
        }
        now
    }

    fn act(&mut self, action: ActionId) {
        let action = if self.turned { 2 - action.0 } else { action.0 };
        if self.distance == 0 || self.rng.chance(0.1) {
            self.bearing = self.rng.below(5) as i32 - 2;
            self.distance = 1 + self.rng.below(5) as i32;
            return;
        }
        match action {
            0 => self.bearing = (self.bearing - 1).max(-2),
            2 => self.bearing = (self.bearing + 1).min(2),
            _ if self.bearing == 0 => self.distance -= 1,
            _ => {}
        }
    }

    /// Lives for so many actions; a fingerprint of all that was chosen and learned.
    pub(crate) fn live<const S: usize, const B: usize, const P: usize, M>(
        &mut self,
        brain: &mut Agent<1, 4, 4, 3, 3, P, 32, S, B, M>,
        actions: u32,
    ) -> u64
    where
        M: Prototypes<4, 3> + Stored,
    {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for step in 0..actions {
            let choice = brain.choose(&self.sense()).unwrap();
            self.act(choice.action);
            if step % 37 == 5 {
                // A reflex, which the brain only sees.
                let before = self.sense();
                self.act(ActionId(0));
                brain.observe(&before, ActionId(0), &self.sense()).unwrap();
            }
            let lesson = brain.learn(&self.sense()).unwrap();
            let (outcome, cost) = (lesson.outcome, brain.cost());
            for number in [
                u32::from(choice.action.0),
                choice.value.to_bits(),
                lesson.reward.to_bits(),
                u32::from(outcome.activated) << 16 | u32::from(outcome.succeeded),
                outcome.schema.map_or(0, |it| u32::from(it.0) + 1),
                u32::from(lesson.harvested),
                cost.moved ^ cost.schemas << 8 ^ cost.beliefs << 16 ^ cost.habits << 24,
            ] {
                for byte in number.to_le_bytes() {
                    hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
                }
            }
        }
        hash
    }
}
