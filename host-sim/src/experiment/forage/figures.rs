//! The figures of the foraging experiment: the book's Figs 6.3 to 6.6.

use super::approach::{Approach, SPECIMEN};
use super::bench::Captures;
use super::options::{ForageOptions, SNAPSHOT};
use super::trial::{Trial, of};
use crate::report::figure::{
    Axes, Bar, FigureError, Line, Panel, Picture, Point, Span, bar_chart, histogram, line_chart,
    panels,
};
use crate::report::{median, sample};
use crate::world::config::PioneerConfig;
use crate::world::setting::WorldOptions;

/// Everything that is drawn, with the names of the files.
pub(super) fn all(
    options: &ForageOptions,
    trials: &[Trial],
) -> Result<[(&'static str, Picture); 5], FigureError> {
    Ok([
        ("learning-curve", learning_curve(options, trials)?),
        ("learning-curve-of-28", in_the_books_unit(options, trials)?),
        ("approach", approaches(options, trials)?),
        ("reliability-bars", reliability_bars(options, trials)?),
        (
            "reliability-histogram",
            reliability_histogram(options, trials)?,
        ),
    ])
}

/// Captures after each thousand actions of training: level 1, and from the end of its training on
/// both levels.
fn courses(options: &ForageOptions, trials: &[Trial], score: fn(&Captures) -> u32) -> [Line; 2] {
    let points = |from: u32, snapshots: fn(&Trial) -> &Vec<Captures>| -> Vec<Point> {
        (0..=options.actions / SNAPSHOT)
            .map(|snapshot| {
                let seeds: Vec<f64> = trials
                    .iter()
                    .filter_map(|trial| snapshots(trial).get(snapshot as usize))
                    .map(|captures| f64::from(score(captures)))
                    .collect();
                Point::mean_of(f64::from(from + snapshot * SNAPSHOT), &seeds).of_count()
            })
            .collect()
    };
    [
        Line::new("level 1", points(0, |it| &it.snapshots)),
        Line::new(
            "both levels, with habits",
            points(options.actions, |it| &it.snapshots_level2),
        ),
    ]
}

/// What the lines of learning curves and the bands around them are.
const fn bands(trials: &[Trial]) -> &'static str {
    match trials.len() {
        1 => "One life has no band.",
        _ => "Lines: mean; bands: 95 % interval of the mean, from seed to seed.",
    }
}

fn learning_curve(options: &ForageOptions, trials: &[Trial]) -> Result<Picture, FigureError> {
    let span = Span {
        from: 0.0,
        to: 2.0 * f64::from(options.actions),
    };
    // What does not learn is as good at the end as at the beginning.
    let level = |name: &str, score: fn(&Trial) -> Captures| {
        let seeds = of(trials, |t| f64::from(score(t).replaced));
        Line::reference(name, crate::report::mean(&seeds), span)
    };
    let [level1, both] = courses(options, trials, |it| it.replaced);
    let lines = [
        level1,
        both,
        level("servo, learner's percept", |t| t.sector_nearest),
        level("servo of the Stage runs", |t| t.sector),
        level("random actions", |t| t.random),
    ];
    let caption = format!(
        "{}. {} Tests of {} actions, specimens that are taken reappear elsewhere; what does not \
         learn is tested once. {}.",
        sample(&options.seeds),
        bands(trials),
        options.test_actions,
        options.world.words(),
    );
    let unit = format!("captures in {} actions", options.test_actions);
    let title = "What the knowledge of each moment is worth, beside what does not learn";
    let axes = Axes::new(title, "actions of training", &unit).caption(caption);
    let most = lines.iter().flat_map(|line| &line.points);
    let most = most.map(|it| it.band.map_or(it.y, |(_, high)| high));
    let top = most.fold(1.0, f64::max) * 1.05;
    line_chart(&axes.y(0.0, top).sized(900, 500), &lines)
}

/// Fig 6.3 as the book counts: of 28, which every servo clears.
fn in_the_books_unit(options: &ForageOptions, trials: &[Trial]) -> Result<Picture, FigureError> {
    let [level1, both] = courses(options, trials, |it| it.removed);
    let half = f64::from(options.actions);
    let book = |name: &str, captures: f64, from: f64| {
        Line::reference(
            name,
            captures,
            Span {
                from,
                to: from + half,
            },
        )
    };
    let lines = [
        level1,
        both,
        book("book, level 1: 20.4 ± 1.53", 20.4, 0.0),
        book("book, both: 22.9 ± 1.19", 22.9, half),
    ];
    let caption = format!(
        "{}; book: 10 runs, ± is the standard deviation. {} Specimens that are taken are gone; after \
         28 there are none, so the number saturates. {}.",
        sample(&options.seeds),
        bands(trials),
        options.world.words(),
    );
    let title = "Captures of 28 at different stages of learning (Fig 6.3)";
    let unit = format!("captures of 28 in {} actions", options.test_actions);
    let axes = Axes::new(title, "actions of training", &unit).caption(caption);
    line_chart(&axes.y(0.0, 30.0).sized(900, 480), &lines)
}

