//! Trials of the Microworld that were written down are judged as if they had just been made; they
//! are made up here, because a real one takes minutes.

use std::collections::BTreeMap;

use super::catalogue::{Found, equations};
use super::goals::GOALS;
use super::level2::Level2;
use super::synthetic::Findings;
use super::trial::{Growth, MOMENTS, Trial};
use super::{Chapter5, MicroworldOptions, Pursued, Pursuit, PursuitOptions};
use crate::experiment::plan::Experiment;
use crate::experiment::record::{line, read};
use crate::world::microworld::{Family, Recall};
use cla_core::num::Rng;

fn made_up(seed: u64) -> Trial {
    let mut rng = Rng::new(seed);
    let mut share = || f64::from(rng.unit()) / 3.0;
    let equations = equations().len();
    let found = [Found::Missed, Found::Refined, Found::Exact];
    let mut growth = |moments: usize| -> Vec<Growth> {
        let of = |&steps: &u32| Growth {
            steps,
            recall: share(),
            own_recall: share(),
            precision: share(),
            schemas: 17,
            bytes: 62_000,
            micros: share(),
        };
        MOMENTS.iter().take(moments).map(of).collect()
    };
    let (whole, roomy, drescher) = (growth(5), growth(4), growth(3));
    let (literal, complete, conjunctive) = (growth(2), growth(2), growth(3));
    let (unrestricted, bounded) = (growth(1), growth(4));
    let recall = |hits: usize| Recall {
        families: Family::ALL.map(|family| (family, (hits, 301))).into(),
        wrong: 7,
    };
    let equation = |shift: usize| -> Vec<Found> {
        let all = (0..equations).map(|index| found[(index + shift) % 3]);
        all.collect()
    };
    Trial {
        raw: recall(100),
        raw_schemas: 400,
        valid: share(),
        raw_equations: equation(0),
        harvest_simplified: share(),
        clasm: recall(200),
        simplified: Recall {
            families: BTreeMap::from([(Family::Touch, (3, 4))]),
            wrong: 0,
        },
        simplified_equations: equation(1),
        foreseen: (0..equations).map(|_| share()).collect(),
        growth: whole,
        roomy,
        slipping: share(),
        goals: GOALS.iter().map(|_| [share(), share(), share()]).collect(),
        practised: share(),
        level2: Level2 {
            palpable: 23,
            attempts: (100, 91),
            objects: vec![(3, 21), (17, 40)],
            ..Level2::default()
        },
        synthetic: Findings {
            items: 140,
            schemas: 655,
            reliability: share(),
            known: share(),
            right: share(),
            pictures: vec![[
                "grasp".to_owned(),
                ". . o\n. E .\nh . .\n  ^\n".to_owned(),
                ". . o\n? ? .\n. . .\n".to_owned(),
            ]],
            ..Findings::default()
        },
        drescher,
        literal,
        complete,
        drescher_goals: GOALS.iter().map(|_| share()).collect(),
        conjunctive,
        conjunctive_schemas: 2674,
        conjunctive_goals: GOALS.iter().map(|_| share()).collect(),
        unrestricted,
        bounded,
    }
}

#[test]
fn lives_that_were_written_down_are_judged_the_same() {
    let options = MicroworldOptions {
        seeds: vec![100, 101],
    };
    let trials = [made_up(100), made_up(101)];
    let back = trials.each_ref().map(|it| {
        let back: Trial = read(&line(it).unwrap()).unwrap();
        back
    });
    assert_eq!(back, trials);
    let results = Chapter5::judge(&options, &trials).unwrap();
    assert_eq!(Chapter5::judge(&options, &back).unwrap(), results);
    let raw = results.summary.find("micro.recall.raw").unwrap();
    assert!(raw.per_seed.iter().all(|it| *it == Some(100.0 / 301.0)));
}

#[test]
fn a_pursuit_is_told_in_its_results_and_the_same_when_it_was_written_down() {
    let options = PursuitOptions::new(100, "+hp22").unwrap();
    let pursued = Pursued {
        start: ". . o".to_owned(),
        steps: vec![("handf".to_owned(), ". h o".to_owned())],
        reached: true,
    };
    let back: Pursued = read(&line(&pursued).unwrap()).unwrap();
    let results = Pursuit::judge(&options, &[pursued]).unwrap();
    assert_eq!(Pursuit::judge(&options, &[back]).unwrap(), results);
    let text = results.text();
    for told in [
        "<+hp22>, seed 100",
        "handf\n. h o",
        "reached after 1 step\n",
    ] {
        assert!(text.contains(told), "{told} is not in {text}");
    }
}
