//! Maps of bytes beside those of floats, their rounding, and what is kept of |m|².

use super::{ByteSom, Norms};
use crate::num::{Neighbourhood, Rng};
use crate::som::{BinarySom, Grid, NodeId, Prototypes, SparseStimulus, best_match};

/// Mean quantization error of a map trained on sixteen patterns of three items.
fn error<M: Prototypes<6, 6>>(seed: u64) -> f32 {
    let mut map = M::ZERO;
    let mut rng = Rng::new(seed);
    map.randomize(&mut rng);
    let patterns: [u32; 16] = core::array::from_fn(|i| 1 << i | 1 << (i + 3) | 1 << (2 * i));
    let (mut scratch, mut total) = (Grid::filled(0.0), 0.0);
    for t in 0..3000 {
        let words = [patterns[rng.below(16) as usize]];
        let minus = [words[0] << 1 & !words[0]];
        let stimulus = SparseStimulus {
            on: &words,
            minus: &minus,
            unknown: &[],
        };
        let mut distances = Grid::filled(0.0);
        map.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
        let best = best_match(&distances);
        let sigma = 3.0 * 0.01_f32.powf(t as f32 / 3000.0);
        let near = Neighbourhood::gaussian(sigma, 0.01).unwrap();
        map.train(&stimulus, best.node, 0.05, &near, |_| true);
        if t >= 2500 {
            total += best.squared_distance / 500.0;
        }
    }
    total
}

#[test]
fn bytes_represent_as_well_as_floats_though_a_late_step_is_below_their_resolution() {
    // A map that folds badly errs by more than any rounding does, so the median of five counts.
    let median = |error: fn(u64) -> f32| {
        let mut errors = [1, 2, 3, 4, 5].map(error);
        errors.sort_by(f32::total_cmp);
        errors[2]
    };
    let bytes = median(error::<ByteSom<6, 6, 40>>);
    let floats = median(error::<BinarySom<6, 6, 40>>);
    assert!((bytes - floats).abs() < 0.02, "{bytes} against {floats}");
}

#[test]
fn small_steps_move_a_weight_on_average() {
    let mut map = ByteSom::<1, 1, 200>::ZERO;
    map.randomize(&mut Rng::new(9));
    let all = [u32::MAX; 7];
    let none = SparseStimulus {
        on: &[],
        minus: &[],
        unknown: &[],
    };
    let on = SparseStimulus {
        on: &all,
        minus: &[],
        unknown: &[],
    };
    map.imprint(&none, NodeId(0));
    for _ in 0..100 {
        map.train(&on, NodeId(0), 0.002, &Neighbourhood::winner_only(), |_| {
            true
        });
    }
    let mut mean = 0.0;
    for feature in 0..200 {
        mean += map.weight(NodeId(0), feature) / 200.0;
    }
    let expected = 1.0 - 0.998_f32.powi(100);
    assert!((mean - expected).abs() < 0.02, "{mean} against {expected}");
}

#[test]
fn unknown_features_are_neither_compared_nor_trained() {
    let mut map = ByteSom::<1, 1, 3>::ZERO;
    map.randomize(&mut Rng::new(2));
    let before = map.weight(NodeId(0), 1);
    let stimulus = SparseStimulus {
        on: &[0b001],
        minus: &[0b100],
        unknown: &[0b010],
    };
    map.train(
        &stimulus,
        NodeId(0),
        1.0,
        &Neighbourhood::winner_only(),
        |_| true,
    );
    let weights = [0, 1, 2].map(|feature| map.weight(NodeId(0), feature));
    assert_eq!(weights, [1.0, before, -1.0]);
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    map.add_squared_distances(&stimulus, 1.0, &mut scratch, &mut distances);
    assert_eq!(distances.as_slice(), [0.0]);
}

#[test]
fn a_step_rounds_up_as_often_as_its_fraction_says() {
    // From 0 towards 127 by 1/508: a quarter of the weights move by one, whichever they are.
    let mut map = ByteSom::<1, 1, 2000>::ZERO;
    map.randomize(&mut Rng::new(4));
    let (none, all) = ([0_u32; 63], [u32::MAX; 63]);
    let of = |on| SparseStimulus {
        on,
        minus: &[],
        unknown: &[],
    };
    for (on, goal, step) in [(&none, &all, 1.0), (&all, &none, -1.0)] {
        map.imprint(&of(on), NodeId(0));
        let c = 1.0 / 508.0;
        map.train(
            &of(goal),
            NodeId(0),
            c,
            &Neighbourhood::winner_only(),
            |_| true,
        );
        let from = if step > 0.0 { 0.0 } else { 1.0 };
        let moved = |feature: u16| (map.weight(NodeId(0), feature) - from) * 127.0 * step;
        let mut count = 0;
        let mut pairs = 0;
        for feature in 0..2000 {
            let far = moved(feature);
            assert!(far.abs() < 0.01 || (far - 1.0).abs() < 0.01, "{far}");
            count += u32::from(far > 0.5);
            pairs += u32::from(far > 0.5 && feature > 0 && moved(feature - 1) > 0.5);
        }
        // Five standard deviations; and of two neighbours one says nothing of the other.
        assert!((403..=597).contains(&count), "{count}");
        assert!((70..=180).contains(&pairs), "{pairs}");
    }
}

