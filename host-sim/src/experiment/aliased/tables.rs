//! The tables beside the claims: what everybody earns, what the constructed items stand for, courses.

use std::fmt::Write;

use serde_json::{Value, json};

use super::earned::last;
use super::options::AliasedOptions;
use super::places::Place;
use super::trial::{Trial, key};
use crate::report::{Table, mean, sample_sd};

/// Everybody, in the order of the tables, and how they are called there.
pub(super) const ALL: [(&str, &str); 11] = [
    ("planner", "planner with a belief"),
    ("mind", "the one learner"),
    ("level2", "both levels"),
    ("level1", "level 1"),
    ("q", "Q, percepts"),
    ("q_2", "Q, two steps"),
    ("q_4", "Q, four steps"),
    ("sarsa", "Sarsa(λ), percepts"),
    ("sarsa_2", "Sarsa(λ), two steps"),
    ("sarsa_4", "Sarsa(λ), four steps"),
    ("random", "random actions"),
];

/// All tables.
pub(super) fn all(options: &AliasedOptions, trials: &[Trial]) -> Vec<(&'static str, Table)> {
    vec![
        ("reward an action", earned(options, trials)),
        ("what is hidden and told, bits", bits(options, trials)),
        ("what synthetic items stand for", items(options, trials)),
    ]
}

fn rounded(number: f64, places: i32) -> Value {
    let by = 10.0_f64.powi(places);
    json!((number * by).round() / by)
}

fn earned(options: &AliasedOptions, trials: &[Trial]) -> Table {
    let mut table = Table::new(&["world", "learner", "mean", "standard deviation", "n"]);
    for &place in &options.places {
        for (who, name) in ALL {
            let seeds = last(trials, place, who);
            if seeds.iter().any(|it| it.is_finite()) {
                table.row([
                    json!(place.name()),
                    json!(name),
                    rounded(mean(&seeds), 4),
                    rounded(sample_sd(&seeds), 4),
                    json!(seeds.len()),
                ]);
            }
        }
    }
    table
}

fn bits(options: &AliasedOptions, trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "world",
        "hidden",
        "told by the item",
        "told by one step of history",
        "items that were on",
    ]);
    for &place in &options.places {
        let of: Vec<_> = trials
            .iter()
            .filter_map(|it| it.constructed.get(place.name()))
            .collect();
        if of.is_empty() {
            continue;
        }
        let middle = |numbers: Vec<f64>| rounded(mean(&numbers), 3);
        table.row([
            json!(place.name()),
            middle(of.iter().map(|it| it.hidden).collect()),
            middle(of.iter().map(|it| it.told).collect()),
            middle(of.iter().map(|it| it.step).collect()),
            middle(of.iter().map(|it| f64::from(it.items)).collect()),
        ]);
    }
    table
}

/// The items that say most, of the first seed: those of others have other names.
fn items(options: &AliasedOptions, trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "world",
        "synthetic item of",
        "with the percept",
        "state",
        "how likely",
        "without the item",
        "bits",
    ]);
    for &place in &options.places {
        let first = trials.first();
        let told = first.and_then(|it| it.constructed.get(place.name()));
        for item in told.into_iter().flat_map(|it| &it.best) {
            table.row([
                json!(place.name()),
                json!(item.schema),
                json!(item.percept),
                json!(item.state),
                rounded(item.sure, 3),
                rounded(item.without, 3),
                rounded(item.bits, 3),
            ]);
        }
    }
    table
}

/// Every test of everybody, as a table of comma-separated values.
pub(super) fn courses(options: &AliasedOptions, trials: &[Trial]) -> String {
    let mut text = String::from("world,learner,seed,actions,reward\n");
    for trial in trials {
        for &place in &options.places {
            for (who, _) in ALL {
                let course = trial.courses.get(&key(place, who));
                let lengths = tests(options, place, who);
                for (reward, length) in course.into_iter().flatten().zip(lengths) {
                    let seed = trial.seed;
                    // A text has always room.
                    let _ = writeln!(text, "{},{who},{seed},{length},{reward}", place.name());
                }
            }
        }
    }
    text
}

/// After how many actions of training the tests of somebody were.
fn tests(options: &AliasedOptions, place: Place, who: &str) -> Vec<u32> {
    if who == "planner" {
        return vec![0];
    }
    let lengths = place.lengths().iter();
    lengths.map(|&it| options.length(it)).collect()
}
