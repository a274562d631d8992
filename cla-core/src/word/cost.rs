//! What a control step touches, counted: the same on every target, so that a host can say what a
//! step would cost on a microcontroller.
//!
//! Whoever does the work adds to its own counts, once for a loop and not in it
//! where that is enough.
//! What comes only now and then is left out: harvests, weighing the evidence in a doubt, settling the
//! values at the end of training.
//! What a count weighs in instructions is measured, not known here (`host-sim`, `experiment::mcu`).

use crate::snapshot::stored;

/// Counts of what was touched in one control step.
///
/// ```
/// use cla_core::word::Cost;
/// let (mut all, one) = (Cost::default(), Cost { schemas: 3, ..Cost::default() });
/// all.add(&one);
/// all.add(&one);
/// assert_eq!((all.schemas, all.units), (6, 0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cost {
    /// Prototypes compared with a sample, context and result halves apart.
    pub units: u32,
    /// Their weights that were read: one for each feature of the sample that is on.
    pub weights: u32,
    /// Prototypes that followed the winner, or were imprinted; halves apart.
    pub moved: u32,
    /// Conjunctions held against a state.
    pub patterns: u32,
    /// Schemas gone through: those that apply, or all where all must be looked at.
    pub schemas: u32,
    /// Synthetic items that a reward was felt by, or gone through to find room.
    pub items: u32,
    /// Counters of beliefs gone through, those included that made room for a new one.
    pub beliefs: u32,
    /// Values of habits that have moved.
    pub habits: u32,
}

impl Cost {
    pub(crate) const NONE: Self = Self {
        units: 0,
        weights: 0,
        moved: 0,
        patterns: 0,
        schemas: 0,
        items: 0,
        beliefs: 0,
        habits: 0,
    };

    /// Adds another's counts to these; sums wrap.
    pub fn add(&mut self, other: &Self) {
        for (count, more) in [
            (&mut self.units, other.units),
            (&mut self.weights, other.weights),
            (&mut self.moved, other.moved),
            (&mut self.patterns, other.patterns),
            (&mut self.schemas, other.schemas),
            (&mut self.items, other.items),
            (&mut self.beliefs, other.beliefs),
            (&mut self.habits, other.habits),
        ] {
            *count = count.wrapping_add(more);
        }
    }
}

stored! {
    impl[] Cost { units, weights, moved, patterns, schemas, items, beliefs, habits }
}
