//! Scales: where a number lies on an axis, and which numbers are written at it.

/// One axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    pub(super) low: f64,
    pub(super) high: f64,
    /// Equal distances are equal factors.
    pub(super) log: bool,
}

impl Scale {
    /// A scale from one end to the other; `None` when there is nothing between them.
    pub(super) fn new((low, high): (f64, f64), log: bool) -> Option<Self> {
        let possible = low.is_finite() && high.is_finite() && low < high && (!log || low > 0.0);
        possible.then_some(Self { low, high, log })
    }

    /// How far along the axis a number lies; 0 and 1 are its ends, beyond which nothing lies.
    pub(super) fn share(&self, value: f64) -> f64 {
        let along = |it: f64| {
            if self.log {
                libm::log(it.max(self.low))
            } else {
                it
            }
        };
        let (low, high) = (along(self.low), along(self.high));
        ((along(value) - low) / (high - low)).clamp(0.0, 1.0)
    }

    /// Round numbers on the axis, at most so many.
    pub(super) fn ticks(&self, most: usize) -> Vec<f64> {
        if self.log {
            self.factors(most)
        } else {
            self.steps(most)
        }
    }

    fn steps(&self, most: usize) -> Vec<f64> {
        let least = (self.high - self.low) / most.max(1) as f64;
        let magnitude = libm::pow(10.0, libm::log10(least).floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|it| it * magnitude);
        let step = step.into_iter().find(|&it| it >= least * 0.999);
        let step = step.unwrap_or(10.0 * magnitude);
        let slack = step * 1e-6;
        let first = ((self.low - slack) / step).ceil() as i64;
        let last = ((self.high + slack) / step).floor() as i64;
        (first..=last).map(|it| it as f64 * step).collect()
    }

    /// 1, 10, 100; where that gives fewer than three, also 2 and 5 and their tens.
    fn factors(&self, most: usize) -> Vec<f64> {
        let from = libm::log10(self.low).floor() as i32;
        let to = libm::log10(self.high).ceil() as i32;
        let within = |digits: &[f64]| -> Vec<f64> {
            (from..=to)
                .flat_map(|power| {
                    digits
                        .iter()
                        .map(move |digit| digit * libm::pow(10.0, f64::from(power)))
                })
                .filter(|it| (self.low * 0.999..=self.high * 1.001).contains(it))
                .collect()
        };
        let tens = within(&[1.0]);
        let all = match tens.len() {
            0..=2 => within(&[1.0, 2.0, 5.0]),
            _ => tens,
        };
        let every = all.len().div_ceil(most.max(1)).max(1);
        all.into_iter().step_by(every).collect()
    }
}

/// A number at an axis: without zeros that say nothing, thousands apart.
pub(super) fn label(value: f64) -> String {
    let text = format!("{:.6}", value.abs());
    let (whole, part) = text.split_once('.').unwrap_or((&text, ""));
    let part = part.trim_end_matches('0');
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) && whole.len() > 4 {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    if !part.is_empty() {
        grouped.push('.');
        grouped.push_str(part);
    }
    if value < 0.0 && grouped != "0" {
        grouped.insert(0, '−');
    }
    grouped
}

#[cfg(test)]
mod tests {
    use super::{Scale, label};

    #[test]
    fn ticks_are_round_numbers_within_the_axis() {
        let scale = |low, high, log| Scale::new((low, high), log).unwrap();
        assert_eq!(
            scale(0.0, 28.0, false).ticks(6),
            [0.0, 5.0, 10.0, 15.0, 20.0, 25.0]
        );
        assert_eq!(
            scale(-3000.0, 13000.0, false).ticks(4),
            [0.0, 5000.0, 10000.0]
        );
        assert_eq!(scale(1000.0, 100_000.0, true).ticks(9), [1e3, 1e4, 1e5]);
        assert_eq!(scale(3.0, 60.0, true).ticks(9), [5.0, 10.0, 20.0, 50.0]);
        assert_eq!(scale(1.0, 1e12, true).ticks(5).len(), 5);
        for most in 1..20 {
            assert!(scale(0.1, 0.83, false).ticks(most).len() <= most + 1);
        }
        assert!(Scale::new((1.0, 1.0), false).is_none());
        assert!(Scale::new((0.0, 1.0), true).is_none());
        assert_eq!(scale(1.0, 100.0, true).share(10.0), 0.5);
        assert_eq!(scale(1.0, 100.0, true).share(-3.0), 0.0);
    }

    #[test]
    fn numbers_are_written_as_people_write_them() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.25, "0.25"),
            (-0.5, "−0.5"),
            (3000.0, "3000"),
            (10_000.0, "10,000"),
            (1_000_000.0, "1,000,000"),
        ] {
            assert_eq!(label(value), text);
        }
    }
}
