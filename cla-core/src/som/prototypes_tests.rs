//! Both numerics against the textbook, weight by weight.

use crate::num::{Neighbourhood, Rng};
use crate::som::{BinarySom, ByteSom, Grid, NodeId, Prototypes, SparseStimulus};

const WIDTH: usize = 19;
const HEIGHT: usize = 3;
const FEATURES: usize = 40;

type Weights = [[f64; FEATURES]; WIDTH * HEIGHT];

fn weights<M: Prototypes<WIDTH, HEIGHT>>(map: &M) -> Weights {
    core::array::from_fn(|node| {
        core::array::from_fn(|j| f64::from(map.weight(NodeId(node as u16), j as u16)))
    })
}

/// Value of a feature; `None` when nobody knows.
fn value(stimulus: &SparseStimulus<'_>, feature: usize) -> Option<f64> {
    let bit = |words: &[u32]| words[feature / 32] >> (feature % 32) & 1 == 1;
    if bit(stimulus.unknown) {
        None
    } else {
        Some(f64::from(u8::from(bit(stimulus.on))) - f64::from(u8::from(bit(stimulus.minus))))
    }
}

fn squared_distance(stimulus: &SparseStimulus<'_>, prototype: &[f64; FEATURES]) -> f64 {
    let known = prototype.iter().enumerate().filter_map(|(j, weight)| {
        let difference = value(stimulus, j)? - weight;
        Some(difference * difference)
    });
    known.fold(0.0, |total, it| total + it)
}

fn words(rng: &mut Rng, p: f32, but: [u32; 2]) -> [u32; 2] {
    let mut words = [0_u32; 2];
    // Features 40 and 41 are outside the map.
    for feature in 0..42 {
        if rng.chance(p) {
            words[feature / 32] |= 1 << (feature % 32);
        }
    }
    [words[0] & !but[0], words[1] & !but[1]]
}

/// Shows a map stimuli of all kinds, and compares each distance and each step of each weight with
/// the formulas; answers the largest differences of distances and of weights.
fn differences<M: Prototypes<WIDTH, HEIGHT>>(seed: u64, steps: u32) -> (f64, f64) {
    let mut rng = Rng::new(seed);
    let mut map = M::ZERO;
    map.randomize(&mut rng);
    let (mut far, mut off) = (0.0_f64, 0.0_f64);
    let mut scratch = Grid::filled(7.0);
    for step in 0..steps {
        // Few features on, many, some at −1, some unknown, and all of this at once.
        let (on, minus, unknown) = match step % 5 {
            0 => (0.15, 0.0, 0.0),
            1 => (0.7, 0.0, 0.0),
            2 => (0.1, 0.2, 0.0),
            3 => (0.1, 0.0, 0.2),
            _ => (0.4, 0.2, 0.3),
        };
        let on = words(&mut rng, on, [0, 0]);
        let minus = words(&mut rng, minus, on);
        let unknown = words(&mut rng, unknown, [on[0] | minus[0], on[1] | minus[1]]);
        let stimulus = SparseStimulus {
            on: &on,
            minus: &minus,
            unknown: &unknown,
        };
        let mut expected = weights(&map);
        let (mut distances, mut sums) = (Grid::filled(9.0), Grid::filled(1.0));
        map.squared_distances(&stimulus, &mut scratch, &mut distances);
        map.add_squared_distances(&stimulus, 0.5, &mut scratch, &mut sums);
        for (node, prototype) in expected.iter().enumerate() {
            let exact = squared_distance(&stimulus, prototype);
            far = far.max((f64::from(distances.as_slice()[node]) - exact).abs());
            far = far.max((f64::from(sums.as_slice()[node]) - 1.0 - 0.5 * exact).abs());
        }
        let winner = NodeId(rng.below((WIDTH * HEIGHT) as u32) as u16);
        if step % 29 == 28 {
            map.imprint(&stimulus, winner);
            let prototype = &mut expected[usize::from(winner.0)];
            for (j, weight) in prototype.iter_mut().enumerate() {
                *weight = value(&stimulus, j).unwrap_or(0.5);
            }
        } else {
            let near = Neighbourhood::gaussian(7.0 * rng.unit(), 0.01).unwrap();
            let alpha = rng.unit();
            let still = rng.below(9) as u16;
            let may_move = |node: NodeId| step % 2 == 0 || node.0 % 9 != still;
            map.train(&stimulus, winner, alpha, &near, may_move);
            let place = Grid::<f32, WIDTH, HEIGHT>::filled(0.0);
            let (x, y) = place.position(winner);
            for (node, prototype) in expected.iter_mut().enumerate() {
                let (u, v) = place.position(NodeId(node as u16));
                if !may_move(NodeId(node as u16)) {
                    continue;
                }
                let c = f64::from(alpha * near.weight(x.abs_diff(u), y.abs_diff(v)));
                for (j, weight) in prototype.iter_mut().enumerate() {
                    if let Some(value) = value(&stimulus, j) {
                        *weight += c * (value - *weight);
                    }
                }
            }
        }
        let now = weights(&map);
        for (ours, theirs) in now.iter().flatten().zip(expected.iter().flatten()) {
            off = off.max((ours - theirs).abs());
        }
    }
    (far, off)
}

