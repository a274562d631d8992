//! What is concluded from the lives of the one learner: its claims.
//!
//! Of a ratio the estimate is asked for and an interval whose lower end is no more than .07 below; of
//! captures the same share of what is asked.

use super::damages::{FIRST, ids, name};
use super::family::Damages;
use super::measured::{Trial, of, sums};
use super::options::{OneOptions, Part};
use super::pioneer::SmallMind;
use super::tables;
use super::worlds::{GENERATED_RIVALS, LeanVacuum};
use crate::learner::mind::Brain;
use crate::report::{Bound, Claim, Expectation, Rule, Statistic, Summary, mean};
use crate::world::pioneer::ITEMS;

/// How far the lower end of an interval may lie below what is asked of the estimate.
const BELOW: f64 = 0.07;
/// What the best policy earns in an action of the shuttle.
pub(super) const SHUTTLE_OPTIMUM: f64 = 1.842;

pub(super) fn summary(options: &OneOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("one", &options.seeds);
    let parts = options.parts.iter().map(|part| part.name());
    summary.parameter("parts", parts.collect::<Vec<_>>().join(" "));
    summary.parameter("configuration", format!("{:?}", options.config));
    summary.parameter("lives shorter by", options.shorter);
    for part in &options.parts {
        summary.claims.extend(match part {
            Part::Forager => forager(options, trials),
            Part::Recover => recover(trials),
            Part::Unknown => unknown(trials),
            Part::Distractors => distractors(trials),
            Part::Lake => vec![
                claim("lake", "share of episodes at the goal")
                    .rule(share(0.72))
                    .note("20,000 actions after as many of training; the best possible is about .74")
                    .judge(&of(trials, "lake.20000")),
            ],
            Part::Shuttle => vec![shuttle(trials)],
            Part::Vacuum => vacuum(trials),
            Part::Keys => vec![
                claim("keys", "shortest way over the way taken")
                    .rule(share(0.9))
                    .note("mean of all tries in 10,000 actions after 50,000 of training; a failure is 0")
                    .judge(&of(trials, "keys.50000")),
            ],
            Part::Generated => vec![generated(trials)],
            Part::Harm => harm(trials),
            Part::Teach => vec![
                claim("teach", "ratio")
                    .rule(share(1.0))
                    .note(
                        "captures in 3000 actions after 2000 actions of a servo were watched, over \
                         those after 2000 of one's own",
                    )
                    .judge_ratio(&of(trials, "teach.watched"), &of(trials, "teach.own")),
            ],
        });
    }
    for (name, table) in tables::all(options, trials) {
        summary.table(name, table);
    }
    if options.is_varied() {
        summary.vary();
    }
    summary
}

fn claim(name: &str, unit: &str) -> Expectation {
    Expectation::new(format!("one.{name}"), "–", unit).extension()
}

/// At least so much of a ratio or a share, surely no less than .07 less.
fn share(asked: f64) -> Rule {
    at_least(asked, asked - BELOW)
}

/// At least so many, surely no fewer than .93 of them.
fn captures(asked: f64) -> Rule {
    at_least(asked, asked * (1.0 - BELOW))
}

fn at_least(asked: f64, surely: f64) -> Rule {
    // As one writes it.
    let surely = (surely * 1e6).round() / 1e6;
    Rule::All(vec![
        Rule::mean(Bound::AtLeast(asked)),
        Rule::Keeps(Statistic::Low, Bound::AtLeast(surely)),
    ])
}

fn bytes(name: &str, most: f64, bytes: usize) -> Claim {
    claim(name, "bytes")
        .rule(Rule::mean(Bound::AtMost(most)))
        .judge_count(bytes as f64)
}

