//! Every kind of module is one, the map is that of the core, and trials are judged as they were.

use cla_core::layer::{Layer, LayerConfig};
use cla_core::num::{Rng, Schedule};

use super::{Kind, Modules, ModulesOptions, Plan, TRIALS, declared, made};
use crate::experiment::record::judged_again;

const PLAN: Plan = Plan {
    side: 6,
    features: 12,
    samples: 600,
    ..Plan::DEFAULT
};

/// One of twelve features is on, the others hardly.
fn stimulus(rng: &mut Rng) -> Vec<f32> {
    let place = rng.below(12) as usize;
    let mut all: Vec<f32> = (0..12).map(|_| 0.05 * rng.unit()).collect();
    all[place] = 1.0;
    all
}

#[test]
fn the_map_answers_as_a_layer_of_the_core_does_to_the_bit() {
    // Setting 1 changes neither width nor neighbourhood.
    let mut module = made(Kind::Map, &PLAN, 1, &mut Rng::new(4)).unwrap();
    let mut layer = Layer::<6, 6, 12>::new();
    let schedule = |from, to| Schedule::geometric(from, to, PLAN.samples).unwrap();
    let config = LayerConfig::try_new(
        PLAN.width,
        schedule(PLAN.alpha.0, PLAN.alpha.1),
        schedule(3.0, PLAN.neighbourhood),
    );
    layer.start(&config.unwrap(), &mut Rng::new(4));
    let mut rng = Rng::new(5);
    for t in 0..600 {
        let stimulus = stimulus(&mut rng);
        module.learn(&stimulus);
        let read: [f32; 12] = stimulus.try_into().unwrap();
        layer.activate(&read).unwrap();
        layer.train(t);
    }
    let read = [0.3; 12];
    layer.activate(&read).unwrap();
    let mut units = [0.0; 36];
    assert_eq!(module.respond(&read, &mut units), layer.novelty());
    assert_eq!(units, layer.activation().as_slice());
}

#[test]
fn every_kind_finds_what_it_has_learned_familiar_in_every_setting() {
    for kind in Kind::ALL {
        for trial in 0..TRIALS {
            let mut module = made(kind, &PLAN, trial, &mut Rng::new(1)).unwrap();
            let mut rng = Rng::new(2);
            for _ in 0..600 {
                module.learn(&stimulus(&mut rng));
            }
            module.settle();
            assert_eq!(module.units(), PLAN.units());
            let mut units = vec![0.0; module.units()];
            let mut novelty = |it: &[f32]| module.respond(it, &mut units);
            let familiar: f32 = (0..50).map(|_| novelty(&stimulus(&mut rng))).sum::<f32>() / 50.0;
            // A map by chance is 3 off, the mean of all stimuli .9.
            assert!(familiar < 0.3, "{kind} {trial}: {familiar}");
            if !matches!(kind, Kind::Batch | Kind::Online) {
                // Components leave no direction out here, so that nothing is new to them.
                assert!(novelty(&[-3.0; 12]) > 20.0, "{kind} {trial}");
            }
            assert!(module.bytes() > 1000 && module.work().respond > 100.0);
        }
    }
}

#[test]
fn a_map_of_a_size_that_is_not_compiled_in_is_refused_by_name() {
    let plan = Plan { side: 7, ..PLAN };
    let refused = made(Kind::Map, &plan, 0, &mut Rng::new(1)).err().unwrap();
    assert!(refused.to_string().contains("7 × 7"), "{refused}");
    assert!(made(Kind::Gas, &plan, 0, &mut Rng::new(1)).is_ok());
}

#[test]
fn shorter_studies_are_judged_again_and_make_every_claim() {
    let options = ModulesOptions {
        shorter: 40,
        ..ModulesOptions::new(vec![1, 2], None).unwrap()
    };
    let results = judged_again::<Modules>(&options).unwrap();
    let ids: Vec<_> = results.summary.claims.iter().map(|it| &it.id).collect();
    let known = declared();
    assert_eq!(ids, known.iter().map(|it| &it.id).collect::<Vec<_>>());
    let bytes = |kind: Kind| {
        let id = format!("modules.bytes.{}", kind.id());
        results.summary.find(&id).unwrap().ours.value.unwrap()
    };
    // What keeps stimuli needs more than what does not.
    assert!(bytes(Kind::Batch) > 2.0 * bytes(Kind::Online));
}
