//! The neighbourhood function of a map as two short tables (book, 2.2).
//!
//! h = exp(−‖r_c − r_i‖² / 2σ²) factors into a horizontal and a vertical Gaussian, so W + H
//! exponentials serve a map of W·H nodes.
//! Where an axis' factor is below a cut, h is 0 there: updates touch a rectangle around the winner.

use core::fmt;

use super::exp;

/// The neighbourhood of a winning node on a map of `WIDTH` × `HEIGHT` nodes.
///
/// ```
/// use cla_core::num::Neighbourhood;
/// let near = Neighbourhood::<20, 20>::gaussian(1.5, 0.01).unwrap();
/// assert_eq!(near.weight(0, 0), 1.0);
/// assert!(near.weight(1, 0) > near.weight(1, 1));
/// assert_eq!(near.horizontal_radius(), 4); // exp(−4²/2·1.5²) = .029, exp(−5²/2·1.5²) = .004
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Neighbourhood<const WIDTH: usize, const HEIGHT: usize> {
    horizontal: [f32; WIDTH],
    vertical: [f32; HEIGHT],
    horizontal_radius: u16,
    vertical_radius: u16,
}

/// Why a [`Neighbourhood`] could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GaussianError {
    /// σ is negative, NaN or infinite.
    Sigma,
    /// The cut is negative, above 1 or NaN.
    Cut,
}

impl fmt::Display for GaussianError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sigma => "a neighbourhood's width must be finite and not negative",
            Self::Cut => "a neighbourhood's cut must lie between 0 and 1",
        })
    }
}

impl core::error::Error for GaussianError {}

impl<const WIDTH: usize, const HEIGHT: usize> Neighbourhood<WIDTH, HEIGHT> {
    /// Only the winner: what a Gaussian becomes at σ = 0.
    #[must_use]
    pub const fn winner_only() -> Self {
        const { assert!(WIDTH > 0 && HEIGHT > 0, "a map needs at least one node") }
        let mut it = Self {
            horizontal: [0.0; WIDTH],
            vertical: [0.0; HEIGHT],
            horizontal_radius: 0,
            vertical_radius: 0,
        };
        if let Some(first) = it.horizontal.first_mut() {
            *first = 1.0;
        }
        if let Some(first) = it.vertical.first_mut() {
            *first = 1.0;
        }
        it
    }

    /// A Gaussian of width `sigma` (in nodes), 0 where the factor of one axis is below `cut`.
    ///
    /// `cut = 0` keeps the whole map, as textbook implementations do.
    ///
    /// # Errors
    /// [`GaussianError`] when `sigma` is negative or not finite or `cut` is outside `[0, 1]`.
    pub fn gaussian(sigma: f32, cut: f32) -> Result<Self, GaussianError> {
        let mut it = Self::winner_only();
        it.widen(sigma, cut)?;
        Ok(it)
    }

    /// Makes the winner alone a Gaussian, in place: a `Result` that holds the tables costs a copy of
    /// them.
    ///
    /// # Errors
    /// As [`gaussian`](Self::gaussian); it stays the winner alone.
    pub(crate) fn widen(&mut self, sigma: f32, cut: f32) -> Result<(), GaussianError> {
        if !sigma.is_finite() || sigma < 0.0 {
            return Err(GaussianError::Sigma);
        }
        if !(0.0..=1.0).contains(&cut) {
            return Err(GaussianError::Cut);
        }
        let two_sigma_squared = 2.0 * sigma * sigma;
        // Below the square root of the smallest normal number the Gaussian is the winner alone.
        if two_sigma_squared >= f32::MIN_POSITIVE {
            self.horizontal_radius = fill(&mut self.horizontal, two_sigma_squared, cut);
            if WIDTH == HEIGHT {
                // The same numbers: exponentials are dear without a floating-point unit.
                self.vertical_radius = self.horizontal_radius;
                for (vertical, horizontal) in self.vertical.iter_mut().zip(self.horizontal) {
                    *vertical = horizontal;
                }
            } else {
                self.vertical_radius = fill(&mut self.vertical, two_sigma_squared, cut);
            }
        }
        Ok(())
    }

    /// h for a node `dx` columns and `dy` rows from the winner; 0 outside the map or below the cut.
    #[must_use]
    pub fn weight(&self, dx: usize, dy: usize) -> f32 {
        match (self.horizontal.get(dx), self.vertical.get(dy)) {
            (Some(x), Some(y)) => x * y,
            _ => 0.0,
        }
    }

    /// Columns to either side of the winner that the neighbourhood reaches.
    #[must_use]
    pub const fn horizontal_radius(&self) -> usize {
        self.horizontal_radius as usize
    }

    /// Rows to either side of the winner that the neighbourhood reaches.
    #[must_use]
    pub const fn vertical_radius(&self) -> usize {
        self.vertical_radius as usize
    }
}

