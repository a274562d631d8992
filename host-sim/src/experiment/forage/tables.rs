//! The tables of the foraging experiment.

use cla_core::forager::pioneer;

use super::bench::Captures;
use super::trial::{Found, Trial, last, of};
use crate::report::{Table, mean, sample_sd};

/// Schemas listed for the first seed.
const LISTED: usize = 16;
/// Trials that make a schema worth listing.
const PROVEN: u32 = 50;

/// Everybody's captures in a test.
pub(super) fn captures(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["controller", "replaced", "sd", "of 28", "sd "]);
    let mut row = |name: &str, score: &dyn Fn(&Trial) -> Captures| {
        let replaced = of(trials, |t| f64::from(score(t).replaced));
        let removed = of(trials, |t| f64::from(score(t).removed));
        let cells = [
            mean(&replaced),
            sample_sd(&replaced),
            mean(&removed),
            sample_sd(&removed),
        ];
        let mut line = vec![name.into()];
        line.extend(cells.map(serde_json::Value::from));
        table.row(line);
    };
    row("CLA, level 1 (ours)", &last);
    row("CLA, level 1, 20,000 actions", &|t| t.second.level1);
    row("CLA, levels 1 and 2, 20,000 actions", &|t| t.second.level2);
    row("CLA, levels 1 and 2 without habits", &|t| t.apart.level2);
    row("CLA, level 1 with habits", &|t| t.apart.habits);
    row("CLA, level 2 from SOMs, 20,000 actions", &|t| {
        t.harvested.counters
    });
    row("CLA, level 2 from SOMs, read with the cut", &|t| {
        t.harvested.cut
    });
    row("CLA, ours with the book's choice rule", &|t| {
        t.lexicographic
    });
    row("CLA, all as the book says", &|t| t.book);
    row("servo `sector` (Stage)", &|t| t.sector);
    row("servo `sector`, learner's percept", &|t| t.sector_nearest);
    row("random", &|t| t.random);
    row("CLA, level 1, noise-free world", &|t| t.noise_free);
    row("servo `sector`, noise-free world", &|t| t.noise_free_sector);
    row("CLA, level 1, noise-free, 20,000", &|t| {
        t.second_noise_free.level1
    });
    row("CLA, levels 1 and 2, noise-free, 20,000", &|t| {
        t.second_noise_free.level2
    });
    row("CLA, level 1, room of 12 m, 20,000", &|t| {
        t.second_large.level1
    });
    row("CLA, levels 1 and 2, room of 12 m, 20,000", &|t| {
        t.second_large.level2
    });
    table.row([
        "the book's level 1 (6.2.5)".into(),
        serde_json::Value::Null,
        serde_json::Value::Null,
        20.4.into(),
        1.53.into(),
    ]);
    table
}

/// The most reliable schemas of the first seed.
pub(super) fn schemas(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["schema", "reliability", "trials"]);
    let says_something = |found: &&Found| found.activations >= PROVEN && !found.text.ends_with('/');
    let proven = trials
        .iter()
        .take(1)
        .flat_map(|t| t.found.iter().filter(says_something));
    let mut proven: Vec<&Found> = proven.collect();
    proven.sort_by(|a, b| b.reliability.total_cmp(&a.reliability));
    for found in proven.into_iter().take(LISTED) {
        table.row([
            found.text.clone().into(),
            found.reliability.into(),
            found.activations.into(),
        ]);
    }
    table
}

/// What the brain is like.
pub(super) fn brain(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["what", "how much"]);
    table.row(["bytes of RAM, all static".into(), pioneer::RAM.into()]);
    table.row([
        "synthetic items, mean".into(),
        mean(&of(trials, |t| t.insight.items)).into(),
    ]);
    table.row([
        "counters of beliefs, mean".into(),
        mean(&of(trials, |t| t.insight.beliefs)).into(),
    ]);
    let schemas = of(trials, |t| t.reliabilities.len() as f64);
    table.row(["schemas, mean over the seeds".into(), mean(&schemas).into()]);
    let training = of(trials, |t| f64::from(t.training_captures));
    table.row(["captures while training".into(), mean(&training).into()]);
    table
}
