//! What is concluded from the trials: claims, tables and figures of the foraging experiment.

use cla_core::forager::pioneer;

use super::bench::Captures;
use super::level2_claims;
use super::options::{BOOK_SCHEMAS, ForageOptions, SNAPSHOT};
use super::trial::{Found, Trial, of};
use crate::failure::Failure;
use crate::report::figure::{Axes, Line, Point, histogram, line_chart};
use crate::report::{
    Bound, Claim, Expectation, Results, Rule, Summary, Table, Verdict, mean, sample_sd, welch_t,
};

/// Schemas listed for the first seed.
const LISTED: usize = 16;
/// Trials that make a schema worth listing.
const PROVEN: u32 = 50;

pub(super) fn results(options: &ForageOptions, trials: &[Trial]) -> Result<Results, Failure> {
    let mut summary = Summary::new("forage", &options.seeds);
    parameters(&mut summary, options);
    summary.claims = claims(trials);
    if options.is_varied() {
        // Numbers of another world or another length say nothing of the book's.
        summary
            .claims
            .iter_mut()
            .for_each(|claim| claim.verdict = Verdict::Extension);
    }
    summary.table("1 captures in a test", captures_table(trials));
    summary.table("2 most reliable schemas, first seed", schemas_table(trials));
    summary.table("3 the brain", brain_table(trials));
    Ok(Results::new(summary)
        .picture("learning-curve", learning_curve(options, trials)?)
        .picture("reliability-histogram", reliability_histogram(trials)?))
}

/// The last test of a seed: what training has come to.
fn last(trial: &Trial) -> Captures {
    trial.snapshots.last().copied().unwrap_or_default()
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    let captures = "captures in 3000 actions";
    let replaced = of(trials, |t| f64::from(last(t).replaced));
    let sector = of(trials, |t| f64::from(t.sector.replaced));
    let welch = welch_t(&replaced, &sector);
    let ahead = mean(&replaced) >= 1.15 * mean(&sector);
    let mut all = vec![
        Expectation::new("forage.ingrip_by_10000", "6.2.6", "share of seeds")
            .book(1.0)
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .judge_share(
                &trials
                    .iter()
                    .map(|t| t.first_ingrip.is_some())
                    .collect::<Vec<_>>(),
            ),
        Expectation::new("forage.first_ingrip", "6.2.6", "actions of training")
            .book(2250.0)
            .rule(Rule::mean(Bound::Between(1500.0, 3000.0)))
            .note("the book says 1500 to 3000; we look every 250 actions, so 250 means at most")
            .judge(&of(trials, |t| t.first_ingrip.map_or(f64::NAN, f64::from))),
        Expectation::new("forage.captures.level1", "6.2.5", captures)
            .extension()
            .rule(Rule::Judged {
                text: format!(
                    "mean >= 1.15 x forage.baseline.sector (Welch t = {:.2}, p = {:.1e})",
                    welch.t, welch.p
                ),
                met: ahead,
            })
            .note("specimens reappear elsewhere, so the score does not saturate")
            .judge(&replaced),
        Expectation::new("forage.level1_over_sector", "6.2.5", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(1.15)))
            .judge_ratio(&replaced, &sector),
        Expectation::new("forage.captures.level1_removed", "6.2.5", "captures of 28")
            .book((20.4, 1.53, 10))
            .rule(Rule::mean(Bound::AtLeast(20.4)))
            .exceeded(Rule::mean(Bound::AtLeast(27.0)))
            .judge(&of(trials, |t| f64::from(last(t).removed))),
        Expectation::new("forage.captures.lexicographic", "6.2.3", "captures of 28")
            .book((20.4, 1.53, 10))
            .rule(Rule::mean(Bound::AtLeast(20.4)))
            .note("our learner with the book's choice rule and values, in training and in the test")
            .judge(&of(trials, |t| f64::from(t.lexicographic.removed))),
        Expectation::new("forage.captures.book", "6.2.5", "captures of 28")
            .book((20.4, 1.53, 10))
            .rule(Rule::mean(Bound::AtLeast(20.4)))
            .note("everything as the book says: schedules, harvest, choice; no recruitment")
            .judge(&of(trials, |t| f64::from(t.book.removed))),
        Expectation::new("forage.captures.lexicographic_replaced", "6.2.3", captures)
            .extension()
            .judge(&of(trials, |t| f64::from(t.lexicographic.replaced))),
        Expectation::new("forage.captures.level1_noise_free", "6.2.5", captures)
            .extension()
            .note("trained and tested without drop-out, step and turn noise")
            .judge(&of(trials, |t| f64::from(t.noise_free.replaced))),
        Expectation::new(
            "forage.captures.level1_noise_free_removed",
            "6.2.5",
            "captures of 28",
        )
        .extension()
        .judge(&of(trials, |t| f64::from(t.noise_free.removed))),
        Expectation::new(
            "forage.mean_reliability.level1",
            "6.2.6",
            "mean reliability",
        )
        .book((0.405, 0.010, 10))
        .rule(Rule::mean(Bound::Between(0.305, 0.505)))
        .note(
            "ours keeps the rare alternatives as schemas of their own, each with a small \
                 share of its context's trials; the book's maps average them away",
        )
        .judge(&of(trials, |t| t.mean_reliability)),
    ];
    all.extend(level2_claims::second_level(trials));
    all.extend(baselines(trials));
    for (index, book) in [8.574, 9.025, 9.5, 9.025, 8.574].into_iter().enumerate() {
        all.push(
            Expectation::new(
                format!("forage.table_6_3.s{}", index + 1),
                "6.2.6",
                "deferred value",
            )
            .book((book, 0.0, 10))
            .rule(Rule::median(Bound::Between(book - 0.001, book + 0.001)))
            .judge(&of(trials, |t| t.deferred[index])),
        );
    }
    for (index, (number, text, printed)) in BOOK_SCHEMAS.iter().enumerate() {
        let record = |t: &Trial| t.records.get(index).copied().unwrap_or_default();
        all.push(
            Expectation::new(
                format!("forage.generated.{number}"),
                "6.2.6",
                "share of seeds",
            )
            .book(1.0)
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .note(*text)
            .judge_share(
                &trials
                    .iter()
                    .map(|t| record(t).schemas > 0)
                    .collect::<Vec<_>>(),
            ),
        );
        if let Some((book, sd)) = *printed {
            all.push(
                Expectation::new(
                    format!("forage.reliability.{number}"),
                    "6.2.6",
                    "reliability",
                )
                .book((book, sd, 10))
                .rule(Rule::mean(Bound::Between(
                    (book * 0.5 * 1000.0).round() / 1000.0,
                    (book * 1.5 * 1000.0).round() / 1000.0,
                )))
                .note(*text)
                .judge(&of(trials, |t| record(t).reliability().unwrap_or(f64::NAN))),
            );
        }
    }
    all
}

