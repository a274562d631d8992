//! What numbers and links of a sound brain are bounded by, and the version that is written.

/// The version of the format that is written.
pub(super) const VERSION: u16 = 2;
/// The oldest that is read; what a later one has more is made by a step of its own
/// ([`Reader::is_before`](super::Reader::is_before)).
pub(super) const OLDEST: u16 = 1;
/// The largest number in a sound brain: sums over tables and products with counts stay finite.
pub(crate) const LARGEST: f32 = 1e20;
/// Less than half of what lies between neighbouring numbers at [`LARGEST`]: whatever is changed by no
/// more stays within it.
pub(crate) const MOST_CHANGE: f32 = 4e12;
/// The largest worth that an item may have for its own sake: summed over all items and divided by the
/// smallest 1 − discount it stays below [`LARGEST`].
pub(crate) const LARGEST_VALUE: f32 = 1e9;
/// The largest count that is a float: from here on 1 more is lost by rounding.
pub(crate) const LARGEST_COUNT: f32 = 16_777_216.0;

/// The nearest number that is at most so far from 0; 0 for what is no number.
///
/// Bits of floats are in the order of their sizes, so that what is within is one comparison away.
#[inline]
pub(crate) const fn bounded(number: f32, most: f32) -> f32 {
    const SIZE: u32 = 0x7FFF_FFFF;
    if number.to_bits() & SIZE <= most.to_bits() {
        number
    } else {
        beyond(number, most)
    }
}

#[cold]
#[inline(never)]
const fn beyond(number: f32, most: f32) -> f32 {
    if number > 0.0 {
        most
    } else if number < 0.0 {
        -most
    } else {
        0.0
    }
}

/// The nearest number from 0 to `most`; 0 for what is no number.
///
/// One comparison for what is within, as in [`bounded`].
#[inline]
pub(crate) const fn clipped(number: f32, most: f32) -> f32 {
    if number.to_bits() <= most.to_bits() {
        number
    } else {
        outside(number, most)
    }
}

#[cold]
#[inline(never)]
const fn outside(number: f32, most: f32) -> f32 {
    if number >= most {
        most
    } else if number >= 0.0 {
        // −0, whose bits are above all.
        number
    } else {
        0.0
    }
}

/// How many there are of what links point at, in the order in which the tables are stored.
///
/// ```
/// fn actions(limits: &cla_core::snapshot::Limits) -> u16 {
///     limits.actions
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Actions of the robot.
    pub actions: u16,
    /// Conjunctions in the table.
    pub patterns: u16,
    /// Schemas in the table.
    pub schemas: u16,
    /// Synthetic items.
    pub synthetic: u16,
    /// What a number may be.
    least: f32,
    largest: f32,
    /// The key of the entry before, in a table that is ordered.
    before: Option<u32>,
}

impl Limits {
    /// For a brain of so many actions.
    pub(crate) const fn of(actions: u16) -> Self {
        Self {
            actions,
            patterns: 0,
            schemas: 0,
            synthetic: 0,
            least: -LARGEST,
            largest: LARGEST,
            before: None,
        }
    }

    /// The numbers that come are at most so far from 0.
    pub(crate) const fn within(&mut self, most: f32) {
        (self.least, self.largest) = (-most, most);
    }

    /// The numbers that come are at least 0 and at most so large.
    pub(crate) const fn up_to(&mut self, most: f32) {
        (self.least, self.largest) = (0.0, most);
    }

    /// Whether a number may be so; what is no number may not.
    pub(crate) const fn hold(&self, number: f32) -> bool {
        self.least <= number && number <= self.largest
    }

    pub(super) const fn begin_section(&mut self) {
        self.before = None;
    }

    /// Whether a key comes after the one before it.
    pub(crate) fn ascends(&mut self, key: u32) -> bool {
        let ascends = self.before.is_none_or(|before| before < key);
        self.before = Some(key);
        ascends
    }
}

#[cfg(test)]
mod tests {
    use super::{bounded, clipped};

    #[test]
    fn what_is_beyond_becomes_the_bound_and_what_is_no_number_nothing() {
        for it in [0.0, -0.0, 1.0, -2.5, 3.0, -3.0, f32::MIN_POSITIVE] {
            assert_eq!(bounded(it, 3.0).to_bits(), it.to_bits());
        }
        for it in [3.000_000_2, 1e30, f32::MAX, f32::INFINITY] {
            assert_eq!(bounded(it, 3.0), 3.0);
            assert_eq!(bounded(-it, 3.0), -3.0);
        }
        assert_eq!(bounded(f32::NAN, 3.0).to_bits(), 0);
        assert_eq!(bounded(-f32::NAN, 3.0).to_bits(), 0);
    }

    #[test]
    fn what_is_below_nothing_becomes_nothing_and_what_is_within_keeps_its_bits() {
        for it in [0.0, -0.0, f32::MIN_POSITIVE, 1e-45, 1.0, 2.5, 3.0] {
            assert_eq!(clipped(it, 3.0).to_bits(), it.to_bits());
        }
        for it in [3.000_000_2, 1e30, f32::MAX, f32::INFINITY] {
            assert_eq!(clipped(it, 3.0), 3.0);
            assert_eq!(clipped(-it, 3.0).to_bits(), 0);
        }
        for it in [-1e-45, -1.0, f32::NAN, -f32::NAN] {
            assert_eq!(clipped(it, 3.0).to_bits(), 0);
        }
    }
}
