//! What is asked of every configuration before it may work, and the error when it cannot.
//!
//! One style for all of them: each configuration is a plain struct of public fields, made by
//! `..DEFAULT` from a constant and changed at will; [`Config::check`] asks every field in its order,
//! and who keeps one keeps it as [`Checked`], which cannot be made otherwise.

use core::fmt::{self, Write as _};
use core::ops::Deref;

use crate::snapshot::{LARGEST, LARGEST_VALUE};

/// The numbers that a field may hold; NaN, infinity and what lies beyond 10²⁰ never are among them:
/// sums of such numbers stay finite.
///
/// ```
/// use cla_core::check::Range;
/// assert!(Range::SHARE.contains(1.0) && !Range::BELOW_ONE.contains(1.0));
/// assert!(!Range::ABOVE_ZERO.contains(f32::INFINITY) && !Range::SHARE.contains(f32::NAN));
/// assert_eq!(Range::BELOW_ONE.to_string(), "at least 0 and below 1");
/// assert_eq!(Range::ABOVE_ZERO.to_string(), "above 0 and at most 1e20");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Range {
    least: f32,
    least_included: bool,
    most: f32,
    most_included: bool,
}

impl Range {
    /// From 0 to 1, both included.
    pub const SHARE: Self = Self::of(0.0, true, 1.0, true);
    /// From 0 to 1, 1 excluded.
    pub const BELOW_ONE: Self = Self::of(0.0, true, 1.0, false);
    /// Above 0.
    pub const ABOVE_ZERO: Self = Self::above(0.0);
    /// At least 0.
    pub const NOT_NEGATIVE: Self = Self::of(0.0, true, LARGEST, true);
    /// At least 1: for counts of which there must be one.
    pub const AT_LEAST_ONE: Self = Self::of(1.0, true, LARGEST, true);
    /// What an item may be worth for its own sake: from 0 to 10⁹, so that values stay far from the end
    /// of their numbers even where nothing is discounted.
    pub const VALUE: Self = Self::of(0.0, true, LARGEST_VALUE, true);

    const fn of(least: f32, least_included: bool, most: f32, most_included: bool) -> Self {
        Self {
            least,
            least_included,
            most,
            most_included,
        }
    }

    /// Above a number.
    #[must_use]
    pub const fn above(least: f32) -> Self {
        Self::of(least, false, LARGEST, true)
    }

    /// At least 0 and below a number.
    #[must_use]
    pub const fn below(most: f32) -> Self {
        Self::of(0.0, true, most, false)
    }

    /// Whether a number is one of them.
    #[must_use]
    pub const fn contains(&self, value: f32) -> bool {
        (value > self.least || (self.least_included && value >= self.least))
            && (value < self.most || (self.most_included && value <= self.most))
    }

    /// The value, if it is one of them.
    ///
    /// # Errors
    /// [`ConfigError`] with that field.
    pub const fn check(self, field: &'static str, value: f32) -> Result<(), ConfigError> {
        if self.contains(value) {
            Ok(())
        } else {
            Err(ConfigError {
                field,
                value,
                range: self,
            })
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.least_included {
            "at least "
        } else {
            "above "
        })?;
        decimal(f, self.least)?;
        f.write_str(if self.most_included {
            " and at most "
        } else {
            " and below "
        })?;
        if self.most >= LARGEST {
            f.write_str("1e20")
        } else {
            decimal(f, self.most)
        }
    }
}

/// A configuration that cannot work: the first field that is out of its range.
///
/// ```
/// use cla_core::AgentConfig;
/// use cla_core::check::{Config, Range};
/// let config = AgentConfig { greedy_share: 1.5, ..AgentConfig::FORAGER };
/// let error = config.check().unwrap_err();
/// assert_eq!((error.field, error.value, error.range), ("AgentConfig::greedy_share", 1.5, Range::SHARE));
/// assert_eq!(
///     error.to_string(),
///     "AgentConfig::greedy_share is 1.5 and must be at least 0 and at most 1"
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct ConfigError {
    /// The type and its field.
    pub field: &'static str,
    /// What it holds; a count as the nearest number.
    pub value: f32,
    /// What it may hold.
    pub range: Range,
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.field)?;
        f.write_str(" is ")?;
        decimal(f, self.value)?;
        f.write_str(" and must be ")?;
        self.range.fmt(f)
    }
}