fn baselines(trials: &[Trial]) -> Vec<Claim> {
    type Score = fn(&Trial) -> Captures;
    let rivals: [(&str, Score, &str); 4] = [
        ("random", |t| t.random, "uniform over the six actions"),
        (
            "sector",
            |t| t.sector,
            "the servo of the Stage runs: every sector that holds a blob",
        ),
        (
            "sector_nearest",
            |t| t.sector_nearest,
            "the same servo on the learner's percept",
        ),
        (
            "sector_noise_free",
            |t| t.noise_free_sector,
            "the Stage servo without noise",
        ),
    ];
    let mut all = Vec::new();
    for (name, score, note) in rivals {
        all.push(
            Expectation::new(
                format!("forage.baseline.{name}"),
                "–",
                "captures in 3000 actions",
            )
            .extension()
            .note(note)
            .judge(&of(trials, |t| f64::from(score(t).replaced))),
        );
        all.push(
            Expectation::new(
                format!("forage.baseline.{name}_removed"),
                "–",
                "captures of 28",
            )
            .extension()
            .note(note)
            .judge(&of(trials, |t| f64::from(score(t).removed))),
        );
    }
    all
}

fn captures_table(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["controller", "replaced", "sd", "of 28", "sd "]);
    let mut row = |name: &str, score: &dyn Fn(&Trial) -> Captures| {
        let replaced = of(trials, |t| f64::from(score(t).replaced));
        let removed = of(trials, |t| f64::from(score(t).removed));
        let cells = [
            mean(&replaced),
            sample_sd(&replaced),
            mean(&removed),
            sample_sd(&removed),
        ];
        let mut line = vec![name.into()];
        line.extend(cells.map(serde_json::Value::from));
        table.row(line);
    };
    row("CLA, level 1 (ours)", &last);
    row("CLA, level 1, 20,000 actions", &|t| t.second.level1);
    row("CLA, levels 1 and 2, 20,000 actions", &|t| t.second.level2);
    row("CLA, levels 1 and 2 without habits", &|t| t.apart.level2);
    row("CLA, level 1 with habits", &|t| t.apart.habits);
    row("CLA, level 2 from SOMs, 20,000 actions", &|t| {
        t.harvested.counters
    });
    row("CLA, level 2 from SOMs, read with the cut", &|t| {
        t.harvested.cut
    });
    row("CLA, ours with the book's choice rule", &|t| {
        t.lexicographic
    });
    row("CLA, all as the book says", &|t| t.book);
    row("servo `sector` (Stage)", &|t| t.sector);
    row("servo `sector`, learner's percept", &|t| t.sector_nearest);
    row("random", &|t| t.random);
    row("CLA, level 1, noise-free world", &|t| t.noise_free);
    row("servo `sector`, noise-free world", &|t| t.noise_free_sector);
    row("CLA, level 1, noise-free, 20,000", &|t| {
        t.second_noise_free.level1
    });
    row("CLA, levels 1 and 2, noise-free, 20,000", &|t| {
        t.second_noise_free.level2
    });
    row("CLA, level 1, room of 12 m, 20,000", &|t| {
        t.second_large.level1
    });
    row("CLA, levels 1 and 2, room of 12 m, 20,000", &|t| {
        t.second_large.level2
    });
    table.row([
        "the book's level 1 (6.2.5)".into(),
        serde_json::Value::Null,
        serde_json::Value::Null,
        20.4.into(),
        1.53.into(),
    ]);
    table
}

