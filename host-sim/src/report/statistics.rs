//! The few statistics that claims and figures need, over slices of seeds.
//!
//! Without enough values the answer is NaN, never a panic; NaN reaches no JSON file because
//! claims write it as `null`.
//! Distributions come from `statrs`.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// The arithmetic mean; NaN without values.
///
/// ```
/// assert_eq!(host_sim::report::mean(&[1.0, 2.0, 6.0]), 3.0);
/// ```
#[must_use]
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The standard deviation of a sample (divided by n − 1); NaN for fewer than two values, which tell
/// nothing of how much they vary.
///
/// ```
/// assert_eq!(host_sim::report::sample_sd(&[2.0, 4.0, 6.0]), 2.0);
/// ```
#[must_use]
pub fn sample_sd(values: &[f64]) -> f64 {
    if values.len() < 2 {
        return f64::NAN;
    }
    variance(values).sqrt()
}

fn variance(values: &[f64]) -> f64 {
    let centre = mean(values);
    let squares: f64 = values.iter().map(|value| (value - centre).powi(2)).sum();
    squares / (values.len() as f64 - 1.0)
}

/// The quantile `q` in `[0, 1]`, interpolated between order statistics (R's type 7).
///
/// NaN values sort last; NaN without values.
///
/// ```
/// assert_eq!(host_sim::report::quantile(&[3.0, 1.0, 2.0, 4.0], 0.25), 1.75);
/// ```
#[must_use]
pub fn quantile(values: &[f64], q: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else {
        return f64::NAN;
    };
    let place = q.clamp(0.0, 1.0) * last as f64;
    let below = place.floor() as usize;
    let above = (below + 1).min(last);
    let share = place - below as f64;
    if share == 0.0 {
        return sorted[below];
    }
    sorted[below] + share * (sorted[above] - sorted[below])
}

/// The median; of an even number of values the middle of the two in the middle.
#[must_use]
pub fn median(values: &[f64]) -> f64 {
    quantile(values, 0.5)
}

/// A range of plausible values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Interval {
    /// No interval: too few values for one.
    pub const NONE: Self = Self {
        low: f64::NAN,
        high: f64::NAN,
    };
}

/// Student's confidence interval of the mean at a level such as 0.95.
///
/// Fewer than two values give NaN.
///
/// ```
/// let band = host_sim::report::confidence_interval(&[9.0, 10.0, 11.0], 0.95);
/// assert!((band.high - 12.484).abs() < 1e-3);
/// ```
#[must_use]
pub fn confidence_interval(values: &[f64], level: f64) -> Interval {
    let centre = mean(values);
    if values.len() < 2 {
        return Interval::NONE;
    }
    let n = values.len() as f64;
    let half = student_quantile(0.5 + level / 2.0, n - 1.0) * sample_sd(values) / n.sqrt();
    Interval {
        low: centre - half,
        high: centre + half,
    }
}

fn student_quantile(probability: f64, freedom: f64) -> f64 {
    StudentsT::new(0.0, 1.0, freedom).map_or(f64::NAN, |t| t.inverse_cdf(probability))
}

/// The outcome of Welch's t test of two means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Welch {
    /// The statistic; positive when the first mean is the larger.
    pub t: f64,
    /// Welch–Satterthwaite degrees of freedom.
    pub freedom: f64,
    /// The two-sided probability of a difference at least as large by chance.
    pub p: f64,
}

/// Welch's t test: do two samples with unequal variances have the same mean?
///
/// Two samples without any variance give t = ±∞ and p = 0 when they differ, NaN when they agree.
///
/// ```
/// let outcome = host_sim::report::welch_t(&[5.1, 4.9, 5.6, 5.2], &[4.1, 4.4, 3.9, 4.6]);
/// assert!((outcome.t - 4.4374).abs() < 1e-4 && (outcome.p - 0.004_419).abs() < 1e-6);
/// ```
#[must_use]
pub fn welch_t(a: &[f64], b: &[f64]) -> Welch {
    let (n, m) = (a.len() as f64, b.len() as f64);
    let (u, v) = (variance(a) / n, variance(b) / m);
    let t = (mean(a) - mean(b)) / (u + v).sqrt();
    if t.is_infinite() {
        return Welch {
            t,
            freedom: n + m - 2.0,
            p: 0.0,
        };
    }
    let freedom = (u + v).powi(2) / (u * u / (n - 1.0) + v * v / (m - 1.0));
    let p = match StudentsT::new(0.0, 1.0, freedom) {
        Ok(student) if t.is_finite() => 2.0 * student.sf(t.abs()),
        _ => f64::NAN,
    };
    Welch { t, freedom, p }
}

/// Cohen's d: the difference of two means in pooled standard deviations.
///
/// ```
/// let d = host_sim::report::cohens_d(&[3.0, 4.0, 5.0], &[1.0, 2.0, 3.0]);
/// assert_eq!(d, 2.0);
/// ```
#[must_use]
pub fn cohens_d(a: &[f64], b: &[f64]) -> f64 {
    let (n, m) = (a.len() as f64 - 1.0, b.len() as f64 - 1.0);
    let pooled = (n * variance(a) + m * variance(b)) / (n + m);
    (mean(a) - mean(b)) / pooled.sqrt()
}

#[cfg(test)]
mod tests {
    use super::{cohens_d, confidence_interval, mean, median, quantile, sample_sd, welch_t};

    #[test]
    fn welch_agrees_with_scipy_on_unequal_variances_and_sizes() {
        // scipy.stats.ttest_ind(a, b, equal_var=False) of SciPy 1.17.1.
        let a = [27.5, 21.0, 19.0, 23.6, 17.0, 17.9, 16.9, 20.1, 21.9, 22.6];
        let b = [27.1, 22.0, 20.8, 23.4, 23.4, 23.5, 25.8];
        let outcome = welch_t(&a, &b);
        assert!(
            (outcome.t - -2.238_026_715_476_236_6).abs() < 1e-12,
            "{outcome:?}"
        );
        assert!(
            (outcome.p - 0.040_864_925_250_480_59).abs() < 1e-9,
            "{outcome:?}"
        );
    }

    #[test]
    fn too_few_values_give_nan_and_never_panic() {
        assert!(mean(&[]).is_nan() && median(&[]).is_nan() && sample_sd(&[]).is_nan());
        assert!(welch_t(&[1.0], &[2.0, 3.0]).p.is_nan());
        assert!(welch_t(&[1.0, 1.0], &[1.0, 1.0]).p.is_nan());
        assert!(cohens_d(&[], &[]).is_nan());
        assert!(confidence_interval(&[], 0.95).low.is_nan());
        assert!(sample_sd(&[4.0]).is_nan());
        assert!(confidence_interval(&[4.0], 0.95).high.is_nan());
        assert_eq!(welch_t(&[2.0, 2.0], &[1.0, 1.0]).p, 0.0);
    }

    #[test]
    fn quantiles_reach_both_ends() {
        let values = [5.0, 1.0, 3.0];
        assert_eq!(quantile(&values, 0.0), 1.0);
        assert_eq!(quantile(&values, 1.0), 5.0);
        assert_eq!(median(&[4.0, 1.0]), 2.5);
    }
}
