//! The figures of the Microworld experiment: growth, one quantity each, and persistent objects.

use super::options::MicroworldOptions;
use super::trial::{Growth, LEARNERS, MOMENTS, Trial, means};
use crate::report::figure::{
    Axes, Board, FigureError, Line, Picture, Point, board_pairs, line_chart,
};
use crate::report::sample;

/// A figure: its name, what it shows, the unit of its axis, whether that axis is one of factors, and
/// where a moment of growth has the number.
type Quantity = (
    &'static str,
    &'static str,
    &'static str,
    bool,
    fn(&Growth) -> f64,
);

/// Learners that are in the table only: their curves lie on another's, or are a single point.
const NOT_DRAWN: [&str; 3] = [
    "Drescher, with conjunctive results",
    "Drescher, with synthetic items",
    "Drescher, unrestricted",
];

/// What is drawn of growth.
const QUANTITIES: [Quantity; 5] = [
    (
        "recall",
        "How much of what can change is foreseen",
        "share of all changes of items that are predicted",
        false,
        |it| it.recall,
    ),
    (
        "precision",
        "How much of what is foreseen comes",
        "share of predicted changes that come",
        false,
        |it| it.precision,
    ),
    ("schemas", "Schemas that it takes", "schemas", true, |it| {
        it.schemas as f64
    }),
    ("bytes", "Memory that it takes", "bytes", true, |it| {
        it.bytes as f64
    }),
    (
        "time",
        "Time that a step of learning takes, on the machine of this run",
        "µs a step",
        true,
        |it| it.micros.max(1e-3),
    ),
];

/// Growth curves, one figure a quantity, and what is believed of the world.
///
/// # Errors
/// [`FigureError`] when nothing could be drawn.
pub(super) fn all(
    options: &MicroworldOptions,
    trials: &[Trial],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    QUANTITIES
        .into_iter()
        .map(|quantity| Ok((quantity.0, growth(options, trials, quantity)?)))
        .chain([believed_figure(options, trials).map(|figure| ("believed", figure))])
        .collect()
}

fn growth(
    options: &MicroworldOptions,
    trials: &[Trial],
    (_, title, unit, factors, of): Quantity,
) -> Result<Picture, FigureError> {
    let lines: Vec<Line> = LEARNERS
        .into_iter()
        .filter(|learner| !NOT_DRAWN.contains(&learner.0))
        .map(|learner| {
            let points = MOMENTS.into_iter().filter_map(|steps| {
                let values = means(trials, learner, steps, of);
                let point = Point::mean_of(f64::from(steps), &values).of_count();
                (!values.is_empty()).then_some(point)
            });
            Line::new(learner.0, points.collect())
        })
        .collect();
    let caption = format!(
        "{}. Marks: mean; error bars: 95 % interval of the mean, from seed to seed. Microworld of \
         7 × 7 cells, random actions; steps of all ten actions together. A line that ends early is of a \
         learner whose memory is full, or that takes too long, by then.",
        sample(&options.seeds)
    );
    let axes = Axes::new(title, "steps", unit).caption(caption).x_log();
    let axes = axes.sized(860, 500);
    let axes = if factors {
        axes.y_log()
    } else {
        axes.y(0.0, 1.0)
    };
    line_chart(&axes, &lines)
}

/// The first seed in whose pictures most actions end with a ball that is believed somewhere.
fn believer<'a>(options: &MicroworldOptions, trials: &'a [Trial]) -> Option<(u64, &'a Trial)> {
    let believed = |trial: &Trial| {
        let pictures = trial.synthetic.pictures.iter();
        pictures.filter(|[_, _, it]| it.contains('o')).count()
    };
    let seeds = options.seeds.iter().copied().zip(trials);
    // The last of equal maxima is taken: the first seed comes last.
    let mut seeds: Vec<_> = seeds.collect();
    seeds.reverse();
    seeds.into_iter().max_by_key(|(_, trial)| believed(trial))
}

/// Composite actions at the end of a life, beside what is believed of the world then (5.4.3).
fn believed_figure(options: &MicroworldOptions, trials: &[Trial]) -> Result<Picture, FigureError> {
    let chosen = believer(options, trials);
    let pictures = chosen.map_or(&[][..], |(_, trial)| &trial.synthetic.pictures);
    let pairs: Vec<[Board; 2]> = pictures
        .iter()
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
    let caption = format!(
        "n = 1 (seed {}: of the {} seeds of this run the first with the most boards on which a ball \
         is believed). After each composite action, the world and, beside it, where the ball is \
         believed to be felt without looking. E: eye; h: hand, H: closed; disc: ball, G: gripped, *: \
         under the hand; grey with ?: nothing is known.",
        chosen.map_or(0, |(seed, _)| seed),
        options.seeds.len(),
    );
    let title = "Persistent objects: the world, and where the ball is believed to be";
    board_pairs(&Axes::new(title, "", "").caption(caption), 4, &pairs)
}
