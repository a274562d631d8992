//! The tables beside the claims of chapter 4: what the means of the claims are made of.

use serde_json::{Value, json};

use super::measure::Differences;
use super::network::{LAYERS, PerLayer};
use super::overload::{Overload, Rates, Reaction};
use super::trial::{Control, Trial, of};
use crate::report::{Table, mean, sample_sd};
use crate::world::launching::{Event, Noise};

fn spread(values: &[f64]) -> [Value; 2] {
    [rounded(mean(values)), rounded(sample_sd(values))]
}

/// Three decimals: tables are read, claims are compared.
fn rounded(value: f64) -> Value {
    json!((value * 1000.0).round() / 1000.0)
}

pub(super) fn differences(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["events", "mean", "sd", "book mean", "book sd"]);
    let mut row = |name: &str, book: [Value; 2], of_it: fn(&Differences) -> f64| {
        let values = of(trials, |trial| of_it(&trial.trained.differences()));
        table.row([json!(name)].into_iter().chain(spread(&values)).chain(book));
    };
    let unknown = || [Value::Null, Value::Null];
    row("Direct – Delay+Gap", [json!(9.66), json!(1.16)], |d| {
        d.direct_delaygap
    });
    row("Direct – Gap", [json!(8.20), json!(0.56)], |d| {
        d.direct_gap
    });
    row("Direct – Delay", unknown(), |d| d.direct_delay);
    row("Delay – Gap", [json!(5.38), json!(1.00)], |d| d.delay_gap);
    table
}

pub(super) fn controls(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "network",
        "Direct–Delay+Gap / Delay–Gap",
        "Direct–Gap / Delay–Gap",
        "full pattern",
        "special: Direct",
        "Delay",
        "Gap",
        "Delay+Gap",
    ]);
    let networks: [(&str, Control); 5] = [
        ("trained", |r| &r.trained),
        ("staged", |r| &r.staged),
        ("equal frequencies", |r| &r.uniform),
        ("Delay 85 %", |r| &r.mostly_delay),
        ("untrained", |r| &r.untrained),
    ];
    for (name, network) in networks {
        let differences = of(trials, |trial| network(trial).differences());
        let below = mean(&differences.iter().map(|d| d.delay_gap).collect::<Vec<_>>());
        let ratio = |of: fn(&Differences) -> f64| {
            rounded(mean(&differences.iter().map(of).collect::<Vec<_>>()) / below)
        };
        let pattern = of(trials, |r| {
            f64::from(u8::from(network(r).has_full_pattern()))
        });
        let nodes = |event: Event| {
            rounded(mean(&of(trials, |r| {
                f64::from(network(r).special_nodes()[event as usize])
            })))
        };
        let ratios = [ratio(|d| d.direct_delaygap), ratio(|d| d.direct_gap)];
        table.row(
            [json!(name)]
                .into_iter()
                .chain(ratios)
                .chain([rounded(mean(&pattern))])
                .chain(Event::ALL.map(nodes)),
        );
    }
    table
}

pub(super) fn special(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["seed", "Direct", "Delay", "Gap", "Delay+Gap"]);
    for trial in trials {
        let nodes = trial.trained.special_nodes().map(|count| json!(count));
        table.row([json!(trial.seed)].into_iter().chain(nodes));
    }
    table
}

pub(super) fn settled(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["layer", "mean", "sd"]);
    for (layer, name) in LAYERS.into_iter().enumerate() {
        let shares = of(trials, |trial| trial.settled[layer]);
        table.row([json!(name)].into_iter().chain(spread(&shares)));
    }
    table
}

pub(super) fn alarms(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "events",
        "distance: Position",
        "Movement",
        "Top",
        "order: Movement",
        "Top",
        "any",
        "falls back to Level 1",
        "literal: Position",
        "Movement",
        "Top",
    ]);
    let mut row = |name: String, reaction: &dyn Fn(&Overload) -> Reaction| {
        let rates = of(trials, |trial| reaction(&trial.overload).rates);
        let layers = |of_it: fn(&Rates) -> PerLayer<f64>| {
            [0, 1, 2].map(|layer| {
                rounded(mean(
                    &rates.iter().map(|r| of_it(r)[layer]).collect::<Vec<_>>(),
                ))
            })
        };
        let one =
            |of_it: fn(&Rates) -> f64| rounded(mean(&rates.iter().map(of_it).collect::<Vec<_>>()));
        let [_, movement, top] = layers(|rates| rates.order);
        table.row(
            [json!(name)]
                .into_iter()
                .chain(layers(|rates| rates.distance))
                .chain([
                    movement,
                    top,
                    one(|rates| rates.any),
                    one(|rates| rates.fallback),
                ])
                .chain(layers(|rates| rates.literal)),
        );
    };
    row("clean".to_owned(), &|overload| overload.clean.clone());
    row("Noisy Direct".to_owned(), &|overload| {
        overload.noisy.clone()
    });
    for (kind, noise) in Noise::ALL.into_iter().enumerate() {
        row(noise.to_string(), &|overload| overload.kinds[kind].clone());
    }
    table
}

pub(super) fn found(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["disturbance", "Direct", "Delay", "Gap", "Delay+Gap"]);
    for (kind, noise) in Noise::ALL.into_iter().enumerate() {
        let found = [0, 1, 2, 3]
            .map(|event| rounded(mean(&of(trials, |trial| trial.overload.found[kind][event]))));
        table.row([json!(noise.to_string())].into_iter().chain(found));
    }
    table
}
