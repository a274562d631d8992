//! The claims of chapter 4; the tables beside them are in `tables`.
//!
//! Each claim states its measure, its margin and the book's number where there is one.

use serde_json::{Value, json};

use super::measure::{Causality, Differences, SEPARATION_MARGIN, SPECIAL};
use super::network::CausalConfig;
use super::options::CausalOptions;
use super::overload::{Reaction, TESTS};
use super::tables;
use super::trial::{Control, Trial, of};
use crate::report::{Bound, Claim, Expectation, Rule, Summary};
use crate::world::launching::{Event, Noise};

pub(super) fn summary(options: &CausalOptions, trials: &[Trial]) -> Summary {
    let CausalOptions { seeds, config } = options;
    let mut summary = Summary::new("causal", seeds);
    parameters(&mut summary, config);
    for claim in components(trials)
        .into_iter()
        .chain(causal_view(trials))
        .chain([stages(trials)])
        .chain(fallback(trials))
        .chain(controls(trials))
    {
        summary.claim(claim);
    }
    summary.table("differences at the Top layer", tables::differences(trials));
    summary.table("controls", tables::controls(trials));
    summary.table("special nodes of the Top layer", tables::special(trials));
    summary.table(
        "settled after this share of training",
        tables::settled(trials),
    );
    summary.table("alarms by kind of event", tables::alarms(trials));
    summary.table("found by disturbed event", tables::found(trials));
    summary
}

fn parameters(summary: &mut Summary, config: &CausalConfig) {
    let events = &config.launching;
    // Decimal fractions as they were typed, not as f32 holds them.
    let typed = |value: f32| -> Value { json!(value.to_string().parse::<f64>().unwrap_or(0.0)) };
    let typed_all = |values: &[f32]| -> Value { values.iter().map(|&v| typed(v)).collect() };
    summary.parameter("training events", config.events);
    summary.parameter(
        "shares of Direct, Delay, Gap, Delay+Gap",
        typed_all(&config.shares),
    );
    summary.parameter(
        "learning rate, first and last",
        typed_all(&[config.alpha.0, config.alpha.1]),
    );
    summary.parameter(
        "last neighbourhood by layer",
        typed_all(&config.final_neighbourhood),
    );
    summary.parameter(
        "activation width by layer",
        typed_all(&config.activation_width),
    );
    summary.parameter("detectors take note from", typed(config.record_from));
    summary.parameter(
        "limit of distance by layer",
        typed_all(&config.detectors.map(|d| d.limit())),
    );
    summary.parameter("slack of transitions by layer", json!(config.order_slack));
    summary.parameter("first ball starts at cell", typed(events.first_start));
    summary.parameter("second ball starts at cell", typed(events.second_start));
    summary.parameter("cells a step", typed(events.cells_per_step));
    summary.parameter("speed level", typed(events.speed_level));
    summary.parameter("gap in cells", typed(events.gap));
    summary.parameter("delay in steps", events.delay);
    summary.parameter("still frames at each end", events.still_frames);
    summary.parameter("position jitter in cells", typed(events.position_jitter));
    summary.parameter("speed jitter in levels", typed(events.speed_jitter));
    summary.parameter("test events of each sort", TESTS);
}

fn components(trials: &[Trial]) -> [Claim; 2] {
    let margin = format!("seeds with a ratio of at least {SEPARATION_MARGIN}");
    let claim = |id: &str, what: &str, ratio: fn(&Causality) -> f64| {
        let ratios = of(trials, |trial| ratio(&trial.trained));
        let separates: Vec<bool> = ratios.iter().map(|&r| r >= SEPARATION_MARGIN).collect();
        Expectation::new(id, "4.3.2", margin.as_str())
            .rule(Rule::mean(Bound::AtLeast(0.9)))
            .note(what)
            .judge_share(&separates)
    };
    [
        claim(
            "causal.position_separates",
            "difference of events with and without gap over that with and without delay",
            Causality::position_separation,
        ),
        claim(
            "causal.movement_separates",
            "difference of events with and without delay over that with and without gap",
            Causality::movement_separation,
        ),
    ]
}

