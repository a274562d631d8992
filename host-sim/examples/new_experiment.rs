//! An experiment of one's own, without touching the library:
//! `cargo run -p host-sim --example new_experiment`.
//!
//! How much does a camera that misses blobs cost a visual servo?
//! Options, trial and judgement are all that there is to write; seeds run on all cores, and trials
//! can be written down and judged another day.

use cla_core::num::Rng;
use host_sim::baseline::sector::Sector;
use host_sim::experiment::plan::Experiment;
use host_sim::experiment::record::judged_again;
use host_sim::failure::Failure;
use host_sim::learner::controller::live;
use host_sim::progress::Ticker;
use host_sim::report::figure::{Axes, Line, Point, line_chart};
use host_sim::report::{Bound, Expectation, Results, Rule, Summary, Table, mean, sample};
use host_sim::world::World;
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::Pioneer;
use serde::{Deserialize, Serialize};

/// What is varied.
#[derive(Clone, Debug, Serialize)]
struct Options {
    seeds: Vec<u64>,
    drop_out: Vec<f64>,
    actions: u32,
}

/// A seed with one share of missed blobs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Case {
    seed: u64,
    drop_out: f64,
}

/// The experiment.
struct Blinking;

impl Experiment for Blinking {
    type Options = Options;
    type Case = Case;
    type Trial = u32;

    const NAME: &'static str = "blinking";
    const PHASE: &'static str = "foraging with a blinking camera";

    /// All seeds of one share, then all of the next.
    fn cases(options: &Options) -> Vec<Case> {
        let of = |&drop_out: &f64| {
            let case = move |&seed: &u64| Case { seed, drop_out };
            options.seeds.iter().map(case)
        };
        options.drop_out.iter().flat_map(of).collect()
    }

    fn trial(options: &Options, case: &Case, ticker: &Ticker) -> Result<u32, Failure> {
        let config = PioneerConfig {
            drop_out: case.drop_out,
            ..PioneerConfig::NOISY
        };
        let mut world = Pioneer::new(config, case.seed)?;
        let (mut servo, mut rng) = (Sector::new(config.forward), Rng::stream(case.seed, 3));
        let captures = live(
            &mut world,
            World::sense,
            &mut servo,
            &mut rng,
            options.actions,
        );
        ticker.advance(1);
        Ok(captures)
    }

    fn judge(options: &Options, trials: &[u32]) -> Result<Results, Failure> {
        let captures: Vec<f64> = trials.iter().map(|&it| f64::from(it)).collect();
        let rows: Vec<&[f64]> = captures.chunks(options.seeds.len()).collect();
        let mut summary = Summary::new(Self::NAME, &options.seeds);
        summary.parameter("actions", options.actions);
        let mut table = Table::new(&["share of blobs missed", "captures"]);
        let mut points = Vec::new();
        for (&drop_out, row) in options.drop_out.iter().zip(&rows) {
            table.row([drop_out.into(), mean(row).into()]);
            points.push(Point::mean_of(drop_out, row));
        }
        if let [clear, .., blind] = rows[..] {
            let claim = Expectation::new("blinking.cost", "–", "ratio")
                .extension()
                .rule(Rule::mean(Bound::AtMost(0.8)))
                .note("captures at the largest share over those at the smallest");
            summary.claim(claim.judge_ratio(blind, clear));
        }
        summary.table("a servo whose camera blinks", table);
        let title = "What a blinking camera costs a servo";
        let caption = format!(
            "{}; band: 95 % interval of the mean",
            sample(&options.seeds)
        );
        let axes = Axes::new(title, "share of blobs missed", "captures").caption(caption);
        let picture = line_chart(&axes, &[Line::new("servo", points)])?;
        Ok(Results::new(summary).picture("blinking", picture))
    }
}

fn main() -> Result<(), Failure> {
    let options = Options {
        seeds: (0..10).collect(),
        drop_out: vec![0.0, 0.3, 0.6, 0.9],
        actions: 1000,
    };
    let results = judged_again::<Blinking>(&options)?;
    println!("{}", results.text());
    let cost = results.summary.find("blinking.cost");
    assert_eq!(cost.and_then(|claim| claim.met), Some(true));
    Ok(())
}
