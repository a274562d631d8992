//! The figures of chapter 4: composites, isolates, differences, stages, Noisy events, detectors.
//!
//! Figures of single networks show the first seed, in the book's order of events.

use super::measure::Differences;
use super::network::{LAYERS, View};
use super::options::CausalOptions;
use super::overload::{Reaction, Scores};
use super::trial::Trial;
use crate::report::figure::{
    Axes, Bar, FigureError, HeatMap, Picture, bar_chart, bar_charts, heat_maps, roc,
};
use crate::report::sample;
use crate::world::launching::Event;

/// The moments of Fig 4.9, in events of 6500.
const MOMENTS: [u32; 6] = [0, 500, 1500, 3500, 5500, 6500];

/// One of the scores of events.
type Score = fn(&Scores) -> &Vec<f64>;

type Figures = Vec<(&'static str, Picture)>;

pub(super) fn all(options: &CausalOptions, trials: &[Trial]) -> Result<Figures, FigureError> {
    let Some(first) = trials.first() else {
        return Ok(Vec::new());
    };
    let of_all = sample(&options.seeds);
    Ok(vec![
        ("composites_level1", level_1(first)?),
        ("composites_top", top(first)?),
        ("differences", differences(&of_all, trials)?),
        ("stages", stages(first)?),
        ("noisy", noisy(first)?),
        ("overload_roc", detectors(&of_all, trials)?),
        ("controls", controls(&of_all, trials)?),
    ])
}

/// What all captions of single networks say.
fn single(trial: &Trial) -> String {
    format!(
        "n = 1 (seed {}, the first). One square a node; events 85 % Direct, 5 % each of the others.",
        trial.seed
    )
}

/// Nodes in a row of each layer.
const WIDTHS: [usize; 3] = [12, 6, 8];

fn map(title: &str, layer: usize, values: impl IntoIterator<Item = f32>) -> HeatMap {
    let values = values.into_iter().map(f64::from).collect();
    HeatMap::new(title, WIDTHS[layer], values)
}

/// The composites of a view, layer by layer.
fn composites(view: &View) -> [&[f32]; 3] {
    [
        view.position.nodes().as_slice(),
        view.movement.nodes().as_slice(),
        view.top.nodes().as_slice(),
    ]
}

/// The largest activation of each layer in any of the views.
fn largest<'a>(views: impl IntoIterator<Item = &'a View>) -> [f32; 3] {
    let mut most = [f32::MIN_POSITIVE; 3];
    for view in views {
        for (most, values) in most.iter_mut().zip(composites(view)) {
            *most = values.iter().copied().fold(*most, f32::max);
        }
    }
    most
}

/// Fig 4.5: a still event holds its nodes for steps on end; the root keeps the others visible beside
/// them.
fn level_1(trial: &Trial) -> Result<Picture, FigureError> {
    let largest = largest(&trial.trained.views);
    let rows = [0, 1].map(|layer| {
        Event::ALL.map(|event| {
            let values = composites(trial.trained.view(event))[layer];
            let shares = values.iter().map(|value| (value / largest[layer]).sqrt());
            map(&format!("{}: {event}", LAYERS[layer]), layer, shares)
        })
    });
    let caption = format!(
        "{} Composite: activation summed over an event, as the root of its share of the layer's \
         largest. The book's figure shows the same in pictures without numbers.",
        single(trial)
    );
    let axes = Axes::new(
        "Claim: Position tells gap from no gap, Movement tells delay from no delay (Fig 4.5)",
        "",
        "root of share of largest",
    );
    heat_maps(&axes.caption(caption), 4, &rows.concat(), Some((0.0, 1.0)))
}

/// Fig 4.6.
fn top(trial: &Trial) -> Result<Picture, FigureError> {
    let composites = Event::ALL.map(|event| {
        let nodes = trial.trained.view(event).top.nodes();
        let name = format!("composite: {event}");
        map(&name, 2, nodes.as_slice().iter().copied())
    });
    let isolates = Event::ALL.map(|event| {
        let isolate = trial.trained.isolate(event);
        let name = format!("isolate: {event}");
        map(&name, 2, isolate.nodes().as_slice().iter().copied())
    });
    let caption = format!(
        "{} Composite: activation summed over an event. Isolate: what exceeds those of the other \
         three events together, at least 0.",
        single(trial)
    );
    let title =
        "Claim: at the Top layer, only Direct and Delay+Gap have nodes of their own (Fig 4.6)";
    let axes = Axes::new(title, "", "summed activation").caption(caption);
    let maps: Vec<HeatMap> = composites.into_iter().chain(isolates).collect();
    heat_maps(&axes, 4, &maps, None)
}

