//! The committed results of `recover` are what the program measures.
//!
//! One seed meets the knocked camera again, and one that the commit chooses a damage that it
//! chooses too; every number must be the same to the last bit.
//! So must be one line of the table by which the rivals were tuned.

mod lived;

use cla_tests::claims::{draw, two_of};
use host_sim::experiment::record::judged_again;
use host_sim::experiment::recover::life::Protocol;
use host_sim::experiment::recover::rivals::{Rival, SEEDS, tried};
use host_sim::experiment::recover::{Recover, RecoverOptions};
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::Damage;
use host_sim::world::pioneer::{ACTIONS, ITEMS};
use host_sim::world::setting::WorldOptions;
use lived::{assert_same_measurements, committed};

const TUNING: &str = include_str!("../../host-sim/data/tuning.tsv");
const RECOVER: &str = include_str!("../claims/recover.json");

/// Lets one seed meet one damage again, and compares all that is claimed of it.
fn live_again(place: usize, damage: &str) {
    let committed = committed(RECOVER);
    let damage = Damage::parse(damage, &ITEMS, &ACTIONS).expect("a reported damage");
    let options = RecoverOptions {
        seeds: vec![committed.seeds[place]],
        world: WorldOptions {
            config: PioneerConfig::NOISY,
            layout: None,
            path: None,
        },
        damages: vec![damage],
        protocol: Protocol::STANDARD,
    };
    let again = judged_again::<Recover>(&options)
        .expect("the experiment runs")
        .summary;
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, again.claims.len(), "{damage}");
    assert!(compared >= 9, "{compared}");
}

#[test]
fn the_knocked_camera_is_lived_the_same_again() {
    live_again(0, "camera:+12");
}

#[test]
fn a_seed_and_a_damage_that_the_commit_chooses_are_lived_the_same_again() {
    let [_, place] = two_of(committed(RECOVER).seeds.len(), RECOVER);
    let damages = Damage::REPORTED.len() as u64;
    let damage = (draw(RECOVER) / 20 % damages) as usize;
    live_again(place, Damage::REPORTED[damage]);
}

/// The quickest of them, Q-learning, on all tuning seeds.
#[test]
fn a_trial_of_the_tuning_is_lived_the_same_again() {
    let rival = Rival::Q;
    let (trial, setup) = (8, rival.draw(8));
    assert_eq!(setup, rival.tuned().setup, "the best of its trials");
    let world = WorldOptions::new(PioneerConfig::NOISY, None).expect("the reference world");
    let mut sums = [[0; 2]; 3];
    for seed in 0..SEEDS {
        let brought = tried(&setup, &world, seed).expect("the reference world can be lived in");
        for (sum, part) in sums.iter_mut().flatten().zip(brought.iter().flatten()) {
            *sum += part;
        }
    }
    let mut compared = 0;
    for line in TUNING.lines() {
        let cells: Vec<&str> = line.split('\t').collect();
        if cells[..2] == ["Q", "8"] {
            let mean = |part: usize| f64::from(sums[compared][part]) / SEEDS as f64;
            let read = |place: usize| cells[place].parse::<f64>().expect("a number");
            assert_eq!(
                (mean(0), mean(1)),
                (read(3), read(4)),
                "trial {trial}: {line}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, sums.len());
}

#[test]
fn the_committed_claims_are_the_ones_that_were_promised() {
    let committed = committed(RECOVER);
    assert_eq!(committed.seeds, (100..120).collect::<Vec<u64>>());
    for id in [
        "recover.camera.after",
        "recover.camera.reliabilities_only",
        "recover.camera.relearn_3000",
        "recover.camera.time_to_recover",
        "recover.camera.random_never",
        "recover.none.time_to_recover",
        "recover.camera.over_sarsa_3000",
        "recover.camera.level2_reliability_drop",
        "recover.family.ahead_after_holm",
        "recover.none.cost",
        "baseline.q",
        "baseline.sarsa_lambda",
    ] {
        assert!(committed.find(id).is_some(), "{id}");
    }
}

/// Twenty seeds, fourteen damages with none among them: chance wins in none.
#[test]
fn random_actions_recover_from_nothing() {
    let committed = committed(RECOVER);
    let mut looked = 0;
    for (title, table) in &committed.tables {
        let column = |name: &str| table.columns.iter().position(|it| it == name);
        let (Some(learner), Some(never)) = (column("learner"), column("never")) else {
            continue;
        };
        let random = table.rows.iter().find(|row| row[learner] == "random");
        let random = random.unwrap_or_else(|| panic!("{title}"));
        assert_eq!(random[never], committed.seeds.len(), "{title}");
        looked += 1;
    }
    assert_eq!(looked, Damage::REPORTED.len() + 1);
}
