//! What is concluded about the second level, in both of its forms.

use super::bench::Captures;
use super::level2_schemas::{Finding, PRINTED};
use super::second::Pair;
use super::trial::{Trial, of};
use crate::report::{Bound, Claim, Expectation, Rule, mean, welch_t};

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
    let welch = welch_t(&level2, &level1);
    let ratio = mean(&level2) / mean(&level1);
    let expectation = Expectation::new(format!("forage.level2_{id}"), "6.2.5", "ratio")
        .extension()
        .note(format!(
            "{note} (Welch t = {:.2}, p = {:.1e})",
            welch.t, welch.p
        ));
    let ruled = if least.is_nan() {
        expectation
    } else {
        expectation.rule(Rule::Judged {
            text: format!("ratio >= {least} and Welch t >= 3"),
            met: ratio >= least && welch.t >= 3.0,
        })
    };
    ruled.judge_ratio(&level2, &level1)
}

/// What one part of the second level brings without the other.
fn alone(trials: &[Trial], id: &str, note: &str, part: fn(&Trial) -> Captures) -> Claim {
    let part = of(trials, |t| f64::from(part(t).replaced));
    let level1 = of(trials, |t| f64::from(t.second.level1.replaced));
    let welch = welch_t(&part, &level1);
    Expectation::new(format!("forage.{id}.noisy"), "6.2.5", "ratio")
        .extension()
        .note(format!(
            "{note} (Welch t = {:.2}, p = {:.1e})",
            welch.t, welch.p
        ))
        .judge_ratio(&part, &level1)
}

/// The second level against the first after the same 20,000 actions.
pub(super) fn second_level(trials: &[Trial]) -> Vec<Claim> {
    let captures = "captures in 3000 actions";
    let level1 = of(trials, |t| f64::from(t.second.level1.replaced));
    let level2 = of(trials, |t| f64::from(t.second.level2.replaced));
    let welch = welch_t(&level2, &level1);
    let pairs = level2.iter().zip(&level1).filter(|(two, one)| two > one);
    let (better, ratio) = (pairs.count(), mean(&level2) / mean(&level1));
    let versus = |id: &str, least: f64, note: &str, pair: fn(&Trial) -> Pair| {
        let level1 = of(trials, |t| f64::from(pair(t).level1.replaced));
        let level2 = of(trials, |t| f64::from(pair(t).level2.replaced));
        let welch = welch_t(&level2, &level1);
        let note = format!("{note} (Welch t = {:.2}, p = {:.1e})", welch.t, welch.p);
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
        Expectation::new("forage.captures.level2_removed", "6.2.5", "captures of 28")
            .book((22.9, 1.19, 10))
            .rule(Rule::mean(Bound::AtLeast(22.9)))
            .exceeded(Rule::mean(Bound::AtLeast(27.0)))
            .judge(&of(trials, |t| f64::from(t.second.level2.removed))),
        Expectation::new("forage.level2_over_level1.noisy", "6.2.5", "ratio")
            .extension()
            .rule(Rule::Judged {
                text: format!(
                    "ratio >= 1.12 ({ratio:.3}), Welch t >= 3 ({:.2}), better in 16 of 20 pairs ({better})",
                    welch.t
                ),
                met: ratio >= 1.12 && welch.t >= 3.0 && better * 20 >= 16 * trials.len(),
            })
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
            "som_over_level1.noisy",
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
            "som_over_level1.R12",
            "level 2 harvested from Action SOMs, a room of 12 m",
            (1.3, |t| t.harvested.large),
            |t| t.second_large.level1,
        ),
        versus("R12", 1.4, "a room of 12 m", |t| t.second_large),
        Expectation::new("forage.level2_over_sector", "6.2.5", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(1.3)))
            .judge_ratio(&level2, &of(trials, |t| f64::from(t.sector.replaced))),
        Expectation::new("forage.reliability.level1", "6.2.6", "mean reliability")
            .book((0.405, 0.010, 10))
            .rule(Rule::mean(Bound::Between(0.305, 0.505)))
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
        Expectation::new("forage.reliability.level2_book", "6.2.6", "mean reliability")
            .book((0.721, 0.074, 10))
            .rule(Rule::mean(Bound::AtLeast(0.721)))
            .note(
                "labels in hindsight: a schema whose own item is in the context succeeds by \
                 definition, so the number says little; the text prints .886, its t fits .721",
            )
            .judge(&of(trials, |t| t.insight.hindsight)),
    ];
    for (index, printed) in PRINTED.iter().enumerate() {
        type Findings = fn(&Trial) -> &[Finding; 5];
        let trainings: [(&str, &str, Findings); 2] = [
            ("", "nine greedy actions of ten in training", |t| {
                &t.harvested.findings
            }),
            (
                ".exploring",
                "two greedy actions of ten in training, as in the book",
                |t| &t.harvested.exploring,
            ),
        ];
        for (name, training, findings) in trainings {
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
