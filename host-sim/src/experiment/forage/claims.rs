//! What is concluded from the trials: the claims of the foraging experiment.

use super::bench::Captures;
use super::options::{BOOK_SCHEMAS, ForageOptions};
use super::trial::{Trial, last, of};
use super::{level2_claims, tables};
use crate::report::{Better, Bound, Claim, Expectation, Rule, Summary};

pub(super) fn summary(options: &ForageOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("forage", &options.seeds);
    parameters(&mut summary, options);
    summary.claims = claims(trials);
    if options.is_varied() {
        summary.vary();
    }
    summary.table("1 captures in a test", tables::captures(trials));
    summary.table(
        "2 most reliable schemas, first seed",
        tables::schemas(trials),
    );
    summary.table("3 the brain", tables::brain(trials));
    summary
}

pub(super) fn claims(trials: &[Trial]) -> Vec<Claim> {
    let captures = "captures in 3000 actions";
    let replaced = of(trials, |t| f64::from(last(t).replaced));
    let sector = of(trials, |t| f64::from(t.sector.replaced));
    let mut all =
        vec![
        Expectation::new("forage.ingrip_by_10000", "6.2.6", "share of seeds")
            .book(1.0)
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .judge_share(
                &trials
                    .iter()
                    .map(|t| t.first_ingrip.is_some())
                    .collect::<Vec<_>>(),
            ),
        Expectation::new("forage.first_ingrip@2", "6.2.6", "actions of training")
            .rule(Rule::median(Bound::Between(1500.0, 3000.0)))
            .note("the book says 1500 to 3000; we look every 250 actions, so 250 means at most")
            .judge_time(&of(trials, |t| t.first_ingrip.map_or(f64::NAN, f64::from))),
        Expectation::new("forage.captures.level1@2", "6.2.5", captures)
            .extension()
            .note("specimens reappear elsewhere, so the score does not saturate")
            .judge(&replaced),
        Expectation::new("forage.level1_over_sector", "6.2.5", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(1.15)))
            .judge_ratio(&replaced, &sector),
        Expectation::new("forage.captures.level1_removed@2", "6.2.5", "captures of 28")
            .book((20.4, 1.53, 10))
            .rule(Rule::Book(Better::Higher))
            .judge(&of(trials, |t| f64::from(last(t).removed))),
        Expectation::new("forage.captures.lexicographic@2", "6.2.3", "captures of 28")
            .book((20.4, 1.53, 10))
            .rule(Rule::Book(Better::Higher))
            .note("our learner with the book's choice rule and values, in training and in the test")
            .judge(&of(trials, |t| f64::from(t.lexicographic.removed))),
        Expectation::new("forage.captures.book@2", "6.2.5", "captures of 28")
            .book((20.4, 1.53, 10))
            .rule(Rule::Book(Better::Higher))
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
            "forage.mean_reliability.level1@2",
            "6.2.6",
            "mean reliability",
        )
        .book((0.405, 0.010, 10))
        .rule(Rule::Book(Better::Neither))
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
                format!("forage.table_6_3.s{}@2", index + 1),
                "6.2.6",
                "deferred value",
            )
            .book((book, 0.0, 10))
            .rule(Rule::Book(Better::Neither))
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
                    format!("forage.reliability.{number}@2"),
                    "6.2.6",
                    "reliability",
                )
                .book((book, sd, 10))
                .rule(Rule::Book(Better::Neither))
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
