//! The committed results of the perception experiments are what the program measures.
//!
//! One seed of each is run again: runs are deterministic, so every claim's number of that seed must
//! be the committed one to the last bit, on any machine.

use host_sim::experiment::angle::{Angle, AngleOptions};
use host_sim::experiment::causal::{Causal, CausalOptions};
use host_sim::experiment::record::judged_again;
use host_sim::report::{Summary, Verdict};

fn committed(text: &str) -> Summary {
    Summary::from_json(text).expect("the committed summary can be read")
}

/// Compares the measurements of `again`, a run of some of the seeds, with the committed ones.
fn assert_same_measurements(again: &Summary, committed: &Summary) {
    assert_eq!(again.parameters, committed.parameters);
    let ids = |summary: &Summary| -> Vec<String> {
        summary
            .claims
            .iter()
            .map(|claim| claim.id.clone())
            .collect()
    };
    assert_eq!(ids(again), ids(committed));
    for (place, seed) in again.seeds.iter().enumerate() {
        let there = committed
            .seeds
            .iter()
            .position(|s| s == seed)
            .expect("a committed seed");
        for (ours, theirs) in again.claims.iter().zip(&committed.claims) {
            assert_eq!(
                ours.per_seed[place], theirs.per_seed[there],
                "{} of seed {seed}",
                ours.id
            );
        }
    }
}

#[test]
fn a_seed_of_the_causal_study_gives_the_committed_numbers() {
    let committed = committed(include_str!("../claims/causal.json"));
    let again = judged_again::<Causal>(&CausalOptions::standard(vec![113]));
    assert_same_measurements(&again.expect("the study runs").summary, &committed);
}

#[test]
fn three_seeds_of_the_angle_study_give_the_committed_numbers() {
    let committed = committed(include_str!("../claims/angle.json"));
    let again = judged_again::<Angle>(&AngleOptions::standard(vec![100, 107, 119]));
    assert_same_measurements(&again.expect("the study runs").summary, &committed);
}

#[test]
fn only_the_literal_trigger_and_the_label_of_fig_4_7_miss_their_rule() {
    let causal = committed(include_str!("../claims/causal.json"));
    let angle = committed(include_str!("../claims/angle.json"));
    assert_eq!((causal.seeds.len(), angle.seeds.len()), (20, 20));
    let claims = causal.claims.iter().chain(&angle.claims);
    let missed: Vec<&str> = claims
        .filter(|claim| claim.met == Some(false))
        .map(|claim| claim.id.as_str())
        .collect();
    assert_eq!(
        missed,
        ["causal.direct_vs_delay", "causal.fallback.literal"]
    );
    let pattern = causal
        .find("causal.isolates.full_pattern")
        .expect("the claim exists");
    assert_eq!(pattern.verdict, Verdict::Reproduced);
}
