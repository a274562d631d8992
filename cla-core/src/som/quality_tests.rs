//! How well a map represents stimuli.

use super::{quantization_error, topographic_error};
use crate::som::{DenseSom, StimulusError};

/// A map of 3 × 3 nodes at these places on a line.
fn map(places: [f32; 9]) -> DenseSom<3, 3, 1> {
    let mut som = DenseSom::new();
    for (prototype, place) in som.prototypes_mut().as_mut_slice().iter_mut().zip(places) {
        *prototype = [place];
    }
    som
}

#[test]
fn the_quantization_error_is_the_mean_distance_to_the_nearest_prototype() {
    let som = map([0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0]);
    let error = |stimuli: &[[f32; 1]]| quantization_error(&som, stimuli.iter());
    assert_eq!(error(&[]), Ok(0.0));
    assert_eq!(error(&[[13.0]]), Ok(3.0));
    assert_eq!(error(&[[13.0], [29.0], [100.0], [40.0]]), Ok(6.0));
    let bad = error(&[[1.0], [f32::NAN]]);
    assert_eq!(bad, Err(StimulusError::NotFinite { feature: 0 }));
}

#[test]
fn the_topographic_error_is_the_share_of_stimuli_between_nodes_that_are_no_neighbours() {
    // Node 4 is the middle and everyone's neighbour; 0 and 2, 3 and 5, 0 and 6 are not neighbours.
    let som = map([0.0, 40.0, 1.0, 20.0, 80.0, 21.0, 60.0, 61.5, 81.0]);
    let error = |stimuli: &[[f32; 1]]| topographic_error(&som, stimuli.iter());
    assert_eq!(error(&[]), Ok(0.0));
    // Same row, two columns apart; one of three.
    assert_eq!(error(&[[0.4]]), Ok(1.0));
    assert_eq!(error(&[[20.4]]), Ok(1.0));
    // Same row, side by side; diagonal.
    assert_eq!(error(&[[60.5]]), Ok(0.0));
    assert_eq!(error(&[[80.4]]), Ok(0.0));
    assert_eq!(error(&[[0.4], [60.5], [80.4], [60.4]]), Ok(0.25));
    // The same column, two rows apart.
    let tall = map([0.0, 40.0, 50.0, 20.0, 80.0, 21.0, 1.0, 61.5, 81.0]);
    assert_eq!(topographic_error(&tall, [[0.4_f32]].iter()), Ok(1.0));
    // The same column, one row apart.
    let near = map([0.0, 40.0, 50.0, 1.0, 80.0, 21.0, 90.0, 61.5, 81.0]);
    assert_eq!(topographic_error(&near, [[0.4_f32]].iter()), Ok(0.0));
    let bad = error(&[[f32::INFINITY]]);
    assert_eq!(bad, Err(StimulusError::NotFinite { feature: 0 }));
}

#[test]
fn of_equally_near_seconds_the_first_counts_and_one_node_is_no_error() {
    // From 0 both 1 (node 1, a neighbour) and −1 (node 2, none) are as far; node 0 wins.
    let som = map([0.0, 1.0, -1.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0]);
    assert_eq!(topographic_error(&som, [[0.0_f32]].iter()), Ok(0.0));
    let alone = DenseSom::<1, 1, 1>::new();
    assert_eq!(topographic_error(&alone, [[0.3_f32]].iter()), Ok(0.0));
}
