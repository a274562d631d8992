//! The figures of the foraging experiment.

use super::bench::Captures;
use super::options::{ForageOptions, SNAPSHOT};
use super::trial::{Trial, of};
use crate::report::figure::{Axes, FigureError, Line, Picture, Point, histogram, line_chart};

/// Everything that is drawn, with the names of the files.
pub(super) fn all(
    options: &ForageOptions,
    trials: &[Trial],
) -> Result<[(&'static str, Picture); 2], FigureError> {
    Ok([
        ("learning-curve", learning_curve(options, trials)?),
        ("reliability-histogram", reliability_histogram(trials)?),
    ])
}

fn learning_curve(options: &ForageOptions, trials: &[Trial]) -> Result<Picture, FigureError> {
    let points = |score: &dyn Fn(&Captures) -> u32| -> Vec<Point> {
        (0..=options.actions / SNAPSHOT)
            .map(|snapshot| {
                let seeds: Vec<f64> = trials
                    .iter()
                    .filter_map(|t| t.snapshots.get(snapshot as usize))
                    .map(|captures| f64::from(score(captures)))
                    .collect();
                Point::mean_of(f64::from(snapshot * SNAPSHOT), &seeds)
            })
            .collect()
    };
    // What does not learn is as good at the end as at the beginning.
    let level = |name: &str, score: fn(&Trial) -> Captures| {
        let seeds = of(trials, |t| f64::from(score(t).replaced));
        let ends = [0.0, f64::from(options.actions)];
        Line::new(name, ends.map(|x| Point::mean_of(x, &seeds)).to_vec())
    };
    let lines = [
        Line::new("CLA, level 1", points(&|c| c.replaced)),
        level("servo, learner's percept", |t| t.sector_nearest),
        level("servo of the Stage runs", |t| t.sector),
        level("random", |t| t.random),
    ];
    let axes = Axes::new(
        "Foraging: what the knowledge of each moment is worth",
        "actions of training",
        "captures in 3000 actions",
    );
    line_chart(&axes, &lines)
}

fn reliability_histogram(trials: &[Trial]) -> Result<Picture, FigureError> {
    let values: Vec<f64> = trials
        .iter()
        .take(1)
        .flat_map(|t| t.reliabilities.clone())
        .collect();
    let axes = Axes::new(
        "Reliability of the level-1 schemas, first seed (Fig 6.6)",
        "successes / activations",
        "schemas",
    );
    histogram(&axes, &values, 20)
}
