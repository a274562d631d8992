//! One seed of the experiment: all parts that are asked for, one after another.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::forager::pioneer::VOCABULARY;

use super::measured::Trial;
use super::options::{OneOptions, Part};
use super::pioneer::Raised;
use super::{damages, pioneer, worlds};
use crate::failure::Failure;
use crate::learner::Learner;
use crate::progress::Ticker;

/// Runs one seed.
///
/// # Errors
/// [`Failure`] when a world cannot be built or a learner cannot go on.
pub(super) fn run(options: &OneOptions, seed: u64, ticker: &Ticker) -> Result<Trial, Failure> {
    let mut trial = Trial {
        seed,
        ..Trial::default()
    };
    let raised = if options.parts.iter().any(|it| it.begins_with_the_forager()) {
        let raised = Raised::new(options, 0.0, seed)?;
        trial.note("forager.20000", raised.captures);
        trial.note("forager.bumps", raised.bumps);
        let names = VOCABULARY.names();
        ticker.keep(&format!("one-{seed}-forager"), || {
            raised.trained.image(names)
        })?;
        Some(raised)
    } else {
        None
    };
    for part in &options.parts {
        match (part, &raised) {
            (Part::Recover, Some(raised)) => damages::lives(options, raised, seed, &mut trial)?,
            (Part::Unknown, Some(raised)) => pioneer::unknown(options, raised, seed, &mut trial)?,
            (Part::Forager, _) => pioneer::lengths(options, seed, &mut trial)?,
            (Part::Distractors, _) => pioneer::distractors(options, seed, &mut trial)?,
            (Part::Harm, _) => pioneer::harm(options, seed, &mut trial)?,
            (Part::Teach, _) => pioneer::teach(options, seed, &mut trial)?,
            (Part::Generated, _) => worlds::generated(options, seed, &mut trial)?,
            (Part::Lake, _) => worlds::lake(options, seed, ticker, &mut trial)?,
            (Part::Shuttle, _) => worlds::shuttle(options, seed, ticker, &mut trial)?,
            (Part::Vacuum, _) => worlds::vacuum(options, seed, ticker, &mut trial)?,
            (Part::Keys, _) => worlds::keys(options, seed, ticker, &mut trial)?,
            (Part::Recover | Part::Unknown, None) => {}
        }
        ticker.advance(1);
    }
    Ok(trial)
}
