//! The table of the study of neighbours.

use serde_json::{Value, json};

use super::places::Topology;
use super::trial::{Done, Trial, of};
use crate::report::{Table, mean};

fn rounded(number: f64) -> Value {
    json!((number * 1000.0).round() / 1000.0)
}

/// What robots did on each map, with neighbours and without.
pub(super) fn worth(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "map",
        "neighbours",
        "distance of neighbours",
        "goals without a schema reached",
        "steps, episodes 1–30",
        "steps, episodes 31–100",
        "steps after the swap",
    ]);
    let measures: [fn(&Done) -> f64; 4] = [
        |it| it.reached,
        |it| it.learning,
        |it| it.learned,
        |it| it.recovery,
    ];
    for map in Topology::ALL {
        let spread: Vec<f64> = trials.iter().map(|it| it.on(map).spread).collect();
        for (name, shared) in [("no", false), ("yes", true)] {
            let means = measures.map(|it| rounded(mean(&of(trials, map, shared, it))));
            let head = [json!(map.to_string()), json!(name), rounded(mean(&spread))];
            table.row(head.into_iter().chain(means));
        }
    }
    table
}
