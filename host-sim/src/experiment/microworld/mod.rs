//! The Microworld experiment (book, chapter 5): what is run, what is claimed.
//!
//! `trial` measures one seed, `claims` judges all of them; `level1`, `goals`, `level2` and
//! `synthetic` are the parts of a life, `catalogue` the book's equations.
//! `pursuit` drives one composite action and shows its steps.

pub mod catalogue;
mod claims;
mod figures;
pub mod goals;
pub mod level1;
pub mod level2;
mod options;
pub mod picture;
mod pursuit;
pub mod synthetic;
mod tables;
pub mod trial;

pub use options::{MicroworldOptions, PursuitOptions};
pub use pursuit::{Pursued, Pursuit};
pub use trial::Trial;

use std::panic::resume_unwind;
use std::thread;

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// Stack of a thread that trains maps: they are built on it before they move to the heap.
const STACK: usize = 32 << 20;

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Chapter5;

impl Experiment for Chapter5 {
    type Options = MicroworldOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "microworld";
    const PHASE: &'static str = "living in the Microworld";

    fn cases(options: &MicroworldOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(_: &MicroworldOptions, seeds: &[u64]) -> Option<MicroworldOptions> {
        let seeds = seeds.to_vec();
        Some(MicroworldOptions { seeds })
    }

    fn work(_: &MicroworldOptions) -> u64 {
        trial::PARTS
    }

    fn trial(_: &MicroworldOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        thread::scope(|scope| {
            let thread = thread::Builder::new().stack_size(STACK);
            let handle = thread.spawn_scoped(scope, || trial::run(seed, ticker))?;
            handle.join().map_err(|panic| resume_unwind(panic))
        })
    }

    fn judge(options: &MicroworldOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "changes of items that are foreseen after 10,000 actions",
            &[
                ("ours, in 62 kB", "micro.recall.simplified"),
                (
                    "Drescher's mechanism, in 2.2 MB",
                    "micro.drescher.recall.10k",
                ),
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
    claims::claims(&[])
}

#[cfg(test)]
#[path = "microworld_tests.rs"]
mod tests;
