//! How a learning rate or a neighbourhood width falls while a map is trained (book, 2.2, 6.2.4).

use core::fmt;

use super::{exp, ln};
use crate::snapshot::{Flip, Reader, Stored, Writer, stored};

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
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "written::Written", into = "written::Written")
)]
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

/// The form in which a schedule is written and read: the name of its function and what that takes.
#[cfg(feature = "serde")]
mod written {
    use super::{Schedule, ScheduleError, Shape};

    #[derive(serde::Serialize, serde::Deserialize)]
    #[serde(rename_all = "snake_case", deny_unknown_fields)]
    pub(super) enum Written {
        Linear {
            from: f32,
            to: f32,
            steps: u32,
        },
        Geometric {
            from: f32,
            to: f32,
            steps: u32,
        },
        Decay {
            from: f32,
            to: f32,
            time_constant: f32,
        },
    }

    impl From<Schedule> for Written {
        fn from(it: Schedule) -> Self {
            let Schedule { from, to, shape } = it;
            match shape {
                Shape::Linear { steps } => Self::Linear { from, to, steps },
                Shape::Geometric { steps } => Self::Geometric { from, to, steps },
                Shape::Decay { time_constant } => Self::Decay {
                    from,
                    to,
                    time_constant,
                },
            }
        }
    }

    impl TryFrom<Written> for Schedule {
        type Error = ScheduleError;

        fn try_from(it: Written) -> Result<Self, ScheduleError> {
            match it {
                Written::Linear { from, to, steps } => Self::linear(from, to, steps),
                Written::Geometric { from, to, steps } => Self::geometric(from, to, steps),
                Written::Decay {
                    from,
                    to,
                    time_constant,
                } => Self::decay(from, to, time_constant),
            }
        }
    }
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

    /// Whether one of the functions above could have made it.
    fn can_be(&self) -> bool {
        let made = match self.shape {
            Shape::Linear { steps } => Self::linear(self.from, self.to, steps),
            Shape::Geometric { steps } => Self::geometric(self.from, self.to, steps),
            Shape::Decay { time_constant } => Self::decay(self.from, self.to, time_constant),
        };
        *self == Self::ZERO || made.is_ok()
    }

    /// The largest value that it may have: the larger of its ends.
    pub(crate) const fn most(&self) -> f32 {
        if self.from < self.to {
            self.to
        } else {
            self.from
        }
    }

