//! The figures: in each world reward an action against experience.

use super::earned::{HISTORY, MEMORYLESS, best, last};
use super::options::AliasedOptions;
use super::places::Place;
use super::tables::ALL;
use super::trial::{Trial, key};
use crate::report::figure::{Axes, FigureError, Line, Picture, Point, Span, line_chart};
use crate::report::{mean, sample};

/// A figure a world.
pub(super) fn all(
    options: &AliasedOptions,
    trials: &[Trial],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    if trials.is_empty() {
        return Ok(Vec::new());
    }
    let one = |&place: &Place| Ok((place.name(), world(options, trials, place)?));
    options.places.iter().map(one).collect()
}

fn world(options: &AliasedOptions, trials: &[Trial], place: Place) -> Result<Picture, FigureError> {
    let lengths: Vec<f64> = place
        .lengths()
        .iter()
        .map(|&it| f64::from(options.length(it)))
        .collect();
    let drawn = [
        "mind",
        "level2",
        best(trials, place, &MEMORYLESS),
        best(trials, place, &HISTORY),
    ];
    let mut lines: Vec<Line> = drawn
        .iter()
        .map(|who| Line::new(label(who), points(trials, place, who, &lengths)))
        .collect();
    let span = Span {
        from: lengths.first().copied().unwrap_or_default(),
        to: lengths.last().copied().unwrap_or_default(),
    };
    for who in ["planner", "random"] {
        let height = mean(&last(trials, place, who));
        if height.is_finite() {
            lines.push(Line::reference(label(who), height, span));
        }
    }
    let caption = format!(
        "{}. Points: mean of tests in which nothing is tried; error bars: 95 %. Of rivals on percepts and \
         of those with history the one with the best mean at the end.",
        sample(&options.seeds)
    );
    let title = format!(
        "What an action earns where places look alike: {}",
        place.name()
    );
    let mut axes = Axes::new(&title, "actions of training", "reward an action");
    axes.x_log = true;
    line_chart(&axes.caption(caption).sized(1000, 460), &lines)
}

fn label(who: &str) -> &'static str {
    ALL.iter().find(|it| it.0 == who).map_or("", |it| it.1)
}

fn points(trials: &[Trial], place: Place, who: &str, lengths: &[f64]) -> Vec<Point> {
    let at = |(index, &length): (usize, &f64)| {
        let seeds: Vec<f64> = trials
            .iter()
            .filter_map(|it| it.courses.get(&key(place, who))?.get(index).copied())
            .collect();
        Point::mean_of(length, &seeds)
    };
    lengths.iter().enumerate().map(at).collect()
}
