//! Foraging: a Pioneer learns to collect specimens from one valued item (book, 6.2).
//!
//! `trial` is one seed of the experiment, `measure` what a knowledge base says about the book's
//! schemas, `second` the second level on trial, `claims` what is concluded from all seeds.

pub mod bench;
mod claims;
pub mod harvested;
mod level2_claims;
pub mod level2_schemas;
pub mod measure;
mod options;
pub mod second;
pub mod som_level2;
pub mod trial;

use crate::device::meter::Load;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::report::Results;
pub use options::{BOOK_SCHEMAS, BookSchema, ForageOptions, SNAPSHOT};

/// Runs all seeds, judges the claims and draws the figures.
///
/// # Errors
/// [`Failure`] when a world cannot be built for one of the seeds or a figure cannot be drawn.
pub fn run(options: &ForageOptions, progress: &Progress) -> Result<Results, Failure> {
    let job = |&seed: &u64, ticker: &_| trial::run(options, seed, ticker);
    let trials = progress
        .over("foraging", &options.seeds, trial::work(options), job)
        .into_iter()
        .collect::<Result<Vec<_>, _>>()?;
    let mut results = claims::results(options, &trials)?;
    results.worst_ticks = Load::of(trials.iter().map(|trial| &trial.load)).by_processor();
    Ok(results)
}
