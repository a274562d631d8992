//! What was measured with one seed, by name: the trial of experiments that are made of parts.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::report::{Table, mean, sample_sd};

/// Everything that was measured with one seed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The seed.
    pub seed: u64,
    /// What was measured, by its name; a course has several numbers.
    pub measured: BTreeMap<String, Vec<f64>>,
}

impl Trial {
    /// Writes down a number.
    pub(crate) fn note(&mut self, name: impl Into<String>, number: impl Into<f64>) {
        self.measured.insert(name.into(), vec![number.into()]);
    }

    /// Writes down a course.
    pub(crate) fn note_all(&mut self, name: impl Into<String>, numbers: Vec<f64>) {
        self.measured.insert(name.into(), numbers);
    }

    /// All numbers of this name; none where it was not measured.
    #[must_use]
    pub fn several(&self, name: &str) -> &[f64] {
        self.measured.get(name).map_or(&[], Vec::as_slice)
    }

    /// The first `count` numbers of this name together; NaN where there are fewer.
    #[must_use]
    pub fn sum(&self, name: &str, count: usize) -> f64 {
        let first = self.several(name).get(..count);
        first.map_or(f64::NAN, |it| it.iter().fold(0.0, |sum, it| sum + it))
    }
}

/// What was measured under one name, seed by seed.
pub(crate) fn of(trials: &[Trial], name: &str) -> Vec<f64> {
    sums(trials, name, 1)
}

/// The first numbers of a course together, seed by seed.
pub(crate) fn sums(trials: &[Trial], name: &str, count: usize) -> Vec<f64> {
    trials.iter().map(|trial| trial.sum(name, count)).collect()
}

/// To three digits behind the point.
pub(crate) fn rounded(number: f64) -> Value {
    json!((number * 1000.0).round() / 1000.0)
}

/// Everything that is one number a seed.
pub(crate) fn table(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["what", "mean", "standard deviation", "n"]);
    let names = trials.first().map(|it| &it.measured);
    for (name, numbers) in names.into_iter().flatten() {
        if numbers.len() == 1 {
            let seeds = of(trials, name);
            table.row([
                json!(name),
                rounded(mean(&seeds)),
                rounded(sample_sd(&seeds)),
                json!(seeds.len()),
            ]);
        }
    }
    table
}
