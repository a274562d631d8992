//! The claims of the study of words.
//!
//! An effect is the mean difference over its standard deviation (Cohen's d of pairs), which a t of n
//! infants gives as t / √n.

use serde_json::json;

use super::options::WordsOptions;
use super::stimuli::TOKENS;
use super::trial::{Looking, Trial};
use crate::report::{Bound, Claim, Expectation, Rule, Summary, Table, mean, sample_sd};

/// The infants of 1996 who heard words and part-words: t(23) = 2.4, and the 95 % interval of its d.
const INFANTS: (f64, f64, f64) = (0.49, 0.06, 0.91);

/// A study by its name in claims, and what a seed measured in it.
pub(super) type Study = (&'static str, fn(&Trial) -> Looking);

/// All of them.
pub(super) const STUDIES: [Study; 5] = [
    ("segmentation", |it| it.words),
    ("uneven", |it| it.uneven),
    ("unheard", |it| it.unheard),
    ("rules", |it| it.rules),
    ("compared", |it| it.compared),
];

pub(super) fn summary(options: &WordsOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("words", &options.seeds);
    summary.parameter("words in a stream", TOKENS);
    summary.parameter("configuration", format!("{:?}", options.config));
    for (name, of) in STUDIES {
        summary.claim(difference(name, trials, of));
        if name != "unheard" {
            summary.claim(effect(name, trials, of));
        }
    }
    summary.table("novelty", novelty(trials));
    summary
}

fn sides(trials: &[Trial], of: fn(&Trial) -> Looking) -> (Vec<f64>, Vec<f64>) {
    trials
        .iter()
        .map(|it| (of(it).other, of(it).familiar))
        .unzip()
}

fn difference(name: &str, trials: &[Trial], of: fn(&Trial) -> Looking) -> Claim {
    let (other, familiar) = sides(trials, of);
    let rule = match name {
        "unheard" => Rule::Measured,
        _ => Rule::All(vec![
            Rule::mean(Bound::Above(0.0)),
            Rule::p(Bound::AtMost(0.05)),
        ]),
    };
    let note = match name {
        "segmentation" => {
            "novelty of part-words less that of words, after 45 tokens of each of four words; infants \
             looked 7.60 s and 6.77 s, t(23) = 2.4"
        }
        "uneven" => "the same where the part-words were heard as often as the words",
        "unheard" => "the same for networks that heard nothing",
        "rules" => {
            "novelty of sentences of the other grammar (ABA, ABB) less those of the one that was heard, \
             all of syllables that were not"
        }
        _ => "the same where it is a sensor of its own that a syllable is one of the last two",
    };
    Expectation::new(format!("words.{name}"), "7.3.3", "squared distance")
        .extension()
        .rule(rule)
        .note(note)
        .judge_difference(&other, &familiar)
}

fn effect(name: &str, trials: &[Trial], of: fn(&Trial) -> Looking) -> Claim {
    let (other, familiar) = sides(trials, of);
    let differences: Vec<f64> = other.iter().zip(&familiar).map(|(a, b)| a - b).collect();
    let d = mean(&differences) / sample_sd(&differences);
    let claim = Expectation::new(format!("words.{name}.effect"), "7.3.3", "d of pairs").extension();
    let claim = if name == "segmentation" {
        let (of, low, high) = INFANTS;
        claim
            .beside("Saffran, Aslin and Newport 1996", of)
            .rule(Rule::mean(Bound::Between(low, high)))
            .note("asked: the 95 % interval of the infants' own effect, t(23) = 2.4")
    } else {
        claim
    };
    claim.judge_count(d)
}

fn novelty(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "study",
        "familiar",
        "other",
        "seeds in which other is more novel",
    ]);
    for (name, of) in STUDIES {
        let (other, familiar) = sides(trials, of);
        let more = other.iter().zip(&familiar).filter(|(a, b)| a > b).count();
        table.row([
            json!(name),
            json!(mean(&familiar)),
            json!(mean(&other)),
            json!(more),
        ]);
    }
    table
}
