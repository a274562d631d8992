//! The tables of the Microworld experiment: the catalogue of equations, recall by family, growth
//! beside Drescher's, persistent objects, memory.

use cla_core::word::Detail;

use super::catalogue::{Found, equations};
use super::goals::Planning;
use super::level1::{Clasm, Mind, RoomyMind};
use super::synthetic::{Memory, Synthetic};
use super::trial::{Growth, LEARNERS, MOMENTS, Trial, by_family, means};
use crate::report::{Table, mean};
use crate::world::microworld::{Oracle, Recall, VOCABULARY};

/// The book's equations with their true reliability and the share of seeds that has them.
pub(super) fn catalogue(trials: &[Trial], oracle: &Oracle) -> Table {
    let mut table = Table::new(&[
        "equation",
        "schema",
        "repaired because",
        "true reliability",
        "raw: exact",
        "raw: refined",
        "simplified: exact",
        "simplified: refined",
        "simplified: foreseen",
    ]);
    for (index, equation) in equations().iter().enumerate() {
        let share = |of: fn(&Trial) -> &Vec<Found>, found: Found| {
            let yes = trials.iter().filter(|it| of(it)[index] == found).count();
            yes as f64 / trials.len() as f64
        };
        table.row([
            equation.number.into(),
            equation
                .schema
                .display(&VOCABULARY, Detail::Full)
                .to_string()
                .into(),
            equation.repair.unwrap_or("").into(),
            oracle.reliability(&equation.schema).into(),
            share(|it| &it.raw_equations, Found::Exact).into(),
            share(|it| &it.raw_equations, Found::Refined).into(),
            share(|it| &it.simplified_equations, Found::Exact).into(),
            share(|it| &it.simplified_equations, Found::Refined).into(),
            mean(
                &trials
                    .iter()
                    .map(|it| it.foreseen[index])
                    .collect::<Vec<f64>>(),
            )
            .into(),
        ]);
    }
    table
}

/// Recall of every form, family by family.
pub(super) fn families(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["family", "raw harvest", "maps seed", "accommodation"]);
    let columns: [fn(&Trial) -> &Recall; 3] = [|it| &it.raw, |it| &it.clasm, |it| &it.simplified];
    let Some(first) = trials.first() else {
        return table;
    };
    for (row, (name, _)) in by_family(&first.raw).enumerate() {
        let cells = columns.map(|of| {
            let values: Vec<f64> = trials
                .iter()
                .filter_map(|it| by_family(of(it)).nth(row).map(|(_, recall)| recall))
                .collect();
            mean(&values).into()
        });
        table.row(std::iter::once(name.into()).chain(cells));
    }
    table
}

/// Recall, precision, schemas, bytes and time of all learners against experience.
pub(super) fn growth(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "learner",
        "steps",
        "recall",
        "believed recall",
        "precision",
        "schemas",
        "bytes",
        "µs a step",
    ]);
    for learner in LEARNERS {
        for steps in MOMENTS {
            let column = |of| means(trials, learner, steps, of);
            if column(|it: &Growth| it.recall).is_empty() {
                continue;
            }
            let of: [fn(&Growth) -> f64; 6] = [
                |it| it.recall,
                |it| it.own_recall,
                |it| it.precision,
                |it| it.schemas as f64,
                |it| it.bytes as f64,
                |it| it.micros,
            ];
            let cells = of.map(|of| mean(&column(of)).into());
            table.row([learner.0.into(), steps.into()].into_iter().chain(cells));
        }
    }
    table
}

/// Composite actions at the end of the first seed's life with synthetic items: the world beside
/// what is believed of it without looking (see [`picture`](super::picture) for the marks).
pub(super) fn believed(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["action", "world", "where the ball is believed to be felt"]);
    for pictures in trials.first().iter().flat_map(|it| &it.synthetic.pictures) {
        let [action, world, believed] = pictures.clone();
        let line = |text: &str| text.lines().collect::<Vec<_>>().join(" | ");
        table.row([action.into(), line(&world).into(), line(&believed).into()]);
    }
    table
}

/// The memory of the parts, bytes.
pub(super) fn memory() -> Table {
    let mut table = Table::new(&["part", "bytes"]);
    for (part, bytes) in [
        ("accommodation: table and reservoirs", size_of::<Mind>()),
        ("the same, roomy", size_of::<RoomyMind>()),
        ("byte maps, table and reservoirs", Clasm::BYTES),
        ("planner", size_of::<Planning>()),
        (
            "synthetic items with what is remembered for them",
            size_of::<Synthetic>() + size_of::<Memory>(),
        ),
        (
            "a brain that fits 256 KiB: all but accommodation alone",
            Clasm::BYTES + size_of::<Planning>(),
        ),
    ] {
        table.row([part.into(), bytes.into()]);
    }
    table
}
