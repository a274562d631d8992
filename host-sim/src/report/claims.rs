//! Claims as data: what was expected, what was measured, how it was judged.
//!
//! The first fields of a [`Claim`] are stated in the program, apart from what is measured;
//! `per_seed` and `against` are measured, and everything else follows from these: `judge` computes it, here and again from a
//! committed file.

use core::fmt;

use serde::{Deserialize, Serialize};

use super::rule::Rule;

/// How a claim came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Verdict {
    /// The book's finding came out.
    #[serde(rename = "reproduced")]
    Reproduced,
    /// Better than the book's, beyond both errors.
    #[serde(rename = "exceeded")]
    Exceeded,
    /// The book's finding did not come out.
    #[serde(rename = "not reproduced")]
    NotReproduced,
    /// The book gives two statements that cannot both be true.
    #[serde(rename = "contradicts itself")]
    ContradictsItself,
    /// The book prints a number without its error: both stand beside each other.
    #[serde(rename = "compared")]
    Compared,
    /// An aim of our own was met.
    #[serde(rename = "extension: met")]
    Met,
    /// An aim of our own was missed.
    #[serde(rename = "extension: missed")]
    Missed,
    /// Too few seeds for a verdict.
    #[serde(rename = "n too small")]
    TooSmall,
    /// Nothing was asked: a number that claims refer to.
    #[serde(rename = "measured")]
    Measured,
}

impl Verdict {
    /// All of them, in the order of a summary line.
    pub const ALL: [Self; 9] = [
        Self::Reproduced,
        Self::Exceeded,
        Self::NotReproduced,
        Self::ContradictsItself,
        Self::Compared,
        Self::Met,
        Self::Missed,
        Self::TooSmall,
        Self::Measured,
    ];

    /// As it is written.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Exceeded => "exceeded",
            Self::NotReproduced => "not reproduced",
            Self::ContradictsItself => "contradicts itself",
            Self::Compared => "compared",
            Self::Met => "extension: met",
            Self::Missed => "extension: missed",
            Self::TooSmall => "n too small",
            Self::Measured => "measured",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.words())
    }
}

/// Whose statement a claim is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// The book's.
    #[serde(rename = "book")]
    Book,
    /// The book's, which says the contrary elsewhere.
    #[serde(rename = "contradiction")]
    Contradiction,
    /// Ours.
    #[serde(rename = "extension")]
    Extension,
    /// Of another world, learner or length than the one that claims are about.
    #[serde(rename = "varied")]
    Varied,
}

/// What is estimated from the seeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Estimator {
    /// The mean of the seeds.
    #[serde(rename = "mean")]
    Mean,
    /// The share of seeds that say yes (1, not 0).
    #[serde(rename = "share")]
    Share,
    /// The median of the seeds.
    #[serde(rename = "median")]
    Median,
    /// The median time until something happened; a missing seed is one in which it never did.
    #[serde(rename = "median time")]
    Time,
    /// The mean over the mean of `against`, in pairs.
    #[serde(rename = "ratio of means")]
    Ratio,
    /// The mean of the differences from `against`, in pairs.
    #[serde(rename = "mean difference")]
    Difference,
    /// A number that comes out the same in every run: bytes, instructions, identity.
    #[serde(rename = "count")]
    Count,
    /// How many members of the claim's family are ahead, after Holm's correction at .05.
    #[serde(rename = "members ahead")]
    Ahead,
}

/// A number that the book (or another source that a claim is compared with) prints.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Where it stands: `book`, `Stage 1.3.4`.
    pub of: String,
    /// The mean, or the only number given.
    pub mean: f64,
    /// Its standard deviation, where printed.
    pub sd: Option<f64>,
    /// The number of runs behind it, where told.
    pub n: Option<u32>,
}

impl From<f64> for Reference {
    fn from(mean: f64) -> Self {
        Self {
            of: "book".to_owned(),
            mean,
            sd: None,
            n: None,
        }
    }
}

impl From<(f64, f64, u32)> for Reference {
    fn from((mean, sd, n): (f64, f64, u32)) -> Self {
        Self {
            sd: Some(sd),
            n: Some(n),
            ..Self::from(mean)
        }
    }
}

/// The ends between which the estimate lies with 95 % confidence, and how they were found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// The lower end.
    pub low: f64,
    /// The upper end; `None` where it is never.
    pub high: Option<f64>,
    /// The method.
    pub by: String,
}

/// What we measured, over the seeds in which the quantity exists.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ours {
    /// The estimate; `None` where the quantity exists in no seed, or is never.
    pub value: Option<f64>,
    /// The standard deviation of the seeds, of an estimator that is a mean; `None` for one seed.
    pub sd: Option<f64>,
    /// The interval of the estimate.
    pub interval: Option<Range>,
    /// The number of seeds, or pairs of them, in which the quantity exists.
    pub n: u32,
    /// In how many seeds it never happened; of a time alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub never: Option<u32>,
}

/// A test that belongs to a claim.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tested {
    /// What was tested, against what.
    pub test: String,
    /// Its statistic: t, or a number of seeds; `None` where it is infinite.
    pub statistic: Option<f64>,
    /// Degrees of freedom of t.
    pub freedom: Option<f64>,
    /// Size of the effect: Cohen's d, of shares Cohen's h; `None` where nothing varies.
    pub effect: Option<f64>,
    /// Probability.
    pub p: Option<f64>,
    /// The family whose claims are corrected together.
    pub family: String,
    /// Its members.
    pub members: u32,
    /// Probability after Holm's correction.
    pub holm: Option<f64>,
}

/// A judged claim, as it stands in a summary.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// The claim's name: `experiment.what.variant`, and `@2` when its subject or its rule is the
    /// second that this name has had.
    pub id: String,
    /// The book's section.
    pub section: String,
    /// What the number counts.
    pub unit: String,
    /// Whose statement it is.
    pub origin: Origin,
    /// What is estimated.
    pub estimator: Estimator,
    /// The number to compare with, where there is one.
    pub reference: Option<Reference>,
    /// What is asked: stated in the program, whatever is measured; `docs/claims-ledger.tsv` says since
    /// when, which for many is after earlier runs had been looked at.
    pub rule: Rule,
    /// The family within which its test is corrected.
    pub family: String,
    /// A sentence beside the numbers that says what is measured, never what came out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The measurement of every seed, in the summary's order of seeds; `None` where it is missing.
    pub per_seed: Vec<Option<f64>>,
    /// What it is compared with, seed by seed, where the estimator is of pairs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub against: Option<Vec<Option<f64>>>,
    /// What we measured.
    pub ours: Ours,
    /// The test, where one can be made.
    pub tested: Option<Tested>,
    /// Whether the rule holds; `None` where there is no verdict.
    pub met: Option<bool>,
    /// How it came out.
    pub verdict: Verdict,
}

impl Claim {
    /// The id without its version.
    #[must_use]
    pub fn name(&self) -> &str {
        self.id.split_once('@').map_or(&self.id, |(name, _)| name)
    }
}