fn schemas_table(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["schema", "reliability", "trials"]);
    let says_something = |found: &&Found| found.activations >= PROVEN && !found.text.ends_with('/');
    let proven = trials
        .iter()
        .take(1)
        .flat_map(|t| t.found.iter().filter(says_something));
    let mut proven: Vec<&Found> = proven.collect();
    proven.sort_by(|a, b| b.reliability.total_cmp(&a.reliability));
    for found in proven.into_iter().take(LISTED) {
        table.row([
            found.text.clone().into(),
            found.reliability.into(),
            found.activations.into(),
        ]);
    }
    table
}

fn brain_table(trials: &[Trial]) -> Table {
    let mut table = Table::new(&["what", "how much"]);
    table.row(["bytes of RAM, all static".into(), pioneer::RAM.into()]);
    table.row([
        "synthetic items, mean".into(),
        mean(&of(trials, |t| t.insight.items)).into(),
    ]);
    table.row([
        "counters of beliefs, mean".into(),
        mean(&of(trials, |t| t.insight.beliefs)).into(),
    ]);
    let schemas = of(trials, |t| t.reliabilities.len() as f64);
    table.row(["schemas, mean over the seeds".into(), mean(&schemas).into()]);
    let training = of(trials, |t| f64::from(t.training_captures));
    table.row(["captures while training".into(), mean(&training).into()]);
    table
}

fn parameters(summary: &mut Summary, options: &ForageOptions) {
    let world = &options.world.config;
    summary.parameter("radius", world.radius);
    summary.parameter("specimens", world.specimens);
    let layout = if options.world.layout.is_some() {
        "file"
    } else {
        "random"
    };
    summary.parameter("layout", layout);
    summary.parameter("forward", world.forward);
    summary.parameter("backward", world.backward);
    summary.parameter("drop_out", world.drop_out);
    summary.parameter("step_noise", world.step_noise);
    summary.parameter("turn_noise", world.turn_noise);
    summary.parameter("actions", options.actions);
    summary.parameter("test_actions", options.test_actions);
    summary.parameter("brain", format!("{:?}", options.brain));
}

fn learning_curve(
    options: &ForageOptions,
    trials: &[Trial],
) -> Result<crate::report::figure::Picture, Failure> {
    let points = |score: &dyn Fn(&Captures) -> u32| -> Vec<Point> {
        (0..=options.actions / SNAPSHOT)
            .map(|snapshot| {
                let seeds: Vec<f64> = trials
                    .iter()
                    .filter_map(|t| t.snapshots.get(snapshot as usize))
                    .map(|captures| f64::from(score(captures)))
                    .collect();
                Point::mean_of(f64::from(snapshot * SNAPSHOT), &seeds)
            })
            .collect()
    };
    // What does not learn is as good at the end as at the beginning.
    let level = |name: &str, score: fn(&Trial) -> Captures| {
        let seeds = of(trials, |t| f64::from(score(t).replaced));
        let ends = [0.0, f64::from(options.actions)];
        Line::new(name, ends.map(|x| Point::mean_of(x, &seeds)).to_vec())
    };
    let lines = [
        Line::new("CLA, level 1", points(&|c| c.replaced)),
        level("servo, learner's percept", |t| t.sector_nearest),
        level("servo of the Stage runs", |t| t.sector),
        level("random", |t| t.random),
    ];
    let axes = Axes::new(
        "Foraging: what the knowledge of each moment is worth",
        "actions of training",
        "captures in 3000 actions",
    );
    Ok(line_chart(&axes, &lines)?)
}

fn reliability_histogram(trials: &[Trial]) -> Result<crate::report::figure::Picture, Failure> {
    let values: Vec<f64> = trials
        .iter()
        .take(1)
        .flat_map(|t| t.reliabilities.clone())
        .collect();
    let axes = Axes::new(
        "Reliability of the level-1 schemas, first seed (Fig 6.6)",
        "successes / activations",
        "schemas",
    );
    Ok(histogram(&axes, &values, 20)?)
}
