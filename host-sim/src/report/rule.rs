//! The rule of a verdict: what is asked of an estimate, and the bound that it must keep.
//!
//! A rule is data and its text is its whole: `text` writes it into a summary and reads it back, so
//! that whoever has the file judges by the same rule.
//! A rule knows nothing of the measurements that it will be asked about.

use super::inference::Printed;

/// What is asked of the measurements before a bound is applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Statistic {
    /// The estimate: the mean, the share of seeds that say yes, the ratio of the means.
    Mean,
    /// The median of the seeds.
    Median,
    /// Each seed for itself, of a ratio its own ratio: the bound must hold for every one.
    Every,
    /// The statistic of the claim's test.
    T,
    /// The probability of its test.
    P,
    /// The same after Holm's correction within the claim's family.
    Holm,
    /// Of pairs, the share in which ours is the larger; ties count half.
    Ahead,
    /// The lower end of the interval.
    Low,
    /// The upper end of the interval.
    High,
}

/// What a statistic must satisfy. All comparisons with NaN fail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// At least this much.
    AtLeast(f64),
    /// At most this much.
    AtMost(f64),
    /// More than this.
    Above(f64),
    /// Less than this.
    Below(f64),
    /// From the first to the second, both included.
    Between(f64, f64),
}

impl Bound {
    /// Whether the value keeps the bound.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::AtLeast(bound) => value >= bound,
            Self::AtMost(bound) => value <= bound,
            Self::Above(bound) => value > bound,
            Self::Below(bound) => value < bound,
            Self::Between(low, high) => low <= value && value <= high,
        }
    }

    /// The number on its edge; `None` of two.
    #[must_use]
    pub const fn edge(self) -> Option<f64> {
        match self {
            Self::AtLeast(bound) | Self::AtMost(bound) => Some(bound),
            Self::Above(bound) | Self::Below(bound) => Some(bound),
            Self::Between(..) => None,
        }
    }
}

/// Which results are better than the book's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Better {
    /// Larger ones.
    Higher,
    /// Smaller ones.
    Lower,
    /// None: another result is another result.
    Neither,
}

/// When a finding counts as reproduced or an aim as met.
///
/// ```
/// use host_sim::report::{Bound, Rule};
/// let rule = Rule::All(vec![Rule::mean(Bound::AtLeast(20.4)), Rule::p(Bound::AtMost(0.05))]);
/// assert_eq!(rule.to_string(), "mean >= 20.4 and p <= 0.05");
/// assert_eq!("mean >= 20.4 and p <= 0.05".parse(), Ok(rule));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// A statistic keeps a bound.
    Keeps(Statistic, Bound),
    /// All of several rules hold.
    All(Vec<Rule>),
    /// The mean is within two standard deviations of the book's, and varies neither more than twice
    /// as much nor less than half as much as the book's does.
    Book(Better),
    /// No worse than the bound, of the interval's end that could be worse; asks for 60 seeds, or for
    /// lives that are the same to the bit.
    Equivalent(Statistic, Bound),
    /// The book gives no error: the numbers stand beside each other, without a verdict.
    Compared,
    /// Nothing is asked: a number that other claims refer to.
    Measured,
}

/// What a rule is asked about: an estimate and what surrounds it.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// The estimate, NaN where there is none.
    pub estimate: f64,
    /// The ends of its interval.
    pub interval: (f64, f64),
    /// Each seed for itself; of pairs their ratio or difference.
    pub seeds: &'a [f64],
    /// Of pairs, the share in which ours is the larger.
    pub ahead: f64,
    /// Statistic, probability and corrected probability of the test.
    pub test: (f64, f64, f64),
    /// What the book prints.
    pub book: Option<Printed>,
}

/// How far from the book's mean ours may be, in the book's standard deviations.
const WITHIN: f64 = 2.0;
/// By what factor our standard deviation may differ from the book's.
const SPREAD: f64 = 2.0;

impl Rule {
    /// The mean keeps a bound; of a yes/no finding the share of seeds, of a ratio that of the means.
    #[must_use]
    pub const fn mean(bound: Bound) -> Self {
        Self::Keeps(Statistic::Mean, bound)
    }

    /// The median keeps a bound.
    #[must_use]
    pub const fn median(bound: Bound) -> Self {
        Self::Keeps(Statistic::Median, bound)
    }

    /// The bound holds in every seed that could be measured, and there is at least one.
    #[must_use]
    pub const fn every_seed(bound: Bound) -> Self {
        Self::Keeps(Statistic::Every, bound)
    }

    /// The test's statistic keeps a bound.
    #[must_use]
    pub const fn t(bound: Bound) -> Self {
        Self::Keeps(Statistic::T, bound)
    }

    /// The test's probability keeps a bound.
    #[must_use]
    pub const fn p(bound: Bound) -> Self {
        Self::Keeps(Statistic::P, bound)
    }

