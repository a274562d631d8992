//! What a part of the experiment is: a name, a measurement, claims.

use core::fmt;

use serde::{Serialize, Serializer};

use crate::experiment::measured::Trial;
use crate::failure::{Failure, Impossible};
use crate::report::{Bound, Claim, Expectation, Rule};

/// By what everything is tried less often and lived shorter than the claims ask; at least 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Scale(pub u32);

impl Scale {
    /// A length or a number of tries of the claims, as it is here.
    #[must_use]
    pub fn of(self, whole: u32) -> u32 {
        (whole / self.0.max(1)).max(1)
    }

    /// One of so many is tried.
    #[must_use]
    pub fn step(self) -> usize {
        self.0.max(1) as usize
    }
}

/// A part of the experiment, which can be run without the others.
#[derive(Clone, Copy)]
pub struct Part {
    /// Its name on the command line, which begins what it measures and, behind `survive.`, its claims.
    pub name: &'static str,
    /// Whether it takes more than a few minutes, and is run only when it is named.
    pub is_slow: bool,
    /// Whether it takes hours, is none of all, and what it claims is not committed.
    pub is_apart: bool,
    /// Looks for programs of others that it starts.
    pub look_for_tools: fn() -> Result<(), Impossible>,
    /// Measures with one seed, from which all chance comes.
    pub measure: fn(Scale, u64, &mut Trial) -> Result<(), Failure>,
    /// What is claimed of its own trials, one a seed; none where nothing was measured.
    pub claims: fn(&[Trial]) -> Vec<Claim>,
}

impl Part {
    /// A part that is quick and needs nothing, for the fields that it does not name.
    pub(super) const QUICK: Self = Self {
        name: "",
        is_slow: false,
        is_apart: false,
        look_for_tools: || Ok(()),
        measure: |_, _, _| Ok(()),
        claims: |_| Vec::new(),
    };
}

impl fmt::Debug for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Serialize for Part {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

/// A claim of a part; those of one part are corrected together.
pub(super) fn claim(id: &str, unit: &str) -> Expectation {
    let part = id.split('.').next().unwrap_or_default();
    Expectation::new(format!("survive.{id}"), "–", unit)
        .family(&format!("survive.{part}"))
        .extension()
}

/// What may never happen, with any seed; the note says what is counted.
pub(super) fn never(id: &str, unit: &str, note: &str, per_seed: &[f64]) -> Claim {
    claim(id, unit)
        .rule(Rule::every_seed(Bound::AtMost(0.0)))
        .note(note)
        .judge(per_seed)
}

/// How often something was tried with all seeds together, and at least how often it is to be.
pub(super) fn tried(id: &str, unit: &str, least: f64, per_seed: &[f64]) -> Claim {
    let all = match per_seed {
        [] => f64::NAN,
        some => some.iter().fold(0.0, |sum, it| sum + it),
    };
    claim(id, unit)
        .rule(Rule::mean(Bound::AtLeast(least)))
        .note("all seeds together")
        .judge_count(all)
}
