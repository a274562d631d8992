//! A run whose trials are noted in a journal as they are finished.
//!
//! What the journal has is not made again; the results are those of an undisturbed run, to the bit.

use std::sync::atomic::{AtomicBool, Ordering};
use std::{fmt, fs};

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::plan::Experiment;
use super::record::{line, read};
use crate::failure::{Failure, Impossible};
use crate::progress::Progress;
use crate::report::{Journal, Results};

/// A finished trial as the journal has it.
#[derive(Serialize, Deserialize)]
struct Entry<C, T> {
    /// Its place among the cases.
    index: usize,
    case: C,
    trial: T,
}

/// Makes the trials that the journal does not have, writes each down when it is finished, and judges
/// all; when interrupted, judges what there is and says so as the parameter [`Journal::UNFINISHED`].
///
/// # Errors
/// [`Failure`] of the first case that could not be tried, of the journal, or of the judgement.
pub fn run_noted<E: Experiment>(
    options: &E::Options,
    progress: &Progress,
    journal: &Journal,
) -> Result<Results, Failure> {
    let cases = E::cases(options);
    let mut trials: Vec<Option<E::Trial>> = cases.iter().map(|_| None).collect();
    for line in journal.begin(&about::<E>(options)?)? {
        let entry: Entry<E::Case, E::Trial> = read(&line)?;
        match (cases.get(entry.index), trials.get_mut(entry.index)) {
            (Some(case), Some(trial)) if *case == entry.case => *trial = Some(entry.trial),
            _ => {
                let sentence = format!("trial {} of the journal is of no case", entry.index);
                return Err(sentence.into());
            }
        }
    }
    let missing: Vec<usize> = (0..cases.len())
        .filter(|&it| trials[it].is_none())
        .collect();
    // One that failed is the end of the run: what the others would find is not waited for.
    let failed = AtomicBool::new(false);
    let made = progress.over(E::PHASE, &missing, E::work(options), |&index, ticker| {
        if failed.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let case = &cases[index];
        let tried = progress.unless_stopped(|| E::trial(options, case, ticker));
        let noted = tried.map(|trial| {
            let case = case.clone();
            let trial = trial?;
            let entry = Entry { index, case, trial };
            journal.append(&line(&entry)?)?;
            Ok(entry.trial)
        });
        match noted.transpose() {
            // Programs that a trial had started may have heard the signal as well.
            Err(_) if progress.stopped().is_some() => Ok(None),
            noted => {
                failed.fetch_or(noted.is_err(), Ordering::Relaxed);
                noted
            }
        }
    });
    for (index, trial) in missing.into_iter().zip(made) {
        let trial: Result<_, Failure> = trial;
        trials[index] = trial?;
    }
    judge_what_there_is::<E>(options, cases, trials)
}

/// What decides a run: one that goes on must say the same.
fn about<E: Experiment>(options: &E::Options) -> Result<Value, Failure> {
    let mut about = build()?;
    about["experiment"] = E::NAME.into();
    about["options"] = serde_json::to_value(options)?;
    Ok(about)
}

/// Which build this is: another may live other lives.
pub(super) fn build() -> Result<Value, Failure> {
    let program = fs::read(std::env::current_exe()?)?;
    let checksum = crc::Crc::<u64>::new(&crc::CRC_64_XZ).checksum(&program);
    Ok(json!({
        "version": env!("CARGO_PKG_VERSION"),
        "checksum of the program": format!("{checksum:016x}"),
    }))
}

fn judge_what_there_is<E: Experiment>(
    options: &E::Options,
    cases: Vec<E::Case>,
    trials: Vec<Option<E::Trial>>,
) -> Result<Results, Failure> {
    let all = cases.len();
    let tried = cases.into_iter().zip(trials);
    let (done, trials): (Vec<_>, Vec<_>) = tried
        .filter_map(|(case, trial)| Some((case, trial?)))
        .unzip();
    if done.len() == all {
        let mut results = E::judge(options, &trials)?;
        results.summary.options = Some(serde_json::to_value(options)?);
        return Ok(results);
    }
    let how_far = format!("{} of {all} trials", done.len());
    let part = E::part(options, &done).filter(|_| !done.is_empty());
    let part = part.ok_or_else(|| format!("interrupted after {how_far}"))?;
    let mut results = E::judge(&part, &trials)?;
    results.summary.options = Some(serde_json::to_value(&part)?);
    results.summary.parameter(Journal::UNFINISHED, how_far);
    Ok(results)
}

/// An experiment with its options, whichever it is.
pub trait Planned: fmt::Debug {
    /// Its name.
    fn name(&self) -> &'static str;

    /// Looks for what it needs before anything runs.
    ///
    /// # Errors
    /// As [`Experiment::look_for_tools`].
    fn look_for_tools(&self) -> Result<(), Impossible>;

    /// Makes the trials that the journal does not have, and judges all.
    ///
    /// # Errors
    /// As [`run_noted`].
    fn run(&self, progress: &Progress, journal: &Journal) -> Result<Results, Failure>;
}

/// The options of an experiment, ready to run.
#[derive(Clone, Debug)]
pub struct Plan<E: Experiment>(
    /// The options.
    pub E::Options,
);

impl<E: Experiment + fmt::Debug> Planned for Plan<E> {
    fn name(&self) -> &'static str {
        E::NAME
    }

    fn look_for_tools(&self) -> Result<(), Impossible> {
        E::look_for_tools()
    }

    fn run(&self, progress: &Progress, journal: &Journal) -> Result<Results, Failure> {
        run_noted::<E>(&self.0, progress, journal)
    }
}
