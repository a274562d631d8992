//! Every verdict is reached by what it asks for, and by nothing less.

use super::judge;
use crate::report::Expectation;
use crate::report::claims::{Claim, Verdict};
use crate::report::rule::{Better, Bound, Rule, Statistic};

fn claim(rule: Rule) -> Expectation {
    Expectation::new("a.b", "6.1", "captures").rule(rule)
}

fn spread(centre: f64, step: f64, n: u32) -> Vec<f64> {
    let middle = f64::from(n - 1) / 2.0;
    (0..n)
        .map(|it| centre + (f64::from(it) - middle) * step)
        .collect()
}

#[test]
fn every_verdict_is_reached_and_written_in_its_words() {
    let book = |mean| claim(Rule::Book(Better::Higher)).book((mean, 1.5, 10));
    let seeds = spread(20.0, 0.4, 10);
    let aim = |least| claim(Rule::mean(Bound::AtLeast(least))).extension();
    for (claim, words) in [
        (book(20.4).judge(&seeds), "reproduced"),
        (book(12.0).judge(&seeds), "exceeded"),
        (book(26.0).judge(&seeds), "not reproduced"),
        (
            aim(1.0).contradicts_itself("a and b").judge(&seeds),
            "contradicts itself",
        ),
        (claim(Rule::Compared).book(20.0).judge(&seeds), "compared"),
        (aim(19.0).judge(&seeds), "extension: met"),
        (aim(21.0).judge(&seeds), "extension: missed"),
        (aim(19.0).judge(&seeds[..9]), "n too small"),
        (claim(Rule::Measured).judge(&seeds), "measured"),
    ] {
        assert_eq!(serde_json::to_value(claim.verdict).unwrap(), words);
        assert_eq!(claim.verdict.to_string(), words);
        let decided = !matches!(words, "compared" | "n too small" | "measured");
        assert_eq!(claim.met.is_some(), decided, "{words}");
    }
    assert_eq!(Verdict::ALL.len(), 9);
}

#[test]
fn the_test_is_that_of_the_estimate() {
    let tested = |claim: Claim| claim.tested.map(|it| it.test);
    let seeds = spread(20.0, 1.0, 10);
    let aim = || claim(Rule::mean(Bound::AtLeast(19.0)));
    for (claim, test) in [
        (aim().judge(&seeds), "t against 19"),
        (aim().judge_ratio(&seeds, &seeds), "paired t of equal means"),
        (
            aim().judge_difference(&seeds, &seeds),
            "paired t of equal means",
        ),
        (
            claim(Rule::share(9, 10)).judge_share(&[true; 10]),
            "exact binomial against 0.9",
        ),
        (
            claim(Rule::median(Bound::AtMost(9.0))).judge_time(&seeds),
            "sign test against 9",
        ),
        (
            claim(Rule::Book(Better::Neither))
                .book((20.0, 1.0, 10))
                .judge(&seeds),
            "Welch's t against the printed mean",
        ),
    ] {
        assert_eq!(tested(claim).as_deref(), Some(test));
    }
    assert_eq!(tested(aim().judge_count(3.0)), None);
    assert_eq!(tested(claim(Rule::Measured).judge(&seeds)), None);
}

#[test]
fn an_equivalence_needs_sixty_seeds_or_the_same_lives() {
    let rule = || claim(Rule::Equivalent(Statistic::Low, Bound::AtLeast(0.95))).extension();
    let seeds = spread(300.0, 1.0, 60);
    let other: Vec<f64> = seeds.iter().map(|it| it * 0.99).collect();
    assert_eq!(rule().judge_ratio(&other, &seeds).verdict, Verdict::Met);
    assert_eq!(
        rule().judge_ratio(&other[..59], &seeds[..59]).verdict,
        Verdict::TooSmall
    );
    assert_eq!(
        rule().judge_ratio(&seeds[..20], &seeds[..20]).verdict,
        Verdict::Met
    );
    let worse: Vec<f64> = seeds.iter().map(|it| it * 0.94).collect();
    assert_eq!(rule().judge_ratio(&worse, &seeds).verdict, Verdict::Missed);
}

#[test]
fn a_family_is_corrected_together_and_counts_who_is_ahead() {
    let base = spread(100.0, 1.0, 20);
    let noise: Vec<f64> = (0..20).map(|it| f64::from((it * 7) % 5) - 2.0).collect();
    let shifted = |by: f64| -> Vec<f64> {
        base.iter()
            .zip(&noise)
            .map(|(it, noise)| it + by + noise)
            .collect()
    };
    let member = |id: &str, by: f64| {
        let rule = Rule::Keeps(Statistic::Holm, Bound::AtMost(0.05));
        let claim = Expectation::new(id, "6.1", "ratio")
            .rule(rule)
            .family("a.over");
        claim.extension().judge_ratio(&shifted(by), &base)
    };
    let ahead = Expectation::new("a.ahead", "6.1", "members")
        .family("a.over")
        .extension();
    let rule = Rule::mean(Bound::AtLeast(2.0));
    let mut claims = vec![
        member("a.one", 5.0),
        member("a.two", 0.3),
        member("a.three", -5.0),
        ahead.rule(rule).judge_family(),
        claim(Rule::mean(Bound::AtLeast(0.0))).judge(&base),
    ];
    let alone: Vec<Option<f64>> = claims.iter().map(|it| it.tested.as_ref()?.holm).collect();
    judge(&mut claims);
    let tested = |index: usize| claims[index].tested.as_ref().unwrap();
    assert_eq!(tested(0).members, 3);
    assert_eq!(tested(4).members, 1);
    for (index, alone) in alone.iter().enumerate().take(3) {
        assert!(tested(index).holm >= tested(index).p, "{index}");
        assert!(tested(index).holm >= *alone, "{index}");
    }
    // The weakest of three keeps its probability, the others are multiplied.
    assert_eq!(tested(1).holm, tested(1).p);
    assert!(tested(1).p.unwrap() > 0.05);
    // One is ahead; one is behind, as clearly, and does not count.
    assert_eq!(claims[3].ours.value, Some(1.0));
    assert_eq!(claims[3].verdict, Verdict::Missed);
}

#[test]
fn judging_twice_changes_nothing() {
    let mut claims = vec![
        claim(Rule::Book(Better::Higher))
            .book((20.4, 1.53, 10))
            .judge(&spread(21.0, 0.3, 20)),
        claim(Rule::share(9, 10)).judge_share(&[true; 12]),
        claim(Rule::median(Bound::AtMost(9.0))).judge_time(&[1.0, f64::NAN, 3.0]),
    ];
    judge(&mut claims);
    let once = claims.clone();
    judge(&mut claims);
    assert_eq!(claims, once);
}
