//! The table beside the claims of the angle study.

use serde_json::json;

use super::network::{Looking, Responses};
use super::trial::{NAMED, Trial, of};
use crate::report::{Table, mean};

/// Which level's answers of a network.
type Answers = fn(&Responses) -> &Looking;

/// What each network answers, at both of its levels.
pub(super) fn novelty(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["network", "level", "habituated", "A: rotated", "B: opened"]);
    let rounded = |value: f64| json!((value * 1000.0).round() / 1000.0);
    for (name, network) in NAMED {
        let levels: [(&str, Answers); 2] = [
            ("Level 1", |responses| &responses.level_1),
            ("Top", |responses| &responses.top),
        ];
        for (level, looking) in levels {
            let mean_of = |stimulus: fn(&Looking) -> f64| {
                rounded(mean(&of(trials, |trial| stimulus(looking(network(trial))))))
            };
            table.row([
                json!(name),
                json!(level),
                mean_of(|l| l.habituated),
                mean_of(|l| l.rotated),
                mean_of(|l| l.opened),
            ]);
        }
    }
    table
}
