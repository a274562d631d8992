//! The angle study of Cohen and Younger (1984), with the layers of the causal study (book, 2.1.2).
//!
//! Two line segments are seen as two orientations and the direction from one midpoint to the other;
//! three maps read them and a Top layer reads the maps.
//! Young networks know only the habituation stimulus; old ones have seen angles of 45° before.
//! The response to a test stimulus is its novelty at the Top layer, which stands for looking time.
//! The book describes the infants and the principle and has no such model: all of it is our
//! extension, to show that the layers serve a second domain.

mod claims;
mod network;
mod stimulus;
pub mod trial;

pub use network::{AngleConfig, Looking, Responses};
pub use stimulus::{AngleStimulus, MIDPOINT_CHANNELS, ORIENTATION_CHANNELS};

use crate::progress::Progress;
use crate::report::figure::FigureError;
use crate::report::{Results, Summary};
use trial::{NETWORKS, SeedResult, run_seed};

/// The results of all seeds.
#[derive(Clone, Debug)]
pub struct Study {
    config: AngleConfig,
    results: Vec<SeedResult>,
}

/// Runs the study for each seed, on all cores.
#[must_use]
pub fn run(seeds: &[u64], config: &AngleConfig, progress: &Progress) -> Study {
    let results = progress.over("angles", seeds, NETWORKS, |&seed, ticker| {
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

    /// The summary and the figures.
    ///
    /// # Errors
    /// [`FigureError`] when a figure cannot be drawn.
    pub fn report(&self) -> Result<Results, FigureError> {
        let mut results = Results::new(self.summary());
        for (name, picture) in claims::figures(&self.results)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}
