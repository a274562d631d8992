//! A robot that circles a lamp, small enough for a million images, and the brains that it may have.

use cla_core::forest::Mind;
use cla_core::num::Rng;
use cla_core::snapshot::Names;
use cla_core::word::ItemId;

use crate::world::{Percept, World};

macro_rules! with_maps {
    ($name:ident, $($maps:tt)+) => {
        cla_core::brain! {
            /// The book's learner.
            pub(super) mod $name {
                items: [light_left, light_ahead, light_right, at_lamp],
                actions: [left, forward, right],
                values: [at_lamp = 10.0],
                maps: $($maps)+,
                patterns: 16,
                schemas: 32,
                synthetic: 12,
                beliefs: 24,
                ram: 20_000,
            }
        }
    };
}

with_maps!(floats, 4 x 3);
with_maps!(bytes, 4 x 3 of bytes);

/// The one learner, with room for 128 samples.
pub(super) type SmallMind = Mind<1, 4, 3, 8, 12, 32, 48, 160>;

/// What its items and actions are called.
pub(super) fn names() -> Names {
    floats::VOCABULARY.names()
}

/// The robot and the lamp, which is elsewhere as soon as it was reached.
#[derive(Clone, Debug)]
pub(super) struct Lamp {
    rng: Rng,
    /// Where the lamp is: −2 far to the right, 0 ahead, 2 far to the left.
    bearing: i32,
    distance: i32,
    reached: u32,
    /// Whether left and right are exchanged.
    pub(super) turned: bool,
}

impl Lamp {
    /// A room in which `seed` decides where the lamp is, and when it moves.
    pub(super) const fn new(seed: u64) -> Self {
        Self {
            rng: Rng::stream(seed, 71),
            bearing: 1,
            distance: 3,
            reached: 0,
            turned: false,
        }
    }
}

impl World for Lamp {
    fn items(&self) -> &'static [&'static str] {
        floats::VOCABULARY.items
    }

    fn actions(&self) -> &'static [&'static str] {
        floats::VOCABULARY.actions
    }

    fn sense(&self) -> Percept {
        let mut now = Percept::all_off(floats::ITEMS.len() as u16);
        for (item, on) in [
            (0, self.bearing == 1),
            (1, self.bearing == 0),
            (2, self.bearing == -1),
            (3, self.distance == 0),
        ] {
            let set = now.set(ItemId(item), Some(on));
            debug_assert!(set.is_ok(), "four items fit a percept");
        }
        now
    }

    fn act(&mut self, action: usize) {
        let action = if self.turned {
            2 - action.min(2)
        } else {
            action
        };
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
        self.reached += u32::from(self.distance == 0);
    }

    fn obtained(&self) -> u32 {
        self.reached
    }
}