/// Writes the factors of one axis and returns the largest distance whose factor is not cut.
fn fill(axis: &mut [f32], two_sigma_squared: f32, cut: f32) -> u16 {
    let mut radius = 0_u16;
    for (distance, factor) in axis.iter_mut().enumerate().skip(1) {
        let d = distance as f32;
        let value = exp(-(d * d) / two_sigma_squared);
        if value < cut || value == 0.0 {
            break;
        }
        *factor = value;
        radius = distance as u16;
    }
    radius
}

#[cfg(test)]
mod tests {
    use super::{GaussianError, Neighbourhood};

    #[test]
    fn the_product_of_the_tables_is_the_two_dimensional_gaussian() {
        let near = Neighbourhood::<12, 9>::gaussian(2.3, 0.0).unwrap();
        for dx in 0..12_usize {
            for dy in 0..9_usize {
                let squared = (dx * dx + dy * dy) as f64;
                let exact = (-squared / (2.0 * 2.3_f64 * 2.3)).exp();
                let ours = f64::from(near.weight(dx, dy));
                assert!((ours - exact).abs() <= 4e-7 * exact.max(1e-30), "{dx} {dy}");
            }
        }
    }

    #[test]
    fn a_width_of_zero_is_the_winner_alone() {
        let near = Neighbourhood::<5, 5>::gaussian(0.0, 0.0).unwrap();
        assert_eq!(near, Neighbourhood::winner_only());
        assert_eq!(
            (near.weight(0, 0), near.weight(1, 0), near.weight(9, 9)),
            (1.0, 0.0, 0.0)
        );
    }

    #[test]
    fn the_cut_bounds_the_radius_on_both_sides() {
        let near = Neighbourhood::<30, 30>::gaussian(3.0, 0.01).unwrap();
        // exp(−9²/18) = .0111 stays, exp(−10²/18) = .0039 goes.
        assert_eq!(near.horizontal_radius(), 9);
        assert!(near.weight(9, 0) > 0.01 && near.weight(10, 0) == 0.0);
    }

    #[test]
    fn impossible_widths_and_cuts_are_refused() {
        type N = Neighbourhood<3, 3>;
        assert_eq!(N::gaussian(f32::NAN, 0.0), Err(GaussianError::Sigma));
        assert_eq!(N::gaussian(-1.0, 0.0), Err(GaussianError::Sigma));
        assert_eq!(N::gaussian(1.0, f32::NAN), Err(GaussianError::Cut));
        assert_eq!(N::gaussian(1.0, 1.5), Err(GaussianError::Cut));
    }

    #[test]
    fn a_tall_map_has_its_own_rows_and_a_wide_one_its_own_columns() {
        let tall = Neighbourhood::<3, 9>::gaussian(2.0, 0.0).unwrap();
        assert_eq!((tall.horizontal_radius(), tall.vertical_radius()), (2, 8));
        let wide = Neighbourhood::<9, 3>::gaussian(2.0, 0.0).unwrap();
        assert_eq!((wide.horizontal_radius(), wide.vertical_radius()), (8, 2));
        for distance in 0..9 {
            let exact = (-((distance * distance) as f64) / 8.0).exp();
            for weight in [tall.weight(0, distance), wide.weight(distance, 0)] {
                assert!((f64::from(weight) - exact).abs() < 1e-6, "{distance}");
            }
        }
        assert_eq!((tall.weight(3, 0), wide.weight(0, 3)), (0.0, 0.0));
    }

    #[test]
    fn a_factor_of_exactly_the_cut_stays_and_one_that_is_zero_bounds_the_radius() {
        let edge = crate::num::exp(-0.5);
        let near = Neighbourhood::<5, 5>::gaussian(1.0, edge).unwrap();
        assert_eq!((near.horizontal_radius(), near.weight(1, 0)), (1, edge));
        // exp(−200) is no number above 0 in `f32`.
        let narrow = Neighbourhood::<5, 5>::gaussian(0.05, 0.0).unwrap();
        assert_eq!(
            (narrow.horizontal_radius(), narrow.vertical_radius()),
            (0, 0)
        );
        // Too narrow for its square to be a normal number.
        let needle = Neighbourhood::<5, 5>::gaussian(1e-22, 0.0).unwrap();
        assert_eq!(needle, Neighbourhood::winner_only());
        for (cut, kept) in [(0.0, true), (1.0, true), (-0.1, false), (1.1, false)] {
            assert_eq!(
                Neighbourhood::<5, 5>::gaussian(1.0, cut).is_ok(),
                kept,
                "{cut}"
            );
        }
        assert!(Neighbourhood::<5, 5>::gaussian(f32::INFINITY, 0.5).is_err());
    }

    #[test]
    fn an_error_says_what_was_wrong() {
        let texts = [GaussianError::Sigma, GaussianError::Cut].map(|it| std::format!("{it}"));
        assert!(texts[0].contains("width") && texts[1].contains("cut"));
    }
}
