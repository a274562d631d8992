//! Any learner in any world, damaged in mid-life if one likes, all settings from a file.
//!
//! `place` knows every world by its name and any `.POMDP` file, `inhabitant` every learner; the
//! protocol and the measure of recovery are those of `recover`.
//! The book has one robot in one room: all of this is our extension.

mod claims;
mod figures;
mod inhabitant;
mod options;
mod place;
mod trial;

pub use inhabitant::{Inhabitant, LEARNERS, Settler, full_agent};
pub use options::LiveOptions;
pub use place::{Place, WORLDS};
pub use trial::{Course, Lives, Trial};

use super::plan::Experiment;
use super::settled::SETTINGS;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::Results;

/// The file with what every life obtained in each thousand actions.
const WINDOWS: &str = "windows.csv";

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Live;

impl Experiment for Live {
    type Options = LiveOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "live";
    const PHASE: &'static str = "living";

    fn cases(options: &LiveOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &LiveOptions, seeds: &[u64]) -> Option<LiveOptions> {
        let seeds = seeds.to_vec();
        Some(LiveOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(options: &LiveOptions) -> u64 {
        trial::work(options)
    }

    fn trial(options: &LiveOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        trial::run(options, seed, ticker)
    }

    fn judge(options: &LiveOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let named = options.everybody().map(|who| {
            let id = format!("live.{}.obtained", who.name().replace('-', "_"));
            (who.name(), id)
        });
        let named: Vec<(&str, String)> = named.collect();
        let named: Vec<(&str, &str)> = named.iter().map(|(who, id)| (*who, id.as_str())).collect();
        let what = format!("obtained undamaged in {} actions", options.protocol.after);
        let results = results.headline(&what, &named);
        let results = results.file(WINDOWS, figures::windows(options, trials)?);
        let mut results = results.file(SETTINGS, options.file()?);
        for (name, picture) in figures::all(options, trials)? {
            results = results.picture(&name, picture);
        }
        Ok(results)
    }
}

#[cfg(test)]
#[path = "live_tests.rs"]
mod tests;