    /// The median is within a share of a number: `0.2` is ±20 %.
    #[must_use]
    pub fn median_within(number: f64, share: f64) -> Self {
        let (a, b) = (number * (1.0 - share), number * (1.0 + share));
        Self::median(Bound::Between(tidy(a.min(b)), tidy(a.max(b))))
    }

    /// The mean is no further than `distance` from a number.
    #[must_use]
    pub fn mean_near(number: f64, distance: f64) -> Self {
        Self::mean(Bound::Between(
            tidy(number - distance),
            tidy(number + distance),
        ))
    }

    /// At least `wanted` of `seeds` say yes (a finding whose measurements are 0 and 1).
    #[must_use]
    pub fn share(wanted: u32, seeds: u32) -> Self {
        Self::mean(Bound::AtLeast(f64::from(wanted) / f64::from(seeds.max(1))))
    }

    /// Whether the rule asks about the median.
    #[must_use]
    pub fn is_of_median(&self) -> bool {
        match self {
            Self::Keeps(statistic, _) => *statistic == Statistic::Median,
            Self::All(rules) => rules.iter().any(Self::is_of_median),
            _ => false,
        }
    }

    /// Whether a verdict follows from the rule.
    #[must_use]
    pub const fn decides(&self) -> bool {
        !matches!(self, Self::Compared | Self::Measured)
    }

    /// The bound of the estimate that a test is made against.
    #[must_use]
    pub fn bound(&self) -> Option<Bound> {
        match self {
            Self::Keeps(Statistic::Mean | Statistic::Median, bound) => Some(*bound),
            Self::All(rules) => rules.iter().find_map(Self::bound),
            _ => None,
        }
    }

    /// Whether the rule holds; one that decides nothing does not.
    #[must_use]
    pub fn is_met(&self, evidence: &Evidence<'_>) -> bool {
        match self {
            Self::Keeps(statistic, bound) => keeps(*statistic, *bound, evidence),
            Self::All(rules) => rules.iter().all(|rule| rule.is_met(evidence)),
            Self::Equivalent(statistic, bound) => keeps(*statistic, *bound, evidence),
            Self::Book(better) => evidence
                .book
                .is_some_and(|book| is_near(evidence, book) || is_better(evidence, book, *better)),
            Self::Compared | Self::Measured => false,
        }
    }

    /// Whether the result is better than the book's beyond both errors.
    #[must_use]
    pub fn is_exceeded(&self, evidence: &Evidence<'_>) -> bool {
        match (self, evidence.book) {
            (Self::Book(better), Some(book)) => is_better(evidence, book, *better),
            _ => false,
        }
    }
}

fn keeps(statistic: Statistic, bound: Bound, evidence: &Evidence<'_>) -> bool {
    bound.holds(match statistic {
        Statistic::Mean | Statistic::Median => evidence.estimate,
        Statistic::T => evidence.test.0,
        Statistic::P => evidence.test.1,
        Statistic::Holm => evidence.test.2,
        Statistic::Ahead => evidence.ahead,
        Statistic::Low => evidence.interval.0,
        Statistic::High => evidence.interval.1,
        Statistic::Every => {
            let all = evidence.seeds.iter().all(|&value| bound.holds(value));
            return all && !evidence.seeds.is_empty();
        }
    })
}

/// The mean within the book's error, and the spread within a factor of the book's.
fn is_near(evidence: &Evidence<'_>, book: Printed) -> bool {
    let ours = super::statistics::sample_sd(evidence.seeds);
    let near = (evidence.estimate - book.mean).abs() <= error(book);
    near && book.sd <= SPREAD * ours && ours <= SPREAD * book.sd
}

/// The two intervals of two standard deviations do not touch, and ours is on the better side.
fn is_better(evidence: &Evidence<'_>, book: Printed, better: Better) -> bool {
    let beyond = error(book) + WITHIN * super::statistics::sample_sd(evidence.seeds);
    match better {
        Better::Higher => evidence.estimate - book.mean > beyond,
        Better::Lower => book.mean - evidence.estimate > beyond,
        Better::Neither => false,
    }
}

/// Two of the book's standard deviations, and never less than half a unit of the last digit that it
/// prints.
fn error(book: Printed) -> f64 {
    let text = format!("{}", book.mean);
    let digits = text.split_once('.').map_or(0, |(_, after)| after.len());
    (WITHIN * book.sd).max(0.5 * 10_f64.powi(-(digits as i32)))
}

/// Rounds away the last digits of a computed bound, so that 640 · 1.2 reads 768.
fn tidy(bound: f64) -> f64 {
    format!("{bound:.9}").parse().unwrap_or(bound)
}

#[cfg(test)]
#[path = "rule_tests.rs"]
mod tests;