/// Fig 4.7, in its own unit and as ratios.
fn differences(of_all: &str, trials: &[Trial]) -> Result<Picture, FigureError> {
    let bar = |label: &str, of: fn(&Differences) -> f64| {
        let values: Vec<f64> = trials
            .iter()
            .map(|trial| of(&trial.trained.differences()))
            .collect();
        Bar::mean_of(label, &values)
    };
    let (pair, deviation) = (5.38, 1.00);
    let sums = [
        bar("Direct – Delay+Gap", |d| d.direct_delaygap).beside_with(9.66, 1.16),
        bar("Direct – Gap", |d| d.direct_gap).beside_with(8.20, 0.56),
        bar("Direct – Delay", |d| d.direct_delay),
        bar("Delay – Gap", |d| d.delay_gap).beside_with(pair, deviation),
    ];
    let ratios = [
        bar("Direct – Delay+Gap", |d| d.direct_delaygap / d.delay_gap).beside(9.66 / pair),
        bar("Direct – Gap", |d| d.direct_gap / d.delay_gap).beside(8.20 / pair),
        bar("Direct – Delay", |d| d.direct_delay / d.delay_gap),
    ];
    let caption = format!(
        "{of_all}; book: 4 runs. Bars: mean; error bars: standard deviation. The sum depends on the \
         width of the nodes' answers, which the book does not print; the ratio does not. The book \
         labels one pair Direct – Delay, its text says Direct – Gap.",
    );
    let title = "Claim: causal pairs differ more than Delay and Gap do (Fig 4.7)";
    let axes = Axes::new(title, "", "").caption(caption).sized(960, 460);
    let charts: [(&str, &[Bar]); 2] = [
        ("summed difference at the Top layer", &sums),
        ("times Delay – Gap", &ratios),
    ];
    bar_charts(&axes, ["ours", "book"], &charts)
}

/// Fig 4.9: every map on its own scale, so that the early ones, which answer to everything, and the
/// late ones, which answer with few nodes, are both seen.
fn stages(trial: &Trial) -> Result<Picture, FigureError> {
    let last = trial.stages.last().map_or(1, |stage| stage.event);
    let moments = MOMENTS.map(|moment| u64::from(moment) * u64::from(last) / 6500);
    let mut maps = Vec::new();
    for (layer, name) in LAYERS.into_iter().enumerate() {
        for moment in moments {
            let near = |stage: &&super::measure::Stage| u64::from(stage.event).abs_diff(moment);
            if let Some(stage) = trial.stages.iter().min_by_key(near) {
                let values = &stage.composites[layer];
                let most = values.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
                let largest = match most {
                    0.05.. => format!("{most:.1}"),
                    _ => "below 0.05".to_owned(),
                };
                let title = format!("{name}, {} events, largest {largest}", stage.event);
                maps.push(map(&title, layer, values.iter().map(|value| value / most)));
            }
        }
    }
    let caption = format!(
        "{} Composite of the Direct event, as a share of the map's own largest activation, which \
         stands above it.",
        single(trial)
    );
    let title = "Claim: the Top layer settles after the layers below it (Fig 4.9)";
    let axes = Axes::new(title, "", "share of largest").caption(caption);
    heat_maps(&axes, MOMENTS.len(), &maps, Some((0.0, 1.0)))
}

/// Fig 4.10.
fn noisy(trial: &Trial) -> Result<Picture, FigureError> {
    let direct = trial.trained.view(Event::Direct);
    let largest = largest([direct, &trial.noisy]);
    let row = |view: &View, name: &str| {
        [0, 1, 2].map(|layer| {
            let shares = composites(view)[layer].iter();
            let shares = shares.map(|value| value / largest[layer]);
            map(&format!("{}: {name}", LAYERS[layer]), layer, shares)
        })
    };
    let maps = [row(direct, "Direct"), row(&trial.noisy, "Noisy")].concat();
    let caption = format!(
        "{} Composite of one event, as a share of the layer's largest in either.",
        single(trial)
    );
    let title =
        "Claim: in a Noisy event the Top layer is muted, the layers below answer (Fig 4.10)";
    let axes = Axes::new(title, "", "share of largest").caption(caption);
    heat_maps(&axes, 3, &maps, Some((0.0, 1.0)))
}

fn detectors(of_all: &str, trials: &[Trial]) -> Result<Picture, FigureError> {
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
    let caption = format!(
        "{of_all}; events of all seeds and of all kinds of noise together. Area: under the curve; \
         .5 is chance, 1 is without error.",
    );
    let title = "How well overload of the Top layer is noticed";
    let axes = Axes::new(
        title,
        "false alarms, share of clean events",
        "hits, share of noisy events",
    );
    roc(&axes.caption(caption), &curves)
}

fn controls(of_all: &str, trials: &[Trial]) -> Result<Picture, FigureError> {
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
        bar("the same, in stages", |r| &r.staged),
        bar("all equally often", |r| &r.uniform),
        bar("Delay 85 %", |r| &r.mostly_delay),
        bar("untrained", |r| &r.untrained),
    ];
    let caption = format!(
        "{of_all}; book: 4 runs. Bars: mean of the ratios; error bars: standard deviation. Above 1: \
         Direct is further from Delay+Gap than Delay from Gap.",
    );
    let title = "Claim: what is special follows what is frequent, not what is causal";
    let axes = Axes::new(title, "", "Direct – Delay+Gap over Delay – Gap").caption(caption);
    bar_chart(&axes.sized(860, 440), ["ours", "book"], &bars)
}
