//! The plan that every experiment follows: cases are tried one by one, then all trials are judged.
//!
//! A trial measures and says nothing of what its numbers mean; a judgement reads options and trials
//! and runs nothing.
//! So trials are written down as they are finished, read back (see [`record`](super::record)) and
//! judged another day: a run that was interrupted goes on where it was.

use std::fmt;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::failure::{Failure, Impossible};
use crate::progress::{Progress, Ticker};
use crate::report::Results;

/// An experiment: what is varied, what is measured, what is concluded.
///
/// ```
/// use host_sim::experiment::plan::{Experiment, run};
/// use host_sim::failure::Failure;
/// use host_sim::progress::{Progress, Ticker};
/// use host_sim::report::{Expectation, Results, Summary};
///
/// /// Whether seeds make even numbers.
/// struct Parity;
///
/// impl Experiment for Parity {
///     type Options = Vec<u64>;
///     type Case = u64;
///     type Trial = bool;
///
///     const NAME: &'static str = "parity";
///     const PHASE: &'static str = "looking at numbers";
///
///     fn cases(seeds: &Vec<u64>) -> Vec<u64> {
///         seeds.clone()
///     }
///
///     fn trial(_: &Vec<u64>, seed: &u64, ticker: &Ticker) -> Result<bool, Failure> {
///         ticker.advance(1);
///         Ok(seed % 2 == 0)
///     }
///
///     fn judge(seeds: &Vec<u64>, even: &[bool]) -> Result<Results, Failure> {
///         let mut summary = Summary::new(Self::NAME, seeds);
///         summary.claim(Expectation::new("parity.even", "–", "share of seeds").judge_share(even));
///         Ok(Results::new(summary))
///     }
/// }
///
/// let results = run::<Parity>(&vec![1, 2, 3, 4], &Progress::hidden())?;
/// assert_eq!(results.summary.claims[0].ours.value, Some(0.5));
/// # Ok::<(), Failure>(())
/// ```
pub trait Experiment {
    /// What is varied: everything that decides the results, so that the same options give the same.
    type Options: Clone + fmt::Debug + Serialize + Send + Sync + 'static;
    /// What one trial is made for, mostly a seed.
    type Case: Clone + fmt::Debug + PartialEq + Serialize + DeserializeOwned + Send + Sync;
    /// What one trial measures; see [`record`](super::record) for numbers that are not finite.
    type Trial: Serialize + DeserializeOwned + Send + Sync;

    /// Its name, which is that of its subcommand and of its claims file.
    const NAME: &'static str;
    /// What it is doing while trials are made, for the progress bar.
    const PHASE: &'static str;

    /// The cases, in the order in which [`judge`](Self::judge) gets their trials.
    fn cases(options: &Self::Options) -> Vec<Self::Case>;

    /// Looks for programs of others that trials start; called before anything runs.
    ///
    /// # Errors
    /// [`Impossible`] with the first that is missing.
    fn look_for_tools() -> Result<(), Impossible> {
        Ok(())
    }

    /// The options of which these are all the cases, if some cases can be judged without the others.
    fn part(_: &Self::Options, _: &[Self::Case]) -> Option<Self::Options> {
        None
    }

    /// The work of one trial in the units of its ticker.
    fn work(_: &Self::Options) -> u64 {
        1
    }

    /// Measures one case; all its chance comes from the case.
    ///
    /// # Errors
    /// [`Failure`] when the case cannot be tried to its end.
    fn trial(
        options: &Self::Options,
        case: &Self::Case,
        ticker: &Ticker,
    ) -> Result<Self::Trial, Failure>;

    /// Concludes from the trials of all cases, in their order.
    ///
    /// # Errors
    /// [`Failure`] when a figure cannot be drawn.
    fn judge(options: &Self::Options, trials: &[Self::Trial]) -> Result<Results, Failure>;
}

/// Makes all trials on all cores and judges them.
///
/// # Errors
/// [`Failure`] of the first case that could not be tried, or of the judgement.
pub fn run<E: Experiment>(options: &E::Options, progress: &Progress) -> Result<Results, Failure> {
    E::judge(options, &trials::<E>(options, progress)?)
}

/// Makes all trials on all cores.
///
/// # Errors
/// [`Failure`] of the first case that could not be tried.
pub fn trials<E: Experiment>(
    options: &E::Options,
    progress: &Progress,
) -> Result<Vec<E::Trial>, Failure> {
    let job = |case: &E::Case, ticker: &Ticker| E::trial(options, case, ticker);
    progress
        .over(E::PHASE, &E::cases(options), E::work(options), job)
        .into_iter()
        .collect()
}
