//! The experiment with one learner, at a hundredth of its length, and its judgement by itself.

use super::damages::{COURSE, FIRST, ids, name};
use super::family::Damages;
use super::{One, OneOptions, Part, Trial, claims, declared};
use crate::experiment::plan;
use crate::experiment::record::judged_again;
use crate::progress::Progress;
use crate::report::{Claim, Estimator, Rule, Verdict};
use crate::world::damage::Damage;

#[test]
fn every_part_is_lived_written_down_and_judged_and_leaves_no_claim_without_a_number() {
    let options = OneOptions {
        shorter: 100,
        ..OneOptions::standard(vec![3, 4])
    };
    let results = judged_again::<One>(&options).unwrap();
    let of_all_seeds = [
        "one.recover.family.size",
        "one.recover.family.ahead",
        "one.recover.family.behind",
        "one.recover.not_back",
        "one.recover.over_newborn",
    ];
    for claim in &results.summary.claims {
        let id = claim.id.as_str();
        let expected = match claim.estimator {
            Estimator::Count if of_all_seeds.contains(&id) => 0,
            Estimator::Count => 1,
            _ => 2,
        };
        assert_eq!(claim.ours.n, expected, "{id}");
        // Shorter lives are no test of what is claimed.
        assert!(
            matches!(claim.verdict, Verdict::Measured | Verdict::TooSmall),
            "{id}"
        );
    }
    let named =
        |claims: &[Claim]| -> Vec<String> { claims.iter().map(|it| it.id.clone()).collect() };
    assert_eq!(named(&results.summary.claims), named(&declared()));
}

#[test]
fn a_life_without_end_is_lived_on_demand() {
    let options = OneOptions {
        shorter: 5000,
        ..OneOptions::new(vec![1], &["forager".into()], true).unwrap()
    };
    let summary = judged_again::<One>(&options).unwrap().summary;
    assert_eq!(summary.find("one.forager.captures_200k").unwrap().ours.n, 1);
    let worst = summary.find("one.forager.worst_block").unwrap();
    assert!(worst.ours.value.is_none_or(|it| (0.0..=1.0).contains(&it)));
}

#[test]
fn parts_are_lived_the_same_alone() {
    let lived = |parts: &[Part]| {
        let options = OneOptions {
            shorter: 200,
            parts: parts.to_vec(),
            ..OneOptions::standard(vec![5])
        };
        plan::trials::<One>(&options, &Progress::hidden()).unwrap()
    };
    let both = lived(&[Part::Unknown, Part::Shuttle]);
    for part in [Part::Unknown, Part::Shuttle] {
        let alone = lived(&[part]);
        assert!(!alone[0].measured.is_empty());
        for (name, numbers) in &alone[0].measured {
            assert_eq!(both[0].several(name), numbers, "{name}");
        }
    }
}

#[test]
fn all_reported_damages_are_met() {
    assert_eq!(ids().len(), Damage::REPORTED.len());
}

/// Ten seeds in which each thousand brings so much, and a little more in every second seed.
fn lived(of: impl Fn(&str, &str, usize) -> f64) -> Vec<Trial> {
    let seed = |seed: u64| {
        let mut trial = Trial {
            seed,
            ..Trial::default()
        };
        let course = |id: &str, who: &str, length| -> Vec<f64> {
            let more = (seed % 2) as f64;
            (0..length).map(|it| of(id, who, it) + more).collect()
        };
        trial.note_all(name("none", "mind"), course("none", "mind", COURSE));
        for id in ids() {
            for (who, length) in [
                ("mind", COURSE),
                ("newborn", COURSE),
                ("sarsa", FIRST),
                ("history", FIRST),
            ] {
                trial.note_all(name(&id, who), course(&id, who, length));
            }
        }
        trial
    };
    (0..10).map(seed).collect()
}

#[test]
fn the_family_is_where_a_newborn_gets_half_and_there_one_is_ahead_of_each_rival() {
    let trials = lived(|id, who, thousand| match (id, who) {
        // No newborn gets far with a blocked beam, so nobody is judged there.
        ("beam", "mind") => 1.0,
        ("beam", "newborn") => 20.0,
        (_, "newborn") => 90.0,
        // Behind one rival at first, and behind the newborn afterwards.
        ("dead_s2", "mind") => 60.0,
        ("dead_s2", "history") => 65.0,
        (_, "mind") if thousand == 0 => 40.0,
        (_, "mind") => 100.0,
        _ => 50.0,
    });
    let ids = ids();
    let of = Damages::new(&trials, &ids);
    assert!(!of.has("beam") && of.has("dead_s2"));
    assert_eq!(of.size(), 12.0);
    assert_eq!(of.ahead(), 11.0 / 12.0);
    // The same five in every seed are no chance.
    let claims = claims::summary(&OneOptions::standard((0..10).collect()), &trials).judged();
    let of = |id: &str| claims.find(id).unwrap().clone();
    assert_eq!(of("one.recover.family.ahead").verdict, Verdict::Met);
    assert_eq!(of("one.recover.family.behind").verdict, Verdict::Missed);
    assert_eq!(of("one.recover.family.behind").ours.value, Some(1.0));
    // .9 of 101 is reached by newborns of 91 everywhere but with the beam.
    assert_eq!(of("one.recover.not_back").ours.value, Some(1.0));
    // 60 a thousand against 90 is 30 behind, and after ten of them more than 270; with the beam 1
    // against 20 is more than 60 behind after four.
    assert_eq!(of("one.recover.over_newborn").ours.value, Some(2.0));
    let camera = of("one.recover.camera.captures_3000");
    assert_eq!(camera.ours.value, Some(241.5));
    assert_eq!(camera.verdict, Verdict::Met);
    assert_eq!(
        of("one.recover.stuck_s3.captures_3000").verdict,
        Verdict::Met
    );
}

#[test]
fn few_seeds_say_nothing_of_a_family() {
    let ids = ids();
    let trials = lived(|_, _, _| 50.0);
    assert!(Damages::new(&trials[..9], &ids).ahead().is_nan());
    assert!(Damages::new(&[], &ids).worse_than_newborn().is_nan());
}

#[test]
fn a_ratio_is_asked_for_and_an_interval_close_to_it() {
    let all = declared();
    let rule = |id: &str| all.iter().find(|it| it.id == id).unwrap().rule.to_string();
    assert_eq!(
        rule("one.forager.captures"),
        "mean >= 1.05 and lower end >= 0.98"
    );
    assert_eq!(
        rule("one.forager.captures_50k"),
        "mean >= 330 and lower end >= 306.9"
    );
    assert_eq!(rule("one.harm.visits"), "mean <= 0.1 and upper end <= 0.17");
    assert!(all.iter().all(|it| it.rule != Rule::Compared));
}
