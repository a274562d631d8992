//! The figures of the Microworld experiment: growth, one quantity each, and persistent objects.

use super::trial::{Growth, LEARNERS, MOMENTS, Trial, means};
use crate::report::figure::{
    Axes, Board, FigureError, Line, Picture, Point, board_pairs, line_chart,
};

/// A figure's name, the unit of its axis, and where a moment of growth has the number.
type Quantity = (&'static str, &'static str, fn(&Growth) -> f64);

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
pub(super) fn all(trials: &[Trial]) -> Result<Vec<(&'static str, Picture)>, FigureError> {
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

/// The composite actions of the table of persistent objects as a figure.
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
