//! The figures of the recovery experiment: curves over both parts of a life, bars, histograms.

use super::life::Course;
use super::options::RecoverOptions;
use super::trial::{Entrant, Lived, Trial, entrants};
use crate::learner::STRIDE;
use crate::report::figure::{
    Axes, Bar, FigureError, Line, Mark, Picture, Point, bar_chart, histogram, line_chart,
};
use crate::report::mean;
use crate::world::damage::Damage;

/// Everything that is drawn, with the names of the files.
pub(super) fn all(
    options: &RecoverOptions,
    trials: &[Trial],
) -> Result<Vec<(String, Picture)>, FigureError> {
    let mut pictures = Vec::new();
    for (index, damage) in options.damages.iter().enumerate() {
        let of = Lived { trials, index };
        pictures.push((format!("curve-{}", damage.id()), curve(&of, damage)?));
        if *damage == Damage::Camera(12.0) {
            pictures.push(("reliability-bars".to_owned(), reliability_bars(&of)?));
            pictures.push(("performance-bars".to_owned(), performance_bars(&of)?));
            for (place, when) in [(0, "before"), (1, "after")] {
                let name = format!("reliability-histogram-{when}");
                pictures.push((name, reliabilities(&of, place, when)?));
            }
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

fn curve(of: &Lived<'_>, damage: &Damage) -> Result<Picture, FigureError> {
    let mut lines = Vec::new();
    let mut most = 0.0_f64;
    // Everybody at once is a thicket: variants stand in the table.
    let drawn = entrants(damage).iter().filter(|who| {
        !matches!(
            who,
            Entrant::SarsaHistory
                | Entrant::QHistory
                | Entrant::Sector
                | Entrant::Frozen
                | Entrant::BothPlain
                | Entrant::BothMean
                | Entrant::Plain
                | Entrant::BothValue
        )
    });
    let mut span = (0.0, 0.0);
    for &who in drawn {
        let courses: Vec<Vec<(f64, f64)>> = of
            .trials
            .iter()
            .filter_map(|trial| trial.course(of.index, who))
            .map(thousands)
            .collect();
        let Some(first) = courses.first() else {
            continue;
        };
        let points: Vec<Point> = (0..first.len())
            .map(|place| {
                let at = |course: &Vec<(f64, f64)>| course.get(place).map(|point| point.1);
                let seeds: Vec<f64> = courses.iter().filter_map(at).collect();
                Point::mean_of(first[place].0, &seeds)
            })
            .collect();
        for point in &points {
            most = most.max(point.y);
            span = (point.x.min(span.0), point.x.max(span.1));
        }
        lines.push(Line::new(who.name(), points));
    }
    let top = (most * 1.15).max(1.0);
    let knock = [(0.0, 0.0), (0.0, top)].map(|(x, y)| Point::at(x, y));
    lines.push(Line {
        label: "damage".to_owned(),
        points: knock.to_vec(),
        mark: Mark::Dashed,
    });
    let title = format!("Damage {damage}: what is collected before and after it");
    let axes = Axes::new(
        &title,
        "actions since the damage",
        "captures in 1000 actions",
    );
    line_chart(
        &axes
            .x(span.0 - 500.0, span.1 + 500.0)
            .y(0.0, top)
            .sized(1080, 520),
        &lines,
    )
}

fn reliability_bars(of: &Lived<'_>) -> Result<Picture, FigureError> {
    let bars = [(0, "before", 0.405), (1, "after", 0.348)].map(|(place, when, book)| {
        let seeds = of.of(Entrant::Reliabilities, |it| mean(&it.reliabilities[place]));
        Bar::mean_of(&format!("level 1 {when}"), &seeds).beside(book)
    });
    let second = [(0, "before", 0.721), (1, "after", 0.446)].map(|(place, when, book)| {
        let seeds = of.of(Entrant::Both, |it| it.predictions[place]);
        Bar::mean_of(&format!("level 2 {when}"), &seeds).beside(book)
    });
    let title = "Mean reliability before and after the damage (Fig 6.5, 6.9)";
    let axes = Axes::new(
        title,
        "level 1: reliabilities only; level 2: predictions that came true; strokes: the book",
        "reliability",
    );
    let bars: Vec<Bar> = bars.into_iter().chain(second).collect();
    bar_chart(&axes.y(0.0, 0.8).sized(900, 480), &bars)
}

fn performance_bars(of: &Lived<'_>) -> Result<Picture, FigureError> {
    let whole = |who| of.of(who, |it| 3.0 * it.rate_before());
    let mut bars = vec![
        Bar::mean_of("level 1, undamaged", &whole(Entrant::Reliabilities)),
        Bar::mean_of("two levels, undamaged", &whole(Entrant::Both)),
    ];
    for (label, who, from, to) in [
        ("frozen", Entrant::Frozen, 0, 3),
        ("reliabilities, 0-3k", Entrant::Reliabilities, 0, 3),
        ("reliabilities, 10-13k", Entrant::Reliabilities, 10, 13),
        ("re-learning, 0-3k", Entrant::Plain, 0, 3),
        ("re-learning, 10-13k", Entrant::Plain, 10, 13),
        ("surprise, 0-3k", Entrant::Surprise, 0, 3),
        ("surprise, 10-13k", Entrant::Surprise, 10, 13),
        ("two levels, 0-3k", Entrant::Both, 0, 3),
        ("two levels, 10-13k", Entrant::Both, 10, 13),
        ("Sarsa(λ), 0-3k", Entrant::Sarsa, 0, 3),
        ("Sarsa(λ), 10-13k", Entrant::Sarsa, 10, 13),
    ] {
        let seeds = of.of(who, |it| it.captures(from, to));
        bars.push(Bar::mean_of(label, &seeds));
    }
    let title = "Performance after the damage (Fig 6.8, with replacement)";
    bar_chart(
        &Axes::new(title, "", "captures in 3000 actions").sized(900, 560),
        &bars,
    )
}

fn reliabilities(of: &Lived<'_>, place: usize, when: &str) -> Result<Picture, FigureError> {
    let first = of.trials.first();
    let course = first.and_then(|trial| trial.course(of.index, Entrant::Reliabilities));
    let values = course.map_or(&[][..], |course| &course.reliabilities[place]);
    let title = format!("Reliability of level 1 {when} the damage, first seed (Fig 6.6)");
    histogram(
        &Axes::new(&title, "reliability", "schemas").x(0.0, 1.0),
        values,
        20,
    )
}