fn forager(options: &OneOptions, trials: &[Trial]) -> Vec<Claim> {
    let after = |actions: &str, asked| {
        claim(
            &format!("forager.captures_{actions}"),
            "captures in 3000 actions",
        )
        .rule(captures(asked))
    };
    let mut all = vec![
        claim("forager.captures", "ratio")
            .rule(share(1.05))
            .note("captures in 3000 actions after 20,000 of training over those of both levels")
            .judge_ratio(
                &of(trials, "forager.20000"),
                &of(trials, "forager.both_levels"),
            ),
        claim("forager.captures_20k", "captures in 3000 actions")
            .judge(&of(trials, "forager.20000")),
        after("5k", 250.0).judge(&of(trials, "forager.5000")),
        after("50k", 330.0).judge(&of(trials, "forager.50000")),
        bytes("forager.bytes", 265_000.0, size_of::<Brain<1, 7, 6>>()),
        claim("forager.small", "ratio")
            .rule(share(0.95))
            .note("the same with 1024 samples and 512 states over that with 7168 and 512")
            .judge_ratio(&of(trials, "forager.small"), &of(trials, "forager.20000")),
        bytes("forager.small.bytes", 131_072.0, size_of::<SmallMind>()),
    ];
    if options.long {
        all.push(after("200k", 330.0).judge(&of(trials, "forager.200000")));
        let least: Vec<f64> = trials
            .iter()
            .map(|trial| {
                let blocks = trial.several("forager.blocks").iter();
                let (least, most) = blocks.fold((f64::INFINITY, 0.0_f64), |(low, high), &it| {
                    (low.min(it), high.max(it))
                });
                least / most
            })
            .collect();
        all.push(
            claim("forager.worst_block", "share of the best block")
                .rule(share(0.9))
                .note("blocks of 100,000 actions, to ten million")
                .judge(&least),
        );
    }
    all
}

fn unknown(trials: &[Trial]) -> Vec<Claim> {
    let against = |name: &str, other: &str, note: String| {
        claim(&format!("unknown.{name}"), "ratio")
            .rule(share(0.97))
            .note(note)
            .judge_ratio(
                &of(trials, &format!("unknown.{name}")),
                &of(trials, &format!("{other}.{name}")),
            )
    };
    let mut all: Vec<Claim> = ITEMS
        .iter()
        .map(|item| {
            let note = format!("captures in 3000 actions, {item} unknown over {item} off");
            against(item, "off", note)
        })
        .collect();
    let note = "captures in 3000 actions, a tenth of the readings unknown over the same held";
    all.push(against("tenth", "held", note.to_owned()));
    all
}

fn distractors(trials: &[Trial]) -> Vec<Claim> {
    let among = |more: &str| {
        claim(&format!("distractors.{more}"), "ratio")
            .rule(share(0.95))
            .note(format!(
                "captures in 3000 actions among {more} items that blink, over none"
            ))
            .judge_ratio(
                &of(trials, &format!("distractors.{more}")),
                &of(trials, "forager.20000"),
            )
    };
    vec![among("8"), among("20")]
}

fn shuttle(trials: &[Trial]) -> Claim {
    let shares: Vec<f64> = of(trials, "shuttle.20000")
        .iter()
        .map(|it| it / SHUTTLE_OPTIMUM)
        .collect();
    claim("shuttle", "share of the optimum")
        .rule(share(0.9))
        .note(format!(
            "reward an action in 10,000 after 20,000 of training, over {SHUTTLE_OPTIMUM}"
        ))
        .judge(&shares)
}

fn vacuum(trials: &[Trial]) -> Vec<Claim> {
    let over = |name: &str, train: &str, asked| {
        claim(name, "ratio")
            .rule(share(asked))
            .note(format!(
                "earned in 3000 actions after {train} of training, over a rival written by hand"
            ))
            .judge_ratio(
                &of(trials, &format!("vacuum.{train}")),
                &of(trials, &format!("vacuum.{train}.hand")),
            )
    };
    vec![
        over("vacuum", "20000", 1.1),
        over("vacuum.3k", "3000", 1.0),
        bytes("vacuum.bytes", 200_000.0, size_of::<Brain<1, 15, 5>>()),
        claim("vacuum.lean", "ratio")
            .rule(share(1.1))
            .note("as vacuum, with 128 states in place of 512")
            .judge_ratio(
                &of(trials, "vacuum.20000.lean"),
                &of(trials, "vacuum.20000.hand"),
            ),
        bytes("vacuum.lean.bytes", 200_000.0, size_of::<LeanVacuum>()),
    ]
}

