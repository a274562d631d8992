//! Claims as data: what the book says, when it counts as reproduced, what was measured.
//!
//! An [`Expectation`] is written down before anything runs; judging it with the measurements of the
//! seeds gives a [`Claim`], which is what the summary stores, the tables print and tests read.
//! A seed in which a quantity does not exist (a schema that was never formed) is missing: `null`
//! among the seeds, and not counted in n.

use core::fmt;

use serde::{Deserialize, Serialize};

use super::rule::Rule;
use super::statistics::{mean, median, sample_sd};

/// How a claim of the book came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Verdict {
    /// The rule holds.
    #[serde(rename = "reproduced")]
    Reproduced,
    /// The rule holds, and so does the stricter one for results better than the book's.
    #[serde(rename = "exceeded")]
    Exceeded,
    /// The rule does not hold.
    #[serde(rename = "not reproduced")]
    NotReproduced,
    /// The book gives two statements that cannot both be true.
    #[serde(rename = "contradicts itself")]
    ContradictsItself,
    /// The book says nothing of it.
    #[serde(rename = "extension")]
    Extension,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Reproduced => "reproduced",
            Self::Exceeded => "exceeded",
            Self::NotReproduced => "not reproduced",
            Self::ContradictsItself => "contradicts itself",
            Self::Extension => "extension",
        })
    }
}

/// A number that the book (or another source that a claim is compared with) prints.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Book {
    /// The mean, or the only number given.
    pub mean: f64,
    /// Its standard deviation, where printed.
    pub sd: Option<f64>,
    /// The number of runs behind it, where told.
    pub n: Option<u32>,
}

impl From<f64> for Book {
    fn from(mean: f64) -> Self {
        Self {
            mean,
            sd: None,
            n: None,
        }
    }
}

impl From<(f64, f64, u32)> for Book {
    fn from((mean, sd, n): (f64, f64, u32)) -> Self {
        Self {
            mean,
            sd: Some(sd),
            n: Some(n),
        }
    }
}

/// What we measured, over the seeds in which the quantity exists; `None` when it exists in none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ours {
    /// The mean; of a yes/no finding the share of seeds, of a ratio the ratio of the means.
    pub mean: Option<f64>,
    /// The sample standard deviation of the seeds (of a ratio: of the paired ratios).
    pub sd: Option<f64>,
    /// The median of the seeds.
    pub median: Option<f64>,
    /// The number of seeds in which it exists.
    pub n: u32,
}

/// A statement to be tested, before anything has run.
///
/// ```
/// use host_sim::report::{Bound, Expectation, Rule, Verdict};
/// let claim = Expectation::new("forage.captures.level1", "6.2.5", "captures in 3000 actions")
///     .book((20.4, 1.53, 10))
///     .rule(Rule::mean(Bound::AtLeast(20.4)))
///     .exceeded(Rule::mean(Bound::AtLeast(23.5)))
///     .judge(&[27.0, 28.0, 26.0]);
/// assert_eq!(claim.verdict, Verdict::Exceeded);
/// assert_eq!(claim.ours.mean, Some(27.0));
/// assert_eq!(claim.rule, "mean >= 20.4; exceeded: mean >= 23.5");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    id: String,
    section: String,
    unit: String,
    book: Option<Book>,
    rule: Option<Rule>,
    exceeded: Option<Rule>,
    origin: Origin,
    note: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    Book,
    Contradiction,
    Extension,
}

