//! Damage and recovery: a robot whose camera was knocked, and what it makes of it (book, 6.3, 7.1.1).
//!
//! `life` is the protocol, `trial` one seed of it for everybody who takes part, `claims` what is
//! concluded, `figures` what is drawn, `page` one robot's life to watch.

mod claims;
mod figures;
pub mod life;
mod options;
mod page;
pub mod trial;

use crate::device::meter::Load;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::report::Results;
pub use options::RecoverOptions;

/// Runs all seeds, judges the claims, draws the figures and writes the page of the first seed.
///
/// # Errors
/// [`Failure`] when a world cannot be built or damaged so, or a figure cannot be drawn.
pub fn run(options: &RecoverOptions, progress: &Progress) -> Result<Results, Failure> {
    let job = |&seed: &u64, ticker: &_| trial::run(options, seed, ticker);
    let trials = progress
        .over("recovering", &options.seeds, trial::work(options), job)
        .into_iter()
        .collect::<Result<Vec<_>, _>>()?;
    let mut results = Results::new(claims::summary(options, &trials));
    results.worst_ticks = Load::of(trials.iter().map(|trial| &trial.load)).by_processor();
    for (name, picture) in figures::all(options, &trials)? {
        results = results.picture(&name, picture);
    }
    if let (Some(&seed), Some(&damage)) = (options.seeds.first(), options.damages.first()) {
        let page = page::page(options, damage, seed)?;
        results = results.file("track.html", page.into_bytes());
    }
    Ok(results)
}
