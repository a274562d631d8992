//! Infants who find words in a stream of syllables, and rules in sentences (book, 7.3.3).
//!
//! The streams are those of Saffran, Aslin and Newport (1996) and of Aslin, Saffran and Newport (1998),
//! the sentences those of Marcus and others (1999); who listens is a layer with recurrence of
//! `cla-core`, with as many networks as there were infants.
//! Looking time stands for novelty.
//! The book asks whether such layers learn language and has no such model: all of it is our extension.

mod claims;
mod figures;
mod network;
mod options;
mod stimuli;
mod trial;

pub use network::ListenerConfig;
pub use options::WordsOptions;
pub use stimuli::{Grammar, Item, Language, SYLLABLES, TOKENS};
pub use trial::{Looking, Trial};

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The study.
#[derive(Clone, Copy, Debug)]
pub struct Words;

impl Experiment for Words {
    type Options = WordsOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "words";
    const PHASE: &'static str = "listening";

    fn cases(options: &WordsOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &WordsOptions, seeds: &[u64]) -> Option<WordsOptions> {
        let seeds = seeds.to_vec();
        Some(WordsOptions {
            seeds,
            ..options.clone()
        })
    }

    fn trial(options: &WordsOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        let trial = trial::run(&options.config, seed)?;
        ticker.advance(1);
        Ok(trial)
    }

    fn judge(options: &WordsOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "more novel",
            &[
                ("part-words than words", "words.segmentation"),
                ("sentences of the other grammar", "words.rules"),
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
    claims::summary(&WordsOptions::standard(Vec::new()), &[]).claims
}

#[cfg(test)]
#[path = "words_tests.rs"]
mod tests;
