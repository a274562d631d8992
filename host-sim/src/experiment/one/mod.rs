//! One learner in every world: [`Mind`](cla_core::forest::Mind) with its default configuration.
//!
//! Nothing is set for a world but what a robot's builder knows: its items, its actions, what an item is worth.
//! `pioneer` are lives in the forager's room, `damages` those with a damage in mid-life, `worlds` those
//! elsewhere; `family` is what is concluded from all damages together.
//! The book has no such learner: all of it is our extension.

mod claims;
mod damages;
mod family;
mod figures;
mod options;
mod pioneer;
mod tables;
mod trial;
mod worlds;

pub use measured::Trial;
pub use options::{OneOptions, Part};

use super::measured;
use super::plan::Experiment;
use super::settled::SETTINGS;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct One;

impl Experiment for One {
    type Options = OneOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "one";
    const PHASE: &'static str = "living everywhere";

    fn cases(options: &OneOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &OneOptions, seeds: &[u64]) -> Option<OneOptions> {
        let seeds = seeds.to_vec();
        Some(OneOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(options: &OneOptions) -> u64 {
        options.parts.len() as u64
    }

    fn trial(options: &OneOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        trial::run(options, seed, ticker)
    }

    fn judge(options: &OneOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "one learner",
            &[
                ("captures over both levels", "one.forager.captures"),
                ("vacuum over by hand", "one.vacuum"),
                ("shuttle, share of the optimum", "one.shuttle"),
                ("lake, episodes", "one.lake"),
            ],
        );
        results = results.file(SETTINGS, options.file()?);
        for (name, picture) in figures::all(options, trials, &results.summary.claims)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}

/// What is claimed, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    claims::summary(&OneOptions::standard(Vec::new()), &[]).claims
}

#[cfg(test)]
#[path = "one_tests.rs"]
mod tests;
