//! What the Microworld experiment prints and draws: the catalogue of equations, recall by family,
//! growth beside Drescher's, and the figures of it.

use cla_core::word::Detail;

use super::catalogue::{Found, equations};
use super::goals::Planning;
use super::level1::{Clasm, Mind, RoomyMind};
use super::synthetic::{Memory, Synthetic};
use super::trial::{Growth, MOMENTS, Trial, by_family};
use crate::report::figure::{
    Axes, Board, FigureError, Line, Picture, Point, board_pairs, line_chart,
};
use crate::report::{Table, mean};
use crate::world::microworld::{Oracle, Recall, VOCABULARY};

/// The book's equations with their true reliability and the share of seeds that has them.
#[must_use]
pub fn catalogue(trials: &[Trial], oracle: &Oracle) -> Table {
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
#[must_use]
pub fn families(trials: &[Trial]) -> Table {
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

/// A figure's name, the unit of its axis, and where a moment of growth has the number.
type Quantity = (&'static str, &'static str, fn(&Growth) -> f64);

/// One learner's growth: its name, and where a trial has it.
type Learner = (&'static str, fn(&Trial) -> &Vec<Growth>);

const LEARNERS: [Learner; 8] = [
    ("accommodation, 62 kB", |it| &it.growth),
    ("accommodation, 198 kB", |it| &it.roomy),
    ("Drescher, tuned", |it| &it.drescher),
    ("Drescher, literal", |it| &it.literal),
    ("Drescher, with conjunctive results", |it| &it.conjunctive),
    ("Drescher, with synthetic items", |it| &it.complete),
    ("Drescher, unrestricted", |it| &it.unrestricted),
    ("Drescher, tuned, in 200 kB", |it| &it.bounded),
];

fn means(trials: &[Trial], learner: Learner, steps: u32, of: fn(&Growth) -> f64) -> Vec<f64> {
    trials
        .iter()
        .filter_map(|it| learner.1(it).iter().find(|it| it.steps == steps))
        .map(of)
        .collect()
}

/// Recall, precision, schemas, bytes and time of all learners against experience.
#[must_use]
pub fn growth(trials: &[Trial]) -> Table {
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
#[must_use]
pub fn believed(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["action", "world", "where the ball is believed to be felt"]);
    for pictures in trials.first().iter().flat_map(|it| &it.synthetic.pictures) {
        let [action, world, believed] = pictures.clone();
        let line = |text: &str| text.lines().collect::<Vec<_>>().join(" | ");
        table.row([action.into(), line(&world).into(), line(&believed).into()]);
    }
    table
}

/// The same as a figure.
fn believed_figure(trials: &[Trial]) -> Result<Picture, FigureError> {
    let pictures = trials
        .first()
        .into_iter()
        .flat_map(|it| &it.synthetic.pictures);
    let pairs: Vec<[Board; 2]> = pictures
        .enumerate()
        .map(|(index, [action, world, believed])| {
            // The mouth's line is no row of cells.
            let cells: Vec<&str> = world.lines().filter(|line| !line.contains('^')).collect();
            let after = format!("{}. {action}", index + 1);
            [
                Board::new(&after, &cells.join("\n")),
                Board::new("believed", believed),
            ]
        })
        .collect();
    board_pairs(
        "Persistent objects: the world, and where the ball is believed to be felt",
        4,
        &pairs,
        "E eye, h hand (H closed), disc: ball (G gripped, * under the hand); grey: nothing is known",
    )
}

/// The memory of the parts, bytes.
#[must_use]
pub fn memory() -> Table {
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

/// Learners that are in the table only: their curves lie on another's, or are a single point.
const NOT_DRAWN: [&str; 3] = [
    "Drescher, with conjunctive results",
    "Drescher, with synthetic items",
    "Drescher, unrestricted",
];

/// Growth curves, one figure a quantity, and what is believed of the world.
///
/// # Errors
/// [`FigureError`] when nothing could be drawn.
pub fn figures(trials: &[Trial]) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    let quantities: [Quantity; 5] = [
        ("recall", "share of all item changes", |it| it.recall),
        ("precision", "share of predicted changes that come", |it| {
            it.precision
        }),
        ("schemas", "schemas", |it| it.schemas as f64),
        ("bytes", "bytes, log10", |it| (it.bytes as f64).log10()),
        ("time", "µs a step, log10", |it| {
            it.micros.max(1e-3).log10()
        }),
    ];
    quantities
        .into_iter()
        .map(|(name, unit, of)| {
            let lines: Vec<Line> = LEARNERS
                .into_iter()
                .filter(|learner| !NOT_DRAWN.contains(&learner.0))
                .map(|learner| {
                    let points = MOMENTS.into_iter().filter_map(|steps| {
                        let values = means(trials, learner, steps, of);
                        let x = f64::from(steps).log10();
                        (!values.is_empty()).then(|| Point::mean_of(x, &values))
                    });
                    Line::new(learner.0, points.collect())
                })
                .collect();
            let axes = Axes::new(&format!("Microworld: {name}"), "steps, log10", unit);
            Ok((name, line_chart(&axes, &lines)?))
        })
        .chain([believed_figure(trials).map(|figure| ("believed", figure))])
        .collect()
}
