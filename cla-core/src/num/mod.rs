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

#[cfg(test)]
mod tests {
    use super::{exp, ln, sqrt};

    #[test]
    fn the_functions_are_what_their_names_say_within_a_thousandth() {
        // The approximations of the feature `micromath` are within some thousandths.
        let within = if cfg!(feature = "micromath") {
            2e-2
        } else {
            1e-6
        };
        for x in [-3.0_f32, -0.5, 0.0, 0.25, 1.0, 2.5] {
            let exact = f64::from(x).exp();
            assert!(
                (f64::from(exp(x)) - exact).abs() < within * exact.max(1.0),
                "exp {x}"
            );
        }
        for x in [0.01_f32, 0.5, 1.0, 3.0, 250.0] {
            let (log, root) = (f64::from(x).ln(), f64::from(x).sqrt());
            assert!(
                (f64::from(ln(x)) - log).abs() < within * log.abs().max(1.0),
                "ln {x}"
            );
            assert!(
                (f64::from(sqrt(x)) - root).abs() < within * root.max(1.0),
                "sqrt {x}"
            );
        }
    }
}
