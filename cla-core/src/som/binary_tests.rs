//! Tests of the sparse map.

use super::BinarySom;
use crate::num::{Neighbourhood, Rng, Schedule};
use crate::som::{DenseSom, Grid, NodeId, SparseStimulus, best_match};

type Sparse = BinarySom<7, 5, 40>;
type Dense = DenseSom<7, 5, 40>;

/// The two maps with the same weights.
fn twins(seed: u64) -> (Sparse, Dense) {
    let mut sparse = Sparse::new();
    sparse.randomize(&mut Rng::new(seed));
    let mut dense = Dense::new();
    for (node, prototype) in dense.prototypes_mut().as_mut_slice().iter_mut().enumerate() {
        for (feature, weight) in prototype.iter_mut().enumerate() {
            *weight = sparse.weight(NodeId(node as u16), feature as u16);
        }
    }
    (sparse, dense)
}

fn words(rng: &mut Rng, p: f32) -> [u32; 2] {
    let mut words = [0_u32; 2];
    for feature in 0..40 {
        if rng.chance(p) {
            words[feature / 32] |= 1 << (feature % 32);
        }
    }
    words
}

fn largest_difference(sparse: &Sparse, dense: &Dense) -> f32 {
    let mut largest = 0.0_f32;
    for (node, prototype) in dense.prototypes().as_slice().iter().enumerate() {
        for (feature, weight) in prototype.iter().enumerate() {
            let ours = sparse.weight(NodeId(node as u16), feature as u16);
            largest = largest.max((ours - weight).abs());
        }
    }
    largest
}

#[test]
fn ten_thousand_steps_agree_with_the_dense_oracle() {
    let (mut sparse, mut dense) = twins(11);
    let mut rng = Rng::new(12);
    let sigma = Schedule::linear(3.0, 0.0, 10_000).unwrap();
    let alpha = Schedule::linear(0.3, 0.01, 10_000).unwrap();
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    let mut same_winner = 0;
    for t in 0..10_000 {
        let on = words(&mut rng, 0.2);
        let minus_words = words(&mut rng, 0.1);
        let minus = [minus_words[0] & !on[0], minus_words[1] & !on[1]];
        let stimulus = SparseStimulus {
            on: &on,
            minus: &minus,
            unknown: &[],
        };
        let mut x = [0.0; 40];
        for (feature, value) in x.iter_mut().enumerate() {
            let bit = |words: &[u32; 2]| (words[feature / 32] >> (feature % 32) & 1) as f32;
            *value = bit(&on) - bit(&minus);
        }
        distances.as_mut_slice().fill(0.0);
        sparse.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
        let ours = best_match(&distances);
        let theirs = dense.best_matching_unit(&x).unwrap();
        assert!(
            (ours.squared_distance - theirs.squared_distance).abs() < 2e-3,
            "step {t}"
        );
        same_winner += u32::from(ours.node == theirs.node);
        // Both follow the oracle's winner: a near tie must not part the maps.
        let near = Neighbourhood::gaussian(sigma.at(t), 0.01).unwrap();
        sparse.train(&stimulus, theirs.node, alpha.at(t), &near, |_| true);
        dense.train(&x, theirs.node, alpha.at(t), &near);
    }
    assert!(same_winner >= 9_990, "{same_winner}");
    let difference = largest_difference(&sparse, &dense);
    assert!(difference < 1e-4, "{difference}");
}

#[test]
fn unknown_features_count_neither_in_the_search_nor_in_the_update() {
    let (mut sparse, dense) = twins(5);
    let mut rng = Rng::new(6);
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    for t in 0..300 {
        let unknown = [0xFF00_u32, 0b1111];
        let on = words(&mut rng, 0.3);
        let on = [on[0] & !unknown[0], on[1] & !unknown[1]];
        let stimulus = SparseStimulus {
            on: &on,
            minus: &[],
            unknown: &unknown,
        };
        distances.as_mut_slice().fill(0.0);
        sparse.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
        for (node, &ours) in distances.as_slice().iter().enumerate() {
            let mut exact = 0.0;
            for feature in (0..40_u16).filter(|&j| !stimulus.is_unknown(j)) {
                let x = (on[usize::from(feature) / 32] >> (feature % 32) & 1) as f32;
                let difference = x - sparse.weight(NodeId(node as u16), feature);
                exact += difference * difference;
            }
            assert!(
                (ours - exact).abs() < 1e-3,
                "step {t} node {node}: {ours} {exact}"
            );
        }
        let winner = best_match(&distances).node;
        let near = Neighbourhood::gaussian(1.5, 0.01).unwrap();
        sparse.train(&stimulus, winner, 0.4, &near, |_| true);
    }
    for (node, prototype) in dense.prototypes().as_slice().iter().enumerate() {
        for feature in (8..16).chain(32..36) {
            let now = sparse.weight(NodeId(node as u16), feature as u16);
            assert!(
                (now - prototype[feature]).abs() < 1e-4,
                "an unknown weight moved"
            );
        }
    }
}

#[test]
fn an_imprinted_node_is_the_stimulus_to_the_bit() {
    let (mut sparse, _) = twins(9);
    let stimulus = SparseStimulus {
        on: &[0b1010],
        minus: &[0b0100],
        unknown: &[0b1],
    };
    sparse.imprint(&stimulus, NodeId(17));
    let read: [f32; 5] = core::array::from_fn(|j| sparse.weight(NodeId(17), j as u16));
    assert_eq!(read, [0.5, 1.0, -1.0, 1.0, 0.0]);
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    sparse.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
    assert!(distances.as_slice()[17] < 1e-6);
}

#[test]
fn nodes_that_may_not_move_stay() {
    let (mut sparse, dense) = twins(2);
    let stimulus = SparseStimulus {
        on: &[0b11],
        minus: &[],
        unknown: &[],
    };
    let near = Neighbourhood::gaussian(9.0, 0.0).unwrap();
    sparse.train(&stimulus, NodeId(3), 0.5, &near, |node| node == NodeId(3));
    for (node, prototype) in dense.prototypes().as_slice().iter().enumerate() {
        let moved = (sparse.weight(NodeId(node as u16), 0) - prototype[0]).abs() > 1e-6;
        assert_eq!(moved, node == 3);
    }
}

#[test]
fn features_outside_the_map_are_left_out() {
    let (mut sparse, _) = twins(4);
    let before = sparse.clone();
    let stimulus = SparseStimulus {
        on: &[0, 0, 1],
        minus: &[],
        unknown: &[0, u32::MAX],
    };
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    sparse.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
    sparse.train(
        &stimulus,
        NodeId(35),
        0.5,
        &Neighbourhood::winner_only(),
        |_| true,
    );
    assert_eq!(sparse, before, "node 35 is outside a map of 35 nodes");
    assert!(distances.as_slice().iter().all(|d| d.is_finite()));
}

#[test]
fn a_squared_distance_that_rounding_made_negative_is_none() {
    let clipped = [-1.0, -1e-30, f32::NEG_INFINITY, 0.0, 2.5, 1e30].map(super::not_below_zero);
    assert_eq!(clipped, [0.0, 0.0, 0.0, 0.0, 2.5, 1e30]);
}
