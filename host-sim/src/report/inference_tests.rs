//! The tests and intervals beside SciPy 1.17.1's, and at their edges.

use super::{
    Printed, binomial_test, holm, median_interval, one_sample_t, paired_t, ratio_interval,
    share_interval, welch_of_printed,
};
use crate::report::statistics::Interval;

const A: [f64; 10] = [27.5, 21.0, 19.0, 23.6, 17.0, 17.9, 16.9, 20.1, 21.9, 22.6];
const B: [f64; 10] = [27.1, 22.0, 20.8, 23.4, 23.4, 23.5, 25.8, 20.0, 22.5, 19.0];

fn near(value: f64, expected: f64) {
    let scale = expected.abs().max(1e-300);
    assert!(
        (value - expected).abs() / scale < 1e-8,
        "{value} for {expected}"
    );
}

#[test]
fn t_tests_agree_with_scipy() {
    let one = one_sample_t(&A, 20.0);
    near(one.statistic, 0.715_151_122_101_861_6);
    near(one.p, 0.492_649_153_195_742_7);
    let paired = paired_t(&A, &B);
    near(paired.statistic, -1.668_599_034_465_448);
    near(paired.p, 0.129_540_663_450_277_23);
    let level2 = Printed {
        mean: 22.9,
        sd: 1.19,
        n: 10.0,
    };
    let level1 = Printed {
        mean: 20.4,
        sd: 1.53,
        n: 10.0,
    };
    let printed = welch_of_printed(level2, level1);
    near(printed.statistic, 4.078_677_913_420_803);
    near(printed.p, 0.000_784_365_314_485_088_2);
}

#[test]
fn exact_tests_and_intervals_of_shares_agree_with_scipy() {
    for (yes, n, chance, p) in [
        (18, 20, 0.5, 0.000_201_225_280_761_718_75),
        (3, 20, 0.5, 0.001_288_414_001_464_843_8),
        (20, 20, 0.9, 0.121_576_654_590_569_31),
        (12, 20, 0.95, 2.856_885_382_818_765e-6),
    ] {
        near(binomial_test(yes, n, chance).p, p);
    }
    for (yes, n, low, high) in [
        (20, 20, 0.831_566_529_016_914_5, 1.0),
        (0, 10, 0.0, 0.308_497_107_818_762_94),
        (7, 20, 0.153_909_204_784_541_2, 0.592_188_534_532_828_3),
        (12, 20, 0.360_542_587_307_244_8, 0.808_809_939_274_429_5),
    ] {
        let interval = share_interval(yes, n);
        assert!(
            (interval.low - low).abs() < 1e-7,
            "{yes} of {n}: {interval:?}"
        );
        assert!(
            (interval.high - high).abs() < 1e-7,
            "{yes} of {n}: {interval:?}"
        );
    }
}

#[test]
fn the_median_lies_between_the_order_statistics_that_the_binomial_names() {
    // As many values lie outside on each side as scipy.stats.binom.cdf(k, n, .5) <= .025 allows.
    for (n, outside) in [(6_u32, 0), (10, 1), (20, 5), (40, 13)] {
        let values: Vec<f64> = (0..n).map(f64::from).collect();
        let interval = median_interval(&values);
        assert_eq!(interval.low, f64::from(outside), "{n}");
        assert_eq!(interval.high, f64::from(n - 1 - outside), "{n}");
    }
    assert!(median_interval(&[1.0, 2.0, 3.0, 4.0, 5.0]).low.is_nan());
    let never = [
        1.0,
        2.0,
        3.0,
        4.0,
        f64::INFINITY,
        f64::INFINITY,
        f64::INFINITY,
    ];
    assert_eq!(median_interval(&never).high, f64::INFINITY);
}

#[test]
fn the_interval_of_a_ratio_pairs_what_belongs_together() {
    // Both arms vary by half of their mean, the ratio hardly: unpaired the interval would be wide.
    let below: Vec<f64> = (10..30).map(f64::from).collect();
    let above: Vec<f64> = below
        .iter()
        .zip(0..)
        .map(|(it, i)| it * 1.5 + f64::from(i % 2))
        .collect();
    let interval = ratio_interval(&above, &below);
    assert!(interval.low > 1.5 && interval.high < 1.56, "{interval:?}");
    assert_eq!(interval, ratio_interval(&above, &below));
    assert!(ratio_interval(&[1.0], &[2.0]).low.is_nan());
    assert!(ratio_interval(&[1.0, 2.0], &[0.0, 0.0]).low.is_nan());
}

#[test]
fn holm_never_makes_a_probability_smaller_nor_turns_their_order() {
    let p = [0.04, f64::NAN, 0.001, 0.6, 0.012];
    let corrected = holm(&p);
    // By hand: .001 x 4, .012 x 3, .04 x 2, .6 x 1.
    assert!(corrected[1].is_nan());
    for (index, expected) in [(2, 0.004), (4, 0.036), (0, 0.08), (3, 0.6)] {
        near(corrected[index], expected);
    }
    assert_eq!(holm(&[0.9, 0.8]), [1.0, 1.0]);
}

#[test]
fn too_little_gives_no_answer_and_never_panics() {
    assert!(one_sample_t(&[1.0], 0.0).p.is_nan());
    assert!(one_sample_t(&[1.0, 1.0], 1.0).p.is_nan());
    assert_eq!(one_sample_t(&[1.0, 1.0], 0.0).p, 0.0);
    assert!(paired_t(&[], &[]).p.is_nan());
    assert!(binomial_test(0, 0, 0.5).p.is_nan());
    assert!(binomial_test(1, 2, 2.0).p.is_nan());
    assert_eq!(binomial_test(0, 5, 0.0).p, 1.0);
    assert!(share_interval(0, 0).low.is_nan());
    assert!(median_interval(&[]).low.is_nan());
    let nothing: Interval = ratio_interval(&[], &[]);
    assert!(nothing.low.is_nan());
    assert!(holm(&[]).is_empty());
}

#[test]
fn the_resampling_draws_the_published_sequence() {
    // The first outputs of SplitMix64 for seed 1234567, as its reference implementation prints them.
    let mut state = 1_234_567;
    let drawn = [(); 3].map(|()| super::draw(&mut state, 1_000_000));
    let outputs: [u64; 3] = [
        6_457_827_717_110_365_317,
        3_203_168_211_198_807_973,
        9_817_491_932_198_370_423,
    ];
    let expected = outputs.map(|it| ((u128::from(it) * 1_000_000) >> 64) as usize);
    assert_eq!(drawn, expected);
}
