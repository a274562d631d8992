//! Worlds in which places look alike (book, 7.1.5): does what a learner constructs tell them apart?
//!
//! The forager among barriers that only a bump shows, Chrisman's shuttle, McCallum's cheese maze, a
//! corridor with a cue and a later choice, the hallway of Littman and others.
//! Who lives there: the one learner, the book's agent with one and with both levels, Q and Sarsa(λ) on
//! percepts and on two and four steps of history; a planner that knows the world but not its state, and
//! random actions, stand beside them.
//! `places` are the worlds, `who` the learners, `rivals` how those were tuned, `constructed` what the
//! second level's items say of the state.

mod claims;
mod constructed;
mod earned;
mod figures;
mod options;
mod places;
pub mod rivals;
mod tables;
mod trial;
mod who;

pub use constructed::{Constructed, Item};
pub use options::AliasedOptions;
pub use places::Place;
pub use trial::Trial;
pub use who::Book;

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Aliased;

impl Experiment for Aliased {
    type Options = AliasedOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "aliased";
    const PHASE: &'static str = "living where places look alike";

    fn cases(options: &AliasedOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &AliasedOptions, seeds: &[u64]) -> Option<AliasedOptions> {
        let seeds = seeds.to_vec();
        Some(AliasedOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(options: &AliasedOptions) -> u64 {
        options.places.len() as u64
    }

    fn trial(options: &AliasedOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        trial::run(options, seed, ticker)
    }

    fn judge(options: &AliasedOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let mut results = Results::new(claims::summary(options, trials)).headline(
            "share of what a planner earns",
            &[
                ("shuttle", "aliased.shuttle.share_of_optimum"),
                ("cheese maze", "aliased.cheese.share_of_optimum"),
                ("corridor of 2", "aliased.t_maze_2.share_of_optimum"),
                ("of 8", "aliased.t_maze_8.share_of_optimum"),
                ("hallway", "aliased.hallway.share_of_optimum"),
            ],
        );
        for (name, picture) in figures::all(options, trials)? {
            results = results.picture(name, picture);
        }
        Ok(results.file("courses.csv", tables::courses(options, trials)))
    }
}

/// What is claimed, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    claims::summary(&AliasedOptions::standard(Vec::new()), &[]).claims
}

#[cfg(test)]
#[path = "aliased_tests.rs"]
mod tests;
