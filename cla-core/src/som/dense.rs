//! The textbook map: real-valued stimuli, every feature of every node at every step (book, 2.2).
//!
//! Prototypes lie node by node.
//! This is the reference for layers and the oracle for the sparse maps of binary stimuli.

use core::fmt;

use super::grid::{BestMatch, Grid, NodeId, best_match};
use crate::num::{Neighbourhood, Rng};

/// A self-organizing map of `WIDTH` × `HEIGHT` prototypes with `FEATURES` weights each.
///
/// It starts with all weights 0 (so that a static map costs no flash); call
/// [`randomize`](Self::randomize) before training.
///
/// ```
/// use cla_core::num::{Neighbourhood, Rng};
/// use cla_core::som::DenseSom;
///
/// let mut som = DenseSom::<4, 4, 2>::new();
/// let mut rng = Rng::new(1);
/// som.randomize(&mut rng);
/// let near = Neighbourhood::gaussian(1.0, 0.01)?;
/// for _ in 0..200 {
///     let stimulus = [rng.unit(), rng.unit()];
///     let best = som.best_matching_unit(&stimulus)?;
///     som.train(&stimulus, best.node, 0.2, &near);
/// }
/// assert!(som.best_matching_unit(&[0.5, 0.5])?.squared_distance < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DenseSom<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> {
    prototypes: Grid<[f32; FEATURES], WIDTH, HEIGHT>,
}

/// A weight nearer to 0 than this becomes 0.
///
/// The weights of features that are off shrink by a factor at every step, and numbers near the
/// smallest that `f32` can hold are up to a hundred times slower on a host.
/// The square of this one is still a normal number.
const NEGLIGIBLE: f32 = 1e-18;

/// A stimulus that no map can be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StimulusError {
    /// A feature is NaN or infinite; the map is unchanged.
    NotFinite {
        /// The first such feature.
        feature: u16,
    },
    /// A feature lies farther from 0 than 10¹⁵, and a squared distance might be infinite; the map is
    /// unchanged.
    TooLarge {
        /// The first such feature.
        feature: u16,
    },
}

/// How far from 0 a feature may lie: of as many features as a map may have, the square of twice that
/// adds up to a finite number.
const FARTHEST: f32 = 1e15;

impl fmt::Display for StimulusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { feature } => write!(
                f,
                "feature {feature} of the stimulus is not a finite number"
            ),
            Self::TooLarge { feature } => write!(
                f,
                "feature {feature} of the stimulus lies farther from 0 than 1e15"
            ),
        }
    }
}

