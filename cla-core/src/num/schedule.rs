//! How a learning rate or a neighbourhood width falls while a map is trained (book, 2.2, 6.2.4).

use core::fmt;

use super::{exp, ln};

/// A parameter as a function of the number of samples that a map has seen.
///
/// ```
/// use cla_core::num::Schedule;
/// // The book's learning rate: "from 0.3 to 0.01" (6.2.4).
/// let alpha = Schedule::linear(0.3, 0.01, 10_000).unwrap();
/// assert_eq!(alpha.at(0), 0.3);
/// assert_eq!(alpha.at(20_000), 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    from: f32,
    to: f32,
    shape: Shape,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Linear { steps: u32 },
    Geometric { steps: u32 },
    Decay { time_constant: f32 },
}

/// Why a [`Schedule`] could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScheduleError {
    /// A value or time constant is NaN or infinite.
    NotFinite,
    /// A value is negative, or a geometric schedule starts or ends at 0.
    OutOfRange,
    /// The number of steps or the time constant is 0.
    NoSteps,
}

impl fmt::Display for ScheduleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "a schedule's values must be finite",
            Self::OutOfRange => {
                "a schedule's values must not be negative, and a geometric one's must be above 0"
            }
            Self::NoSteps => "a schedule needs at least one step",
        })
    }
}

impl core::error::Error for ScheduleError {}

impl Schedule {
    /// Always 0, and all of its bytes are 0: what a static brain holds before it is started.
    pub const ZERO: Self = Self {
        from: 0.0,
        to: 0.0,
        shape: Shape::Linear { steps: 0 },
    };

    /// Always `value`.
    ///
    /// # Errors
    /// [`ScheduleError`] when `value` is negative or not finite.
    pub const fn constant(value: f32) -> Result<Self, ScheduleError> {
        Self::linear(value, value, 1)
    }

    /// A straight line from `from` at sample 0 to `to` at sample `steps`, constant afterwards.
    ///
    /// # Errors
    /// [`ScheduleError`] when a value is negative or not finite or `steps` is 0.
    pub const fn linear(from: f32, to: f32, steps: u32) -> Result<Self, ScheduleError> {
        match checked(from, to, steps) {
            Ok(()) => Ok(Self {
                from,
                to,
                shape: Shape::Linear { steps },
            }),
            Err(error) => Err(error),
        }
    }

    /// A constant factor a sample, from `from` at sample 0 to `to` at sample `steps`, constant afterwards.
    ///
    /// # Errors
    /// [`ScheduleError`] when a value is not above 0 or not finite or `steps` is 0.
    pub const fn geometric(from: f32, to: f32, steps: u32) -> Result<Self, ScheduleError> {
        if from == 0.0 || to == 0.0 {
            return Err(ScheduleError::OutOfRange);
        }
        match checked(from, to, steps) {
            Ok(()) => Ok(Self {
                from,
                to,
                shape: Shape::Geometric { steps },
            }),
            Err(error) => Err(error),
        }
    }

    /// Falls from `from` towards `to` as `to + (from − to)·exp(−t / time_constant)`, without an end.
    ///
    /// The form for a robot that never stops learning: no number of samples has to be known.
    ///
    /// # Errors
    /// [`ScheduleError`] when a value is negative or not finite or `time_constant` is not above 0.
    pub const fn decay(from: f32, to: f32, time_constant: f32) -> Result<Self, ScheduleError> {
        if !time_constant.is_finite() {
            return Err(ScheduleError::NotFinite);
        }
        if time_constant <= 0.0 {
            return Err(ScheduleError::NoSteps);
        }
        match checked(from, to, 1) {
            Ok(()) => Ok(Self {
                from,
                to,
                shape: Shape::Decay { time_constant },
            }),
            Err(error) => Err(error),
        }
    }

    /// The value after `samples` samples; always between the two ends.
    #[must_use]
    pub fn at(&self, samples: u32) -> f32 {
        match self.shape {
            Shape::Linear { steps } if samples < steps => {
                self.from + (self.to - self.from) * (samples as f32 / steps as f32)
            }
            Shape::Geometric { steps } if samples < steps => {
                let share = samples as f32 / steps as f32;
                // from·(to/from)^share.
                self.from * exp(share * ln(self.to / self.from))
            }
            Shape::Linear { .. } | Shape::Geometric { .. } => self.to,
            Shape::Decay { time_constant } => {
                self.to + (self.from - self.to) * exp(-(samples as f32) / time_constant)
            }
        }
    }
}

const fn checked(from: f32, to: f32, steps: u32) -> Result<(), ScheduleError> {
    if !from.is_finite() || !to.is_finite() {
        Err(ScheduleError::NotFinite)
    } else if from < 0.0 || to < 0.0 {
        Err(ScheduleError::OutOfRange)
    } else if steps == 0 {
        Err(ScheduleError::NoSteps)
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Schedule, ScheduleError};

    #[test]
    fn a_linear_schedule_is_halfway_at_half_time() {
        let schedule = Schedule::linear(15.0, 0.0, 1000).unwrap();
        assert_eq!(schedule.at(500), 7.5);
        assert_eq!(schedule.at(1000), 0.0);
        assert_eq!(schedule.at(u32::MAX), 0.0);
    }

    #[test]
    fn a_geometric_schedule_passes_its_geometric_mean_at_half_time() {
        let schedule = Schedule::geometric(8.0, 0.5, 100).unwrap();
        assert!((schedule.at(50) - 2.0).abs() < 1e-5);
        assert_eq!(schedule.at(0), 8.0);
        assert_eq!(schedule.at(100), 0.5);
    }

    #[test]
    fn a_decay_has_lost_63_percent_after_its_time_constant() {
        let schedule = Schedule::decay(1.0, 0.0, 600.0).unwrap();
        assert!((schedule.at(600) - 0.367_879_44).abs() < 1e-6);
    }

    #[test]
    fn the_zero_schedule_is_zero_at_every_sample() {
        assert_eq!(Schedule::ZERO.at(0), 0.0);
        assert_eq!(Schedule::ZERO.at(u32::MAX), 0.0);
    }

    #[test]
    fn impossible_schedules_are_refused() {
        assert_eq!(
            Schedule::linear(f32::NAN, 0.0, 1),
            Err(ScheduleError::NotFinite)
        );
        assert_eq!(
            Schedule::linear(0.1, -0.1, 1),
            Err(ScheduleError::OutOfRange)
        );
        assert_eq!(
            Schedule::geometric(1.0, 0.0, 10),
            Err(ScheduleError::OutOfRange)
        );
        assert_eq!(Schedule::linear(1.0, 0.0, 0), Err(ScheduleError::NoSteps));
        assert_eq!(Schedule::decay(1.0, 0.0, 0.0), Err(ScheduleError::NoSteps));
    }
}
