//! The committed results of `forage` and `calibrate` are what the program measures.
//!
//! Two seeds of the foraging run live again, one of them chosen by the commit, and the whole
//! calibration, which takes a second.
//! Every number must be the same to the last bit: runs are deterministic.

mod lived;

use cla_core::agent::AgentConfig;
use cla_tests::claims::two_of;
use host_sim::experiment::calibrate::{Calibrate, CalibrateOptions};
use host_sim::experiment::forage::{Forage, ForageOptions};
use host_sim::experiment::record::judged_again;
use host_sim::world::config::PioneerConfig;
use host_sim::world::setting::WorldOptions;
use lived::{assert_same_measurements, committed};

const FORAGE: &str = include_str!("../claims/forage.json");

#[test]
fn two_seeds_of_the_foraging_run_live_the_same_lives_again() {
    let committed = committed(FORAGE);
    let places = two_of(committed.seeds.len(), FORAGE);
    let options = ForageOptions {
        seeds: places.map(|place| committed.seeds[place]).to_vec(),
        world: WorldOptions {
            config: PioneerConfig::NOISY,
            layout: None,
            path: None,
        },
        brain: AgentConfig::FORAGER,
        actions: 10_000,
        test_actions: 3_000,
    };
    let again = judged_again::<Forage>(&options)
        .expect("the experiment runs")
        .summary;
    assert_eq!(again.parameters, committed.parameters);
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, committed.claims.len());
    assert_eq!(compared, again.claims.len());
}

#[test]
fn the_calibration_comes_out_as_committed() {
    let committed = committed(include_str!("../claims/calibrate.json"));
    let again =
        judged_again::<Calibrate>(&CalibrateOptions::standard()).expect("the layouts are built in");
    assert_eq!(again.summary.claims, committed.claims);
}

#[test]
fn the_committed_claims_are_the_ones_that_were_promised() {
    let forage = committed(FORAGE);
    assert_eq!(forage.seeds, (100..120).collect::<Vec<u64>>());
    for id in [
        "ingrip_by_10000",
        "captures.level1",
        "captures.level1_removed",
        "captures.lexicographic",
        "baseline.random",
        "baseline.sector",
        "table_6_3.s1",
        "table_6_3.s2",
        "table_6_3.s3",
        "table_6_3.s4",
        "table_6_3.s5",
        "reliability.6_1",
        "reliability.6_2",
        "reliability.6_7",
        "reliability.6_8",
        "reliability.6_9",
        "reliability.6_11",
        "reliability.6_12",
        "reliability.6_13",
        "reliability.6_14",
        "level2_drop.book",
    ] {
        assert!(forage.find(&format!("forage.{id}")).is_some(), "{id}");
    }
    let calibrate = committed(include_str!("../claims/calibrate.json"));
    for radius in [3, 5, 8] {
        for step in ["0_1", "0_5"] {
            for quantity in ["actions", "p_s3"] {
                let id = format!("calibrate.{quantity}.R{radius}_f{step}");
                let claim = calibrate.find(&id).expect("every condition is claimed");
                assert_eq!(claim.met, Some(true), "{id}");
            }
        }
    }
}
