//! Judging: from what was written and measured to estimates, tests and verdicts.
//!
//! Everything here is computed from a claim's first fields and its seeds, so a committed file can
//! be judged again by whoever reads it.
//! What is derived is rounded to six digits: the digits beyond differ between machines whose
//! mathematical functions do, and mean nothing.

use super::claims::{Claim, Estimator, Origin, Ours, Range, Tested, Verdict};
use super::inference::{
    Outcome, Printed, RESAMPLES, binomial_test, holm, median_interval, one_sample_t, paired_t,
    ratio_interval, share_interval, welch_of_printed,
};
use super::rule::{Bound, Evidence, Rule};
use super::statistics::{Interval, confidence_interval, mean, median, sample_sd};

/// Seeds below which an estimate has no verdict.
pub const LEAST: u32 = 10;
/// Seeds that an equivalence asks for: our arms differ by 8 to 28 % from seed to seed.
pub const EQUIVALENCE: u32 = 60;
/// The corrected probability at which a member of a family is ahead.
pub const AHEAD: f64 = 0.05;

/// An estimate with everything that a rule may ask about.
struct Measured {
    estimate: f64,
    interval: Interval,
    by: String,
    /// Each seed for itself; of pairs their ratio or difference.
    seeds: Vec<f64>,
    pairs: Vec<(f64, f64)>,
    n: u32,
    never: Option<u32>,
    outcome: Option<(String, Outcome)>,
    holm: f64,
}

/// Judges claims anew; those of one family are corrected together.
pub(super) fn judge(claims: &mut [Claim]) {
    let mut all: Vec<Measured> = claims.iter().map(measure).collect();
    correct(claims, &mut all);
    for index in 0..claims.len() {
        if claims[index].estimator == Estimator::Ahead {
            all[index].estimate = members_ahead(claims, &all, index);
        }
    }
    let families: Vec<u32> = claims
        .iter()
        .map(|claim| members(claims, &all, &claim.family) as u32)
        .collect();
    for ((claim, measured), members) in claims.iter_mut().zip(&all).zip(families) {
        conclude(claim, measured, members);
    }
}

impl Claim {
    /// What is stated in the program, with nothing measured.
    ///
    /// ```
    /// use host_sim::report::Expectation;
    /// let claim = |seeds: &[f64]| Expectation::new("a.b", "6.1", "captures").judge(seeds);
    /// assert_eq!(claim(&[1.0, 2.0]).declared(), claim(&[]).declared());
    /// ```
    #[must_use]
    pub fn declared(&self) -> Self {
        let mut bare = Self {
            per_seed: Vec::new(),
            against: self.against.as_ref().map(|_| Vec::new()),
            ..self.clone()
        };
        judge(core::slice::from_mut(&mut bare));
        bare
    }
}

fn members(claims: &[Claim], all: &[Measured], family: &str) -> usize {
    let pairs = claims.iter().zip(all);
    pairs
        .filter(|(claim, it)| claim.family == family && probability(it).is_finite())
        .count()
}

fn probability(measured: &Measured) -> f64 {
    measured.outcome.as_ref().map_or(f64::NAN, |(_, it)| it.p)
}

fn correct(claims: &[Claim], all: &mut [Measured]) {
    let mut families: Vec<&str> = claims.iter().map(|it| it.family.as_str()).collect();
    families.sort_unstable();
    families.dedup();
    for family in families {
        let of_family = |(claim, it): (&Claim, &Measured)| {
            if claim.family == family {
                probability(it)
            } else {
                f64::NAN
            }
        };
        let probabilities: Vec<f64> = claims.iter().zip(all.iter()).map(of_family).collect();
        for (measured, corrected) in all.iter_mut().zip(holm(&probabilities)) {
            if corrected.is_finite() {
                measured.holm = corrected;
            }
        }
    }
}

/// How many other claims of the same family are ahead: a positive statistic, and improbable.
fn members_ahead(claims: &[Claim], all: &[Measured], index: usize) -> f64 {
    let family = &claims[index].family;
    let ahead = claims.iter().zip(all).filter(|(claim, it)| {
        let positive = it
            .outcome
            .as_ref()
            .is_some_and(|(_, it)| it.statistic > 0.0);
        claim.family == *family && positive && it.holm <= AHEAD
    });
    ahead.count() as f64
}

