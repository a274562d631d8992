//! The figures of the recovery experiment: courses of lives, and the book's Figs 6.6, 6.8 and 6.9.

use super::life::Course;
use super::options::RecoverOptions;
use super::rivals::Rival;
use super::trial::{Entrant, Lived, Trial, entrants};
use crate::learner::STRIDE;
use crate::report::figure::{
    Axes, Bar, FigureError, Line, Panel, Picture, Point, Row, bar_chart, histogram, panels,
    row_chart,
};
use crate::report::{mean, sample};
use crate::world::damage::Damage;

/// Everything that is drawn, with the names of the files.
pub(super) fn all(
    options: &RecoverOptions,
    trials: &[Trial],
) -> Result<Vec<(String, Picture)>, FigureError> {
    let mut pictures = Vec::new();
    for (index, damage) in options.damages.iter().enumerate() {
        let of = Lived { trials, index };
        let mut push = |name: &str, picture| pictures.push((name.to_owned(), picture));
        push(
            &format!("curve-{}", damage.id()),
            curve(&of, options, damage)?,
        );
        if *damage == Damage::Camera(12.0) {
            push("performance", performance(&of, options)?);
            push("performance-bars", performance_bars(&of, options)?);
            push("reliability-bars", reliability_bars(&of, options)?);
            push("reliability-histogram", reliabilities(&of, options)?);
        }
    }
    Ok(pictures)
}

/// Captures of each thousand actions, those before the damage at negative places.
fn thousands(course: &Course) -> Vec<(f64, f64)> {
    let strides = (1000 / STRIDE) as usize;
    let sums = |part: &[u32]| -> Vec<f64> {
        part.chunks(strides)
            .map(|chunk| f64::from(chunk.iter().sum::<u32>()))
            .collect()
    };
    let before = sums(&course.before);
    let start = -1000.0 * before.len() as f64;
    let all = before.into_iter().chain(sums(&course.after));
    all.enumerate()
        .map(|(index, sum)| (start + 1000.0 * index as f64 + 500.0, sum))
        .collect()
}

/// Everybody's course in a chart of its own, beside that of both levels.
fn curve(
    of: &Lived<'_>,
    options: &RecoverOptions,
    damage: &Damage,
) -> Result<Picture, FigureError> {
    let line = |who: Entrant| -> Option<Line> {
        let courses: Vec<Vec<(f64, f64)>> = of
            .trials
            .iter()
            .filter_map(|trial| trial.course(of.index, who))
            .map(thousands)
            .collect();
        let first = courses.first()?;
        let points = (0..first.len()).map(|place| {
            let at = |course: &Vec<(f64, f64)>| course.get(place).map(|point| point.1);
            let seeds: Vec<f64> = courses.iter().filter_map(at).collect();
            Point::mean_of(first[place].0, &seeds).of_count()
        });
        Some(Line::new(who.name(), points.collect()))
    };
    let ours = line(Entrant::Both);
    let charts: Vec<Panel> = entrants(damage)
        .iter()
        // The others vary one of these; their numbers stand in the table.
        .filter(|who| DRAWN.contains(who))
        .filter_map(|&who| {
            let early = of.captures(who, 0, 3);
            Some(Panel {
                subject: line(who)?,
                note: format!("{:.0} in the first 3000 damaged", mean(&early)),
                context: ours.clone().filter(|_| who != Entrant::Both),
            })
        })
        .collect();
    let title = format!("What everybody captures before and after the damage {damage}");
    let caption = format!(
        "{}. Line: mean; band: 95 % interval of the mean, from seed to seed. Each point is 1000 \
         actions; the damage comes at 0. {}.",
        sample(&options.seeds),
        options.world.words(),
    );
    let axes = Axes::new(
        &title,
        "actions since the damage",
        "captures in 1000 actions",
    );
    let axes = axes.caption(caption);
    let rows = charts.len().div_ceil(COLUMNS) as u32;
    let axes = axes.sized(960, 90 + 250 * rows);
    let most = charts.iter().flat_map(|it| &it.subject.points);
    let most = most.map(|it| it.band.map_or(it.y, |(_, high)| high));
    let top = most.fold(1.0, f64::max) * 1.05;
    panels(&axes.y(0.0, top), COLUMNS, &charts, Some((0.0, "damage")))
}

/// Charts in a row.
const COLUMNS: usize = 4;

/// Whose courses are drawn.
const DRAWN: [Entrant; 8] = [
    Entrant::Both,
    Entrant::BothNoHabits,
    Entrant::NoLevel2,
    Entrant::BothPlain,
    Entrant::of(Rival::BEST),
    Entrant::Sarsa,
    Entrant::Told,
    Entrant::Random,
];

