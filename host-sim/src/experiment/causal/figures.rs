//! The figures of chapter 4: composites, isolates, differences, stages, Noisy events, detectors.
//!
//! Figures of single networks show the first seed, in the book's order of events.

use super::measure::Differences;
use super::network::{LAYERS, View};
use super::overload::{Reaction, Scores};
use super::trial::Trial;
use crate::report::figure::{Axes, Bar, FigureError, HeatMap, Picture, bar_chart, heat_maps, roc};
use crate::world::launching::Event;

/// The moments of Fig 4.9, in events of 6500.
const MOMENTS: [u32; 6] = [0, 500, 1500, 3500, 5500, 6500];

/// One of the scores of events.
type Score = fn(&Scores) -> &Vec<f64>;

type Figures = Vec<(&'static str, Picture)>;

pub(super) fn all(trials: &[Trial]) -> Result<Figures, FigureError> {
    let Some(first) = trials.first() else {
        return Ok(Vec::new());
    };
    Ok(vec![
        ("composites_level1", level_1(first)?),
        ("composites_top", top(first)?),
        ("differences", differences(trials)?),
        ("stages", stages(first)?),
        ("noisy", noisy(first)?),
        ("overload_roc", detectors(trials)?),
        ("controls", controls(trials)?),
    ])
}

/// A map drawn with every node as a square of `side` × `side`, so that maps of different layers
/// are equally large on the page.
fn map(title: &str, width: usize, side: usize, values: impl IntoIterator<Item = f32>) -> HeatMap {
    let values: Vec<f64> = values.into_iter().map(f64::from).collect();
    let large = values
        .chunks(width)
        .flat_map(|row| {
            let wide: Vec<f64> = row
                .iter()
                .flat_map(|&value| std::iter::repeat_n(value, side))
                .collect();
            std::iter::repeat_n(wide, side).flatten()
        })
        .collect();
    HeatMap::new(title, width * side, large)
}

/// The composites of a view, as shares of the largest of `largest`.
fn maps_of(view: &View, name: &str, largest: [f32; 3]) -> [HeatMap; 3] {
    let share = |layer: usize| move |&value: &f32| value / largest[layer];
    let title = |layer: usize| format!("{}: {name}", LAYERS[layer]);
    [
        map(
            &title(0),
            12,
            2,
            view.position.nodes().as_slice().iter().map(share(0)),
        ),
        map(
            &title(1),
            6,
            4,
            view.movement.nodes().as_slice().iter().map(share(1)),
        ),
        map(
            &title(2),
            8,
            3,
            view.top.nodes().as_slice().iter().map(share(2)),
        ),
    ]
}

fn largest<'a>(views: impl IntoIterator<Item = &'a View>) -> [f32; 3] {
    let most = |values: &[f32]| values.iter().copied().fold(0.0, f32::max);
    views
        .into_iter()
        .fold([f32::MIN_POSITIVE; 3], |[a, b, c], view| {
            [
                a.max(most(view.position.nodes().as_slice())),
                b.max(most(view.movement.nodes().as_slice())),
                c.max(most(view.top.nodes().as_slice())),
            ]
        })
}

/// A still event holds its nodes for steps on end; the root keeps the others visible beside them.
fn level_1(trial: &Trial) -> Result<Picture, FigureError> {
    let largest = largest(&trial.trained.views);
    let mut maps: [Vec<HeatMap>; 3] = Default::default();
    for event in Event::ALL {
        let of_event = maps_of(trial.trained.view(event), &event.to_string(), largest);
        for (row, mut map) in maps.iter_mut().zip(of_event) {
            map.values
                .iter_mut()
                .for_each(|value| *value = value.sqrt());
            row.push(map);
        }
    }
    let [position, movement, _] = maps;
    let both: Vec<HeatMap> = position.into_iter().chain(movement).collect();
    let title = format!(
        "Level 1: activation composites, root of the share of the largest (seed {})",
        trial.seed
    );
    heat_maps(&title, 4, &both, Some((0.0, 1.0)))
}

fn top(trial: &Trial) -> Result<Picture, FigureError> {
    let composites = Event::ALL.map(|event| {
        let nodes = trial.trained.view(event).top.nodes();
        map(
            &format!("composite: {event}"),
            8,
            3,
            nodes.as_slice().iter().copied(),
        )
    });
    let isolates = Event::ALL.map(|event| {
        let isolate = trial.trained.isolate(event);
        map(
            &format!("isolate: {event}"),
            8,
            3,
            isolate.nodes().as_slice().iter().copied(),
        )
    });
    let maps: Vec<HeatMap> = composites.into_iter().chain(isolates).collect();
    let title = format!(
        "Top layer: composites and isolates, summed activation (seed {})",
        trial.seed
    );
    heat_maps(&title, 4, &maps, None)
}

