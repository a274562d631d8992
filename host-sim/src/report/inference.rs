//! How sure an estimate is: intervals and tests over seeds, each for the estimator it is named by.
//!
//! Distributions come from `statrs`; the resampling is seeded, so that the same seeds give the same
//! interval on every machine.
//! Without enough values the answer is NaN or `None`, never a panic.

use statrs::distribution::{Beta, Binomial, ContinuousCDF, DiscreteCDF, StudentsT};

use super::statistics::{Interval, mean, sample_sd};

/// The level of every interval.
pub const LEVEL: f64 = 0.95;
/// Resamples behind an interval of a ratio.
pub const RESAMPLES: u32 = 4000;
/// Seed of the resampling: the same in every run.
const RESAMPLING: u64 = 2004;

/// The outcome of a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The statistic: t, or the number of seeds for which something held.
    pub statistic: f64,
    /// Degrees of freedom, where the statistic has some; NaN otherwise.
    pub freedom: f64,
    /// Probability of an outcome at least as far off by chance.
    pub p: f64,
    /// Size of the effect in the measure of the test.
    pub effect: f64,
}

/// Student's t test of one sample against a number, two-sided; the effect is Cohen's d, the distance
/// in standard deviations.
///
/// A sample without any variance gives t = ±∞ and p = 0 when it differs, NaN when it agrees.
///
/// ```
/// let outcome = host_sim::report::one_sample_t(&[5.1, 4.9, 5.6, 5.2], 4.0);
/// assert!((outcome.statistic - 8.152_39).abs() < 1e-4 && outcome.freedom == 3.0);
/// ```
#[must_use]
pub fn one_sample_t(values: &[f64], number: f64) -> Outcome {
    let n = values.len() as f64;
    let effect = (mean(values) - number) / sample_sd(values);
    let (statistic, freedom) = (effect * n.sqrt(), n - 1.0);
    Outcome {
        statistic,
        freedom,
        p: two_sided(statistic, freedom),
        effect,
    }
}

/// The paired t test: are two measurements of the same seeds equal on average?
///
/// The effect is Cohen's d of the differences. Halves without a partner are left out.
///
/// ```
/// let outcome = host_sim::report::paired_t(&[5.0, 7.0, 9.0], &[4.0, 5.0, 6.0]);
/// assert_eq!(outcome.effect, 2.0);
/// ```
#[must_use]
pub fn paired_t(a: &[f64], b: &[f64]) -> Outcome {
    let differences: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    one_sample_t(&differences, 0.0)
}

/// A mean with its deviation and the number of runs behind it, as a book prints it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Printed {
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub sd: f64,
    /// The number of runs.
    pub n: f64,
}

impl Printed {
    /// What a sample would print.
    #[must_use]
    pub fn of(values: &[f64]) -> Self {
        Self {
            mean: mean(values),
            sd: sample_sd(values),
            n: values.len() as f64,
        }
    }
}

/// Welch's t test of two printed means, two-sided; the effect is Cohen's d, in the root of the mean
/// of both variances.
///
/// ```
/// use host_sim::report::{Printed, welch_of_printed};
/// // Section 6.2.5: the book's own numbers give 4.08, not its -2.55.
/// let (level2, level1) = (Printed { mean: 22.9, sd: 1.19, n: 10.0 }, Printed { mean: 20.4, sd: 1.53, n: 10.0 });
/// assert!((welch_of_printed(level2, level1).statistic - 4.079).abs() < 1e-3);
/// ```
#[must_use]
pub fn welch_of_printed(a: Printed, b: Printed) -> Outcome {
    let (u, v) = (a.sd * a.sd / a.n, b.sd * b.sd / b.n);
    let statistic = (a.mean - b.mean) / (u + v).sqrt();
    let freedom = (u + v).powi(2) / (u * u / (a.n - 1.0) + v * v / (b.n - 1.0));
    Outcome {
        statistic,
        freedom,
        p: two_sided(statistic, freedom),
        effect: (a.mean - b.mean) / ((a.sd * a.sd + b.sd * b.sd) / 2.0).sqrt(),
    }
}

fn two_sided(t: f64, freedom: f64) -> f64 {
    if t.is_infinite() {
        return 0.0;
    }
    match StudentsT::new(0.0, 1.0, freedom) {
        Ok(student) if t.is_finite() => (2.0 * student.sf(t.abs())).min(1.0),
        _ => f64::NAN,
    }
}

/// The exact test of a share: how probable are so many of `n`, or a number still further from what
/// `chance` expects on the same side?
///
/// The effect is Cohen's h, the distance of the shares on the arcsine scale.
///
/// ```
/// let outcome = host_sim::report::binomial_test(18, 20, 0.5);
/// assert!((outcome.p - 2.012e-4).abs() < 1e-7);
/// ```
#[must_use]
pub fn binomial_test(yes: u64, n: u64, chance: f64) -> Outcome {
    let share = yes as f64 / n as f64;
    let p = match Binomial::new(chance, n) {
        Ok(_) if n == 0 => f64::NAN,
        Ok(it) if share >= chance && yes > 0 => it.sf(yes - 1),
        Ok(_) if share >= chance => 1.0,
        Ok(it) => it.cdf(yes),
        Err(_) => f64::NAN,
    };
    Outcome {
        statistic: yes as f64,
        freedom: f64::NAN,
        p,
        effect: 2.0 * share.sqrt().asin() - 2.0 * chance.sqrt().asin(),
    }
}

