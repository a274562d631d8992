//! Knowledge that survives: what a failing memory, a cut of power, a wire or a long life may not take.
//!
//! A part a file under `parts`, each with what it measures with a seed and what is claimed of that; to
//! add one is to write its file and to name it in `parts/mod.rs`.
//! `lamp` is the small robot whose images are damaged bit by bit.
//! The book has none of this: all of it is our extension.

mod claims;
mod configurations;
mod lamp;
mod options;
mod part;
mod parts;

pub use options::{Case, SurviveOptions};
pub use part::{Part, Scale};

use super::measured::Trial;
use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Survive;

impl Experiment for Survive {
    type Options = SurviveOptions;
    type Case = Case;
    type Trial = Trial;

    const NAME: &'static str = "survive";
    const PHASE: &'static str = "surviving";

    fn cases(options: &SurviveOptions) -> Vec<Case> {
        options.cases()
    }

    fn part(options: &SurviveOptions, cases: &[Case]) -> Option<SurviveOptions> {
        options.of_cases(cases)
    }

    fn trial(options: &SurviveOptions, case: &Case, ticker: &Ticker) -> Result<Trial, Failure> {
        let mut trial = Trial {
            seed: case.seed,
            ..Trial::default()
        };
        let part = options.parts.iter().find(|it| it.name == case.part);
        let part = part.ok_or("the case is of a part that is not run")?;
        (part.measure)(options.shorter, case.seed, &mut trial)?;
        ticker.advance(1);
        Ok(trial)
    }

    fn judge(options: &SurviveOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        Ok(results.headline(
            "damaged images accepted, resumed lives that ended otherwise",
            &[("images", "survive.bit_flip"), ("lives", "survive.resume")],
        ))
    }
}

/// What is claimed, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    claims::summary(&SurviveOptions::standard(Vec::new()), &[]).claims
}

#[cfg(test)]
#[path = "survive_tests.rs"]
mod tests;
