//! Tests of marginal attribution on the Microworld.

use super::{Drescher, DrescherConfig};
use crate::experiment::microworld::goals::Chains;
use crate::experiment::microworld::level1::Life;
use crate::world::microworld::{Body, Family, Oracle};

fn grown(config: DrescherConfig, steps: u32) -> Drescher {
    let (mut life, mut mechanism) = (Life::new(3, Body::Visible, 0.0), Drescher::new(config));
    for _ in 0..steps {
        let (action, step) = life.step();
        mechanism.learn(action, &step);
    }
    mechanism
}

#[test]
fn it_learns_how_hand_and_eye_move() {
    let oracle = Oracle::new(Body::Visible);
    let mechanism = grown(DrescherConfig::RESTRICTED, 5000);
    let recall = oracle.recall(&mechanism.schemas(), 0.9);
    for family in [Family::EyeProprioception, Family::HandProprioception] {
        let share = recall.of(family);
        assert!((0.9..=1.0).contains(&share), "{}: {share}", family.name());
    }
}

#[test]
fn with_synthetic_items_it_tracks_more_and_pays_for_it() {
    let (plain, complete) = (
        grown(DrescherConfig::RESTRICTED, 3000),
        grown(DrescherConfig::COMPLETE, 3000),
    );
    assert_eq!(plain.items().as_slice().len(), 0);
    assert_eq!(complete.items().as_slice().len(), super::SYNTHETIC);
    assert_eq!(
        complete.schema_bytes() - plain.schema_bytes(),
        2 * super::SYNTHETIC
    );
    // Some schemas speak of synthetic items, and the truth is not asked about those.
    assert!(complete.len() > complete.schemas().len() + 20);
    assert_eq!(plain.len(), plain.schemas().len());
    let in_contexts = complete.schemas.iter().filter(|it| {
        let speaks_of_primitive = usize::from(it.schema.result_item().0) < super::ITEM_COUNT;
        speaks_of_primitive && !complete.is_primitive(it)
    });
    assert!(
        in_contexts.count() > 10,
        "items of its own stand in contexts"
    );
}

#[test]
fn contexts_of_reliable_schemas_become_results_as_a_whole() {
    let (plain, whole) = (
        grown(DrescherConfig::RESTRICTED, 3000),
        grown(DrescherConfig::CONJUNCTIVE, 3000),
    );
    assert_eq!(plain.conjunctive(), []);
    let oracle = Oracle::new(Body::Visible);
    let conjunctive = whole.conjunctive();
    assert!(conjunctive.len() > 20, "{}", conjunctive.len());
    let true_ones = conjunctive
        .iter()
        .filter(|it| oracle.reliability(it).is_some_and(|r| r >= 0.9));
    assert!(true_ones.count() > 0);
    assert!(whole.bytes() > plain.bytes());
    // Everything else is learned as before.
    let single = whole
        .schemas()
        .iter()
        .filter(|it| it.result.len() == 1)
        .count();
    assert_eq!(single, plain.schemas().len());
}

#[test]
fn its_schemas_serve_composite_actions() {
    let mechanism = grown(DrescherConfig::RESTRICTED, 5000);
    let chainable = mechanism.chainable(20);
    assert!(chainable.len() > 200, "{}", chainable.len());
    let oracle = Oracle::new(Body::Visible);
    let mut chains = Chains::new(&oracle, &chainable, &["hp22"]);
    let hand = oracle.states().iter().filter(|state| {
        let next = chains.next(0, state);
        next.is_some_and(|action| action.0 < 4)
    });
    let share = hand.count() as f64 / oracle.states().len() as f64;
    assert!(share > 0.6, "by hand actions towards a hand goal: {share}");
}

#[test]
fn unrestricted_it_grows_much_faster_and_memory_stops_it() {
    let count = |config| grown(config, 1500).schemas().len();
    let (restricted, unrestricted) = (
        count(DrescherConfig::RESTRICTED),
        count(DrescherConfig::UNRESTRICTED),
    );
    assert!(
        unrestricted > 2 * restricted,
        "{restricted}, {unrestricted}"
    );
    let small = DrescherConfig {
        memory: 50_000,
        ..DrescherConfig::UNRESTRICTED
    };
    let bounded = grown(small, 1500);
    assert!((49_000..=50_000).contains(&bounded.bytes()));
}
