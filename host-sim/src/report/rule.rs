//! The rule of a verdict: a statistic over the seeds, and the bound it must keep.
//!
//! A rule is data, so that its text in the summary and its evaluation are the same thing.

use core::fmt;

use super::statistics::{mean, median};

/// What is computed from the measurements of all seeds before a bound is applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Statistic {
    /// The mean; of a yes/no finding the share of seeds, of a ratio the ratio of the means.
    Mean,
    /// The median of the seeds.
    Median,
    /// Each seed for itself: the bound must hold for every one.
    Every,
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
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtLeast(bound) => write!(f, ">= {bound}"),
            Self::AtMost(bound) => write!(f, "<= {bound}"),
            Self::Above(bound) => write!(f, "> {bound}"),
            Self::Below(bound) => write!(f, "< {bound}"),
            Self::Between(low, high) => write!(f, "in [{low}, {high}]"),
        }
    }
}

/// When a finding of the book counts as reproduced.
///
/// ```
/// use host_sim::report::Rule;
/// let rule = Rule::median_within(640.0, 0.2);
/// assert_eq!(rule.to_string(), "median in [512, 768]");
/// assert!(rule.is_met(&[500.0, 600.0, 900.0], 666.7));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// A statistic over the seeds keeps a bound.
    Keeps(Statistic, Bound),
    /// All of several rules hold.
    All(Vec<Rule>),
    /// A test that the experiment made itself, told in one sentence, and its outcome.
    Judged {
        /// The sentence.
        text: String,
        /// Whether it came out as the book says.
        met: bool,
    },
}

impl Rule {
    /// The mean keeps a bound.
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

    /// A test that the experiment made itself.
    #[must_use]
    pub fn judged(text: impl Into<String>, met: bool) -> Self {
        Self::Judged {
            text: text.into(),
            met,
        }
    }

    /// Whether the rule holds for the seeds that could be measured, and their mean.
    ///
    /// The mean is handed in because that of a ratio is not the mean of the seeds' ratios.
    #[must_use]
    pub fn is_met(&self, measured: &[f64], mean_of_all: f64) -> bool {
        match self {
            Self::Keeps(Statistic::Mean, bound) => bound.holds(mean_of_all),
            Self::Keeps(Statistic::Median, bound) => bound.holds(median(measured)),
            Self::Keeps(Statistic::Every, bound) => {
                !measured.is_empty() && measured.iter().all(|&value| bound.holds(value))
            }
            Self::All(rules) => rules.iter().all(|rule| rule.is_met(measured, mean_of_all)),
            Self::Judged { met, .. } => *met,
        }
    }

    /// As [`is_met`](Self::is_met), with the plain mean of the seeds.
    #[must_use]
    pub fn is_met_by(&self, measured: &[f64]) -> bool {
        self.is_met(measured, mean(measured))
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Keeps(Statistic::Mean, bound) => write!(f, "mean {bound}"),
            Self::Keeps(Statistic::Median, bound) => write!(f, "median {bound}"),
            Self::Keeps(Statistic::Every, bound) => write!(f, "every seed {bound}"),
            Self::All(rules) => {
                for (index, rule) in rules.iter().enumerate() {
                    let between = if index == 0 { "" } else { " and " };
                    write!(f, "{between}{rule}")?;
                }
                Ok(())
            }
            Self::Judged { text, .. } => f.write_str(text),
        }
    }
}

/// Rounds away the last digits of a computed bound, so that 640 · 1.2 reads 768.
fn tidy(bound: f64) -> f64 {
    format!("{bound:.9}").parse().unwrap_or(bound)
}

#[cfg(test)]
mod tests {
    use super::{Bound, Rule};

    #[test]
    fn the_text_of_a_rule_says_what_is_evaluated() {
        let rule = Rule::All(vec![
            Rule::mean(Bound::AtLeast(20.4)),
            Rule::every_seed(Bound::Above(1.0)),
        ]);
        assert_eq!(rule.to_string(), "mean >= 20.4 and every seed > 1");
        assert!(rule.is_met_by(&[20.0, 21.0]));
        assert!(!rule.is_met_by(&[0.5, 60.0]));
        assert_eq!(Rule::share(19, 20).to_string(), "mean >= 0.95");
    }

    #[test]
    fn nothing_measured_meets_no_rule() {
        for rule in [
            Rule::mean(Bound::AtMost(1.0)),
            Rule::median(Bound::AtLeast(-1.0)),
            Rule::every_seed(Bound::Between(0.0, 1.0)),
        ] {
            assert!(!rule.is_met_by(&[]), "{rule}");
        }
    }
}