impl core::error::Error for ConfigError {}

/// A configuration that can say whether it works.
///
/// ```
/// use cla_core::check::Config;
/// use cla_core::choice::HabitConfig;
/// let habits = HabitConfig { weight: 0.3, ..HabitConfig::FORAGER }.checked()?;
/// assert_eq!(habits.weight, 0.3);
/// # Ok::<(), cla_core::ConfigError>(())
/// ```
pub trait Config: Copy {
    /// Whether every field is in its range.
    ///
    /// # Errors
    /// [`ConfigError`] for the first that is not.
    fn check(&self) -> Result<(), ConfigError>;

    /// The same configuration, known to work.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    fn checked(self) -> Result<Checked<Self>, ConfigError> {
        self.check()?;
        Ok(Checked(self))
    }
}

/// A configuration that was checked; [`Config::checked`] alone makes one, and nobody changes it.
///
/// ```
/// use cla_core::AgentConfig;
/// use cla_core::check::{Checked, Config};
/// let config: Checked<AgentConfig> = AgentConfig::FORAGER.checked()?;
/// assert_eq!(config.training_run, 50);
/// # Ok::<(), cla_core::ConfigError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Checked<C>(pub(crate) C);

impl<C> Deref for Checked<C> {
    type Target = C;

    #[inline]
    fn deref(&self) -> &C {
        &self.0
    }
}

/// Checks what is there; what is absent is no fault.
pub(crate) fn check_some<C: Config>(config: &Option<C>) -> Result<(), ConfigError> {
    config.as_ref().map_or(Ok(()), C::check)
}

/// Writes a number without the code that formats any float: at most six decimals.
fn decimal(f: &mut fmt::Formatter<'_>, value: f32) -> fmt::Result {
    if value.is_nan() {
        return f.write_str("NaN");
    }
    if value < 0.0 {
        f.write_char('-')?;
    }
    let size = value.abs();
    if size > LARGEST_VALUE {
        return f.write_str(if size.is_finite() { "huge" } else { "infinite" });
    }
    // Exact: a float of this size has at most 24 bits before or behind its point.
    let whole = size as u32;
    let mut rest = ((size - whole as f32) * 1e6 + 0.5) as u32;
    let carried = rest / 1_000_000;
    rest %= 1_000_000;
    write!(f, "{}", whole + carried)?;
    if rest > 0 {
        f.write_char('.')?;
    }
    let mut place = 100_000;
    while rest > 0 && place > 0 {
        f.write_char(char::from(b'0' + (rest / place) as u8))?;
        rest %= place;
        place /= 10;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Config, ConfigError, Range};
    use crate::agent::AgentConfig;
    use std::string::ToString;

    #[test]
    fn an_error_says_field_value_and_range_in_a_sentence() {
        for (value, text) in [
            (1.5, "1.5"),
            (-0.25, "-0.25"),
            (f32::NAN, "NaN"),
            (f32::NEG_INFINITY, "-infinite"),
            (1e30, "huge"),
            (0.999_999_9, "1"),
            (16_777_216.0, "16777216"),
            (0.000_001, "0.000001"),
        ] {
            let range = Range::above(2.5);
            let error = ConfigError {
                field: "It::field",
                value,
                range,
            };
            let sentence =
                std::format!("It::field is {text} and must be above 2.5 and at most 1e20");
            assert_eq!(error.to_string(), sentence);
        }
    }

    #[test]
    fn every_constant_configuration_works() {
        for config in [
            AgentConfig::BOOK,
            AgentConfig::FORAGER,
            AgentConfig::FORAGER_LEVEL2,
            AgentConfig::RESILIENT,
            AgentConfig::RESILIENT_LEVEL2,
            AgentConfig::FORAGER_LASTING,
            AgentConfig::RESILIENT_LASTING,
        ] {
            assert_eq!(config.check(), Ok(()));
        }
    }
}
