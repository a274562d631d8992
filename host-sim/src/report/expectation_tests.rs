//! What an expectation makes of its measurements.

use super::Expectation;
use crate::report::claims::{Claim, Estimator, Verdict};
use crate::report::rule::{Bound, Rule};

fn expectation() -> Expectation {
    Expectation::new("a.b", "6.1", "captures").rule(Rule::mean(Bound::AtLeast(2.0)))
}

#[test]
fn a_missing_seed_keeps_its_place_and_does_not_count() {
    let claim = expectation().judge(&[1.0, f64::NAN, 3.0]);
    assert_eq!(claim.per_seed, [Some(1.0), None, Some(3.0)]);
    assert_eq!((claim.ours.n, claim.ours.value), (2, Some(2.0)));
    let none = expectation().judge(&[f64::NAN]);
    assert_eq!((none.ours.value, none.verdict), (None, Verdict::TooSmall));
}

#[test]
fn one_seed_has_a_number_without_spread_and_no_verdict() {
    let claim = expectation().judge(&[5.0]);
    assert_eq!((claim.ours.value, claim.ours.sd), (Some(5.0), None));
    assert_eq!(claim.ours.interval, None);
    assert_eq!((claim.verdict, claim.met), (Verdict::TooSmall, None));
}

#[test]
fn a_ratio_is_of_means_over_whole_pairs_and_keeps_both_halves() {
    let claim = expectation().judge_ratio(&[1.0, 9.0, 5.0], &[1.0, 3.0]);
    assert_eq!(claim.estimator, Estimator::Ratio);
    assert_eq!((claim.ours.value, claim.ours.sd), (Some(2.5), None));
    assert_eq!(claim.ours.n, 2);
    assert_eq!(claim.against, Some(vec![Some(1.0), Some(3.0), None]));
    // Over means of 0 there is no ratio; a single 0 is an ordinary pair.
    assert_eq!(expectation().judge_ratio(&[1.0], &[0.0]).ours.value, None);
    let claim = expectation().judge_ratio(&[1.0, 3.0], &[0.0, 2.0]);
    assert_eq!(claim.ours.value, Some(2.0));
}

#[test]
fn what_never_happens_is_counted_and_not_averaged() {
    let times = [100.0, f64::NAN, 300.0, f64::INFINITY, 200.0];
    let claim = expectation().judge_time(&times);
    assert_eq!(
        (claim.ours.value, claim.ours.never, claim.ours.n),
        (Some(300.0), Some(2), 5)
    );
    let claim = expectation().judge_time(&[f64::NAN, f64::NAN, 1.0]);
    assert_eq!((claim.ours.value, claim.ours.never), (None, Some(2)));
}

#[test]
fn a_rule_about_the_median_makes_it_the_estimate() {
    let rule = Rule::median(Bound::AtMost(3.0));
    let claim = Expectation::new("a.b", "6.1", "actions")
        .rule(rule)
        .judge(&[1.0, 2.0, 90.0]);
    assert_eq!(
        (claim.estimator, claim.ours.value),
        (Estimator::Median, Some(2.0))
    );
    assert_eq!(claim.ours.sd, None);
}

#[test]
fn json_gives_back_every_bit() {
    let awkward = [0.1 + 0.2, 1.0 / 3.0, f64::MIN_POSITIVE, 6.02e23, -0.0];
    let claim = expectation().book(0.1 + 0.7).note("why").judge(&awkward);
    let text = serde_json::to_string_pretty(&claim).unwrap();
    let back: Claim = serde_json::from_str(&text).unwrap();
    assert_eq!(back, claim);
    let bits = |claim: &Claim| -> Vec<u64> {
        let values = claim.per_seed.iter().flatten();
        values.map(|value| value.to_bits()).collect()
    };
    assert_eq!(bits(&back), bits(&claim));
}
