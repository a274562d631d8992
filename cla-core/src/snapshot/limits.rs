//! What numbers and links of a sound brain are bounded by, and the version that is written.

/// The version of the format that is written; older ones that can be read are migrated by a step of
/// their own.
pub(super) const VERSION: u16 = 1;
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
pub(crate) const fn bounded(number: f32, most: f32) -> f32 {
    if -most <= number && number <= most {
        number
    } else if number > most {
        most
    } else if number < -most {
        -most
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