/// A map that has seen stimuli of all kinds, and the last of them.
fn lived<N: Norms<9, 7>>(seed: u64, signed: bool) -> (ByteSom<9, 7, 40, N>, [[u32; 2]; 3]) {
    let mut map = ByteSom::<9, 7, 40, N>::ZERO;
    let mut rng = Rng::new(seed);
    map.randomize(&mut rng);
    let mut words = [[0_u32; 2]; 3];
    for t in 0..60 {
        words = [[0; 2]; 3];
        for j in 0..40 {
            let set = match rng.below(20) {
                0..5 => 0,
                5 if signed => 1,
                6 if t % 3 == 0 => 2,
                _ => continue,
            };
            words[set][j / 32] |= 1 << (j % 32);
        }
        let [on, minus, unknown] = &words;
        let x = SparseStimulus { on, minus, unknown };
        let winner = NodeId(rng.below(63) as u16);
        let near = Neighbourhood::gaussian(2.0, 0.01).unwrap();
        map.train(&x, winner, 0.3, &near, |node| node.0 % 5 != 2);
        if t % 9 == 4 {
            map.imprint(&x, NodeId(rng.below(63) as u16));
        }
    }
    (map, words)
}

#[test]
fn what_is_kept_of_the_norms_is_what_the_weights_have() {
    for (seed, signed) in [(1, false), (2, true), (3, false), (4, true)] {
        let (mut kept, _) = lived::<Grid<i32, 9, 7>>(seed, signed);
        for node in 0..63 {
            assert!(!kept.audit(NodeId(node)), "{node} needs no mending");
        }
        let sound = kept.norms.clone();
        kept.norms.as_mut_slice()[17] ^= 1 << 9;
        assert!(kept.audit(NodeId(17)) && !kept.audit(NodeId(16)));
        assert_eq!(kept.norms, sound);
    }
}

#[test]
fn a_weight_that_cannot_be_makes_its_node_a_free_one() {
    let (mut map, _) = lived::<Grid<i32, 9, 7>>(1, false);
    map.columns[3].as_mut_slice()[5] = -128;
    assert!(map.audit(NodeId(5)) && !map.audit(NodeId(5)));
    assert_eq!(map.weight(NodeId(5), 3), 63.0 / 127.0);
}

#[test]
fn a_map_that_keeps_no_norms_answers_the_same() {
    for (seed, signed) in [(1, false), (2, true), (3, false), (4, true)] {
        let (kept, [on, minus, unknown]) = lived::<Grid<i32, 9, 7>>(seed, signed);
        let (lean, _) = lived::<()>(seed, signed);
        let x = SparseStimulus {
            on: &on,
            minus: &minus,
            unknown: &unknown,
        };
        let plain = SparseStimulus {
            on: &[1 << 3 | 1 << 30, 1],
            minus: &[],
            unknown: &[],
        };
        for x in [x, plain] {
            let mut scratch = Grid::filled(0.0);
            let [mut one, mut other, mut work] = [const { Grid::filled(7.0) }; 3];
            kept.squared_distances(&x, &mut scratch, &mut one);
            lean.squared_distances(&x, &mut scratch, &mut other);
            assert_eq!(one, other);
            let best = best_match(&one);
            assert_eq!(kept.best_match(&x, &mut scratch, &mut work), best);
            assert_eq!(lean.best_match(&x, &mut scratch, &mut work), best);
        }
    }
}

#[test]
fn a_node_of_many_features_is_mended_whole() {
    let mut map = ByteSom::<2, 1, 3000>::ZERO;
    map.randomize(&mut Rng::new(1));
    map.columns[7].as_mut_slice()[1] = i8::MIN;
    assert!(!map.audit(NodeId(0)) && map.audit(NodeId(1)));
    let weights = [0, 2047, 2048, 2999].map(|feature| map.weight(NodeId(1), feature));
    assert_eq!(weights, [63.0 / 127.0; 4]);
    assert!(!map.audit(NodeId(1)));
}