    /// The value after `samples` samples; always between the two ends.
    #[must_use]
    pub fn at(&self, samples: u32) -> f32 {
        let value = match self.shape {
            Shape::Linear { steps } if samples < steps => {
                self.from + (self.to - self.from) * (samples as f32 / steps as f32)
            }
            Shape::Geometric { steps } if samples < steps => {
                let share = samples as f32 / steps as f32;
                let ratio = self.to / self.from;
                if ratio >= f32::MIN_POSITIVE && ratio.is_finite() {
                    // from·(to/from)^share.
                    self.from * exp(share * ln(ratio))
                } else {
                    exp(ln(self.from) + share * (ln(self.to) - ln(self.from)))
                }
            }
            Shape::Linear { .. } | Shape::Geometric { .. } => self.to,
            Shape::Decay { time_constant } => {
                self.to + (self.from - self.to) * exp(-(samples as f32) / time_constant)
            }
        };
        // Rounding may lead past an end.
        let (least, most) = if self.from < self.to {
            (self.from, self.to)
        } else {
            (self.to, self.from)
        };
        if value < least {
            least
        } else if value > most {
            most
        } else {
            value
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

stored! {
    impl[] Schedule { from, to, shape }
    sound |it, _limits| it.can_be()
}

impl Stored for Shape {
    const BLANK: Self = Self::Linear { steps: 0 };

    fn store(&self, to: &mut Writer<'_>) {
        match self {
            Self::Linear { steps } => (0_u8, *steps).store(to),
            Self::Geometric { steps } => (1_u8, *steps).store(to),
            Self::Decay { time_constant } => (2_u8, *time_constant).store(to),
        }
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        let (mut kind, mut steps, mut time_constant) = (0_u8, 0, 0.0);
        kind.restore(from);
        match kind {
            0 | 1 => steps.restore(from),
            2 => time_constant.restore(from),
            _ => from.refuse(),
        }
        *self = match kind {
            0 => Self::Linear { steps },
            1 => Self::Geometric { steps },
            _ => Self::Decay { time_constant },
        };
    }

    fn flip(&mut self, by: &mut Flip) {
        if by.field(8) == Some(0) {
            *self = match *self {
                Self::Linear { steps } => Self::Geometric { steps },
                Self::Geometric { steps } => Self::Linear { steps },
                decay @ Self::Decay { .. } => decay,
            };
        }
        match self {
            Self::Linear { steps } | Self::Geometric { steps } => steps.flip(by),
            Self::Decay { time_constant } => time_constant.flip(by),
        }
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

    #[test]
    fn a_line_rises_and_falls_between_its_ends() {
        let falls = Schedule::linear(0.3, 0.1, 400).unwrap();
        let rises = Schedule::linear(1.0, 3.0, 4).unwrap();
        assert!((falls.at(100) - 0.25).abs() < 1e-6 && (falls.at(300) - 0.15).abs() < 1e-6);
        assert_eq!(
            [0, 1, 2, 3, 4, 5].map(|t| rises.at(t)),
            [1.0, 1.5, 2.0, 2.5, 3.0, 3.0]
        );
        assert_eq!(falls.at(400), 0.1);
        let always = Schedule::constant(0.7).unwrap();
        assert_eq!([0, 1, u32::MAX].map(|t| always.at(t)), [0.7; 3]);
    }

    #[test]
    fn a_geometric_schedule_loses_the_same_share_at_every_sample() {
        let it = Schedule::geometric(8.0, 0.5, 100).unwrap();
        for t in 0..100 {
            let share = it.at(t + 1) / it.at(t);
            assert!((share - 0.0625_f32.powf(0.01)).abs() < 1e-4, "{t}: {share}");
        }
        assert_eq!((it.at(100), it.at(u32::MAX)), (0.5, 0.5));
    }

    #[test]
    fn a_decay_comes_near_its_end_and_never_passes_it() {
        let it = Schedule::decay(1.0, 0.2, 600.0).unwrap();
        assert_eq!(it.at(0), 1.0);
        assert!((it.at(600) - (0.2 + 0.8 * 0.367_879_44)).abs() < 1e-6);
        assert!((it.at(1200) - (0.2 + 0.8 * 0.135_335_28)).abs() < 1e-6);
        assert_eq!(it.at(1_000_000), 0.2);
    }

    #[test]
    fn no_schedule_leaves_its_ends_however_far_they_are_apart() {
        let ends = [1e-45, 1e-38, 1e-30, 0.1, 0.3, 1.0, 1e30, f32::MAX];
        for (from, to) in ends.iter().flat_map(|&a| ends.map(|b| (a, b))) {
            for it in [
                Schedule::linear(from, to, 10),
                Schedule::geometric(from, to, 10),
                Schedule::decay(from, to, 3.0),
                Schedule::decay(from, to, 1e-45),
            ] {
                let it = it.unwrap();
                for t in [0, 1, 5, 9, 10, 11, 1000, u32::MAX] {
                    let value = it.at(t);
                    let inside = value >= from.min(to) && value <= from.max(to);
                    assert!(inside, "{it:?} at {t}: {value}");
                }
            }
        }
    }

    #[test]
    fn every_number_of_a_schedule_is_checked() {
        use ScheduleError::{NoSteps, NotFinite, OutOfRange};
        let linear = |from, to, steps| Schedule::linear(from, to, steps).err();
        assert_eq!(linear(0.0, 0.0, 1), None);
        assert_eq!(linear(-0.1, 0.1, 1), Some(OutOfRange));
        assert_eq!(linear(0.1, -0.1, 1), Some(OutOfRange));
        assert_eq!(linear(f32::INFINITY, 0.1, 1), Some(NotFinite));
        assert_eq!(linear(0.1, f32::NAN, 1), Some(NotFinite));
        let geometric = |from, to, steps| Schedule::geometric(from, to, steps).err();
        assert_eq!(geometric(1.0, 2.0, 1), None);
        assert_eq!(geometric(0.0, 1.0, 1), Some(OutOfRange));
        assert_eq!(geometric(1.0, 0.0, 1), Some(OutOfRange));
        assert_eq!(geometric(-1.0, 1.0, 1), Some(OutOfRange));
        assert_eq!(geometric(1.0, 1.0, 0), Some(NoSteps));
        let decay = |from, to, time| Schedule::decay(from, to, time).err();
        assert_eq!(decay(0.0, 0.0, 0.1), None);
        assert_eq!(decay(1.0, 0.0, -1.0), Some(NoSteps));
        assert_eq!(decay(1.0, 0.0, f32::NAN), Some(NotFinite));
        assert_eq!(decay(1.0, 0.0, f32::INFINITY), Some(NotFinite));
        assert_eq!(decay(1.0, -1.0, 1.0), Some(OutOfRange));
        for (error, word) in [
            (NotFinite, "finite"),
            (OutOfRange, "negative"),
            (NoSteps, "step"),
        ] {
            assert!(std::format!("{error}").contains(word));
        }
    }
}
