//! The cart: its items, actions and values, and its sensors' thresholds.

use cla_core::Threshold;

cla_core::brain! {
    /// A cart that wants to stand in its charger and not to bump.
    pub mod cart {
        items: [near_left, near_ahead, near_right, light_left, light_right, bump, charging],
        actions: [forward, left, right, back, stop],
        values: [charging = 10.0, bump = -2.0],
        safe: stop,
        samples: 2_048,
        ram: 72_000,
    }
}
use cart::{Action, Item, Percept};

/// What the part measures in one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readings {
    /// Range sensors left, ahead and right, volts: an infrared sensor says more when something is near.
    pub ranges: [f32; 3],
    /// Light sensors left and right, volts.
    pub lights: [f32; 2],
    /// Whether the bumper's switch is closed.
    pub bumped: bool,
    /// Whether the charger's contacts have voltage.
    pub charging: bool,
}

/// A reading that a sensor of this supply cannot give: below it lies a short circuit, above it an
/// open one. What is outside becomes NaN, so the item is unknown and not off.
pub const POSSIBLE: core::ops::RangeInclusive<f32> = 0.02..=3.25;

/// Sensors as items.
#[derive(Clone, Copy, Debug)]
pub struct Senses {
    ranges: [Threshold; 3],
    lights: [Threshold; 2],
    bump: Threshold,
    charging: Threshold,
}

impl Senses {
    /// Thresholds for infrared sensors of 10 to 80 cm and photo resistors at 3.3 V: 1.1 V is about
    /// 25 cm.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            ranges: [Threshold::above(1.1).band(0.1).debounced(2); 3],
            lights: [Threshold::above(1.6).band(0.15).debounced(2); 2],
            // A switch that bounces must be seen at once when it closes; a tick is longer than a bounce.
            bump: Threshold::above(0.5),
            charging: Threshold::above(0.5).debounced(3),
        }
    }

    /// The percept after one more tick.
    pub fn sense(&mut self, readings: &Readings) -> Percept {
        let possible = |volts: f32| {
            if POSSIBLE.contains(&volts) {
                volts
            } else {
                f32::NAN
            }
        };
        let level = |on: bool| if on { 1.0 } else { 0.0 };
        let [left, ahead, right] = &mut self.ranges;
        let [light_left, light_right] = &mut self.lights;
        let [range_left, range_ahead, range_right] = readings.ranges.map(possible);
        let [bright_left, bright_right] = readings.lights.map(possible);
        let (bump, charging) = (&mut self.bump, &mut self.charging);
        cart::percept(|item| match item {
            Item::near_left => left.read(range_left),
            Item::near_ahead => ahead.read(range_ahead),
            Item::near_right => right.read(range_right),
            Item::light_left => light_left.read(bright_left),
            Item::light_right => light_right.read(bright_right),
            Item::bump => bump.read(level(readings.bumped)),
            Item::charging => charging.read(level(readings.charging)),
        })
    }
}

impl Default for Senses {
    fn default() -> Self {
        Self::new()
    }
}

/// Speeds of the left and right wheel, from -1 to 1.
///
/// A bumper that is pressed lets the cart go back and turn, whatever it was told: a reflex below the
/// brain, which sees from the items what it did.
#[must_use]
pub const fn wheels(action: Action, bumped: bool) -> (f32, f32) {
    match action {
        Action::forward if bumped => (0.0, 0.0),
        Action::forward => (0.6, 0.6),
        Action::left => (-0.4, 0.4),
        Action::right => (0.4, -0.4),
        Action::back => (-0.5, -0.5),
        Action::stop => (0.0, 0.0),
    }
}