fn measure(claim: &Claim) -> Measured {
    let values: Vec<f64> = claim.per_seed.iter().flatten().copied().collect();
    let pairs = pairs(claim);
    let (above, below): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let mut never = None;
    let (estimate, interval, by, seeds) = match claim.estimator {
        Estimator::Mean => (
            mean(&values),
            confidence_interval(&values, super::inference::LEVEL),
            "Student's t".to_owned(),
            values,
        ),
        Estimator::Share => (
            mean(&values),
            share_interval(yes(&values), values.len() as u64),
            "Clopper and Pearson".to_owned(),
            values,
        ),
        Estimator::Median => (
            median(&values),
            median_interval(&values),
            "order statistics".to_owned(),
            values,
        ),
        Estimator::Time => {
            let all: Vec<f64> = claim
                .per_seed
                .iter()
                .map(|it| it.unwrap_or(f64::INFINITY))
                .collect();
            never = Some((all.len() - values.len()) as u32);
            let interval = median_interval(&all);
            (median(&all), interval, "order statistics".to_owned(), all)
        }
        Estimator::Ratio => (
            mean(&above) / mean(&below),
            ratio_interval(&above, &below),
            format!("bootstrap of pairs, {RESAMPLES} resamples"),
            pairs.iter().map(|(a, b)| a / b).collect(),
        ),
        Estimator::Difference => {
            let differences: Vec<f64> = pairs.iter().map(|(a, b)| a - b).collect();
            let interval = confidence_interval(&differences, super::inference::LEVEL);
            let by = "Student's t of pairs".to_owned();
            (mean(&differences), interval, by, differences)
        }
        Estimator::Count => {
            let first = values.first().copied().unwrap_or(f64::NAN);
            let same = values.iter().all(|it| it.to_bits() == first.to_bits());
            let number = if same { first } else { f64::NAN };
            (number, Interval::NONE, String::new(), values)
        }
        Estimator::Ahead => (f64::NAN, Interval::NONE, String::new(), values),
    };
    let n = match claim.estimator {
        Estimator::Ratio | Estimator::Difference => pairs.len(),
        _ => seeds.len(),
    } as u32;
    let mut measured = Measured {
        estimate,
        interval,
        by,
        seeds,
        pairs,
        n,
        never,
        outcome: None,
        holm: f64::NAN,
    };
    measured.outcome = test(claim, &measured);
    measured
}

fn pairs(claim: &Claim) -> Vec<(f64, f64)> {
    let against = claim.against.iter().flatten();
    let both = claim.per_seed.iter().zip(against);
    both.filter_map(|(a, b)| Some(((*a)?, (*b)?))).collect()
}

fn yes(values: &[f64]) -> u64 {
    values.iter().filter(|&&it| it > 0.5).count() as u64
}

/// The test that fits the estimator: of pairs that their means are equal, of others that they are
/// what the book prints or what the rule's bound is.
fn test(claim: &Claim, measured: &Measured) -> Option<(String, Outcome)> {
    let edge = claim.rule.bound().and_then(Bound::edge);
    match claim.estimator {
        // A share that is pooled from counts is no comparison of two arms.
        Estimator::Ratio if matches!(claim.rule.bound(), Some(Bound::Between(..))) => None,
        Estimator::Ratio | Estimator::Difference => {
            let (a, b): (Vec<f64>, Vec<f64>) = measured.pairs.iter().copied().unzip();
            Some(("paired t of equal means".to_owned(), paired_t(&a, &b)))
        }
        Estimator::Mean => match (&claim.reference, &claim.rule) {
            (_, Rule::Measured) => None,
            // Against a number that varies by nothing every difference is infinitely improbable.
            (Some(book), Rule::Book(_)) if book.sd == Some(0.0) => None,
            (Some(book), Rule::Book(_) | Rule::Compared) => {
                Some(beside(&measured.seeds, book.mean, book.sd.zip(book.n)))
            }
            _ => edge.map(|edge| {
                (
                    format!("t against {edge}"),
                    one_sample_t(&measured.seeds, edge),
                )
            }),
        },
        Estimator::Share => edge.map(|edge| {
            let n = u64::from(measured.n);
            let outcome = binomial_test(yes(&measured.seeds), n, edge);
            (format!("exact binomial against {edge}"), outcome)
        }),
        Estimator::Median | Estimator::Time => edge.map(|edge| {
            let beyond = |it: &&f64| **it > edge;
            let above = measured.seeds.iter().filter(beyond).count() as u64;
            let equal = measured.seeds.iter().filter(|it| **it == edge).count() as u64;
            let outcome = binomial_test(above, u64::from(measured.n) - equal, 0.5);
            (format!("sign test against {edge}"), outcome)
        }),
        Estimator::Count | Estimator::Ahead => None,
    }
}

