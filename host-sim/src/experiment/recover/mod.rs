//! Damage and recovery: a robot whose camera was knocked, and what it makes of it (book, 6.3, 7.1.1).
//!
//! `life` is the protocol, `trial` one seed of it for everybody who takes part, `claims` what is
//! concluded, `figures` what is drawn, `page` one robot's life to watch.

mod claims;
mod figures;
pub mod life;
mod page;
pub mod trial;

use crate::meter::Load;
use crate::options::{Failure, WorldOptions};
use crate::progress::Progress;
use crate::report::Results;
use crate::world::config::PioneerConfig;
use crate::world::damage::Damage;
use life::Protocol;

/// What is varied.
#[derive(Clone, Debug, PartialEq)]
pub struct RecoverOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// The world of all lives.
    pub world: WorldOptions,
    /// What breaks, one after another in lives of their own; at least one.
    pub damages: Vec<Damage>,
    /// How long everything takes.
    pub protocol: Protocol,
}

impl RecoverOptions {
    /// Whether this is another world or length than the one that the claims are about.
    #[must_use]
    pub fn is_varied(&self) -> bool {
        self.world.config != PioneerConfig::NOISY
            || self.world.layout.is_some()
            || self.protocol != Protocol::STANDARD
    }
}

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
