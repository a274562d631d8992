//! One seed: an infant in each of the studies.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::network::{Listener, ListenerConfig};
use super::stimuli::{Grammar, Item, Language};
use crate::failure::Failure;

/// How novel test items are: the mean of two of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Looking {
    /// Words, or sentences of the grammar that was heard.
    pub familiar: f64,
    /// Part-words, or sentences of the other grammar.
    pub other: f64,
}

/// What was measured with one seed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The seed.
    pub seed: u64,
    /// After 45 tokens of each word.
    pub words: Looking,
    /// Where part-words came as often as words.
    pub uneven: Looking,
    /// Without having heard anything.
    pub unheard: Looking,
    /// After sentences of one grammar, with syllables that were never heard.
    pub rules: Looking,
    /// The same for a network that hears whether a syllable is one of the last two.
    pub compared: Looking,
}

/// Runs one seed.
///
/// # Errors
/// [`Failure`] when a network cannot be made.
pub(super) fn run(config: &ListenerConfig, seed: u64) -> Result<Trial, Failure> {
    let mut rng = Rng::stream(seed, 1);
    let language = Language::new(&mut rng);
    let (even, uneven) = (language.stream(&mut rng), language.uneven(&mut rng));
    let listening = |stream: &[usize]| {
        let mut listener = Listener::new(config, stream.len().max(1), seed)?;
        listener.hear(stream)?;
        let [first, second] = language.tests();
        looking(&listener, [first[0], second[0]], [first[1], second[1]])
    };
    let compares = ListenerConfig {
        compares: true,
        ..*config
    };
    Ok(Trial {
        seed,
        words: listening(&even)?,
        uneven: listening(&uneven)?,
        unheard: listening(&[])?,
        rules: rules(config, seed)?,
        compared: rules(&compares, seed)?,
    })
}

/// Half of the infants hear the one grammar, half the other.
fn rules(config: &ListenerConfig, seed: u64) -> Result<Looking, Failure> {
    let (heard, other) = if seed.is_multiple_of(2) {
        (Grammar::Aba, Grammar::Abb)
    } else {
        (Grammar::Abb, Grammar::Aba)
    };
    let sentences = heard.familiarization(&mut Rng::stream(seed, 2));
    let mut listener = Listener::new(config, 3 * sentences.len(), seed)?;
    for sentence in &sentences {
        listener.pause();
        listener.hear(sentence)?;
    }
    looking(&listener, heard.tests(), other.tests())
}

fn looking(listener: &Listener, familiar: [Item; 2], other: [Item; 2]) -> Result<Looking, Failure> {
    let novelty = |items: [Item; 2]| -> Result<f64, Failure> {
        Ok(0.5 * (listener.novelty(&items[0])? + listener.novelty(&items[1])?))
    };
    Ok(Looking {
        familiar: novelty(familiar)?,
        other: novelty(other)?,
    })
}