/// Fig 6.4: the first seed's ways, with the actions of all.
fn approaches(options: &ForageOptions, trials: &[Trial]) -> Result<Picture, FigureError> {
    let [x, y] = SPECIMEN;
    let straight = vec![Point::at(0.0, 0.0), Point::at(x, y)];
    let charts = [(0, "level 1"), (1, "both levels, with habits")].map(|(level, name)| {
        let ways = trials.iter().map(|trial| &trial.approaches[level]);
        let taken: Vec<&Approach> = ways.filter(|it| it.taken).collect();
        let of = |number: fn(&Approach) -> f64| {
            median(&taken.iter().map(|it| number(it)).collect::<Vec<f64>>())
        };
        let path = trials
            .first()
            .map_or(&[][..], |it| &it.approaches[level].path);
        let points = path.iter().map(|&[x, y]| Point::at(x, y)).collect();
        let note = match taken.len() {
            0 => "taken in no seed".to_owned(),
            some => format!(
                "{:.0} actions, {:.0} of them turns: median of the {some} of {} seeds that take it",
                of(Approach::actions),
                of(Approach::turns),
                trials.len()
            ),
        };
        Panel {
            subject: Line::new(name, points),
            note,
            context: Some(Line::new("straight to the specimen", straight.clone())),
        }
    });
    let seed = options.seeds.first().copied().unwrap_or_default();
    let caption = format!(
        "{}; drawn is seed {seed}, the first. The only specimen lies 4 m away, 12° to the left, in \
         sector 2; the robot stands at (0, 0) and looks to the right; greedy, as in a test. The book \
         draws arcs for level 1 and a straight way for both levels, without numbers. {}.",
        sample(&options.seeds),
        WorldOptions {
            config: PioneerConfig {
                specimens: 1,
                ..options.world.config
            },
            layout: None,
            path: None,
        }
        .words(),
    );
    let title = "The way to a specimen that lies aside (Fig 6.4)";
    let axes = Axes::new(title, "metres ahead", "metres to the left").caption(caption);
    // A metre is as long upwards as ahead.
    panels(
        &axes.x(-0.5, 4.5).y(-0.75, 1.5).sized(900, 660),
        1,
        &charts,
        None,
    )
}

/// Fig 6.5.
fn reliability_bars(options: &ForageOptions, trials: &[Trial]) -> Result<Picture, FigureError> {
    let bars = [
        Bar::mean_of("level 1", &of(trials, |t| t.mean_reliability)).beside_with(0.405, 0.010),
        Bar::mean_of(
            "level 2, in hindsight as the book counts",
            &of(trials, |t| t.insight.hindsight),
        )
        .beside_with(0.721, 0.074),
        Bar::mean_of(
            "level 2, predictions that came true",
            &of(trials, |t| t.insight.prospective),
        ),
    ];
    let caption = format!(
        "{}; book: 10 runs. Bars: mean; error bars: standard deviation. Level 1 has its own rare \
         alternatives as schemas, which the book's maps average away. In hindsight a schema whose own \
         item is in the context succeeds by definition. The book's text prints .886 for level 2, its \
         t fits .721. {}.",
        sample(&options.seeds),
        options.world.words(),
    );
    let title = "Mean reliability of the schemas of both levels (Fig 6.5)";
    let axes = Axes::new(title, "", "mean reliability").caption(caption);
    bar_chart(&axes.y(0.0, 1.15).sized(800, 460), ["ours", "book"], &bars)
}

/// Fig 6.6, in its own bins.
fn reliability_histogram(
    options: &ForageOptions,
    trials: &[Trial],
) -> Result<Picture, FigureError> {
    let first = trials.first();
    let level1 = first.map_or(&[][..], |trial| &trial.reliabilities);
    let level2 = first.map_or(&[][..], |trial| &trial.reliabilities_level2);
    let seed = options.seeds.first().copied().unwrap_or_default();
    let caption = format!(
        "n = 1 (seed {seed}, the first), as in the book: a single run, of which it prints .41 ± .16 for \
         level 1 and .89 ± .11 for level 2. Level 2 is counted in hindsight, as there. {}.",
        options.world.words(),
    );
    let axes = Axes::new(
        "Reliabilities of the schemas of both levels (Fig 6.6)",
        "reliability",
        "schemas",
    );
    let samples = [("level 1", level1), ("level 2, in hindsight", level2)];
    histogram(
        &axes.caption(caption).x(0.0, 1.0).sized(860, 440),
        &samples,
        20,
    )
}
