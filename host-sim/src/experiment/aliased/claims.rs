//! What is concluded from lives where places look alike: its claims.

use super::constructed::Constructed;
use super::earned::{HISTORY, MEMORYLESS, SARSA, best, last};
use super::options::AliasedOptions;
use super::places::Place;
use super::tables;
use super::trial::Trial;
use crate::report::{Bound, Claim, Expectation, Rule, Statistic, Summary};

/// How far the lower end of an interval may lie below what is asked of the estimate.
const BELOW: f64 = 0.07;
/// Least t of a lead.
const LEAD: f64 = 3.0;

pub(super) fn summary(options: &AliasedOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("aliased", &options.seeds);
    let places = options.places.iter().map(|it| it.name());
    summary.parameter("worlds", places.collect::<Vec<_>>().join(" "));
    summary.parameter("lives shorter by", options.shorter);
    for &place in &options.places {
        summary.claims.extend(match place {
            Place::Barriers => barriers(trials),
            _ => of_file(place, trials),
        });
    }
    for (name, table) in tables::all(options, trials) {
        summary.table(name, table);
    }
    if options.shorter != 1 {
        summary.vary();
    }
    summary
}

fn claim(place: Place, name: &str, unit: &str) -> Expectation {
    let id = format!("aliased.{}.{name}", place.name());
    Expectation::new(id, "7.1.5", unit).extension()
}

fn share(asked: f64) -> Rule {
    // As one writes it.
    let surely = ((asked - BELOW) * 1e6).round() / 1e6;
    Rule::All(vec![
        Rule::mean(Bound::AtLeast(asked)),
        Rule::Keeps(Statistic::Low, Bound::AtLeast(surely)),
    ])
}

fn lead() -> Rule {
    Rule::Keeps(Statistic::T, Bound::AtLeast(LEAD))
}

/// The forager among barriers.
fn barriers(trials: &[Trial]) -> Vec<Claim> {
    let place = Place::Barriers;
    let rival = last(trials, place, best(trials, place, &SARSA));
    let over = |name: &str, who: &str, rule: Rule| {
        claim(place, name, "ratio")
            .rule(rule)
            .note(
                "captures in 3000 actions after 20,000 of training, over those of Sarsa(λ) on percepts \
                 or on two or four steps of history, whichever has the best mean",
            )
            .judge_ratio(&last(trials, place, who), &rival)
    };
    vec![
        over("over_sarsa", "mind", share(1.5)),
        over("level2.over_sarsa", "level2", Rule::Measured),
    ]
}

/// A world of a file.
fn of_file(place: Place, trials: &[Trial]) -> Vec<Claim> {
    let planner = last(trials, place, "planner");
    let memoryless = last(trials, place, best(trials, place, &MEMORYLESS));
    let history = last(trials, place, best(trials, place, &HISTORY));
    let rule = match place {
        Place::TMaze16 | Place::Hallway => Rule::Measured,
        _ => share(0.9),
    };
    let mut claims = Vec::new();
    for (prefix, who) in [("", "mind"), ("level2.", "level2")] {
        let earned = last(trials, place, who);
        let rule = if who == "mind" {
            rule.clone()
        } else {
            Rule::Measured
        };
        claims.push(
            claim(
                place,
                &format!("{prefix}share_of_optimum"),
                "share of the planner",
            )
            .rule(rule)
            .note(
                "reward an action in 5000 after 50,000 of training, over that of a planner who \
                     knows the world but not the state",
            )
            .judge_ratio(&earned, &planner),
        );
        claims.push(
            claim(
                place,
                &format!("{prefix}over_memoryless"),
                "reward an action",
            )
            .rule(lead())
            .note("less that of Q or Sarsa(λ) on percepts, whichever has the best mean")
            .judge_difference(&earned, &memoryless),
        );
        claims.push(
            claim(place, &format!("{prefix}over_history"), "reward an action")
                .note(
                    "less that of Q or Sarsa(λ) on two or four steps of history, whichever has the \
                     best mean",
                )
                .judge_difference(&earned, &history),
        );
    }
    let told = |of: fn(&Constructed) -> f64| -> Vec<f64> {
        let one = |trial: &Trial| trial.constructed.get(place.name()).map_or(f64::NAN, of);
        trials.iter().map(one).collect()
    };
    claims.push(
        claim(place, "constructed", "bits")
            .note(
                "mutual information of the state and the synthetic item of both levels that is on, given \
                 the percept, less what is counted by chance",
            )
            .judge(&told(|it| it.told)),
    );
    claims.push(
        claim(place, "hidden", "bits")
            .note("entropy of the state given the percept, in the same 10,000 actions")
            .judge(&told(|it| it.hidden)),
    );
    claims
}
