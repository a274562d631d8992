//! Causal perception: a hierarchy learns what a launching is, in stages, and falls back (book, 4).
//!
//! `network` is the hierarchy and its training, `measure` and `overload` are what is read off it,
//! `trial` is one network with its controls, `claims` what is concluded.
//! One parameter set, [`CausalConfig::standard`](network::CausalConfig::standard), serves all claims.

mod claims;
mod figures;
pub mod measure;
pub mod network;
mod options;
pub mod overload;
mod tables;
mod trial;

pub use options::CausalOptions;
pub use trial::Trial;

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Causal;

impl Experiment for Causal {
    type Options = CausalOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "causal";
    const PHASE: &'static str = "causal perception";

    fn cases(options: &CausalOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &CausalOptions, seeds: &[u64]) -> Option<CausalOptions> {
        let seeds = seeds.to_vec();
        Some(CausalOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(_: &CausalOptions) -> u64 {
        trial::NETWORKS
    }

    fn trial(options: &CausalOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        Ok(trial::run(seed, &options.config, || ticker.advance(1)))
    }

    /// Figures of single networks show the first seed.
    fn judge(options: &CausalOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "differences at the Top layer, times that of Delay and Gap",
            &[
                ("Direct and Delay+Gap", "causal.direct_vs_delaygap"),
                ("Direct and Gap", "causal.direct_vs_gap"),
            ],
        );
        for (name, picture) in figures::all(options, trials)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}

/// What is claimed, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    claims::summary(&CausalOptions::standard(Vec::new()), &[]).claims
}