fn causal_view(trials: &[Trial]) -> Vec<Claim> {
    let nodes = of(trials, |trial| trial.trained.special_nodes());
    let share = |id: &str, section: &str, unit: String, least: f64, yes: Vec<bool>| {
        let claim = Expectation::new(id, section, unit);
        claim
            .rule(Rule::mean(Bound::AtLeast(least)))
            .judge_share(&yes)
    };
    let special = |event: Event, some: bool| -> Vec<bool> {
        nodes
            .iter()
            .map(|nodes| (nodes[event as usize] > 0) == some)
            .collect()
    };
    let some = format!("seeds with nodes whose isolate is above {SPECIAL}");
    let none = format!("seeds without nodes whose isolate is above {SPECIAL}");
    let pattern = of(trials, |trial| trial.trained.has_full_pattern());
    let differences = of(trials, |trial| trial.trained.differences());
    let pick = |of: fn(&Differences) -> f64| -> Vec<f64> { differences.iter().map(of).collect() };
    let below = pick(|d| d.delay_gap);
    vec![
        share(
            "causal.isolates.direct",
            "4.3.3",
            some.clone(),
            0.9,
            special(Event::Direct, true),
        ),
        share(
            "causal.isolates.delaygap",
            "4.3.5",
            some,
            0.9,
            special(Event::DelayGap, true),
        ),
        share(
            "causal.isolates.delay",
            "4.3.3",
            none.clone(),
            0.9,
            special(Event::Delay, false),
        ),
        share(
            "causal.isolates.gap",
            "4.3.3",
            none,
            0.9,
            special(Event::Gap, false),
        ),
        share(
            "causal.isolates.full_pattern",
            "4.3.3, 4.3.5",
            "seeds with nodes for Direct and Delay+Gap, none for Delay and Gap".to_owned(),
            0.85,
            pattern,
        ),
        larger(
            "causal.direct_vs_delaygap@2",
            (9.66, 1.16),
            1.6,
            &pick(|d| d.direct_delaygap),
            &below,
        ),
        larger(
            "causal.direct_vs_gap@2",
            (8.20, 0.56),
            1.4,
            &pick(|d| d.direct_gap),
            &below,
        ),
        Expectation::new(
            "causal.direct_vs_delay",
            "Fig 4.7",
            "Direct–Delay over Delay–Gap",
        )
        .rule(Rule::every_seed(Bound::Above(1.0)))
        .contradicts_itself(
            "the label of Fig 4.7 says Direct–Delay, the text Direct–Gap; only the text holds",
        )
        .judge_ratio(&pick(|d| d.direct_delay), &below),
    ]
}

/// A causal difference that is larger than that of Delay and Gap, 5.38 ± 1.00 in the book.
///
/// The book's units are those of its own maps, and its ratio has no error: what is asked is that the
/// difference is larger, clearly and in every seed.
fn larger(id: &str, book: (f64, f64), least: f64, above: &[f64], below: &[f64]) -> Claim {
    Expectation::new(id, "4.3.4", "times the difference of Delay and Gap")
        .rule(Rule::All(vec![
            Rule::mean(Bound::AtLeast(least)),
            Rule::every_seed(Bound::Above(1.0)),
            Rule::p(Bound::AtMost(0.001)),
        ]))
        .note(format!(
            "the book has {:.2} ± {:.2} against 5.38 ± 1.00 (n = 4), {:.2} times as much",
            book.0,
            book.1,
            book.0 / 5.38,
        ))
        .judge_ratio(above, below)
}

fn stages(trials: &[Trial]) -> Claim {
    let last = of(trials, |trial| {
        let [position, movement, top] = trial.settled;
        top > position && top > movement
    });
    Expectation::new(
        "causal.stages",
        "4.3.6",
        "seeds in which the Top layer settles last",
    )
    .rule(Rule::mean(Bound::AtLeast(0.9)))
    .note("settled: within a third of the final composite; the book has .69 for Level 1")
    .judge_share(&last)
}

