//! A claim before it is measured: a statement, its number, its rule.
//!
//! Judging an [`Expectation`] with the measurements of the seeds gives a [`Claim`].
//! A seed in which a quantity does not exist (a schema that was never formed) is missing: `null`
//! among the seeds, and not counted in n.

use super::claims::{Claim, Estimator, Origin, Ours, Reference, Verdict};
use super::judge::judge;
use super::rule::Rule;

/// A statement to be tested, with nothing measured.
///
/// ```
/// use host_sim::report::{Better, Expectation, Rule, Verdict};
/// let claim = Expectation::new("forage.captures.level1", "6.2.5", "captures of 28")
///     .book((20.4, 1.53, 10))
///     .rule(Rule::Book(Better::Higher));
/// let few = claim.clone().judge(&[28.0, 28.0, 27.0]);
/// assert_eq!(few.verdict, Verdict::TooSmall);
/// let enough = claim.judge(&[28.0, 28.0, 27.0, 28.0, 28.0, 28.0, 28.0, 27.0, 28.0, 28.0]);
/// assert_eq!((enough.ours.value, enough.verdict), (Some(27.8), Verdict::Exceeded));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    id: String,
    section: String,
    unit: String,
    reference: Option<Reference>,
    rule: Rule,
    family: Option<String>,
    origin: Origin,
    note: Option<String>,
}

impl Expectation {
    /// A claim by its id (`experiment.what.variant`), the book's section and the unit of its number.
    #[must_use]
    pub fn new(id: impl Into<String>, section: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            id: id.into(),
            section: section.into(),
            unit: unit.into(),
            reference: None,
            rule: Rule::Measured,
            family: None,
            origin: Origin::Book,
            note: None,
        }
    }

    /// The number the book prints: `20.4`, or `(20.4, 1.53, 10)` with its deviation and runs.
    #[must_use]
    pub fn book(mut self, number: impl Into<Reference>) -> Self {
        self.reference = Some(number.into());
        self
    }

    /// A number from another source than the book.
    #[must_use]
    pub fn beside(mut self, of: &str, number: f64) -> Self {
        self.reference = Some(Reference {
            of: of.to_owned(),
            ..Reference::from(number)
        });
        self
    }

    /// What is asked.
    #[must_use]
    pub fn rule(mut self, rule: Rule) -> Self {
        self.rule = rule;
        self
    }

    /// The claims that are corrected together; without it all of an experiment.
    #[must_use]
    pub fn family(mut self, family: &str) -> Self {
        self.family = Some(family.to_owned());
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

    /// One sentence beside the numbers; it says what is measured, never what came out.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.note = Some(note.into());
        self
    }

    /// The claim for these measurements, one a seed; a value that is not finite is missing.
    ///
    /// A rule that asks about the median makes it the claim's estimator.
    #[must_use]
    pub fn judge(self, per_seed: &[f64]) -> Claim {
        let estimator = if self.rule.is_of_median() {
            Estimator::Median
        } else {
            Estimator::Mean
        };
        self.claim(estimator, per_seed, None)
    }

    /// The claim for the median of these measurements.
    #[must_use]
    pub fn judge_median(self, per_seed: &[f64]) -> Claim {
        self.claim(Estimator::Median, per_seed, None)
    }

    /// The claim for a yes/no finding: 1 for every seed that says yes.
    #[must_use]
    pub fn judge_share(self, per_seed: &[bool]) -> Claim {
        let numbers: Vec<f64> = per_seed
            .iter()
            .map(|&yes| f64::from(u8::from(yes)))
            .collect();
        self.claim(Estimator::Share, &numbers, None)
    }

    /// The claim for the median time until something happens; where it never does it is not finite.
    #[must_use]
    pub fn judge_time(self, per_seed: &[f64]) -> Claim {
        self.claim(Estimator::Time, per_seed, None)
    }

    /// The claim for a ratio of means, seed by seed in pairs.
    ///
    /// A pair with a missing half, or without a partner, is left out.
    #[must_use]
    pub fn judge_ratio(self, above: &[f64], below: &[f64]) -> Claim {
        self.claim(Estimator::Ratio, above, Some(below))
    }

    /// The claim for a mean difference, seed by seed in pairs, as [`judge_ratio`](Self::judge_ratio).
    #[must_use]
    pub fn judge_difference(self, of: &[f64], from: &[f64]) -> Claim {
        self.claim(Estimator::Difference, of, Some(from))
    }

    /// The claim for a number that comes out the same in every run.
    #[must_use]
    pub fn judge_count(self, number: f64) -> Claim {
        self.claim(Estimator::Count, &[number], None)
    }

    /// The claim for how many of its family are ahead after correction; judged in a summary.
    #[must_use]
    pub fn judge_family(self) -> Claim {
        self.claim(Estimator::Ahead, &[], None)
    }

    fn claim(self, estimator: Estimator, per_seed: &[f64], against: Option<&[f64]>) -> Claim {
        let seeds = per_seed.len().max(against.map_or(0, <[f64]>::len));
        let column = |values: &[f64]| -> Vec<Option<f64>> {
            let at = |seed| values.get(seed).copied().filter(|it: &f64| it.is_finite());
            (0..seeds).map(at).collect()
        };
        let experiment = self.id.split('.').next().unwrap_or_default().to_owned();
        let mut claim = Claim {
            id: self.id,
            section: self.section,
            unit: self.unit,
            origin: self.origin,
            estimator,
            reference: self.reference,
            rule: self.rule,
            family: self.family.unwrap_or(experiment),
            note: self.note,
            per_seed: column(per_seed),
            against: against.map(column),
            ours: Ours {
                value: None,
                sd: None,
                interval: None,
                n: 0,
                never: None,
            },
            tested: None,
            met: None,
            verdict: Verdict::Measured,
        };
        judge(core::slice::from_mut(&mut claim));
        claim
    }
}

#[cfg(test)]
#[path = "expectation_tests.rs"]
mod tests;
