//! The committed results of the perception experiments are what the program measures.
//!
//! Two seeds of each are run again, one of them chosen by the commit: runs are deterministic, so
//! every claim's numbers of these seeds must be the committed ones to the last bit, on any machine.

mod lived;

use cla_tests::claims::two_of;
use host_sim::experiment::angle::{Angle, AngleOptions};
use host_sim::experiment::causal::{Causal, CausalOptions};
use host_sim::experiment::record::judged_again;
use host_sim::report::{Summary, Verdict};
use lived::{assert_same_measurements, committed};

const CAUSAL: &str = include_str!("../claims/causal.json");
const ANGLE: &str = include_str!("../claims/angle.json");

/// The seeds to live again.
fn seeds(committed: &Summary, text: &str) -> [u64; 2] {
    two_of(committed.seeds.len(), text).map(|place| committed.seeds[place])
}

#[test]
fn two_seeds_of_the_causal_study_give_the_committed_numbers() {
    let committed = committed(CAUSAL);
    let seeds = seeds(&committed, CAUSAL);
    let again = judged_again::<Causal>(&CausalOptions::standard(seeds.to_vec()));
    let again = again.expect("the study runs").summary;
    assert_eq!(again.parameters, committed.parameters);
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, committed.claims.len());
}

#[test]
fn two_seeds_of_the_angle_study_give_the_committed_numbers() {
    let committed = committed(ANGLE);
    let seeds = seeds(&committed, ANGLE);
    let again = judged_again::<Angle>(&AngleOptions::standard(seeds.to_vec()));
    let again = again.expect("the study runs").summary;
    assert_eq!(again.parameters, committed.parameters);
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, committed.claims.len());
}

#[test]
fn only_the_literal_trigger_and_the_label_of_fig_4_7_miss_their_rule() {
    let causal = committed(CAUSAL);
    let angle = committed(ANGLE);
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
