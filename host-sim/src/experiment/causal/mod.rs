//! Causal perception: a hierarchy learns what a launching is, in stages, and falls back (book, 4).
//!
//! [`run`] trains and tests one network a seed, with its controls, and returns a [`Study`]; the
//! study gives the summary (claims and tables) and the figures.
//! One parameter set, [`CausalConfig::standard`](network::CausalConfig::standard), serves all claims.
//! Nothing here prints or writes files.

mod claims;
mod figures;
pub mod measure;
pub mod network;
pub mod overload;
mod tables;
pub mod trial;

use crate::progress::Progress;
use crate::report::figure::FigureError;
use crate::report::{Results, Summary};
use network::CausalConfig;
use trial::{NETWORKS, SeedResult, run_seed};

/// The results of all seeds.
#[derive(Clone, Debug)]
pub struct Study {
    config: CausalConfig,
    results: Vec<SeedResult>,
}

/// Runs the experiment for each seed, on all cores.
#[must_use]
pub fn run(seeds: &[u64], config: &CausalConfig, progress: &Progress) -> Study {
    let results = progress.over("causal perception", seeds, NETWORKS, |&seed, ticker| {
        run_seed(seed, config, || ticker.advance(1))
    });
    Study {
        config: *config,
        results,
    }
}

impl Study {
    /// What was measured with each seed.
    #[must_use]
    pub fn results(&self) -> &[SeedResult] {
        &self.results
    }

    /// Claims, tables and parameters.
    #[must_use]
    pub fn summary(&self) -> Summary {
        claims::summary(&self.config, &self.results)
    }

    /// The summary and the figures; those of single networks show the first seed.
    ///
    /// # Errors
    /// [`FigureError`] when a figure cannot be drawn.
    pub fn report(&self) -> Result<Results, FigureError> {
        let mut results = Results::new(self.summary());
        for (name, picture) in figures::all(&self.results)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}