impl core::error::Error for StimulusError {}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>
    DenseSom<WIDTH, HEIGHT, FEATURES>
{
    /// A map whose weights are all 0.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                FEATURES > 0 && FEATURES <= u16::MAX as usize,
                "a map has 1 to 65,535 features"
            )
        }
        Self {
            prototypes: Grid::filled([0.0; FEATURES]),
        }
    }

    /// Draws every weight from `[0, 1)`, node by node.
    pub fn randomize(&mut self, rng: &mut Rng) {
        for weight in self.prototypes.as_mut_slice().as_flattened_mut() {
            *weight = rng.unit();
        }
    }

    /// The prototypes, row by row.
    #[must_use]
    pub const fn prototypes(&self) -> &Grid<[f32; FEATURES], WIDTH, HEIGHT> {
        &self.prototypes
    }

    /// The prototypes, to set weights by hand (for example when a snapshot is restored).
    ///
    /// Weights must be finite; a map with other weights answers with distances that never win.
    pub const fn prototypes_mut(&mut self) -> &mut Grid<[f32; FEATURES], WIDTH, HEIGHT> {
        &mut self.prototypes
    }

    /// Writes ‖x − m‖² of every node into `distances`, feature 0 first.
    ///
    /// # Errors
    /// [`StimulusError`] when a feature is not finite or lies farther from 0 than 10¹⁵; `distances` is then unchanged.
    pub fn squared_distances(
        &self,
        stimulus: &[f32; FEATURES],
        distances: &mut Grid<f32, WIDTH, HEIGHT>,
    ) -> Result<(), StimulusError> {
        check(stimulus)?;
        // Four nodes at a time: the sums of one node wait for each other, those of four do not.
        // Each node's own sum is the same, in the same order.
        let (fours, rest) = self.prototypes.as_slice().as_chunks::<4>();
        let (far_fours, far_rest) = distances.as_mut_slice().as_chunks_mut::<4>();
        for (distance, prototypes) in far_fours.iter_mut().zip(fours) {
            *distance = four_squared_distances(stimulus, prototypes);
        }
        for (distance, prototype) in far_rest.iter_mut().zip(rest) {
            *distance = squared_distance(stimulus, prototype);
        }
        Ok(())
    }

    /// The node whose prototype is nearest to `stimulus`; ties go to the lowest index.
    ///
    /// # Errors
    /// [`StimulusError`] when a feature is not finite or lies farther from 0 than 10¹⁵.
    pub fn best_matching_unit(
        &self,
        stimulus: &[f32; FEATURES],
    ) -> Result<BestMatch, StimulusError> {
        let mut distances = Grid::filled(0.0);
        self.squared_distances(stimulus, &mut distances)?;
        Ok(best_match(&distances))
    }

    /// Moves the prototypes around `winner` towards `stimulus`: m ← m + α·h·(x − m).
    ///
    /// A weight that comes nearer to 0 than 10⁻¹⁸ becomes 0.
    /// `alpha` lies in `[0, 1]`; the stimulus is one that [`squared_distances`](Self::squared_distances)
    /// accepts.
    /// With another one, and with a winner outside the map, nothing changes.
    pub fn train(
        &mut self,
        stimulus: &[f32; FEATURES],
        winner: NodeId,
        alpha: f32,
        neighbourhood: &Neighbourhood<WIDTH, HEIGHT>,
    ) {
        if usize::from(winner.0) >= Grid::<f32, WIDTH, HEIGHT>::NODES
            || !(0.0..=1.0).contains(&alpha)
            || check(stimulus).is_err()
        {
            return;
        }
        let (column, row) = self.prototypes.position(winner);
        let top = row.saturating_sub(neighbourhood.vertical_radius());
        let left = column.saturating_sub(neighbourhood.horizontal_radius());
        let height = (row - top) + neighbourhood.vertical_radius() + 1;
        let width = (column - left) + neighbourhood.horizontal_radius() + 1;
        let rows = self.prototypes.rows_mut().iter_mut().enumerate();
        for (y, nodes) in rows.skip(top).take(height) {
            for (x, prototype) in nodes.iter_mut().enumerate().skip(left).take(width) {
                let rate = alpha * neighbourhood.weight(x.abs_diff(column), y.abs_diff(row));
                for (weight, &value) in prototype.iter_mut().zip(stimulus) {
                    let moved = *weight + rate * (value - *weight);
                    *weight = if moved.abs() < NEGLIGIBLE { 0.0 } else { moved };
                }
            }
        }
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Default
    for DenseSom<WIDTH, HEIGHT, FEATURES>
{
    fn default() -> Self {
        Self::new()
    }
}

fn check(stimulus: &[f32]) -> Result<(), StimulusError> {
    // What is NaN is not within.
    let within = |value: &f32| value.abs() <= FARTHEST;
    let Some(index) = stimulus.iter().position(|value| !within(value)) else {
        return Ok(());
    };
    let feature = index as u16;
    Err(match stimulus.get(index) {
        Some(value) if value.is_finite() => StimulusError::TooLarge { feature },
        _ => StimulusError::NotFinite { feature },
    })
}

fn four_squared_distances<const FEATURES: usize>(
    stimulus: &[f32; FEATURES],
    [a, b, c, d]: &[[f32; FEATURES]; 4],
) -> [f32; 4] {
    let mut totals = [0.0; 4];
    for ((((&value, a), b), c), d) in stimulus.iter().zip(a).zip(b).zip(c).zip(d) {
        for (total, weight) in totals.iter_mut().zip([a, b, c, d]) {
            let difference = value - weight;
            *total += difference * difference;
        }
    }
    totals
}

fn squared_distance(stimulus: &[f32], prototype: &[f32]) -> f32 {
    let mut total = 0.0;
    for (&value, &weight) in stimulus.iter().zip(prototype) {
        let difference = value - weight;
        total += difference * difference;
    }
    total
}

#[cfg(test)]
mod tests {
    use super::{DenseSom, StimulusError};
    use crate::num::{Neighbourhood, Rng};
    use crate::som::NodeId;

    #[test]
    fn the_winner_moves_by_alpha_and_its_neighbour_by_alpha_times_h() {
        let mut som = DenseSom::<3, 1, 1>::new();
        let near = Neighbourhood::gaussian(1.0, 0.0).unwrap();
        som.train(&[1.0], NodeId(0), 0.5, &near);
        let weights = som.prototypes().as_slice();
        assert_eq!(weights[0][0], 0.5);
        assert!((weights[1][0] - 0.5 * 0.606_530_66).abs() < 1e-6);
        assert!((weights[2][0] - 0.5 * 0.135_335_28).abs() < 1e-6);
    }

    #[test]
    fn the_neighbourhood_is_clipped_at_every_edge() {
        let near = Neighbourhood::<4, 3>::gaussian(0.8, 0.0).unwrap();
        for winner in 0..12 {
            let mut som = DenseSom::<4, 3, 1>::new();
            som.train(&[1.0], NodeId(winner), 1.0, &near);
            for (index, weight) in som.prototypes().as_slice().iter().enumerate() {
                let dx = (index % 4).abs_diff(usize::from(winner) % 4);
                let dy = (index / 4).abs_diff(usize::from(winner) / 4);
                assert_eq!(weight[0], near.weight(dx, dy));
            }
        }
    }

    #[test]
    fn every_node_has_the_distance_that_it_has_alone_to_the_bit() {
        let mut som = DenseSom::<3, 3, 7>::new();
        let mut rng = Rng::new(6);
        som.randomize(&mut rng);
        let stimulus: [f32; 7] = core::array::from_fn(|_| rng.unit());
        let mut distances = crate::som::Grid::filled(0.0);
        som.squared_distances(&stimulus, &mut distances).unwrap();
        let nodes = som.prototypes().as_slice();
        for (node, &distance) in nodes.iter().zip(distances.as_slice()) {
            assert_eq!(
                distance.to_bits(),
                super::squared_distance(&stimulus, node).to_bits()
            );
        }
    }

    #[test]
    fn a_stimulus_that_is_not_finite_is_refused_by_name() {
        let som = DenseSom::<2, 2, 3>::new();
        let refused = som.best_matching_unit(&[0.0, f32::NAN, f32::INFINITY]);
        assert_eq!(refused, Err(StimulusError::NotFinite { feature: 1 }));
    }

    #[test]
    fn a_weight_that_shrinks_ends_at_zero_and_not_among_the_slow_numbers() {
        let mut som = DenseSom::<1, 1, 1>::new();
        som.prototypes_mut().as_mut_slice()[0] = [1.0];
        for _ in 0..59 {
            som.train(&[0.0], NodeId(0), 0.5, &Neighbourhood::winner_only());
        }
        assert_eq!(som.prototypes().as_slice()[0], [2.0_f32.powi(-59)]);
        som.train(&[0.0], NodeId(0), 0.5, &Neighbourhood::winner_only());
        assert_eq!(som.prototypes().as_slice()[0], [0.0]);
    }

    #[test]
    fn a_winner_outside_the_map_changes_nothing() {
        let mut som = DenseSom::<2, 2, 1>::new();
        som.train(&[1.0], NodeId(4), 1.0, &Neighbourhood::winner_only());
        assert_eq!(som, DenseSom::new());
    }

    #[test]
    fn a_map_of_the_unit_square_unfolds() {
        let mut som = DenseSom::<6, 6, 2>::new();
        let mut rng = Rng::new(3);
        som.randomize(&mut rng);
        for t in 0..4000_u32 {
            let share = t as f32 / 4000.0;
            let near = Neighbourhood::gaussian(3.0 * (1.0 - share) + 0.5, 0.01).unwrap();
            let stimulus = [rng.unit(), rng.unit()];
            let best = som.best_matching_unit(&stimulus).unwrap();
            som.train(&stimulus, best.node, 0.5 * (1.0 - share) + 0.02, &near);
        }
        let samples: [[f32; 2]; 500] = core::array::from_fn(|_| [rng.unit(), rng.unit()]);
        let quantization = crate::som::quantization_error(&som, samples.iter()).unwrap();
        let topographic = crate::som::topographic_error(&som, samples.iter()).unwrap();
        // A perfect 6 × 6 lattice has .064; a map that never unfolded has more than .15.
        assert!((0.05..0.10).contains(&quantization), "{quantization}");
        assert!(topographic < 0.1, "{topographic}");
    }

    #[test]
    fn a_step_goes_the_share_of_the_way_from_where_the_weight_was() {
        let mut som = DenseSom::<1, 1, 3>::new();
        som.prototypes_mut().as_mut_slice()[0] = [2.0, -1.0, 0.5];
        som.train(
            &[4.0, -2.0, 0.5],
            NodeId(0),
            0.25,
            &Neighbourhood::winner_only(),
        );
        assert_eq!(som.prototypes().as_slice()[0], [2.5, -1.25, 0.5]);
    }

    #[test]
    fn a_refused_stimulus_leaves_the_distances_as_they_were() {
        let mut som = DenseSom::<5, 1, 2>::new();
        som.prototypes_mut().as_mut_slice()[4] = [3.0, 4.0];
        let mut distances = crate::som::Grid::filled(-1.0);
        let error = som.squared_distances(&[f32::INFINITY, 0.0], &mut distances);
        let error = error.unwrap_err();
        assert_eq!(error, StimulusError::NotFinite { feature: 0 });
        let text = std::string::ToString::to_string(&error);
        assert_eq!(text, "feature 0 of the stimulus is not a finite number");
        assert_eq!(distances.as_slice(), [-1.0; 5]);
        som.squared_distances(&[1.0, 0.0], &mut distances).unwrap();
        assert_eq!(distances.as_slice(), [1.0, 1.0, 1.0, 1.0, 20.0]);
    }
}
