//! A point with the ends of its band: the mean of some seeds and how sure it is.

use crate::report::{confidence_interval, mean};

/// A point of a line, with the ends of its band where it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The horizontal place.
    pub x: f64,
    /// The height of the line.
    pub y: f64,
    /// The lower and upper end of the band.
    pub band: Option<(f64, f64)>,
}

impl Point {
    /// A point without a band.
    #[must_use]
    pub const fn at(x: f64, y: f64) -> Self {
        Self { x, y, band: None }
    }

    /// The mean of the seeds, with its 95 % confidence interval as the band; one seed has none.
    #[must_use]
    pub fn mean_of(x: f64, seeds: &[f64]) -> Self {
        let interval = confidence_interval(seeds, 0.95);
        Self {
            x,
            y: mean(seeds),
            band: (seeds.len() > 1).then_some((interval.low, interval.high)),
        }
    }

    /// The same point of what cannot be less than nothing: its band ends at 0.
    #[must_use]
    pub fn of_count(mut self) -> Self {
        self.band = self.band.map(|(low, high)| (low.max(0.0), high));
        self
    }
}
