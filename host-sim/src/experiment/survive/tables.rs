//! The tables beside the claims on survival.

use serde_json::{Value, json};

use crate::experiment::measured::{Trial, of};
use crate::report::{Table, mean, sample_sd};

fn rounded(number: f64) -> Value {
    json!((number * 1000.0).round() / 1000.0)
}

/// Everything that is one number a seed.
pub(super) fn measured(trials: &[Trial]) -> Table {
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