impl Expectation {
    /// A claim by its id (`experiment.what.variant`), the book's section and the unit of its number.
    #[must_use]
    pub fn new(id: impl Into<String>, section: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            id: id.into(),
            section: section.into(),
            unit: unit.into(),
            book: None,
            rule: None,
            exceeded: None,
            origin: Origin::Book,
            note: None,
        }
    }

    /// The number the book prints: `20.4`, or `(20.4, 1.53, 10)` with its deviation and runs.
    #[must_use]
    pub fn book(mut self, number: impl Into<Book>) -> Self {
        self.book = Some(number.into());
        self
    }

    /// When the claim counts as reproduced.
    #[must_use]
    pub fn rule(mut self, rule: Rule) -> Self {
        self.rule = Some(rule);
        self
    }

    /// When the result is better than the book's; asked only when the rule holds.
    #[must_use]
    pub fn exceeded(mut self, rule: Rule) -> Self {
        self.exceeded = Some(rule);
        self
    }

    /// Marks a finding that the book does not have; its rule says whether our own aim was met.
    #[must_use]
    pub const fn extension(mut self) -> Self {
        self.origin = Origin::Extension;
        self
    }

    /// Marks a statement of the book that contradicts another; the note says which.
    #[must_use]
    pub fn contradicts_itself(mut self, note: impl Into<String>) -> Self {
        self.origin = Origin::Contradiction;
        self.note = Some(note.into());
        self
    }

    /// One sentence beside the numbers: where ours deviates, and why.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.note = Some(note.into());
        self
    }

    /// The claim for these measurements, one a seed; a value that is not finite is missing.
    #[must_use]
    pub fn judge(self, per_seed: &[f64]) -> Claim {
        let measured: Vec<f64> = finite(per_seed);
        let centre = mean(&measured);
        self.claim(per_seed, &measured, centre)
    }

    /// The claim for a yes/no finding: 1 for every seed that says yes.
    #[must_use]
    pub fn judge_share(self, per_seed: &[bool]) -> Claim {
        let numbers: Vec<f64> = per_seed
            .iter()
            .map(|&yes| f64::from(u8::from(yes)))
            .collect();
        self.judge(&numbers)
    }

    /// The claim for a ratio: its mean is the ratio of the means, its seeds the paired ratios.
    ///
    /// A pair with a missing half, or without a partner, is left out of the means.
    /// A pair over 0 counts in the means, but has no ratio of its own.
    #[must_use]
    pub fn judge_ratio(self, numerators: &[f64], denominators: &[f64]) -> Claim {
        let seeds = numerators.len().max(denominators.len());
        let pairs: Vec<(f64, f64)> = (0..seeds)
            .map(|seed| {
                let half = |values: &[f64]| values.get(seed).copied().unwrap_or(f64::NAN);
                (half(numerators), half(denominators))
            })
            .collect();
        let per_seed: Vec<f64> = pairs.iter().map(|(above, below)| above / below).collect();
        let whole: Vec<(f64, f64)> = pairs
            .into_iter()
            .filter(|(above, below)| above.is_finite() && below.is_finite())
            .collect();
        let (above, below): (Vec<f64>, Vec<f64>) = whole.into_iter().unzip();
        let ratio = mean(&above) / mean(&below);
        let measured = finite(&per_seed);
        self.claim(&per_seed, &measured, ratio)
    }

    fn claim(self, per_seed: &[f64], measured: &[f64], centre: f64) -> Claim {
        let met = |rule: &Option<Rule>| {
            rule.as_ref()
                .is_some_and(|rule| rule.is_met(measured, centre))
        };
        let holds = met(&self.rule);
        let verdict = match self.origin {
            Origin::Extension => Verdict::Extension,
            Origin::Contradiction => Verdict::ContradictsItself,
            Origin::Book if holds && met(&self.exceeded) => Verdict::Exceeded,
            Origin::Book if holds => Verdict::Reproduced,
            Origin::Book => Verdict::NotReproduced,
        };
        let mut text = self.rule.as_ref().map(Rule::to_string).unwrap_or_default();
        if let Some(better) = &self.exceeded {
            text.push_str(&format!("; exceeded: {better}"));
        }
        Claim {
            id: self.id,
            section: self.section,
            unit: self.unit,
            book: self.book,
            ours: Ours {
                mean: present(centre),
                sd: present(sample_sd(measured)),
                median: present(median(measured)),
                n: measured.len() as u32,
            },
            per_seed: per_seed.iter().copied().map(present).collect(),
            rule: text,
            met: self.rule.is_some().then_some(holds),
            verdict,
            note: self.note,
        }
    }
}

