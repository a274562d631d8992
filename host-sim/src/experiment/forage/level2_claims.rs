//! What is concluded about the second level, in both of its forms.

use super::bench::Captures;
use super::level2_schemas::{Finding, PRINTED};
use super::second::Pair;
use super::trial::{Trial, of};
use crate::report::{Better, Bound, Claim, Expectation, Rule, Statistic};

/// In how many of the book's ten runs its level-2 schemas were generated, as a share (6.2.6).
const GENERATED_IN_THE_BOOK: [f64; 5] = [0.8, 1.0, 1.0, 1.0, 0.7];

/// A harvested second level against the first; `least` is the rule's ratio, NaN for none.
fn harvested(
    trials: &[Trial],
    id: &str,
    note: &str,
    (least, above): (f64, fn(&Trial) -> Captures),
    below: fn(&Trial) -> Captures,
) -> Claim {
    let level2 = of(trials, |t| f64::from(above(t).replaced));
    let level1 = of(trials, |t| f64::from(below(t).replaced));
    let expectation = Expectation::new(format!("forage.level2_{id}"), "6.2.5", "ratio")
        .extension()
        .note(note);
    let ruled = if least.is_nan() {
        expectation
    } else {
        expectation.rule(clearly(least))
    };
    ruled.judge_ratio(&level2, &level1)
}

/// So many times as much, and clearly more in pairs.
fn clearly(least: f64) -> Rule {
    let three = Rule::t(Bound::AtLeast(3.0));
    Rule::All(vec![Rule::mean(Bound::AtLeast(least)), three])
}

/// What one part of the second level brings without the other.
fn alone(trials: &[Trial], id: &str, note: &str, part: fn(&Trial) -> Captures) -> Claim {
    let part = of(trials, |t| f64::from(part(t).replaced));
    let level1 = of(trials, |t| f64::from(t.second.level1.replaced));
    Expectation::new(format!("forage.{id}.noisy"), "6.2.5", "ratio")
        .extension()
        .note(note)
        .judge_ratio(&part, &level1)
}

/// The second level against the first after the same 20,000 actions.
pub(super) fn second_level(trials: &[Trial]) -> Vec<Claim> {
    let captures = "captures in 3000 actions";
    let level1 = of(trials, |t| f64::from(t.second.level1.replaced));
    let level2 = of(trials, |t| f64::from(t.second.level2.replaced));
    let versus = |id: &str, least: f64, note: &str, pair: fn(&Trial) -> Pair| {
        let level1 = of(trials, |t| f64::from(pair(t).level1.replaced));
        let level2 = of(trials, |t| f64::from(pair(t).level2.replaced));
        Expectation::new(format!("forage.level2_over_level1.{id}"), "6.2.5", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(least)))
            .note(note)
            .judge_ratio(&level2, &level1)
    };
    let score = |id: &str, unit: &str, note: &str, score: fn(&Trial) -> u32| {
        Expectation::new(format!("forage.captures.{id}"), "6.2.5", unit)
            .extension()
            .note(note)
            .judge(&of(trials, |t| f64::from(score(t))))
    };
    let mut all = vec![
        score(
            "level2",
            captures,
            "10,000 actions of level 1, then 10,000 with both levels and habits",
            |t| t.second.level2.replaced,
        ),
        score(
            "level1_20000",
            captures,
            "level 1 alone, trained as long as level 2",
            |t| t.second.level1.replaced,
        ),
        Expectation::new("forage.captures.level2_removed@2", "6.2.5", "captures of 28")
            .book((22.9, 1.19, 10))
            .rule(Rule::Book(Better::Higher))
            .judge(&of(trials, |t| f64::from(t.second.level2.removed))),
        Expectation::new("forage.level2_over_level1.noisy@2", "6.2.5", "ratio")
            .extension()
            .rule(Rule::All(vec![
                Rule::mean(Bound::AtLeast(1.12)),
                Rule::t(Bound::AtLeast(3.0)),
                Rule::Keeps(Statistic::Ahead, Bound::AtLeast(0.8)),
            ]))
            .note("level 1 had the same 20,000 actions, explored as suits it best")
            .judge_ratio(&level2, &level1),
        alone(
            trials,
            "level2_without_habits_over_level1",
            "beliefs alone, no habits",
            |t| t.apart.level2,
        ),
        alone(
            trials,
            "level1_with_habits_over_level1",
            "habits alone: of items, there is no schema that has just succeeded",
            |t| t.apart.habits,
        ),
        versus("clean", 0.97, "no drop-out, no noise of steps and turns", |t| {
            t.second_noise_free
        }),
        harvested(
            trials,
            "som_over_level1.noisy@2",
            "level 2 harvested from Action SOMs whose nodes count",
            (1.10, |t| t.harvested.counters),
            |t| t.second.level1,
        ),
        harvested(
            trials,
            "som_cut_over_level1.noisy",
            "the same maps read with the book's cut: items on in nine of ten cases",
            (f64::NAN, |t| t.harvested.cut),
            |t| t.second.level1,
        ),
        harvested(
            trials,
            "som_over_level1.R12@2",
            "level 2 harvested from Action SOMs, a room of 12 m",
            (1.3, |t| t.harvested.large),
            |t| t.second_large.level1,
        ),
        versus("R12", 1.4, "a room of 12 m", |t| t.second_large),
        Expectation::new("forage.level2_over_sector", "6.2.5", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(1.3)))
            .judge_ratio(&level2, &of(trials, |t| f64::from(t.sector.replaced))),
        Expectation::new("forage.reliability.level1@2", "6.2.6", "mean reliability")
            .book((0.405, 0.010, 10))
            .rule(Rule::Book(Better::Neither))
            .note("as forage.mean_reliability.level1")
            .judge(&of(trials, |t| t.mean_reliability)),
        Expectation::new(
            "forage.reliability.level2_prospective",
            "6.2.6",
            "share of predictions that came true",
        )
        .extension()
        .note("what was believed most after the last schema, compared with what came")
        .judge(&of(trials, |t| t.insight.prospective)),
        Expectation::new("forage.reliability.level2_book@2", "6.2.6", "mean reliability")
            .book((0.721, 0.074, 10))
            .rule(Rule::Book(Better::Neither))
            .note(
                "labels in hindsight: a schema whose own item is in the context succeeds by \
                 definition, so the number says little; the text prints .886, its t fits .721",
            )
            .judge(&of(trials, |t| t.insight.hindsight)),
        Expectation::new("forage.level2_drop.book", "6.3", "mean reliability lost")
            .book(0.44)
            .rule(Rule::Compared)
            .note(
                "labels in hindsight, before and after 13,000 actions with the camera turned by 12° \
                 in which only reliabilities adapt; .886 - .446 as printed, .275 from .721",
            )
            .judge_difference(
                &of(trials, |t| t.insight.hindsight),
                &of(trials, |t| t.insight.hindsight_damaged),
            ),
    ];
    all.extend(printed_reliabilities(trials));
    for (index, printed) in PRINTED.iter().enumerate() {
        for (name, training, findings) in TRAININGS {
            let generated = |t: &Trial| findings(t)[index].is_generated();
            all.push(
                Expectation::new(
                    format!("forage.generated.{}{name}", printed.number),
                    "6.2.6",
                    "share of seeds",
                )
                .book(GENERATED_IN_THE_BOOK[index])
                .rule(Rule::mean(Bound::AtLeast(0.7)))
                .note(format!("{}; {training}", printed.text))
                .judge_share(&trials.iter().map(generated).collect::<Vec<_>>()),
            );
        }
    }
    all
}

