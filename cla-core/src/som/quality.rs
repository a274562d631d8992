//! How well a map represents stimuli: quantization and topographic error.

use super::dense::{DenseSom, StimulusError};
use super::grid::{Grid, NodeId, best_match};
use crate::num::sqrt;

/// The mean distance ‖x − m_c‖ between stimuli and their best matching units; 0 without stimuli.
///
/// # Errors
/// [`StimulusError`] for the first stimulus with a feature that is not finite.
///
/// ```
/// use cla_core::som::{DenseSom, quantization_error};
/// let som = DenseSom::<2, 2, 1>::new(); // all prototypes at 0
/// assert_eq!(quantization_error(&som, [[0.5], [1.5]].iter())?, 1.0);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
pub fn quantization_error<'a, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>(
    som: &DenseSom<WIDTH, HEIGHT, FEATURES>,
    stimuli: impl Iterator<Item = &'a [f32; FEATURES]>,
) -> Result<f32, StimulusError> {
    let mut total = 0.0;
    let mut count = 0_u32;
    for stimulus in stimuli {
        total += sqrt(som.best_matching_unit(stimulus)?.squared_distance);
        count += 1;
    }
    Ok(if count == 0 {
        0.0
    } else {
        total / count as f32
    })
}

/// The share of stimuli whose second best unit is not one of the eight neighbours of the best.
///
/// 0 without stimuli, and on a map of one node.
///
/// # Errors
/// [`StimulusError`] for the first stimulus with a feature that is not finite.
///
/// ```
/// use cla_core::som::{DenseSom, topographic_error};
/// let mut som = DenseSom::<3, 1, 1>::new();
/// som.prototypes_mut().as_mut_slice().copy_from_slice(&[[0.0], [9.0], [1.0]]);
/// assert_eq!(topographic_error(&som, [[0.2]].iter())?, 1.0);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
pub fn topographic_error<'a, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>(
    som: &DenseSom<WIDTH, HEIGHT, FEATURES>,
    stimuli: impl Iterator<Item = &'a [f32; FEATURES]>,
) -> Result<f32, StimulusError> {
    let mut distances = Grid::filled(0.0);
    let mut apart = 0_u32;
    let mut count = 0_u32;
    for stimulus in stimuli {
        som.squared_distances(stimulus, &mut distances)?;
        count += 1;
        let best = best_match(&distances).node;
        let second = runner_up(&distances, best);
        let (x, y) = distances.position(best);
        let (u, v) = distances.position(second);
        if x.abs_diff(u) > 1 || y.abs_diff(v) > 1 {
            apart += 1;
        }
    }
    Ok(if count == 0 {
        0.0
    } else {
        apart as f32 / count as f32
    })
}

/// The nearest node but the best; the best itself on a map of one node.
fn runner_up<const WIDTH: usize, const HEIGHT: usize>(
    distances: &Grid<f32, WIDTH, HEIGHT>,
    best: NodeId,
) -> NodeId {
    let mut second = best;
    let mut nearest = f32::INFINITY;
    for (index, &distance) in distances.as_slice().iter().enumerate() {
        if index != usize::from(best.0) && distance < nearest {
            nearest = distance;
            second = NodeId(index as u16);
        }
    }
    second
}

#[cfg(test)]
#[path = "quality_tests.rs"]
mod tests;
