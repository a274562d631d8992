//! The committed results of `recover` are what the program measures.
//!
//! One seed meets the knocked camera again, and one that the commit chooses a damage that it
//! chooses too; every number must be the same to the last bit.

mod lived;

use cla_tests::claims::{draw, two_of};
use host_sim::experiment::record::judged_again;
use host_sim::experiment::recover::life::Protocol;
use host_sim::experiment::recover::{Recover, RecoverOptions};
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::Damage;
use host_sim::world::pioneer::{ACTIONS, ITEMS};
use host_sim::world::setting::WorldOptions;
use lived::{assert_same_measurements, committed};

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

#[test]
fn the_committed_claims_are_the_ones_that_were_promised() {
    let committed = committed(RECOVER);
    assert_eq!(committed.seeds, (100..120).collect::<Vec<u64>>());
    for id in [
        "recover.camera.after",
        "recover.camera.reliabilities_only",
        "recover.camera.relearn_3000",
        "recover.camera.actions_to_90",
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
