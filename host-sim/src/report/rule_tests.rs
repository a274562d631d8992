//! Rules are read as they are written, and judge as they read.

use super::{Better, Bound, Evidence, Rule, Statistic};
use crate::report::inference::Printed;

fn evidence(seeds: &[f64]) -> Evidence<'_> {
    Evidence {
        estimate: crate::report::mean(seeds),
        interval: (f64::NAN, f64::NAN),
        seeds,
        ahead: f64::NAN,
        test: (f64::NAN, f64::NAN, f64::NAN),
        book: None,
    }
}

#[test]
fn the_text_of_every_rule_is_read_back() {
    let mut rules = vec![Rule::Compared, Rule::Measured];
    rules.extend([Better::Higher, Better::Lower, Better::Neither].map(Rule::Book));
    let bounds = [
        Bound::AtLeast(20.4),
        Bound::AtMost(-1e-9),
        Bound::Above(1.0),
        Bound::Below(0.1 + 0.2),
        Bound::Between(-3.0, 7.25),
    ];
    for statistic in [
        Statistic::Mean,
        Statistic::Median,
        Statistic::Every,
        Statistic::T,
        Statistic::P,
        Statistic::Holm,
        Statistic::Ahead,
        Statistic::Low,
        Statistic::High,
    ] {
        rules.extend(bounds.map(|bound| Rule::Keeps(statistic, bound)));
        rules.push(Rule::Equivalent(statistic, Bound::AtLeast(0.97)));
    }
    rules.push(Rule::All(rules[5..9].to_vec()));
    for rule in rules {
        let text = rule.to_string();
        assert_eq!(text.parse(), Ok(rule), "{text}");
    }
    for nonsense in [
        "",
        "mean",
        "mean >= ",
        "mean >= x",
        "mode > 1",
        "mean >= 1 and ",
        "mean in [1]",
    ] {
        assert!(nonsense.parse::<Rule>().is_err(), "{nonsense}");
    }
}

#[test]
fn the_text_of_a_rule_says_what_is_evaluated() {
    let rule = Rule::All(vec![
        Rule::mean(Bound::AtLeast(20.4)),
        Rule::every_seed(Bound::Above(1.0)),
    ]);
    assert_eq!(rule.to_string(), "mean >= 20.4 and every seed > 1");
    assert!(rule.is_met(&evidence(&[20.0, 21.0])));
    assert!(!rule.is_met(&evidence(&[0.5, 60.0])));
    assert_eq!(Rule::share(19, 20).to_string(), "mean >= 0.95");
    let near = Rule::median_within(640.0, 0.2);
    assert_eq!(near.to_string(), "median in [512, 768]");
}

#[test]
fn nothing_measured_meets_no_rule() {
    for rule in [
        Rule::mean(Bound::AtMost(1.0)),
        Rule::median(Bound::AtLeast(-1.0)),
        Rule::every_seed(Bound::Between(0.0, 1.0)),
        Rule::p(Bound::AtMost(1.0)),
        Rule::Book(Better::Higher),
        Rule::Compared,
        Rule::Measured,
    ] {
        assert!(!rule.is_met(&evidence(&[])), "{rule}");
    }
}

#[test]
fn the_book_is_reproduced_within_its_own_error_and_exceeded_beyond_both() {
    let book = Printed {
        mean: 20.0,
        sd: 1.5,
        n: 10.0,
    };
    let ask = |better, seeds: &[f64]| {
        let evidence = Evidence {
            book: Some(book),
            ..evidence(seeds)
        };
        let rule = Rule::Book(better);
        (rule.is_met(&evidence), rule.is_exceeded(&evidence))
    };
    // 22.9 ± 1.5: within two of the book's deviations.
    let close = [21.4, 22.9, 24.4];
    assert_eq!(ask(Better::Higher, &close), (true, false));
    // As near, but varying five times as much, or a tenth.
    assert_eq!(ask(Better::Higher, &[15.4, 22.9, 30.4]), (false, false));
    assert_eq!(ask(Better::Higher, &[22.75, 22.9, 23.05]), (false, false));
    // 28 ± 0.2 is above 23 and far from touching it; the same below is not better.
    let far = [27.8, 28.0, 28.2];
    assert_eq!(ask(Better::Higher, &far), (true, true));
    assert_eq!(ask(Better::Lower, &far), (false, false));
    assert_eq!(ask(Better::Neither, &far), (false, false));
    // 25 ± 2 is outside the book's error, and its own reaches back into it.
    assert_eq!(ask(Better::Higher, &[23.0, 25.0, 27.0]), (false, false));
}

#[test]
fn a_number_without_spread_is_reproduced_to_its_last_digit() {
    let book = Printed {
        mean: 8.574,
        sd: 0.0,
        n: 10.0,
    };
    let met = |seeds: &[f64]| {
        Rule::Book(Better::Neither).is_met(&Evidence {
            book: Some(book),
            ..evidence(seeds)
        })
    };
    assert!(met(&[8.573_75, 8.573_75]));
    assert!(!met(&[8.5751, 8.5751]));
    assert!(!met(&[8.573_75, 8.573_76]));
}
