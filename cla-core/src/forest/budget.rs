//! Units of work: what makes a tick's cost a number that is known beforehand.
//!
//! A unit is one node passed or one item counted, some thirty instructions on a Cortex-M4F at most.
//! They are counted, not timed, so that the same seed does the same work on every target.

/// How much work a call may still do.
///
/// ```
/// use cla_core::forest::WorkBudget;
/// let mut budget = WorkBudget::of(100);
/// budget.spend(30);
/// assert_eq!(budget.left(), 70);
/// budget.spend(80);
/// assert!(budget.is_spent());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorkBudget(u32);

impl WorkBudget {
    /// A budget of so many units.
    #[must_use]
    pub const fn of(units: u32) -> Self {
        Self(units)
    }

    /// Takes units away; below 0 there is nothing.
    pub const fn spend(&mut self, units: u32) {
        self.0 = self.0.saturating_sub(units);
    }

    /// The units that are left.
    #[must_use]
    pub const fn left(&self) -> u32 {
        self.0
    }

    /// Whether nothing is left.
    #[must_use]
    pub const fn is_spent(&self) -> bool {
        self.0 == 0
    }
}
