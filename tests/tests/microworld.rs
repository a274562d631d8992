//! The Microworld's committed results are what the program measures: a part of them, lived again.

use cla_tests::claims::two_of;
use cla_tests::root;
use host_sim::experiment::microworld::catalogue::{
    Found, Schema, VALID, among_whole_schemas, equations,
};
use host_sim::experiment::microworld::goals::{GOALS, Strategy, success};
use host_sim::experiment::microworld::level1::Maps;
use host_sim::experiment::microworld::trial::{EARLY, STEPS, educated};
use host_sim::report::Summary;
use host_sim::world::microworld::{Body, Oracle};

fn committed() -> Summary {
    let path = root().join("tests/claims/microworld.json");
    let text = std::fs::read_to_string(path).expect("the committed results");
    Summary::from_json(&text).expect("a summary")
}

/// The places of the seeds that are lived again: the first, and one that the commit chooses.
fn places(summary: &Summary) -> [usize; 2] {
    two_of(summary.seeds.len(), &summary.command)
}

/// What a seed measured for a claim.
fn measured(summary: &Summary, place: usize, id: &str) -> f64 {
    let claim = summary.find(id).unwrap_or_else(|| panic!("no claim {id}"));
    claim.per_seed[place].expect("a number")
}

#[test]
fn two_seeds_harvest_what_was_committed() {
    let (summary, oracle) = (committed(), Oracle::new(Body::Visible));
    for place in places(&summary) {
        let raw = Maps::train(summary.seeds[place], Body::Visible, STEPS).harvest();
        let recall = oracle.recall(&raw, VALID).total();
        let committed = measured(&summary, place, "micro.recall.raw");
        assert_eq!(recall.to_bits(), committed.to_bits());
        for equation in equations() {
            let found = among_whole_schemas(&equation.schema, &raw, &oracle) != Found::Missed;
            let committed = measured(&summary, place, &equation.id());
            let found = f64::from(u8::from(found));
            assert_eq!(found, committed, "{}", equation.number);
        }
    }
}

#[test]
fn two_seeds_accommodate_and_reach_their_hand_goals_as_committed() {
    let (summary, oracle) = (committed(), Oracle::new(Body::Visible));
    for place in places(&summary) {
        let seed = summary.seeds[place];
        let (mind, mut planner) = educated(seed, EARLY);
        let known: Vec<Schema> = mind.schemas().iter().map(|it| it.text()).collect();
        let recall = oracle.recall(&known, VALID).total();
        let committed = measured(&summary, place, "micro.recall.simplified");
        assert_eq!(recall.to_bits(), committed.to_bits());
        // The goals are tried in the order of their groups, so the first draws the same starts.
        let mut tries = cla_core::num::Rng::stream(seed, 57);
        let (hand, search) = (&GOALS[0], Strategy::Search);
        let reached = success(
            hand,
            &oracle,
            mind.schemas(),
            &mut planner,
            search,
            &mut tries,
        );
        let committed = measured(&summary, place, "micro.goal.hand");
        assert_eq!(reached.to_bits(), committed.to_bits());
    }
}

#[test]
fn every_claim_that_was_promised_stands_in_the_summary() {
    let summary = committed();
    let mut ids: Vec<String> = equations().iter().map(|it| it.id()).collect();
    for id in [
        "micro.recall.raw",
        "micro.valid",
        "micro.equations",
        "micro.recall.clasm",
        "micro.recall.simplified",
        "micro.equations_simplified",
        "micro.goal.hand",
        "micro.goal.eye",
        "micro.goal.taste",
        "micro.goal.touch",
        "micro.palpable",
        "micro.visible",
        "micro.cross.touch_to_vision",
        "micro.cross.vision_to_touch",
        "micro.eq.5_33",
        "micro.eq.5_34",
        "micro.eq.5_35a",
        "micro.eq.5_35b",
        "micro.eq.5_36",
        "micro.eq.5_24",
        "micro.eq.5_25",
        "micro.eq.5_26",
        "micro.eq.5_27",
        "micro.eq.5_28",
        "micro.eq.5_29",
        "micro.synthetic.schemas",
        "micro.synthetic.reliability",
        "micro.synthetic.literal",
        "micro.drescher.recall.10k",
        "micro.drescher.recall.complete.3k",
        "micro.drescher.recall.unrestricted.1k",
        "micro.drescher.goal.hand",
        "micro.drescher.ratio.200kB",
    ] {
        ids.push(id.to_owned());
    }
    for id in ids {
        assert!(summary.find(&id).is_some(), "{id}");
    }
}
