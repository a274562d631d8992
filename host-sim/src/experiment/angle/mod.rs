//! The angle study of Cohen and Younger (1984), with the layers of the causal study (book, 2.1.2).
//!
//! Two line segments are seen as two orientations and the direction from one midpoint to the other;
//! three maps read them and a Top layer reads the maps.
//! Young networks know only the habituation stimulus; old ones have seen angles of 45° before.
//! The response to a test stimulus is its novelty at the Top layer, which stands for looking time.
//! The book describes the infants and the principle and has no such model: all of it is our
//! extension, to show that the layers serve a second domain.

mod claims;
mod figures;
mod network;
mod options;
mod stimulus;
mod tables;
mod trial;

pub use network::{AngleConfig, Looking, Responses};
pub use options::AngleOptions;
pub use stimulus::{AngleStimulus, MIDPOINT_CHANNELS, ORIENTATION_CHANNELS};
pub use trial::Trial;

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The study.
#[derive(Clone, Copy, Debug)]
pub struct Angle;

impl Experiment for Angle {
    type Options = AngleOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "angle";
    const PHASE: &'static str = "angles";

    fn cases(options: &AngleOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &AngleOptions, seeds: &[u64]) -> Option<AngleOptions> {
        let seeds = seeds.to_vec();
        Some(AngleOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(_: &AngleOptions) -> u64 {
        trial::NETWORKS
    }

    fn trial(options: &AngleOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        Ok(trial::run(seed, &options.config, || ticker.advance(1)))
    }

    fn judge(options: &AngleOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "novelty",
            &[
                ("young, new lines over a new angle", "angle.young.ratio"),
                ("old, a new angle over new lines", "angle.trained.ratio"),
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
    claims::summary(&AngleOptions::standard(Vec::new()), &[]).claims
}
