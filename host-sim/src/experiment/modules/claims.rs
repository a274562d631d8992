//! The claims of the study of modules.
//!
//! A sign, a size and an interval of each module beside the map, in pairs of the same seeds.

use super::make::TRIALS;
use super::module::Kind;
use super::options::ModulesOptions;
use super::tables;
use super::trial::{Measured, Trial, of};
use crate::report::{Bound, Claim, Expectation, Rule, Statistic, Summary};

/// A number of a module, by its name in claims.
type Measure = (
    &'static str,
    &'static str,
    &'static str,
    fn(&Measured) -> f64,
);

/// What is compared with the map: name, unit, what it is.
const COMPARED: [Measure; 4] = [
    (
        "causal",
        "share of events",
        "new launching events told by the nearest composite of a clean one",
        |it| it.causal.told,
    ),
    (
        "noisy",
        "area under the ROC curve",
        "novelty at the Top of Noisy events against clean ones",
        |it| it.causal.noisy,
    ),
    (
        "compactness",
        "units",
        "units of the Top that were above .5 in a new launching event",
        |it| it.causal.used,
    ),
    (
        "schemas",
        "share of transitions",
        "results of forward that the prototype with the nearest context says",
        |it| it.schemas.predicted,
    ),
];

pub(super) fn summary(options: &ModulesOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("modules", &options.seeds);
    summary.parameter("settings tried of each kind", TRIALS);
    for kind in Kind::ALL {
        let name = format!("setting of {}", kind.id());
        summary.parameter(&name, options.setting(kind));
    }
    summary.parameter("trainings and lives shorter by", options.shorter);
    for kind in Kind::ALL {
        summary.claims.extend(alone(kind, trials));
    }
    for kind in &Kind::ALL[1..] {
        summary.claims.extend(beside_the_map(*kind, trials));
    }
    summary.claims.push(recruited(trials));
    for (name, table) in tables::all(trials) {
        summary.table(name, table);
    }
    if !options.is_standard() {
        summary.vary();
    }
    summary
}

fn claim(what: &str, kind: Kind, name: &str, section: &str, unit: &str) -> Expectation {
    let id = format!("modules.{what}.{}{name}", kind.id());
    Expectation::new(id, section, unit).extension()
}

/// What is asked of each kind for itself.
fn alone(kind: Kind, trials: &[Trial]) -> Vec<Claim> {
    let measure = |it: fn(&Measured) -> f64| of(trials, kind, it);
    let share = |it: fn(&Measured) -> bool| -> Vec<bool> {
        trials.iter().map(|trial| it(trial.of(kind))).collect()
    };
    let more = || {
        Rule::All(vec![
            Rule::mean(Bound::Above(0.0)),
            Rule::p(Bound::AtMost(0.05)),
        ])
    };
    let nearly_all = || Rule::mean(Bound::AtLeast(0.9));
    vec![
        claim("causal", kind, ".ratio", "7.1.2", "times Delay and Gap")
            .rule(Rule::Keeps(Statistic::Low, Bound::Above(1.0)))
            .note("difference of Direct and Delay+Gap at the Top over that of Delay and Gap")
            .judge_ratio(
                &measure(|it| it.causal.direct_delaygap),
                &measure(|it| it.causal.delay_gap),
            ),
        claim("causal", kind, ".pattern", "7.1.2", "share of seeds")
            .rule(nearly_all())
            .note("special units for Direct and Delay+Gap, none for Delay and Gap")
            .judge_share(&share(|it| it.causal.has_full_pattern())),
        claim("angle", kind, ".young", "7.1.2", "share of seeds")
            .rule(nearly_all())
            .note("networks that met one angle find new lines newer than a new angle")
            .judge_share(&share(|it| it.angle.young.rotated > it.angle.young.opened)),
        claim("angle", kind, ".old", "7.1.2", "share of seeds")
            .rule(nearly_all())
            .note("networks that have seen angles find a new angle newer than new lines")
            .judge_share(&share(|it| it.angle.old.opened > it.angle.old.rotated)),
        claim("invariance", kind, ".untrained", "7.1.3", "share of events")
            .rule(more())
            .note(
                "shifted launching events at shifts never trained that are told, with a Position layer \
                 that pools over shifts, less those with a plain one",
            )
            .judge_difference(
                &measure(|it| it.invariance.pooled.untrained),
                &measure(|it| it.invariance.plain.untrained),
            ),
        claim("invariance", kind, ".trained", "7.1.3", "share of events")
            .note("the same at the shifts of training")
            .judge_difference(
                &measure(|it| it.invariance.pooled.trained),
                &measure(|it| it.invariance.plain.trained),
            ),
        claim("bytes", kind, "", "7.1.2", "bytes")
            .note("all three modules of the causal study while they learn")
            .judge(&measure(|it| it.causal.bytes)),
        claim("work", kind, ".respond", "7.1.2", "multiply-adds")
            .note("to answer a stimulus of the causal study; a function counts for ten")
            .judge(&measure(|it| it.causal.respond)),
        claim("work", kind, ".learn", "7.1.2", "multiply-adds")
            .note("to learn a stimulus of the causal study; a function counts for ten")
            .judge(&measure(|it| it.causal.learn)),
    ]
}

/// A kind less the map, seed by seed.
fn beside_the_map(kind: Kind, trials: &[Trial]) -> Vec<Claim> {
    COMPARED
        .iter()
        .map(|(what, unit, note, measure)| {
            claim(what, kind, ".over_som", "7.1.2", unit)
                .note(format!("{note}, less those of the map"))
                .judge_difference(&of(trials, kind, measure), &of(trials, Kind::Map, measure))
        })
        .collect()
}

/// The core's Action SOM, less the plain map.
fn recruited(trials: &[Trial]) -> Claim {
    let recruited: Vec<f64> = trials.iter().map(|it| it.action_som.predicted).collect();
    Expectation::new(
        "modules.schemas.recruitment.over_som",
        "5.3.1",
        "share of transitions",
    )
    .extension()
    .note("the Action SOM of the forager, which recruits nodes, less the plain map")
    .judge_difference(
        &recruited,
        &of(trials, Kind::Map, |it| it.schemas.predicted),
    )
}
