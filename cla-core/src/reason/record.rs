//! What an action's own record says of how far it can be relied on.
//!
//! In a world that always does the same, a context that was met before leads to what it led to
//! before, and a schema that held often holds always; how far either is untrue is what schemas of
//! this action must be forgiven (EXACT and TOLERANT of `growth`, learned instead of configured).

use crate::snapshot::stored;

/// Trials after which both counts of a share are halved.
const REMEMBERED: u16 = 400;
/// Trials without which nothing is said.
const ENOUGH: u16 = 20;
/// A schema with so many successes is expected to hold.
pub(super) const MATURE: u16 = 16;

/// A share of trials of which the old fade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Share {
    trials: u16,
    bad: u16,
}

impl Share {
    const NONE: Self = Self { trials: 0, bad: 0 };

    const fn count(&mut self, bad: bool) {
        if self.trials >= REMEMBERED {
            self.trials /= 2;
            self.bad /= 2;
        }
        self.trials += 1;
        self.bad = self.bad.saturating_add(bad as u16);
    }

    fn value(self) -> Option<f32> {
        (self.trials >= ENOUGH).then(|| f32::from(self.bad) / f32::from(self.trials))
    }
}

/// The record of one action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Record {
    /// Contexts that came again, and outcomes that differed then.
    repeated: Share,
    /// Actions in which a mature schema applied, and those in which one failed.
    trusted: Share,
}

impl Record {
    pub(super) const NEW: Self = Self {
        repeated: Share::NONE,
        trusted: Share::NONE,
    };

    /// A context came again, whole; whether it led elsewhere.
    pub(super) const fn repeat(&mut self, differs: bool) {
        self.repeated.count(differs);
    }

    /// Mature schemas applied; whether most of them failed.
    pub(super) const fn trust(&mut self, failed: bool) {
        self.trusted.count(failed);
    }

    /// The share of actions that do not do what they mostly do, in `[0, 0.2]`; 0 where nothing
    /// speaks for more.
    pub(super) fn noise(&self) -> f32 {
        // Whichever of two equal contexts was the exception, they differ.
        let noise = match (self.repeated.value(), self.trusted.value()) {
            (Some(differing), _) => 0.5 * differing,
            (None, Some(failing)) if failing > CREDIBLE => failing,
            _ => 0.0,
        };
        if noise > 0.2 { 0.2 } else { noise }
    }
}

/// Where contexts never come again, so many failures of mature schemas are still those of schemas
/// that say too little.
const CREDIBLE: f32 = 0.02;

stored! {
    impl[] Share { trials, bad }
    sound |it, _limits| it.bad <= it.trials
}
stored! { impl[] Record { repeated, trusted } }
