//! The claims of the study of neighbours: what they are worth, and whether that needs a topology.

use super::options::{NeighboursOptions, TRIALS};
use super::places::Topology;
use super::tables;
use super::trial::{Done, Trial, of};
use crate::report::{Bound, Claim, Expectation, Rule, Statistic, Summary};

pub(super) fn summary(options: &NeighboursOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("neighbours", &options.seeds);
    summary.parameter("settings tried, with neighbours and without", TRIALS);
    summary.parameter(
        "without neighbours",
        format!("{:?}", options.learning(false)),
    );
    summary.parameter("with neighbours", format!("{:?}", options.learning(true)));
    summary.parameter("studies shorter by", options.shorter);
    for map in Topology::ALL {
        summary.claims.extend(on(map, trials));
    }
    summary.claims.push(topology(trials));
    summary.table("what neighbours are worth", tables::worth(trials));
    if !options.is_standard() {
        summary.vary();
    }
    summary
}

fn on(map: Topology, trials: &[Trial]) -> [Claim; 3] {
    let ordered = map == Topology::Ordered;
    let name = |what: &str| match map {
        Topology::Ordered => format!("neighbours.{what}"),
        _ => format!("neighbours.{what}.{}", map.id()),
    };
    let claim = |what: &str, unit: &str| Expectation::new(name(what), "7.1.4", unit).extension();
    let asked = |rule: Rule| if ordered { rule } else { Rule::Measured };
    let steps = |what: &str, note: &str, measure: fn(&Done) -> f64| {
        claim(what, "times the steps without neighbours")
            .rule(asked(Rule::Keeps(Statistic::High, Bound::Below(1.0))))
            .note(note)
            .judge_ratio(
                &of(trials, map, true, measure),
                &of(trials, map, false, measure),
            )
    };
    [
        claim("effect", "share of attempts")
            .rule(asked(Rule::All(vec![
                Rule::mean(Bound::Above(0.0)),
                Rule::p(Bound::AtMost(0.05)),
            ])))
            .note(
                "attempts in 40 steps that reach goals that no schema has as its result, with neighbours \
                 less without",
            )
            .judge_difference(
                &of(trials, map, true, |it| it.reached),
                &of(trials, map, false, |it| it.reached),
            ),
        steps(
            "learning",
            "mean steps to the goal in the first 30 episodes, with neighbours over without",
            |it| it.learning,
        ),
        steps(
            "recovery",
            "the same in 30 episodes after two actions were swapped",
            |it| it.recovery,
        ),
    ]
}

/// The effect less that on the same nodes in an order by chance.
fn topology(trials: &[Trial]) -> Claim {
    let effect = |map: Topology| -> Vec<f64> {
        let reached = |shared| of(trials, map, shared, |it| it.reached);
        let pairs = reached(true).into_iter().zip(reached(false));
        pairs.map(|(with, without)| with - without).collect()
    };
    Expectation::new("neighbours.topology", "7.1.4", "share of attempts")
        .extension()
        .rule(Rule::All(vec![
            Rule::mean(Bound::Above(0.0)),
            Rule::p(Bound::AtMost(0.05)),
        ]))
        .note(
            "what neighbours are worth for goals without a schema, less on the same nodes shuffled",
        )
        .judge_difference(&effect(Topology::Ordered), &effect(Topology::Shuffled))
}