/// A part of a claim's id, how the forager was trained, and what it knows of the schemas.
type Training = (&'static str, &'static str, fn(&Trial) -> &[Finding; 5]);

/// Ours and the book's.
const TRAININGS: [Training; 2] = [
    ("", "nine greedy actions of ten in training", |t| {
        &t.harvested.findings
    }),
    (
        ".exploring",
        "two greedy actions of ten in training, as in the book",
        |t| &t.harvested.exploring,
    ),
];

/// The reliabilities that the book prints of its level-2 schemas (6.2.6).
const PRINTED_RELIABILITIES: [(&str, f64); 3] = [("6_9", 0.314), ("6_13", 0.88), ("6_14", 0.79)];

/// How reliable these schemas are in the book's way, and before the action.
///
/// The book counts in hindsight: of the occasions on which the primitive part succeeded, the share on
/// which the item was on. What can be foreseen is less by how often the primitive part succeeds.
fn printed_reliabilities(trials: &[Trial]) -> Vec<Claim> {
    let mut all = Vec::new();
    for (number, book) in PRINTED_RELIABILITIES {
        let place = PRINTED.iter().position(|it| it.number == number);
        let text = place.and_then(|place| PRINTED.get(place));
        let text = text.map_or("", |it| it.text);
        for (name, training, findings) in TRAININGS {
            let reliability = |of_it: fn(&Finding) -> Option<f64>| {
                of(trials, |t| {
                    let finding = place.and_then(|place| findings(t).get(place));
                    finding.and_then(of_it).unwrap_or(f64::NAN)
                })
            };
            let claim = |name: &str, note: &str| {
                let id = format!("forage.reliability.{number}{name}");
                let note = format!("{text}; {note}; {training}");
                Expectation::new(id, "6.2.6", "reliability").note(note)
            };
            all.push(
                claim(name, "in hindsight")
                    .book(book)
                    .rule(Rule::Compared)
                    .judge(&reliability(Finding::hindsight)),
            );
            all.push(
                claim(&format!("{name}.prospective"), "before the action")
                    .extension()
                    .judge(&reliability(Finding::prospective)),
            );
        }
    }
    all
}
