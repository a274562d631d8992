//! The tables of the study of modules: what each kind costs, and what it is worth in each study.

use serde_json::{Value, json};

use super::module::Kind;
use super::schemas::Schemas;
use super::trial::{Measured, Trial, of};
use crate::report::{Table, mean};

/// All tables.
pub(super) fn all(trials: &[Trial]) -> [(&'static str, Table); 4] {
    [
        ("launching events", causal(trials)),
        ("angles", angles(trials)),
        ("an action of the forager", schemas(trials)),
        ("launching events that are shifted", shifted(trials)),
    ]
}

fn rounded(number: f64) -> Value {
    json!((number * 1000.0).round() / 1000.0)
}

/// A row a kind: the means of these.
fn rows(columns: &[&str], trials: &[Trial], measures: &[fn(&Measured) -> f64]) -> Table {
    let names: Vec<&str> = ["module"].iter().chain(columns).copied().collect();
    let mut table = Table::new(&names);
    for kind in Kind::ALL {
        let means = measures
            .iter()
            .map(|it| rounded(mean(&of(trials, kind, it))));
        table.row([json!(kind.to_string())].into_iter().chain(means));
    }
    table
}

fn causal(trials: &[Trial]) -> Table {
    rows(
        &[
            "Direct–Delay+Gap / Delay–Gap",
            "Direct–Gap / Delay–Gap",
            "full pattern",
            "new events told",
            "Noisy newer than clean",
            "Top units used",
            "Top units a step",
            "bytes",
            "multiply-adds to answer",
            "to learn",
        ],
        trials,
        &[
            |it| it.causal.leslie(),
            |it| it.causal.direct_gap / it.causal.delay_gap,
            |it| f64::from(u8::from(it.causal.has_full_pattern())),
            |it| it.causal.told,
            |it| it.causal.noisy,
            |it| it.causal.used,
            |it| it.causal.sharing,
            |it| it.causal.bytes,
            |it| it.causal.respond,
            |it| it.causal.learn,
        ],
    )
}

fn angles(trials: &[Trial]) -> Table {
    rows(
        &[
            "young: new lines (A)",
            "young: new angle (B)",
            "seeds A over B",
            "old: new lines (A)",
            "old: new angle (B)",
            "seeds B over A",
        ],
        trials,
        &[
            |it| it.angle.young.rotated,
            |it| it.angle.young.opened,
            |it| f64::from(u8::from(it.angle.young.rotated > it.angle.young.opened)),
            |it| it.angle.old.rotated,
            |it| it.angle.old.opened,
            |it| f64::from(u8::from(it.angle.old.opened > it.angle.old.rotated)),
        ],
    )
}

fn schemas(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "module",
        "prototypes that won",
        "candidates",
        "quantization error",
        "predicted",
        "covered",
        "reliability",
        "bytes",
    ]);
    let mut row = |name: String, each: Vec<Schemas>| {
        let of = |it: fn(&Schemas) -> f64| rounded(mean(&each.iter().map(it).collect::<Vec<_>>()));
        table.row([
            json!(name),
            of(|it| it.prototypes),
            of(|it| it.candidates),
            of(|it| it.quantization),
            of(|it| it.predicted),
            of(|it| it.covered),
            of(|it| it.reliability),
            of(|it| it.bytes),
        ]);
    };
    for kind in Kind::ALL {
        let each = trials.iter().map(|it| it.of(kind).schemas).collect();
        row(kind.to_string(), each);
    }
    let each = trials.iter().map(|it| it.action_som).collect();
    row("Action SOM with recruitment".to_owned(), each);
    let ceiling: Vec<f64> = trials.iter().map(|it| it.ceiling).collect();
    let mut best = vec![Value::Null; 8];
    best[0] = json!("most frequent result of each context");
    best[4] = rounded(mean(&ceiling));
    table.row(best);
    table
}

fn shifted(trials: &[Trial]) -> Table {
    rows(
        &[
            "plain: trained shifts",
            "plain: untrained",
            "plain: untrained, gap",
            "plain: untrained, delay",
            "pooled: trained shifts",
            "pooled: untrained",
            "pooled: untrained, gap",
            "pooled: untrained, delay",
            "multiply-adds to answer, plain",
            "multiply-adds to answer, pooled",
        ],
        trials,
        &[
            |it| it.invariance.plain.trained,
            |it| it.invariance.plain.untrained,
            |it| it.invariance.plain.gap,
            |it| it.invariance.plain.delay,
            |it| it.invariance.pooled.trained,
            |it| it.invariance.pooled.untrained,
            |it| it.invariance.pooled.gap,
            |it| it.invariance.pooled.delay,
            |it| it.invariance.plain.respond,
            |it| it.invariance.pooled.respond,
        ],
    )
}