fn finite(values: &[f64]) -> Vec<f64> {
    values
        .iter()
        .copied()
        .filter(|value| value.is_finite())
        .collect()
}

fn present(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// A judged claim, as it stands in a summary.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// The claim's name: `experiment.what.variant`.
    pub id: String,
    /// The book's section.
    pub section: String,
    /// What the number counts.
    pub unit: String,
    /// The book's number, where it has one.
    pub book: Option<Book>,
    /// What we measured.
    pub ours: Ours,
    /// The measurement of every seed, in the summary's order of seeds; `None` where it is missing.
    pub per_seed: Vec<Option<f64>>,
    /// When the claim counts as reproduced.
    pub rule: String,
    /// Whether the rule holds, where there is one.
    pub met: Option<bool>,
    /// How it came out.
    pub verdict: Verdict,
    /// A sentence beside the numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::{Claim, Expectation, Verdict};
    use crate::report::rule::{Bound, Rule};

    fn expectation() -> Expectation {
        Expectation::new("a.b", "6.1", "captures").rule(Rule::mean(Bound::AtLeast(2.0)))
    }

    #[test]
    fn every_verdict_is_reached_and_written_in_its_words() {
        let better = expectation().exceeded(Rule::mean(Bound::AtLeast(3.0)));
        for (claim, words) in [
            (expectation().judge(&[2.0]), "reproduced"),
            (better.clone().judge(&[2.0]), "reproduced"),
            (better.judge(&[3.0]), "exceeded"),
            (expectation().judge(&[1.0]), "not reproduced"),
            (
                expectation().contradicts_itself("a and b").judge(&[1.0]),
                "contradicts itself",
            ),
            (expectation().extension().judge(&[1.0]), "extension"),
        ] {
            let written = serde_json::to_value(claim.verdict).unwrap();
            assert_eq!(written, words);
            assert_eq!(claim.verdict.to_string(), words);
        }
    }

    #[test]
    fn a_claim_without_a_rule_is_never_reproduced() {
        let claim = Expectation::new("a.b", "6.1", "captures").judge(&[9.0]);
        assert_eq!((claim.verdict, claim.met), (Verdict::NotReproduced, None));
    }

    #[test]
    fn a_missing_seed_keeps_its_place_and_does_not_count() {
        let claim = expectation().judge(&[1.0, f64::NAN, 3.0]);
        assert_eq!(claim.per_seed, [Some(1.0), None, Some(3.0)]);
        assert_eq!((claim.ours.n, claim.ours.mean), (2, Some(2.0)));
        let none = expectation().judge(&[f64::NAN]);
        assert_eq!(
            (none.ours.mean, none.verdict),
            (None, Verdict::NotReproduced)
        );
    }

    #[test]
    fn a_ratio_is_the_ratio_of_the_means_with_paired_ratios_beside_it() {
        let claim = expectation().judge_ratio(&[1.0, 9.0, 5.0], &[1.0, 3.0]);
        assert_eq!(claim.ours.mean, Some(2.5));
        assert_eq!(claim.per_seed, [Some(1.0), Some(3.0), None]);
    }

    #[test]
    fn json_gives_back_every_bit() {
        let awkward = [0.1 + 0.2, 1.0 / 3.0, f64::MIN_POSITIVE, 6.02e23, -0.0];
        let claim = expectation().book(0.1 + 0.7).note("why").judge(&awkward);
        let text = serde_json::to_string_pretty(&claim).unwrap();
        let back: Claim = serde_json::from_str(&text).unwrap();
        assert_eq!(back, claim);
        let bits = |claim: &Claim| -> Vec<u64> {
            claim
                .per_seed
                .iter()
                .flatten()
                .map(|value| value.to_bits())
                .collect()
        };
        assert_eq!(bits(&back), bits(&claim));
    }
}
