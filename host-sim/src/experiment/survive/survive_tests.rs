//! The experiment on survival, at a small part of its length, and its judgement by itself.

use super::{Scale, Survive, SurviveOptions, declared};
use crate::experiment::plan::{Experiment, trials};
use crate::experiment::record::judged_again;
use crate::progress::Progress;
use crate::report::{Claim, Estimator, Summary, Verdict};

/// Without the part that starts an emulator.
fn small(seeds: Vec<u64>) -> SurviveOptions {
    let mut options = SurviveOptions {
        shorter: Scale(200),
        ..SurviveOptions::standard(seeds)
    };
    options.parts.retain(|it| it.name != "kill");
    options
}

#[test]
fn every_part_is_tried_written_down_and_judged_and_leaves_no_claim_without_a_number() {
    let results = judged_again::<Survive>(&small(vec![3, 4])).unwrap();
    for claim in &results.summary.claims {
        let expected = if claim.estimator == Estimator::Count {
            1
        } else {
            2
        };
        assert_eq!(claim.ours.n, expected, "{}", claim.id);
        assert_eq!(claim.verdict, Verdict::Measured, "{}", claim.id);
    }
    let named =
        |claims: &[Claim]| -> Vec<String> { claims.iter().map(|it| it.id.clone()).collect() };
    let mut declared = named(&declared());
    declared.retain(|id| !id.starts_with("survive.kill"));
    assert_eq!(named(&results.summary.claims), declared);
}

#[test]
fn one_accepted_image_of_one_seed_is_a_miss() {
    let options = SurviveOptions::new((0..10).collect(), &["bit_flip".into()]).unwrap();
    let lived = small(vec![5]);
    let mut all = vec![trials::<Survive>(&lived, &Progress::hidden()).unwrap()[0].clone(); 10];
    let judged = |all: &[_]| -> Summary { Survive::judge(&options, all).unwrap().summary };
    let verdict = |it: &Summary| it.find("survive.bit_flip").unwrap().verdict;
    assert_eq!(verdict(&judged(&all)), Verdict::Met);
    all[7].note("bit_flip.accepted", 1);
    assert_eq!(verdict(&judged(&all)), Verdict::Missed);
}

#[test]
fn an_interrupted_run_is_judged_by_the_parts_that_all_its_seeds_have() {
    let options = SurviveOptions::standard(vec![1, 2, 3]);
    let cases = Survive::cases(&options);
    let part = Survive::part(&options, &cases[..3]).unwrap();
    assert_eq!((part.seeds.len(), part.parts.len()), (3, 1));
    assert_eq!(part.parts, options.parts[..1]);
    assert!(Survive::part(&options, &cases[..4]).is_none());
    assert!(Survive::part(&options, &[]).is_none());
    assert_eq!(Survive::part(&options, &cases), Some(options));
}

#[test]
fn slow_parts_are_run_when_they_are_named_or_all_are() {
    let named = |names: &[&str]| {
        let names: Vec<String> = names.iter().map(|&it| it.into()).collect();
        let options = SurviveOptions::new(vec![3], &names);
        options.map(|it| it.parts.iter().map(|part| part.name).collect::<Vec<_>>())
    };
    let quick = named(&[]).unwrap();
    assert_eq!(quick, ["bit_flip", "resume", "power_cut", "wire"]);
    assert_eq!(named(&["long_life"]).unwrap(), ["long_life"]);
    assert_eq!(named(&["longest_life"]).unwrap(), ["longest_life"]);
    assert!(named(&["moon"]).is_err());
}

#[test]
fn a_life_whose_brain_was_lost_goes_on() {
    let options = SurviveOptions {
        shorter: Scale(10),
        ..SurviveOptions::new(vec![3], &["ram_flips".into()]).unwrap()
    };
    let trial = &trials::<Survive>(&options, &Progress::hidden()).unwrap()[0];
    let of = |name: &str| trial.measured[&format!("ram_flips.{name}")][0];
    // So many flips that brains are lost, and lives go on.
    let lost = ["agent", "mind"].map(|name| of(&format!("{name}.scrubbed.10x4.lost")));
    assert!(lost[0] + lost[1] > 0.0, "{lost:?}");
    for name in ["agent", "mind"] {
        assert_eq!(of(&format!("{name}.scrubbed.10x4.ended")), 0.0, "{name}");
    }
}

#[test]
fn a_long_life_is_judged_block_by_block() {
    let options = SurviveOptions {
        shorter: Scale(1000),
        ..SurviveOptions::new(vec![3, 4], &["long_life".into()]).unwrap()
    };
    let summary = judged_again::<Survive>(&options).unwrap().summary;
    let of = |id: &str| {
        &summary
            .find(&format!("survive.long_life.{id}"))
            .unwrap()
            .ours
    };
    assert_eq!(of("unsound").value, Some(0.0));
    assert_eq!(of("lamp.mind").n, 2);
    for id in ["lamp.mind", "lamp.mind.fall"] {
        assert!(
            of(id).value.is_some_and(|it| (0.0..=1.0).contains(&it)),
            "{id}"
        );
    }
    assert!(of("lamp.mind.best_block").value.is_some_and(|it| it > 0.0));
    let all = SurviveOptions::new(vec![3], &["all".into()]).unwrap();
    assert_eq!(all.parts, SurviveOptions::standard(vec![3]).parts);
    let has = |name: &str| all.parts.iter().any(|it| it.name == name);
    assert!(has("lasting") && !has("longest_life"));
}
