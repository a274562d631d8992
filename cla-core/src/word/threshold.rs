//! From a continuous sensor to an item: a threshold with a band, and readings that must agree.

/// Makes an item of a sensor's readings: a Schmitt trigger with debouncing.
///
/// An item that flickers about its threshold, or follows every spike of a cable, is learned from as if
/// the world did so. The band (hysteresis) keeps the item as it is while the reading is near the
/// threshold; debouncing lets it change only after so many readings in a row that say the same.
/// Readings are in the sensor's own unit. One that is NaN makes the item unknown at once, and what is
/// known again is believed at the first reading: a sensor that fails says nothing, so it must not say
/// *off*. Infinite readings are compared as numbers (nothing in reach of a range sensor).
///
/// ```
/// use cla_core::word::Threshold;
/// // Near: the range in metres falls below .4, and is far again above .5.
/// let mut near = Threshold::below(0.45).band(0.05);
/// assert_eq!(near.read(0.9), Some(false));
/// assert_eq!(near.read(0.42), Some(false)); // within the band: as it was
/// assert_eq!(near.read(0.39), Some(true));
/// assert_eq!(near.read(0.48), Some(true));
/// assert_eq!(near.read(f32::NAN), None);
/// // A bumper that bounces: three readings must agree.
/// let mut bump = Threshold::above(0.5).debounced(3);
/// let told = [0.0, 1.0, 0.0, 1.0, 1.0, 1.0].map(|reading| bump.read(reading));
/// assert_eq!(told, [false, false, false, false, false, true].map(Some));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    low: f32,
    high: f32,
    /// Whether it is on above, or below.
    above: bool,
    /// Readings that must agree before the item changes.
    agree: u8,
    /// Readings in a row that contradicted the state.
    against: u8,
    state: Option<bool>,
}

impl Threshold {
    const fn at(level: f32, above: bool) -> Self {
        Self {
            low: level,
            high: level,
            above,
            agree: 1,
            against: 0,
            state: None,
        }
    }

    /// On above `level`, off at it and below. A level that is NaN makes every reading unknown.
    #[must_use]
    pub const fn above(level: f32) -> Self {
        Self::at(level, true)
    }

    /// On below `level`, off at it and above.
    #[must_use]
    pub const fn below(level: f32) -> Self {
        Self::at(level, false)
    }

    /// The item keeps its state while the reading is at most `half` from the level (≥ 0, in the unit
    /// of the readings). One that is negative or no number makes every reading unknown, so that the
    /// mistake is seen at the first.
    #[must_use]
    pub const fn band(mut self, half: f32) -> Self {
        if half >= 0.0 {
            self.low -= half;
            self.high += half;
        } else {
            (self.low, self.high) = (f32::NAN, f32::NAN);
        }
        self
    }

    /// The item changes when so many readings in a row say so; 0 is 1.
    #[must_use]
    pub const fn debounced(mut self, readings: u8) -> Self {
        self.agree = if readings == 0 { 1 } else { readings };
        self
    }

    /// The state of the item after a reading; `None` when the reading is NaN.
    pub const fn read(&mut self, reading: f32) -> Option<bool> {
        if reading.is_nan() || self.low.is_nan() || self.high.is_nan() {
            self.state = None;
            self.against = 0;
            return None;
        }
        let Some(state) = self.state else {
            // Within the band nothing was yet on.
            let state = self.says(reading, false);
            self.state = Some(state);
            return self.state;
        };
        if self.says(reading, state) == state {
            self.against = 0;
        } else {
            self.against = self.against.saturating_add(1);
            if self.against >= self.agree {
                self.state = Some(!state);
                self.against = 0;
            }
        }
        self.state
    }

    /// What one reading says of an item that is in `state`.
    const fn says(&self, reading: f32, state: bool) -> bool {
        if reading > self.high {
            self.above
        } else if reading < self.low {
            !self.above
        } else if self.low == self.high {
            // At the level itself: off.
            false
        } else {
            state
        }
    }

    /// The state of the item after the last reading; `None` before the first.
    #[must_use]
    pub const fn state(&self) -> Option<bool> {
        self.state
    }
}

#[cfg(test)]
#[path = "threshold_tests.rs"]
mod tests;
