//! The only arithmetic the brain uses: exponential, Gaussian table, random numbers, schedules.
//!
//! Everything here gives the same bits on every target: plain `f32` operations in a written order,
//! no fused multiply-add, no float function of `std`.
//! With the feature `micromath` the functions are that crate's approximations: fast where floats are
//! functions, and another life, because every result differs in its last bits or more.
//! It knows nothing of maps or schemas (book, chapter 2, for what the maps need).

#[cfg_attr(feature = "micromath", path = "functions_inexact.rs")]
mod functions;
mod gaussian;
mod ones;
pub(crate) mod ordered;
mod rng;
mod schedule;

pub use gaussian::{GaussianError, Neighbourhood};
pub use ones::Ones;
pub use rng::Rng;
pub use schedule::{Schedule, ScheduleError};

/// `e` to the power of `x`, to within one unit in the last place, with the same bits on every target;
/// with the feature `micromath` neither.
///
/// Source: the portable `expf` of the `libm` crate (a port of musl's).
/// Range: every `f32`; overflows to infinity above about 88.7 and underflows to 0 below about −103.9.
///
/// ```
/// assert_eq!(cla_core::num::exp(0.0), 1.0);
/// assert!((cla_core::num::exp(-1.0) - 0.367_879_44).abs() < 1e-7);
/// ```
#[must_use]
pub fn exp(x: f32) -> f32 {
    functions::exp(x)
}

/// Correctly rounded square root, with the same bits on every target; with the feature `micromath`
/// neither.
///
/// Only reports need it: the maps compare squared distances.
///
/// ```
/// assert_eq!(cla_core::num::sqrt(2.25), 1.5);
/// ```
#[must_use]
pub fn sqrt(x: f32) -> f32 {
    functions::sqrt(x)
}

/// The natural logarithm, to within one unit in the last place, with the same bits on every target;
/// with the feature `micromath` neither.
///
/// Source: the portable `logf` of the `libm` crate (a port of musl's).
/// Range: every `f32`; −∞ at 0, NaN below.
///
/// ```
/// assert_eq!(cla_core::num::ln(1.0), 0.0);
/// assert!((cla_core::num::ln(0.5) + 0.693_147_2).abs() < 1e-7);
/// ```
#[must_use]
pub fn ln(x: f32) -> f32 {
    functions::ln(x)
}