/// The rival with the best mean of all seeds is the one to beat.
fn generated(trials: &[Trial]) -> Claim {
    let mut best = of(trials, GENERATED_RIVALS[0]);
    for rival in GENERATED_RIVALS {
        let other = of(trials, rival);
        if mean(&other) > mean(&best) {
            best = other;
        }
    }
    claim("generated", "ratio")
        .rule(share(1.25))
        .note(
            "share of the optimum in 5000 actions after 20,000 of training, over the best of tabular \
             and linear Sarsa(λ) on percepts and on two steps, which is the one with the best mean",
        )
        .judge_ratio(&of(trials, "generated.mind"), &best)
}

fn harm(trials: &[Trial]) -> Vec<Claim> {
    let fewer = Rule::All(vec![
        Rule::mean(Bound::AtMost(0.1)),
        Rule::Keeps(Statistic::High, Bound::AtMost(0.17)),
    ]);
    vec![
        claim("harm.visits", "ratio")
            .rule(fewer)
            .note("bumps in 3000 actions where one is worth -10, over those where it is worth nothing")
            .judge_ratio(&of(trials, "harm.bumps"), &of(trials, "forager.bumps")),
        claim("harm.captures", "ratio")
            .rule(share(0.95))
            .note("captures of the same lives")
            .judge_ratio(&of(trials, "harm.captures"), &of(trials, "forager.20000")),
    ]
}

/// What is asked of two damages by themselves, in captures.
const ASKED: [(&str, f64); 2] = [("camera", 210.0), ("stuck_s3", 190.0)];

fn recover(trials: &[Trial]) -> Vec<Claim> {
    let ids = ids();
    let first = |id: &str, who: &str| sums(trials, &name(id, who), FIRST);
    let mut claims = Vec::new();
    for id in &ids {
        for (rival, words) in [("sarsa", "Sarsa(λ)"), ("history", "Sarsa(λ) with history")] {
            let suffix = if rival == "sarsa" { "" } else { "_history" };
            claims.push(
                claim(&format!("recover.{id}.over_sarsa{suffix}_3000"), "ratio")
                    .family("one.recover.over_sarsa_3000")
                    .note(format!(
                        "captures in the first 3000 damaged actions over those of {words}"
                    ))
                    .judge_ratio(&first(id, "mind"), &first(id, rival)),
            );
        }
    }
    for (id, asked) in ASKED {
        claims.push(
            claim(
                &format!("recover.{id}.captures_3000"),
                "captures in 3000 actions",
            )
            .rule(captures(asked))
            .note("the first damaged actions")
            .judge(&first(id, "mind")),
        );
    }
    let of = Damages::new(trials, &ids);
    let none = || Rule::mean(Bound::AtMost(0.0));
    claims.extend([
        claim("recover.family.size", "damages")
            .note("those in which a newborn takes half of an undamaged mind's captures in its last 3000 of 13,000 actions")
            .judge_count(of.size()),
        claim("recover.family.ahead", "share of the family")
            .rule(Rule::mean(Bound::AtLeast(0.8)))
            .note("more captures in the first 3000 damaged actions than each Sarsa(λ), means of all seeds")
            .judge_count(of.ahead()),
        claim("recover.family.behind", "damages of the family")
            .rule(none())
            .note("fewer captures in the first 3000 than one of both Sarsa(λ), p <= .05 after Holm's correction")
            .judge_count(of.behind()),
        claim("recover.not_back", "damages")
            .rule(none())
            .note(
                "a newborn is at .9 of an undamaged mind in the last 3000 of 13,000 actions, the \
                 damaged mind is not",
            )
            .judge_count(of.lost()),
        claim("recover.over_newborn", "damages")
            .rule(none())
            .note(
                "captures so far are, at some thousand, fewer than a newborn's less its first 3000 \
                 actions', means of all seeds",
            )
            .judge_count(of.worse_than_newborn()),
    ]);
    claims
}