fn beside(seeds: &[f64], number: f64, error: Option<(f64, u32)>) -> (String, Outcome) {
    match error {
        Some((sd, n)) => {
            let book = Printed {
                mean: number,
                sd,
                n: f64::from(n),
            };
            let outcome = welch_of_printed(Printed::of(seeds), book);
            ("Welch's t against the printed mean".to_owned(), outcome)
        }
        None => (format!("t against {number}"), one_sample_t(seeds, number)),
    }
}

fn conclude(claim: &mut Claim, measured: &Measured, members: u32) {
    let is_mean = matches!(claim.estimator, Estimator::Mean | Estimator::Difference);
    claim.ours = Ours {
        value: present(measured.estimate),
        sd: present(sample_sd(&measured.seeds)).filter(|_| is_mean),
        interval: six(measured.interval.low).map(|low| Range {
            low,
            high: six(measured.interval.high),
            by: measured.by.clone(),
        }),
        n: measured.n,
        never: measured.never,
    };
    claim.tested = measured.outcome.as_ref().map(|(test, outcome)| Tested {
        test: test.clone(),
        statistic: six(outcome.statistic),
        freedom: six(outcome.freedom),
        effect: six(outcome.effect),
        p: six(outcome.p),
        family: claim.family.clone(),
        members,
        holm: six(measured.holm),
    });
    let ahead = |&(a, b): &(f64, f64)| {
        if a == b {
            0.5
        } else {
            f64::from(u8::from(a > b))
        }
    };
    let shares: Vec<f64> = measured.pairs.iter().map(ahead).collect();
    let outcome = measured.outcome.as_ref().map(|(_, it)| *it);
    let evidence = Evidence {
        estimate: measured.estimate,
        interval: (measured.interval.low, measured.interval.high),
        seeds: &measured.seeds,
        ahead: mean(&shares),
        test: (
            outcome.map_or(f64::NAN, |it| it.statistic),
            outcome.map_or(f64::NAN, |it| it.p),
            measured.holm,
        ),
        book: claim.reference.as_ref().and_then(|it| {
            Some(Printed {
                mean: it.mean,
                sd: it.sd?,
                n: f64::from(it.n?),
            })
        }),
    };
    let met = claim.rule.is_met(&evidence);
    claim.verdict = match (claim.origin, &claim.rule) {
        (Origin::Varied, _) | (_, Rule::Measured) => Verdict::Measured,
        _ if measured.n < asked(claim, measured) => Verdict::TooSmall,
        (_, Rule::Compared) => Verdict::Compared,
        (Origin::Contradiction, _) => Verdict::ContradictsItself,
        (Origin::Extension, _) if met => Verdict::Met,
        (Origin::Extension, _) => Verdict::Missed,
        (Origin::Book, rule) if rule.is_exceeded(&evidence) => Verdict::Exceeded,
        (Origin::Book, _) if met => Verdict::Reproduced,
        (Origin::Book, _) => Verdict::NotReproduced,
    };
    let decided = !matches!(
        claim.verdict,
        Verdict::Measured | Verdict::TooSmall | Verdict::Compared
    );
    claim.met = decided.then_some(met);
}

/// How many seeds a verdict needs.
fn asked(claim: &Claim, measured: &Measured) -> u32 {
    let same = |(a, b): &(f64, f64)| a.to_bits() == b.to_bits();
    match (claim.estimator, &claim.rule) {
        (Estimator::Count, _) => 1,
        (Estimator::Ahead, _) => 0,
        (_, Rule::Equivalent(..)) if measured.pairs.iter().all(same) => LEAST,
        (_, Rule::Equivalent(..)) => EQUIVALENCE,
        _ => LEAST,
    }
}

fn present(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// The number to six significant digits; `None` when it is not finite.
fn six(value: f64) -> Option<f64> {
    present(value).and_then(|it| format!("{it:.5e}").parse().ok())
}

#[cfg(test)]
#[path = "judge_tests.rs"]
mod tests;
