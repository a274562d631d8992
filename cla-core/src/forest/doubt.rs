//! Doubt: when rewards stay away for much longer than they used to, the world has changed.
//!
//! A sum of what is missing rings; for some time after it recent experience counts for more (habits
//! learn faster, the model forgets faster and, where so configured, its counts weigh few trials), and what
//! was lived before weighs little in the leaves of the trees, whose questions stay.

use crate::snapshot::{LARGEST_COUNT, stored};

/// The share of the usual rewards that is asked for.
const ASKED: f32 = 0.65;
/// So many rewards must be missing.
const MISSING: f32 = 8.0;
/// Actions over which the usual rate is averaged, and before which nothing is usual.
const LONG: f32 = 3000.0;
const EARLY: u16 = 500;

/// Whether the world is as it was.
#[derive(Clone, Debug)]
pub(super) struct Doubt {
    usual: f32,
    missing: f32,
    acted: u16,
    left: u16,
    alarms: u32,
}

impl Doubt {
    pub(super) const fn new() -> Self {
        Self {
            usual: 0.0,
            missing: 0.0,
            acted: 0,
            left: 0,
            alarms: 0,
        }
    }

    /// Whether it doubts now.
    pub(super) const fn lasts(&self) -> bool {
        self.left > 0
    }

    pub(super) const fn alarms(&self) -> u32 {
        self.alarms
    }

    /// Other rewards come from now on: what was usual is no measure any more.
    pub(super) const fn get_acquainted(&mut self) {
        *self = Self {
            alarms: self.alarms,
            ..Self::new()
        };
    }

    /// An action was rewarded or not; answers whether the alarm rings, for a doubt of `lasts` actions.
    pub(super) fn notice(&mut self, rewarded: bool, lasts: u16) -> bool {
        let got = if rewarded { 1.0 } else { 0.0 };
        self.acted = self.acted.saturating_add(1);
        self.usual += (got - self.usual) / f32::from(self.acted).min(LONG);
        if self.left > 0 {
            self.left -= 1;
            return false;
        }
        if self.acted < EARLY {
            return false;
        }
        self.missing = (self.missing + ASKED * self.usual - got).max(0.0);
        if self.missing <= MISSING {
            return false;
        }
        self.missing = 0.0;
        self.left = lasts;
        self.alarms = self.alarms.wrapping_add(1);
        true
    }
}

stored! {
    impl[] Doubt { usual => up_to 1.1, missing => up_to LARGEST_COUNT, acted, left, alarms }
}

#[cfg(test)]
#[path = "doubt_tests.rs"]
mod tests;
