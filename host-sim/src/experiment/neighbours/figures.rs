//! The figure of the study of neighbours.

use super::options::NeighboursOptions;
use super::places::Topology;
use super::trial::{Trial, of};
use crate::report::figure::{Axes, FigureError, Picture, Row, row_chart};
use crate::report::sample;

/// How many goals without a schema are reached on each map.
pub(super) fn all(
    options: &NeighboursOptions,
    trials: &[Trial],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    if trials.is_empty() {
        return Ok(Vec::new());
    }
    let rows: Vec<Row> = Topology::ALL
        .iter()
        .map(|&map| {
            let samples = [false, true].map(|shared| of(trials, map, shared, |it| it.reached));
            Row::means_of(&map.to_string(), &samples)
        })
        .collect();
    let caption = format!(
        "{}. Means with 95 % intervals. Goals that no schema has as its result, 40 steps an attempt. With \
         neighbours, a node is worth a share of the best node beside it on the map.",
        sample(&options.seeds)
    );
    let axes = Axes::new(
        "Goals without a schema",
        "share of attempts that reach them",
        "",
    )
    .x(0.0, 1.0)
    .caption(caption)
    .sized(900, 340);
    let series = ["without neighbours", "with neighbours"];
    Ok(vec![(
        "neighbours",
        row_chart(&axes, &series, &rows, None)?,
    )])
}
