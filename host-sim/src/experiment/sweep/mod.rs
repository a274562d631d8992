//! Lives on a grid of settings and seeds, one line of JSON a finished life, on one machine or in shards
//! on many.
//!
//! A sweep is made of the trials of [`live`](super::live); a shard makes every so-manyth of them.
//! `merge` puts the shards of a sweep together, if they are all there and nothing else is, and judges
//! as one process would have, to the bit.

mod judged;
mod merge;
mod options;

pub use merge::merge;
pub use options::{Axis, Case, Point, Shard, SweepOptions};

use super::live::{Live, Trial};
use super::plan::Experiment;
use super::settled::SETTINGS;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::Results;

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Sweep;

impl Sweep {
    /// The file with a line for every life, in the order of the grid and of the seeds.
    pub const LINES: &'static str = "results.jsonl";
}

impl Experiment for Sweep {
    type Options = SweepOptions;
    type Case = Case;
    type Trial = Trial;

    const NAME: &'static str = "sweep";
    const PHASE: &'static str = "sweeping";

    fn cases(options: &SweepOptions) -> Vec<Case> {
        options.cases()
    }

    fn work(options: &SweepOptions) -> u64 {
        let each = options.points.iter().map(|it| Live::work(&it.live));
        each.max().unwrap_or(1)
    }

    fn trial(options: &SweepOptions, case: &Case, ticker: &Ticker) -> Result<Trial, Failure> {
        let point = options.points.get(case.point as usize);
        let point = point.ok_or_else(|| format!("there is no point {}", case.point))?;
        Live::trial(&point.live, &case.seed, ticker)
    }

    fn judge(options: &SweepOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let cases = options.cases();
        let results = Results::new(judged::summary(options, &cases, trials));
        let results = results.file(SETTINGS, options.file()?);
        if let Some(shard) = options.shard {
            let mut results = results;
            let directory = shard.directory();
            results.remark = Some(format!(
                "shard {shard} is made ({directory}); host-sim merge judges all of them together"
            ));
            return Ok(results);
        }
        let lines = judged::lines(options, &cases, trials)?;
        Ok(results.file(Self::LINES, lines))
    }
}

#[cfg(test)]
#[path = "sweep_tests.rs"]
mod tests;
