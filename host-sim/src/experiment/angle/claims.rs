//! The claims of the angle study.

use serde_json::{Value, json};

use super::network::Looking;
use super::options::AngleOptions;
use super::stimulus::{MIDPOINT_CHANNELS, ORIENTATION_CHANNELS};
use super::tables;
use super::trial::{NAMED, Network, Trial, of};
use crate::report::{Bound, Claim, Expectation, Rule, Summary};

/// A response counts as none when it is within this much of the habituated one.
const NULL: f64 = 0.01;

pub(super) fn summary(options: &AngleOptions, trials: &[Trial]) -> Summary {
    let AngleOptions { seeds, config } = options;
    let mut summary = Summary::new("angle", seeds);
    let typed = |value: f32| -> Value { json!(value.to_string().parse::<f64>().unwrap_or(0.0)) };
    summary.parameter("directions in training", config.directions);
    summary.parameter("turn of test A in degrees", typed(config.turn));
    summary.parameter("training trials", config.trials);
    summary.parameter("habituation trials", config.habituation);
    summary.parameter("jitter in degrees", typed(config.jitter));
    summary.parameter(
        "learning rate, first and last",
        json!([typed(config.alpha.0), typed(config.alpha.1)]),
    );
    summary.parameter("last neighbourhood", typed(config.final_neighbourhood));
    summary.parameter(
        "activation width of maps and Top",
        json!(config.activation_width.map(typed)),
    );
    summary.parameter("channels of an orientation", json!(ORIENTATION_CHANNELS));
    summary.parameter("channels of the midpoints", json!(MIDPOINT_CHANNELS));
    for claim in claims(trials) {
        summary.claim(claim);
    }
    summary.table(
        "novelty at the Top, change at Level 1",
        tables::novelty(trials),
    );
    summary
}

fn claims(trials: &[Trial]) -> [Claim; 8] {
    let prefers = |network: Network, preferred: fn(&Looking) -> bool| -> Vec<bool> {
        trials
            .iter()
            .map(|trial| preferred(&network(trial).top))
            .collect()
    };
    let a_over_b: fn(&Looking) -> bool = |looking| looking.rotated > looking.opened;
    let b_over_a: fn(&Looking) -> bool = |looking| looking.opened > looking.rotated;
    let ratio = |claim: Expectation, network: Network| {
        claim.judge_ratio(
            &of(trials, |trial| network(trial).top.opened),
            &of(trials, |trial| network(trial).top.rotated),
        )
    };
    let null: Vec<bool> = trials
        .iter()
        .map(|trial| {
            let looking = trial.orientation_only.top;
            (looking.opened - looking.habituated).abs() < NULL
        })
        .collect();
    let level_1: Vec<bool> = trials
        .iter()
        .map(|trial| trial.old.level_1.rotated > trial.old.level_1.opened)
        .collect();
    let nineteen = || Rule::share(19, 20);
    [
        Expectation::new(
            "angle.young",
            "2.1.2",
            "seeds in which A is more novel than B",
        )
        .rule(nineteen())
        .judge_share(&prefers(NAMED[0].1, a_over_b)),
        Expectation::new(
            "angle.young.ratio",
            "2.1.2",
            "novelty of A over that of B, young",
        )
        .extension()
        .judge_ratio(
            &of(trials, |trial| trial.young.top.rotated),
            &of(trials, |trial| trial.young.top.opened),
        ),
        Expectation::new(
            "angle.trained",
            "2.1.2",
            "seeds in which B is more novel than A",
        )
        .rule(nineteen())
        .judge_share(&prefers(NAMED[1].1, b_over_a)),
        ratio(
            Expectation::new(
                "angle.trained.ratio",
                "2.1.2",
                "novelty of B over that of A, old",
            )
            .extension()
            .rule(Rule::mean(Bound::AtLeast(3.0))),
            NAMED[1].1,
        ),
        Expectation::new(
            "angle.held_out",
            "2.1.2",
            "seeds in which B is more novel than A",
        )
        .extension()
        .rule(nineteen())
        .judge_share(&prefers(NAMED[2].1, b_over_a)),
        ratio(
            Expectation::new(
                "angle.held_out.ratio",
                "2.1.2",
                "novelty of B over that of A, old, A unseen",
            )
            .extension(),
            NAMED[2].1,
        ),
        Expectation::new(
            "angle.level1",
            "2.1.3",
            "seeds in which Level 1 changes more for A than for B",
        )
        .extension()
        .rule(nineteen())
        .note("the maps of an old network still see lines: only the Top layer sees the angle")
        .judge_share(&level_1),
        Expectation::new(
            "angle.control.orientation_only",
            "2.1.2",
            "seeds in which B is as familiar as the habituation stimulus",
        )
        .extension()
        .rule(nineteen())
        .note("without the place of the second line no network can see the angle")
        .judge_share(&null),
    ]
}
