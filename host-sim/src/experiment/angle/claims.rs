//! The claims of the angle study, its tables and its figure.

use serde_json::{Value, json};

use super::network::{AngleConfig, Looking, Responses};
use super::stimulus::{MIDPOINT_CHANNELS, ORIENTATION_CHANNELS};
use super::trial::SeedResult;
use crate::report::figure::{Axes, Bar, FigureError, Picture, bar_chart};
use crate::report::{
    Bound, Claim, Expectation, Rule, Summary, Table, cohens_d, mean, sample_sd, welch_t,
};

/// Which level's answers of a network.
type Answers = fn(&Responses) -> &Looking;

/// Which network of a seed.
type Network = fn(&SeedResult) -> &Responses;

const NETWORKS: [(&str, Network); 4] = [
    ("young", |result| &result.young),
    ("old", |result| &result.old),
    ("old, A unseen", |result| &result.held_out),
    ("old, no midpoints", |result| &result.orientation_only),
];

/// A response counts as none when it is within this much of the habituated one.
const NULL: f64 = 0.01;

fn of(results: &[SeedResult], measure: impl Fn(&SeedResult) -> f64) -> Vec<f64> {
    results.iter().map(measure).collect()
}

pub(super) fn summary(config: &AngleConfig, results: &[SeedResult]) -> Summary {
    let seeds: Vec<u64> = results.iter().map(|result| result.seed).collect();
    let mut summary = Summary::new("angle", &seeds);
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
    for claim in claims(results) {
        summary.claim(claim);
    }
    summary.table("novelty at the Top, change at Level 1", table(results));
    summary
}

fn claims(results: &[SeedResult]) -> [Claim; 6] {
    let prefers = |network: Network, preferred: fn(&Looking) -> bool| -> Vec<bool> {
        results
            .iter()
            .map(|result| preferred(&network(result).top))
            .collect()
    };
    let a_over_b: fn(&Looking) -> bool = |looking| looking.rotated > looking.opened;
    let b_over_a: fn(&Looking) -> bool = |looking| looking.opened > looking.rotated;
    let ratio = |claim: Expectation, network: Network| {
        claim.judge_ratio(
            &of(results, |result| network(result).top.opened),
            &of(results, |result| network(result).top.rotated),
        )
    };
    let null: Vec<bool> = results
        .iter()
        .map(|result| {
            let looking = result.orientation_only.top;
            (looking.opened - looking.habituated).abs() < NULL
        })
        .collect();
    let level_1: Vec<bool> = results
        .iter()
        .map(|result| result.old.level_1.rotated > result.old.level_1.opened)
        .collect();
    let nineteen = || Rule::share(19, 20);
    [
        Expectation::new(
            "angle.young",
            "2.1.2",
            "seeds in which A is more novel than B",
        )
        .rule(nineteen())
        .note(compared(results, NETWORKS[0].1))
        .judge_share(&prefers(NETWORKS[0].1, a_over_b)),
        Expectation::new(
            "angle.trained",
            "2.1.2",
            "seeds in which B is more novel than A",
        )
        .rule(nineteen())
        .note(compared(results, NETWORKS[1].1))
        .judge_share(&prefers(NETWORKS[1].1, b_over_a)),
        ratio(
            Expectation::new(
                "angle.trained.ratio",
                "2.1.2",
                "novelty of B over that of A, old",
            )
            .extension()
            .rule(Rule::mean(Bound::AtLeast(3.0))),
            NETWORKS[1].1,
        ),
        Expectation::new(
            "angle.held_out",
            "2.1.2",
            "seeds in which B is more novel than A",
        )
        .extension()
        .rule(nineteen())
        .note(compared(results, NETWORKS[2].1))
        .judge_share(&prefers(NETWORKS[2].1, b_over_a)),
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

fn compared(results: &[SeedResult], network: Network) -> String {
    let a = of(results, |result| network(result).top.rotated);
    let b = of(results, |result| network(result).top.opened);
    let test = welch_t(&a, &b);
    format!(
        "A {:.2} ± {:.2}, B {:.2} ± {:.2}, t({:.1}) = {:.1}, p = {:.1e}, d = {:.1}",
        mean(&a),
        sample_sd(&a),
        mean(&b),
        sample_sd(&b),
        test.freedom,
        test.t,
        test.p,
        cohens_d(&a, &b),
    )
}

fn table(results: &[SeedResult]) -> Table {
    let mut table = Table::new(&["network", "level", "habituated", "A: rotated", "B: opened"]);
    let rounded = |value: f64| json!((value * 1000.0).round() / 1000.0);
    for (name, network) in NETWORKS {
        let levels: [(&str, Answers); 2] = [
            ("Level 1", |responses| &responses.level_1),
            ("Top", |responses| &responses.top),
        ];
        for (level, looking) in levels {
            let mean_of = |stimulus: fn(&Looking) -> f64| {
                rounded(mean(&of(results, |result| {
                    stimulus(looking(network(result)))
                })))
            };
            table.row([
                json!(name),
                json!(level),
                mean_of(|l| l.habituated),
                mean_of(|l| l.rotated),
                mean_of(|l| l.opened),
            ]);
        }
    }
    table
}

/// Which test is more novel to each network, as a power of 2.
pub(super) fn figures(results: &[SeedResult]) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    let bars = NETWORKS.map(|(name, network)| {
        let preference = of(results, |result| {
            let looking = network(result).top;
            (looking.opened / looking.rotated).log2()
        });
        Bar::mean_of(name, &preference)
    });
    let axes = Axes::new(
        "Young networks see lines (below 0), old ones see angles (above 0)",
        "",
        "log2 of novelty, new angle over new lines, mean ± sd",
    );
    Ok(vec![("angle", bar_chart(&axes, &bars)?)])
}