fn reliability_bars(of: &Lived<'_>, options: &RecoverOptions) -> Result<Picture, FigureError> {
    let level1 = |place: usize| of.of(Entrant::Reliabilities, |it| mean(&it.reliabilities[place]));
    let level2 = |place: usize| of.of(Entrant::Both, |it| it.predictions[place]);
    let bars = [
        Bar::mean_of("level 1 before", &level1(0)).beside_with(0.405, 0.010),
        Bar::mean_of("level 1 after", &level1(1)).beside_with(0.348, 0.048),
        Bar::mean_of("level 2 before", &level2(0)).beside_with(0.721, 0.074),
        Bar::mean_of("level 2 after", &level2(1)).beside_with(0.446, 0.032),
    ];
    let caption = format!(
        "{}; book: 10 runs. Bars: mean; error bars: standard deviation. Level 1: mean reliability \
         of its schemas, reliabilities alone adapt. Level 2, ours: share of its predictions, said \
         before each action, that came true; the book counts in hindsight (.721 is what fits its t; \
         its text prints .886). {}.",
        sample(&options.seeds),
        options.world.words(),
    );
    let title = "Reliability before and after the camera was turned by 12° (Fig 6.9)";
    let axes = Axes::new(title, "", "mean reliability").caption(caption);
    bar_chart(&axes.y(0.0, 1.0).sized(860, 460), ["ours", "book"], &bars)
}

/// In the book's own unit, captures of 28.
fn performance_bars(of: &Lived<'_>, options: &RecoverOptions) -> Result<Picture, FigureError> {
    let removed = |place: usize| -> Vec<f64> {
        let of = of.trials.iter();
        of.map(|it| f64::from(it.removed[place])).collect()
    };
    let bars = [
        Bar::new("level 1, undamaged", f64::NAN).beside_with(20.4, 1.53),
        Bar::new("both levels, undamaged", f64::NAN).beside_with(22.9, 1.19),
        Bar::mean_of("damaged, frozen", &removed(0)).beside_with(1.6, 0.84),
        Bar::mean_of("damaged, reliabilities adapted", &removed(1)).beside_with(17.4, 3.37),
    ];
    let caption = format!(
        "{}; book: 10 runs. Bars: mean; error bars: standard deviation. Captures of 28 in 3000 \
         actions, specimens that are taken are gone; ours is level 1. Undamaged robots of ours \
         are measured by `forage`. {}.",
        sample(&options.seeds),
        options.world.words(),
    );
    let title = "Captures before and after the camera was turned by 12° (Fig 6.8)";
    let axes = Axes::new(title, "", "captures of 28").caption(caption);
    bar_chart(&axes.y(0.0, 32.0).sized(860, 460), ["ours", "book"], &bars)
}

/// The same with specimens that reappear, so that nothing saturates, and everybody.
fn performance(of: &Lived<'_>, options: &RecoverOptions) -> Result<Picture, FigureError> {
    let rows: Vec<Row> = Entrant::ALL
        .iter()
        .map(|&who| {
            let whole = of.of(who, |it| 3.0 * it.rate_before());
            let parts = [whole, of.captures(who, 0, 3), of.captures(who, 10, 13)];
            Row::means_of(who.name(), &parts)
        })
        .collect();
    let caption = format!(
        "{}. Marks: mean; bars: 95 % interval of the mean, from seed to seed. Specimens that are \
         taken reappear elsewhere. {}.",
        sample(&options.seeds),
        options.world.words(),
    );
    let title = "What everybody collects after the camera was turned by 12°";
    let axes = Axes::new(title, "captures in 3000 actions", "").caption(caption);
    let series = ["undamaged", "damaged, 0–3000", "damaged, 10,000–13,000"];
    row_chart(&axes.sized(900, 860), &series, &rows, None)
}

fn reliabilities(of: &Lived<'_>, options: &RecoverOptions) -> Result<Picture, FigureError> {
    let first = of.trials.first();
    let course = first.and_then(|trial| trial.course(of.index, Entrant::Reliabilities));
    let at = |place: usize| course.map_or(&[][..], |course| &course.reliabilities[place]);
    let seed = options
        .seeds
        .first()
        .map_or_else(String::new, u64::to_string);
    let caption = format!(
        "n = 1 (seed {seed}, the first). All schemas of level 1 of the robot whose reliabilities \
         alone adapt, when the damage came and {} actions later. {}.",
        options.protocol.after,
        options.world.words(),
    );
    let title = "Reliabilities of level 1 before and after the damage (as Fig 6.6)";
    let axes = Axes::new(title, "reliability", "schemas").caption(caption);
    let samples = [("before", at(0)), ("after", at(1))];
    histogram(&axes.x(0.0, 1.0).sized(860, 440), &samples, 20)
}