/// Clopper and Pearson's exact interval of a share.
///
/// ```
/// let interval = host_sim::report::share_interval(20, 20);
/// assert!((interval.low - 0.831_57).abs() < 1e-4 && interval.high == 1.0);
/// ```
#[must_use]
pub fn share_interval(yes: u64, n: u64) -> Interval {
    if n == 0 {
        return Interval::NONE;
    }
    let tail = (1.0 - LEVEL) / 2.0;
    let (k, rest) = (yes as f64, n.saturating_sub(yes) as f64);
    let quantile =
        |a: f64, b: f64, q: f64| Beta::new(a, b).map_or(f64::NAN, |it| it.inverse_cdf(q));
    Interval {
        low: if yes == 0 {
            0.0
        } else {
            quantile(k, rest + 1.0, tail)
        },
        high: if yes >= n {
            1.0
        } else {
            quantile(k + 1.0, rest, 1.0 - tail)
        },
    }
}

/// The interval of a median between two order statistics, at least at [`LEVEL`]; the values may be
/// infinite, and `NONE` comes of fewer than six.
///
/// ```
/// let values: Vec<f64> = (1..=20).map(f64::from).collect();
/// let interval = host_sim::report::median_interval(&values);
/// assert_eq!((interval.low, interval.high), (6.0, 15.0));
/// ```
#[must_use]
pub fn median_interval(values: &[f64]) -> Interval {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as u64;
    let Ok(below) = Binomial::new(0.5, n) else {
        return Interval::NONE;
    };
    // The most values that may lie outside on each side.
    let outside = (0..n).take_while(|&k| below.cdf(k) <= (1.0 - LEVEL) / 2.0);
    match outside.last() {
        Some(k) => {
            let at = |place: u64| sorted.get(place as usize).copied().unwrap_or(f64::NAN);
            Interval {
                low: at(k),
                high: at(n - 1 - k),
            }
        }
        None => Interval::NONE,
    }
}

/// The interval of a ratio of means: pairs are drawn again with replacement, and the middle of the
/// ratios of their means is kept (percentile bootstrap).
///
/// ```
/// let interval = host_sim::report::ratio_interval(&[2.0, 4.0, 6.0], &[1.0, 2.0, 3.0]);
/// assert_eq!((interval.low, interval.high), (2.0, 2.0));
/// ```
#[must_use]
pub fn ratio_interval(above: &[f64], below: &[f64]) -> Interval {
    let pairs: Vec<(f64, f64)> = above.iter().copied().zip(below.iter().copied()).collect();
    if pairs.len() < 2 {
        return Interval::NONE;
    }
    let mut state = RESAMPLING;
    let mut ratios = Vec::with_capacity(RESAMPLES as usize);
    for _ in 0..RESAMPLES {
        let (mut sum, mut whole) = (0.0, 0.0);
        for _ in 0..pairs.len() {
            let drawn = draw(&mut state, pairs.len());
            if let Some((above, below)) = pairs.get(drawn) {
                sum += above;
                whole += below;
            }
        }
        ratios.push(sum / whole);
    }
    if ratios.iter().any(|it| !it.is_finite()) {
        return Interval::NONE;
    }
    let tail = (1.0 - LEVEL) / 2.0;
    Interval {
        low: super::statistics::quantile(&ratios, tail),
        high: super::statistics::quantile(&ratios, 1.0 - tail),
    }
}

/// A number below `bound`, by SplitMix64 (Steele, Lea and Flood 2014): a report has a generator of
/// its own, so that no brain's draws hang on what is reported of it.
fn draw(state: &mut u64, bound: usize) -> usize {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut mixed = *state;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^= mixed >> 31;
    ((u128::from(mixed) * bound as u128) >> 64) as usize
}

/// Holm's correction of the probabilities of one family, in their order; NaN stays, and is no member.
///
/// ```
/// let corrected = host_sim::report::holm(&[0.01, 0.04, 0.03]);
/// assert_eq!(corrected, [0.03, 0.06, 0.06]);
/// ```
#[must_use]
pub fn holm(probabilities: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..probabilities.len())
        .filter(|&index| probabilities.get(index).is_some_and(|p| !p.is_nan()))
        .collect();
    let at = |index: usize| probabilities.get(index).copied().unwrap_or(f64::NAN);
    order.sort_by(|&a, &b| at(a).total_cmp(&at(b)));
    let mut corrected = vec![f64::NAN; probabilities.len()];
    let mut least = 0.0_f64;
    for (rank, &index) in order.iter().enumerate() {
        least = least.max(at(index) * (order.len() - rank) as f64).min(1.0);
        if let Some(place) = corrected.get_mut(index) {
            *place = least;
        }
    }
    corrected
}

#[cfg(test)]
#[path = "inference_tests.rs"]
mod tests;
