//! The dense map, feature by feature: the bits of `cla_core::som::DenseSom`, several nodes at a time.
//!
//! A sum over features waits for itself; feature by feature the nodes' sums stand side by side, each in
//! the core's order.
//! A feature that is NaN is unknown: it counts neither in the search nor in the update.

/// A weight nearer to 0 than this becomes 0, as in the core.
const NEGLIGIBLE: f32 = 1e-18;
/// Nodes whose sums are made together.
const LANES: usize = 32;

/// ‖x − m‖² over the known features, for every node.
#[inline(always)]
pub(crate) fn squared_distances(weights: &[f32], stimulus: &[f32], distances: &mut [f32]) {
    let nodes = distances.len();
    let mut blocks = distances.chunks_exact_mut(LANES);
    let mut first = 0;
    for block in &mut blocks {
        let mut sums = [0.0_f32; LANES];
        for (column, &value) in weights.chunks_exact(nodes).zip(stimulus) {
            if value.is_nan() {
                continue;
            }
            let (column, _) = column[first..].as_chunks::<LANES>();
            if let Some(column) = column.first() {
                for (sum, weight) in sums.iter_mut().zip(column) {
                    let difference = value - weight;
                    *sum += difference * difference;
                }
            }
        }
        block.copy_from_slice(&sums);
        first += LANES;
    }
    let rest = blocks.into_remainder();
    rest.fill(0.0);
    for (column, &value) in weights.chunks_exact(nodes).zip(stimulus) {
        if !value.is_nan() {
            for (sum, weight) in rest.iter_mut().zip(&column[first..]) {
                let difference = value - weight;
                *sum += difference * difference;
            }
        }
    }
}

/// The nearest node; of equally near ones the lowest.
#[inline(always)]
pub(crate) fn nearest(distances: &[f32]) -> usize {
    // A single minimum would wait for itself at every node.
    let (blocks, rest) = distances.as_chunks::<LANES>();
    let mut leasts = [f32::INFINITY; LANES];
    for block in blocks {
        for (least, &distance) in leasts.iter_mut().zip(block) {
            *least = if distance < *least { distance } else { *least };
        }
    }
    let all = leasts.iter().chain(rest);
    let least = all.fold(f32::INFINITY, |least, &distance| least.min(distance));
    let found = distances.iter().position(|&distance| distance == least);
    found.unwrap_or(0)
}

/// m ← m + rate · (x − m) on the known features of some nodes.
#[inline(always)]
pub(crate) fn train(
    weights: &mut [f32],
    stimulus: &[f32],
    rates: &[f32],
    moving: std::ops::Range<usize>,
) {
    let nodes = rates.len();
    let rates = &rates[moving.clone()];
    for (column, &value) in weights.chunks_exact_mut(nodes).zip(stimulus) {
        if value.is_nan() {
            continue;
        }
        for (weight, rate) in column[moving.clone()].iter_mut().zip(rates) {
            let moved = *weight + rate * (value - *weight);
            *weight = if moved.abs() < NEGLIGIBLE { 0.0 } else { moved };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::rates::{Lattice, Rates, Shape};
    use super::{nearest, squared_distances, train};
    use cla_core::num::{Neighbourhood, Rng};
    use cla_core::som::{DenseSom, Grid, best_match};

    /// A life of the core's map and of this one, from the same weights.
    fn lives<const W: usize, const H: usize, const F: usize>() {
        let mut rng = Rng::new(5);
        let mut core = Box::new(DenseSom::<W, H, F>::new());
        core.randomize(&mut rng);
        let nodes = W * H;
        let mut weights = vec![0.0; F * nodes];
        for (node, prototype) in core.prototypes().as_slice().iter().enumerate() {
            for (feature, &weight) in prototype.iter().enumerate() {
                weights[feature * nodes + node] = weight;
            }
        }
        // The core's rows are x here, its columns y.
        let mut rates = Rates::new(Lattice {
            x: H,
            y: W,
            hexagonal: false,
            shape: Shape::Gaussian,
        });
        let mut distances = vec![0.0; nodes];
        let mut grid = Grid::filled(0.0);
        for t in 0..200 {
            let stimulus: [f32; F] = core::array::from_fn(|_| rng.unit());
            let (sigma, alpha) = (3.0 / (1.0 + t as f32 / 50.0), 0.5 / (1.0 + t as f32 / 50.0));
            core.squared_distances(&stimulus, &mut grid).unwrap();
            squared_distances(&weights, &stimulus, &mut distances);
            assert_eq!(grid.as_slice(), distances, "{t}");
            let winner = best_match(&grid).node;
            assert_eq!(usize::from(winner.0), nearest(&distances));
            let near = Neighbourhood::gaussian(sigma, 0.0).unwrap();
            core.train(&stimulus, winner, alpha, &near);
            rates.around(usize::from(winner.0), sigma, alpha);
            train(&mut weights, &stimulus, &rates.of, rates.moving.clone());
        }
        for (node, prototype) in core.prototypes().as_slice().iter().enumerate() {
            for (feature, &weight) in prototype.iter().enumerate() {
                assert_eq!(weights[feature * nodes + node].to_bits(), weight.to_bits());
            }
        }
    }

    #[test]
    fn it_is_the_map_of_the_core_to_the_bit() {
        lives::<20, 20, 14>();
        lives::<7, 9, 5>();
        lives::<3, 1, 2>();
    }

    #[test]
    fn unknown_features_count_neither_in_the_search_nor_in_the_update() {
        // Two nodes: (0, 0) and (5, 1).
        let mut weights = vec![0.0, 5.0, 0.0, 1.0];
        let mut distances = [0.0; 2];
        squared_distances(&weights, &[f32::NAN, 0.75], &mut distances);
        assert_eq!((distances, nearest(&distances)), ([0.5625, 0.0625], 1));
        train(&mut weights, &[f32::NAN, 0.75], &[0.0, 1.0], 0..2);
        assert_eq!(weights, [0.0, 5.0, 0.0, 0.75]);
    }
}
