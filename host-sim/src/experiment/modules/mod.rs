//! Layers made of other modules than the map, and layers that do not mind shifts (book, 7.1.2, 7.1.3).
//!
//! [`Module`] is what a layer may be made of: the map, growing neural gas, k-means, independent
//! components of a batch or in fixed memory.
//! Each kind goes through the causal study, the angle study and an action of the forager with as many
//! units as the map has; each was tried with as many settings.
//! A layer that pools over shifts is tested on launching events at places where there was no training.
//! The book asks for other modules and has none: all of it is our extension.

mod angle;
mod batch;
mod causal;
mod claims;
mod components;
mod figures;
mod gas;
mod hierarchy;
mod invariance;
mod launched;
mod linear;
mod make;
mod map;
mod means;
mod module;
mod online;
mod options;
mod pooled;
mod schemas;
mod tables;
mod trial;

pub use angle::Angles;
pub use causal::Causality;
pub use invariance::{Invariance, Told};
pub use make::{KEPT, TRIALS, made};
pub use module::{FUNCTION, Kind, Module, Plan, Work};
pub use options::ModulesOptions;
pub use schemas::Schemas;
pub use trial::{Measured, Trial};

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The study.
#[derive(Clone, Copy, Debug)]
pub struct Modules;

impl Experiment for Modules {
    type Options = ModulesOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "modules";
    const PHASE: &'static str = "kinds of modules";

    fn cases(options: &ModulesOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &ModulesOptions, seeds: &[u64]) -> Option<ModulesOptions> {
        let seeds = seeds.to_vec();
        Some(ModulesOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(_: &ModulesOptions) -> u64 {
        Kind::ALL.len() as u64
    }

    fn trial(options: &ModulesOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        trial::run(options, seed, || ticker.advance(1))
    }

    fn judge(options: &ModulesOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "told at shifts never trained, pooled less plain",
            &[
                ("map", "modules.invariance.som.untrained"),
                ("k-means", "modules.invariance.k_means.untrained"),
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
    let options = ModulesOptions {
        seeds: Vec::new(),
        settings: KEPT,
        shorter: 1,
    };
    claims::summary(&options, &[]).claims
}

#[cfg(test)]
#[path = "components_tests.rs"]
mod components_tests;
#[cfg(test)]
#[path = "modules_tests.rs"]
mod tests;