fn differences(trials: &[Trial]) -> Result<Picture, FigureError> {
    let bar = |label: &str, of: fn(&Differences) -> f64| {
        let values: Vec<f64> = trials
            .iter()
            .map(|trial| of(&trial.trained.differences()))
            .collect();
        Bar::mean_of(label, &values)
    };
    // The book's numbers in our unit: both are drawn over the difference of Delay and Gap.
    let bars = [
        bar("Direct – Delay+Gap", |d| d.direct_delaygap / d.delay_gap).beside(9.66 / 5.38),
        bar("Direct – Gap", |d| d.direct_gap / d.delay_gap).beside(8.20 / 5.38),
        bar("Direct – Delay", |d| d.direct_delay / d.delay_gap),
        Bar::new("Delay – Gap", 1.0).beside(1.0),
    ];
    let title = format!(
        "Differences at the Top layer ({} seeds; lines: the book)",
        trials.len()
    );
    bar_chart(
        &Axes::new(&title, "", "times Delay – Gap, mean ± sd"),
        &bars,
    )
}

fn stages(trial: &Trial) -> Result<Picture, FigureError> {
    let last = trial.stages.last().map_or(1, |stage| stage.event);
    let moments = MOMENTS.map(|moment| u64::from(moment) * u64::from(last) / 6500);
    let mut maps = Vec::new();
    for (layer, (width, side)) in [(12, 2), (6, 4), (8, 3)].into_iter().enumerate() {
        let end = trial
            .stages
            .last()
            .map_or(&[][..], |stage| &stage.composites[layer]);
        let most = end.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
        for moment in moments {
            let near = |stage: &&super::measure::Stage| u64::from(stage.event).abs_diff(moment);
            if let Some(stage) = trial.stages.iter().min_by_key(near) {
                let title = format!("{} {}", LAYERS[layer], stage.event);
                let values = stage.composites[layer]
                    .iter()
                    .map(|value| (value / most).min(1.0));
                maps.push(map(&title, width, side, values));
            }
        }
    }
    let title = format!(
        "The Direct event after so many training events; 1 is the final largest (seed {})",
        trial.seed
    );
    heat_maps(&title, MOMENTS.len(), &maps, Some((0.0, 1.0)))
}

fn noisy(trial: &Trial) -> Result<Picture, FigureError> {
    let direct = trial.trained.view(Event::Direct);
    let largest = largest([direct, &trial.noisy]);
    let maps: Vec<HeatMap> = maps_of(direct, "Direct", largest)
        .into_iter()
        .chain(maps_of(&trial.noisy, "Noisy", largest))
        .collect();
    let title = format!(
        "A Noisy event: composites, share of the largest (seed {})",
        trial.seed
    );
    heat_maps(&title, 3, &maps, Some((0.0, 1.0)))
}

fn detectors(trials: &[Trial]) -> Result<Picture, FigureError> {
    let pool = |reactions: fn(&Trial) -> &[Reaction], of: Score| -> Vec<f64> {
        let reactions = trials.iter().flat_map(reactions);
        reactions
            .flat_map(|reaction| of(&reaction.scores))
            .copied()
            .collect()
    };
    let scores: [(&str, Score); 3] = [
        ("distance, by node", |scores| &scores.distance),
        ("distance, as it is", |scores| &scores.raw_distance),
        ("total activation (book)", |scores| &scores.literal),
    ];
    let pooled = scores.map(|(name, of)| {
        let noisy = pool(|trial| &trial.overload.kinds, of);
        let clean = pool(|trial| std::slice::from_ref(&trial.overload.clean), of);
        (name, noisy, clean)
    });
    let curves: Vec<(&str, &[f64], &[f64])> = pooled
        .iter()
        .map(|(name, noisy, clean)| (*name, &noisy[..], &clean[..]))
        .collect();
    roc("Overload of the Top layer, all kinds of noise", &curves)
}

fn controls(trials: &[Trial]) -> Result<Picture, FigureError> {
    let bar = |label: &str, network: fn(&Trial) -> &super::measure::Causality| {
        let ratios: Vec<f64> = trials
            .iter()
            .map(|trial| {
                let differences = network(trial).differences();
                differences.direct_delaygap / differences.delay_gap
            })
            .collect();
        Bar::mean_of(label, &ratios)
    };
    let bars = [
        bar("Direct 85 %", |r| &r.trained).beside(9.66 / 5.38),
        bar("staged", |r| &r.staged),
        bar("equal", |r| &r.uniform),
        bar("Delay 85 %", |r| &r.mostly_delay),
        bar("untrained", |r| &r.untrained),
    ];
    let axes = Axes::new(
        "What is special follows frequency (line: the book)",
        "",
        "Direct–Delay+Gap over Delay–Gap, mean ± sd",
    );
    bar_chart(&axes, &bars)
}
