//! The committed results of `recover` are what the program measures.
//!
//! One seed meets two of the damages again; every number must be the same to the last bit.

use host_sim::experiment::record::judged_again;
use host_sim::experiment::recover::life::Protocol;
use host_sim::experiment::recover::{Recover, RecoverOptions};
use host_sim::report::Summary;
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::Damage;
use host_sim::world::setting::WorldOptions;

fn committed() -> Summary {
    Summary::from_json(include_str!("../claims/recover.json"))
        .expect("a committed claims file can be read")
}

#[test]
fn one_damaged_life_is_lived_the_same_again() {
    let committed = committed();
    let options = RecoverOptions {
        seeds: vec![committed.seeds[0]],
        world: WorldOptions {
            config: PioneerConfig::NOISY,
            layout: None,
        },
        damages: vec![Damage::Camera(-12.0)],
        protocol: Protocol::STANDARD,
    };
    let again = judged_again::<Recover>(&options)
        .expect("the experiment runs")
        .summary;
    let mut compared = 0;
    for new in &again.claims {
        let Some(old) = committed.find(&new.id) else {
            continue;
        };
        assert_eq!(new.per_seed[0], old.per_seed[0], "{}", new.id);
        compared += 1;
    }
    assert!(compared >= 5, "{compared}");
}

#[test]
fn the_committed_claims_are_the_ones_that_were_promised() {
    let committed = committed();
    assert_eq!(committed.seeds, (100..120).collect::<Vec<u64>>());
    for id in [
        "recover.camera.after",
        "recover.camera.reliabilities_only",
        "recover.camera.relearn_3000",
        "recover.camera.actions_to_90",
        "recover.camera.vs_sarsa_3000",
        "recover.none.cost",
        "baseline.q",
        "baseline.sarsa_lambda",
    ] {
        assert!(committed.find(id).is_some(), "{id}");
    }
}
