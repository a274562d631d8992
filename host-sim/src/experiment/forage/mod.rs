//! Foraging: a Pioneer learns to collect specimens from one valued item (book, 6.2).
//!
//! `trial` is one seed of the experiment with `bench` for what its parts share, `measure` what a
//! knowledge base says about the book's schemas, `second` and `harvested` the second level on trial
//! in its two forms, `claims` what is concluded from all seeds.

mod approach;
pub mod bench;
mod claims;
mod figures;
pub mod harvested;
mod level2_claims;
pub mod level2_schemas;
pub mod measure;
mod options;
pub mod second;
pub mod som_level2;
mod tables;
mod trial;

pub use approach::Approach;
pub use options::{BOOK_SCHEMAS, BookSchema, ForageOptions, Lengths, SNAPSHOT};
pub use trial::{Found, Trial};

use super::plan::Experiment;
use super::settled::SETTINGS;
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Forage;

impl Experiment for Forage {
    type Options = ForageOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "forage";
    const PHASE: &'static str = "foraging";

    fn cases(options: &ForageOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &ForageOptions, seeds: &[u64]) -> Option<ForageOptions> {
        let seeds = seeds.to_vec();
        Some(ForageOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(options: &ForageOptions) -> u64 {
        trial::work(options)
    }

    fn trial(options: &ForageOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        trial::run(options, seed, ticker)
    }

    fn judge(options: &ForageOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "captures in a test",
            &[
                ("level 1", "forage.captures.level1"),
                ("both levels with habits", "forage.captures.level2"),
                (
                    "servo on the same percept",
                    "forage.baseline.sector_nearest",
                ),
                ("random", "forage.baseline.random"),
            ],
        );
        results = results.file(SETTINGS, options.file()?);
        for (name, picture) in figures::all(options, trials)? {
            results = results.picture(name, picture);
        }
        results.worst_ticks = Load::of(trials.iter().map(|trial| &trial.load)).by_processor();
        Ok(results)
    }
}

/// What is claimed, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    claims::claims(&[])
}
