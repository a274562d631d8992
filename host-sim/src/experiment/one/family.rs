//! What all damages together say: in which a newborn finds its feet, and who is ahead in those.
//!
//! These are numbers of all seeds at once; with too few of them they are missing.

use super::damages::{COURSE, FIRST, TWIN, name};
use super::measured::{Trial, sums};
use crate::report::{AHEAD, LEAST, holm, mean, paired_t};

/// Share of its undamaged twin from which on a newborn has found its feet.
const FOUND: f64 = 0.5;
/// Share of its undamaged twin that counts as recovered.
const RECOVERED: f64 = 0.9;

/// All seeds of some damages.
pub(super) struct Damages<'a> {
    trials: &'a [Trial],
    /// Those of the family, by their part of a claim's id.
    family: Vec<&'a str>,
    all: &'a [String],
}

impl<'a> Damages<'a> {
    /// Finds the family: a newborn reaches half of the undamaged twin in the last 3000 actions.
    pub(super) fn new(trials: &'a [Trial], all: &'a [String]) -> Self {
        let twin = end(trials, TWIN);
        let found = |id: &&str| end(trials, &name(id, "newborn")) >= FOUND * twin;
        Self {
            trials,
            family: all.iter().map(String::as_str).filter(found).collect(),
            all,
        }
    }

    /// Whether a damage belongs to the family.
    pub(super) fn has(&self, id: &str) -> bool {
        self.family.contains(&id)
    }

    fn first(&self, id: &str, who: &str) -> Vec<f64> {
        sums(self.trials, &name(id, who), FIRST)
    }

    fn enough(&self, number: f64) -> f64 {
        let measured = self.trials.iter().all(|it| !it.several(TWIN).is_empty());
        if measured && self.trials.len() >= LEAST as usize {
            number
        } else {
            f64::NAN
        }
    }

    /// Damages of the family.
    pub(super) fn size(&self) -> f64 {
        self.enough(self.family.len() as f64)
    }

    /// Share of the family in which the mind takes more at first than each of the rivals, on average.
    pub(super) fn ahead(&self) -> f64 {
        let ahead = |id: &&&str| {
            let ours = mean(&self.first(id, "mind"));
            ["sarsa", "history"]
                .iter()
                .all(|rival| ours > mean(&self.first(id, rival)))
        };
        let count = self.family.iter().filter(ahead).count();
        self.enough(count as f64 / self.family.len() as f64)
    }

    /// Damages of the family in which a rival takes more at first, beyond chance after Holm's
    /// correction over all rivals and damages of the family.
    pub(super) fn behind(&self) -> f64 {
        let tests: Vec<_> = self
            .family
            .iter()
            .flat_map(|id| ["sarsa", "history"].map(|rival| (*id, rival)))
            .map(|(id, rival)| {
                let test = paired_t(&self.first(id, "mind"), &self.first(id, rival));
                (id, test)
            })
            .collect();
        let chances: Vec<f64> = tests.iter().map(|(_, it)| it.p).collect();
        let mut behind: Vec<&str> = tests
            .iter()
            .zip(holm(&chances))
            .filter(|((_, test), chance)| test.statistic < 0.0 && *chance <= AHEAD)
            .map(|((id, _), _)| *id)
            .collect();
        behind.dedup();
        self.enough(behind.len() as f64)
    }

    /// Damages in which a newborn is back at .9 of the undamaged twin at the end, and the mind is not.
    pub(super) fn lost(&self) -> f64 {
        let twin = RECOVERED * end(self.trials, TWIN);
        let lost = |id: &&String| {
            end(self.trials, &name(id, "newborn")) >= twin
                && end(self.trials, &name(id, "mind")) < twin
        };
        self.enough(self.all.iter().filter(lost).count() as f64)
    }

    /// Damages in which the mind has at some thousand taken less, on average, than a newborn less
    /// what that takes in its first 3000.
    pub(super) fn worse_than_newborn(&self) -> f64 {
        let so_far = |id: &str, who, thousands| mean(&sums(self.trials, &name(id, who), thousands));
        let worse = |id: &&String| {
            let allowed = so_far(id, "newborn", FIRST);
            (1..=COURSE).any(|it| so_far(id, "mind", it) < so_far(id, "newborn", it) - allowed)
        };
        self.enough(self.all.iter().filter(worse).count() as f64)
    }
}

/// Captures of the last 3000 damaged actions, mean of the seeds.
pub(super) fn end(trials: &[Trial], name: &str) -> f64 {
    mean(&sums(trials, name, COURSE)) - mean(&sums(trials, name, COURSE - FIRST))
}
