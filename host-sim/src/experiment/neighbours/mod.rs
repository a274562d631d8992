//! What a schema's neighbours on the map are worth (book, 7.1.4).
//!
//! A robot in an open room knows its places by a map of 64 nodes.
//! Values that are shared with neighbours may speed learning and recovery, and neighbours of a goal that
//! no schema has as its result may be reached in its stead.
//! Each robot has a twin without neighbours; maps have a topology or none.
//! The book asks the question and has no such model: all of it is our extension.

mod claims;
mod figures;
mod options;
mod places;
mod room;
mod strategies;
mod tables;
mod trial;
mod values;

pub use options::{KEPT, NeighboursOptions, TRIALS};
pub use places::Topology;
pub use trial::{Done, OnMap, Trial};
pub use values::Learning;

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The study.
#[derive(Clone, Copy, Debug)]
pub struct Neighbours;

impl Experiment for Neighbours {
    type Options = NeighboursOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "neighbours";
    const PHASE: &'static str = "robots with neighbours";

    fn cases(options: &NeighboursOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &NeighboursOptions, seeds: &[u64]) -> Option<NeighboursOptions> {
        let seeds = seeds.to_vec();
        Some(NeighboursOptions {
            seeds,
            ..options.clone()
        })
    }

    fn trial(options: &NeighboursOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        let trial = trial::run(options, seed)?;
        ticker.advance(1);
        Ok(trial)
    }

    fn judge(options: &NeighboursOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "goals without a schema, reached with neighbours less without",
            &[
                ("map with topology", "neighbours.effect"),
                ("the same nodes shuffled", "neighbours.effect.shuffled"),
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
    let options = NeighboursOptions {
        seeds: Vec::new(),
        settings: KEPT,
        shorter: 1,
    };
    claims::summary(&options, &[]).claims
}

#[cfg(test)]
#[path = "neighbours_tests.rs"]
mod tests;
