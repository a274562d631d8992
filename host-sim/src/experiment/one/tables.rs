//! The tables beside the claims of the one learner.

use serde_json::json;

use super::damages::{FIRST, TWIN, ids, name};
use super::family::{Damages, end};
use super::measured::{Trial, rounded, sums, table};
use super::options::{OneOptions, Part};
use super::pioneer::SmallMind;
use super::worlds::LeanVacuum;
use crate::learner::mind::Brain;
use crate::report::{Table, mean};

/// Those of the parts that were run.
pub(super) fn all(options: &OneOptions, trials: &[Trial]) -> Vec<(&'static str, Table)> {
    let mut tables = vec![
        ("what was measured", table(trials)),
        ("bytes of the learner", bytes()),
    ];
    if options.has(Part::Recover) {
        tables.push(("captures after a damage", damages(trials)));
    }
    tables
}

/// What the learner takes, shape by shape.
fn bytes() -> Table {
    let mut table = Table::new(&["world", "items", "actions", "bytes"]);
    for (world, items, actions, bytes) in [
        ("forager", 7, 6, size_of::<Brain<1, 7, 6>>()),
        ("forager, small", 7, 6, size_of::<SmallMind>()),
        (
            "forager, 20 distractors",
            27,
            6,
            size_of::<Brain<1, 27, 6>>(),
        ),
        ("lake", 16, 4, size_of::<Brain<1, 16, 4>>()),
        ("shuttle", 5, 3, size_of::<Brain<1, 5, 3>>()),
        ("vacuum", 15, 5, size_of::<Brain<1, 15, 5>>()),
        ("vacuum, lean", 15, 5, size_of::<LeanVacuum>()),
        ("keys", 48, 6, size_of::<Brain<2, 48, 6>>()),
        (
            "generated, the largest",
            64,
            12,
            size_of::<Brain<2, 64, 12>>(),
        ),
    ] {
        table.row([json!(world), json!(items), json!(actions), json!(bytes)]);
    }
    table
}

/// Damage by damage, and the undamaged mind below.
fn damages(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "damage",
        "first 3000",
        "newborn",
        "Sarsa(λ)",
        "with history",
        "last 3000",
        "newborn, last 3000",
        "in the family",
    ]);
    let ids = ids();
    let of = Damages::new(trials, &ids);
    for id in &ids {
        let first = |who: &str| rounded(mean(&sums(trials, &name(id, who), FIRST)));
        let last = |who: &str| rounded(end(trials, &name(id, who)));
        table.row([
            json!(id),
            first("mind"),
            first("newborn"),
            first("sarsa"),
            first("history"),
            last("mind"),
            last("newborn"),
            json!(if of.has(id) { "yes" } else { "no" }),
        ]);
    }
    table.row([
        json!("none"),
        rounded(mean(&sums(trials, TWIN, FIRST))),
        json!("–"),
        json!("–"),
        json!("–"),
        rounded(end(trials, TWIN)),
        json!("–"),
        json!("–"),
    ]);
    table
}