fn fallback(trials: &[Trial]) -> Vec<Claim> {
    let noisy = |of_it: fn(&Reaction) -> f64| of(trials, |r| of_it(&r.overload.noisy));
    let clean = |of_it: fn(&Reaction) -> f64| of(trials, |r| of_it(&r.overload.clean));
    let detected = noisy(|reaction| reaction.rates.overloaded[2]);
    let false_alarms = clean(|reaction| reaction.rates.any);
    let good: Vec<bool> = detected
        .iter()
        .zip(&false_alarms)
        .map(|(detected, false_alarms)| *detected >= 0.95 && *false_alarms <= 0.05)
        .collect();
    let mut claims = vec![
        Expectation::new(
            "causal.fallback.good",
            "4.4",
            "seeds that find .95 of Noisy events at .05 false alarms or fewer",
        )
        .extension()
        .rule(Rule::share(19, 20))
        .note("detectors of our own, of distance and of order")
        .judge_share(&good),
        Expectation::new("causal.fallback.detected@2", "4.4", "share of Noisy events")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .note("the Top layer's own detectors: distance and order")
            .judge(&detected),
        Expectation::new(
            "causal.fallback.false_alarms@2",
            "4.4",
            "share of held-out clean events",
        )
        .extension()
        .rule(Rule::mean(Bound::AtMost(0.05)))
        .note("any detector of any layer; clean: new draws within the trained jitter")
        .judge(&false_alarms),
        Expectation::new("causal.fallback.correct", "4.4", "share of Noisy events")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .note(
                "the Top layer is overloaded and one of the layers below it is not, which answers, \
                 be it Position alone",
            )
            .judge(&noisy(|reaction| reaction.rates.fallback)),
        Expectation::new("causal.fallback.literal", "3.4", "share of Noisy events")
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .note("the book's trigger: the Top's total is below the minimum of late training")
            .judge(&noisy(|reaction| reaction.rates.literal[2])),
        muted(trials),
    ];
    for (kind, noise) in Noise::ALL.into_iter().enumerate() {
        let found = of(trials, |trial| trial.overload.kinds[kind].rates.any);
        let id = format!("causal.fallback.noise.{}", noise.id());
        claims.push(
            Expectation::new(id, "4.4", "share of disturbed events")
                .extension()
                .rule(Rule::mean(Bound::AtLeast(0.9)))
                .note("any detector of any layer")
                .judge(&found),
        );
    }
    claims
}

/// Level 1 responds to the Noisy event and the Top layer hardly does (Fig 4.10).
fn muted(trials: &[Trial]) -> Claim {
    let top = of(trials, |r| r.overload.noisy.activation[2]);
    Expectation::new(
        "causal.fallback.muted",
        "4.4.2",
        "Top activation, Noisy over Direct",
    )
    .rule(Rule::mean(Bound::AtMost(0.5)))
    .judge(&top)
}

fn controls(trials: &[Trial]) -> [Claim; 4] {
    let nodes = |control: Control, event: Event| {
        of(trials, |trial| {
            control(trial).special_nodes()[event as usize]
        })
    };
    let uniform = of(trials, |trial| {
        let differences = trial.uniform.differences();
        differences.direct_delaygap / differences.delay_gap
    });
    let delay = nodes(|trial| &trial.mostly_delay, Event::Delay);
    let direct = nodes(|trial| &trial.mostly_delay, Event::Direct);
    let delay_is_special: Vec<bool> = delay
        .iter()
        .zip(&direct)
        .map(|(delay, direct)| *delay > 0 && delay > direct)
        .collect();
    let none = of(trials, |trial| trial.untrained.special_nodes() == [0; 4]);
    let staged = of(trials, |trial| trial.staged.has_full_pattern());
    [
        Expectation::new(
            "causal.control.uniform",
            "4.3.1",
            "Direct–Delay+Gap over Delay–Gap, equal frequencies",
        )
        .rule(Rule::mean(Bound::AtMost(1.2)))
        .note("with equal frequencies in training: special follows frequency")
        .judge(&uniform),
        Expectation::new(
            "causal.control.delay85",
            "4.3.1",
            "seeds with more special nodes for Delay than for Direct",
        )
        .rule(Rule::mean(Bound::AtLeast(0.9)))
        .note("with Delay at 85 % of the events in training: special follows frequency")
        .judge_share(&delay_is_special),
        Expectation::new(
            "causal.control.untrained",
            "4.3.3",
            "seeds without any special node",
        )
        .extension()
        .rule(Rule::mean(Bound::AtLeast(0.9)))
        .judge_share(&none),
        Expectation::new(
            "causal.control.staged",
            "4.3.6",
            "seeds with the full pattern of isolates",
        )
        .extension()
        .rule(Rule::mean(Bound::AtLeast(0.85)))
        .note("Level 1 trained alone, then the Top layer for as many events")
        .judge_share(&staged),
    ]
}