#[test]
fn every_step_of_a_map_of_floats_is_the_textbooks() {
    let (far, off) = differences::<BinarySom<WIDTH, HEIGHT, FEATURES>>(1, 290);
    assert!(far < 1e-3 && off < 1e-5, "{far} {off}");
}

#[test]
fn every_step_of_a_map_of_bytes_is_the_textbooks_but_for_the_rounding() {
    let (far, off) = differences::<ByteSom<WIDTH, HEIGHT, FEATURES>>(2, 290);
    // A weight is one of 255; imprinted, one that nobody knows is 63 of 127 and not a half.
    assert!(far < 1e-3 && off < 1.02 / 127.0, "{far} {off}");
}

#[test]
fn a_node_that_follows_for_ever_keeps_its_digits() {
    // Alone and among neighbours that follow with it, with and without what nobody knows.
    for (unknown, sigma) in [(0, 0.0), (0, 9.0), (0b100, 0.0), (0b100, 9.0)] {
        let mut map = BinarySom::<2, 1, 3>::ZERO;
        map.randomize(&mut Rng::new(3));
        let before = map.weight(NodeId(0), 2);
        let near = Neighbourhood::gaussian(sigma, 0.0).unwrap();
        let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
        for step in 0..400 {
            let stimulus = SparseStimulus {
                on: if step % 2 == 0 { &[0b01] } else { &[0b11] },
                minus: &[],
                unknown: &[unknown],
            };
            map.train(&stimulus, NodeId(0), 0.5, &near, |_| true);
            map.squared_distances(&stimulus, &mut scratch, &mut distances);
        }
        let kept = if unknown == 0 { 0.0 } else { before };
        assert!((map.weight(NodeId(0), 0) - 1.0).abs() < 1e-5);
        assert!((map.weight(NodeId(0), 2) - kept).abs() < 1e-4);
        // The second feature is 2/3 after a step towards 1.
        let far = distances.as_slice()[0];
        assert!((far - 1.0 / 9.0).abs() < 1e-3, "{far}");
    }
}

#[test]
fn a_map_answers_nothing_for_nodes_and_features_that_it_does_not_have() {
    fn outside<M: Prototypes<2, 1>>() -> [f32; 3] {
        let mut map = M::ZERO;
        map.randomize(&mut Rng::new(3));
        let stimulus = SparseStimulus {
            on: &[0b1],
            minus: &[],
            unknown: &[],
        };
        map.imprint(&stimulus, NodeId(0));
        map.imprint(&stimulus, NodeId(2));
        map.train(
            &stimulus,
            NodeId(2),
            1.0,
            &Neighbourhood::winner_only(),
            |_| true,
        );
        [(0, 0), (2, 0), (0, 3)].map(|(node, feature)| map.weight(NodeId(node), feature))
    }
    assert_eq!(outside::<BinarySom<2, 1, 3>>(), [1.0, 0.0, 0.0]);
    assert_eq!(outside::<ByteSom<2, 1, 3>>(), [1.0, 0.0, 0.0]);
}

#[test]
fn weights_are_drawn_from_the_whole_of_zero_to_one() {
    fn drawn<M: Prototypes<WIDTH, HEIGHT>>() -> (f64, f64, f64) {
        let mut map = M::ZERO;
        map.randomize(&mut Rng::new(5));
        let all = weights(&map);
        let all = all.iter().flatten();
        let mean = all.clone().fold(0.0, |sum, it| sum + it) / (57.0 * 40.0);
        let ends = all.fold((1.0_f64, 0.0_f64), |(low, high), &it| {
            (low.min(it), high.max(it))
        });
        (ends.0, mean, ends.1)
    }
    for (low, mean, high) in [
        drawn::<BinarySom<WIDTH, HEIGHT, FEATURES>>(),
        drawn::<ByteSom<WIDTH, HEIGHT, FEATURES>>(),
    ] {
        assert!(
            (0.0..0.01).contains(&low) && (0.99..1.0).contains(&high),
            "{low} {high}"
        );
        assert!((mean - 0.5).abs() < 0.02, "{mean}");
    }
}
