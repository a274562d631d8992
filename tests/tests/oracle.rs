//! The dense map against MiniSom 2.3.6: same start, same order, same end.
//!
//! `fixtures/make_minisom.py` says how the fixture was made.
//! MiniSom computes in f64 and we in f32, so the weights agree to about 1e-5.

use cla_core::num::{Neighbourhood, Schedule};
use cla_core::som::{DenseSom, quantization_error, topographic_error};
use serde::Deserialize;

#[derive(Deserialize)]
struct Fixture {
    sigma: [f32; 2],
    alpha: [f32; 2],
    steps: u32,
    samples: Vec<[f32; 4]>,
    initial: Vec<[f32; 4]>,
    #[serde(rename = "final")]
    last: Vec<[f64; 4]>,
    quantization_error: f64,
    topographic_error: f64,
}

fn fixture() -> Fixture {
    serde_json::from_str(include_str!("../fixtures/minisom.json")).expect("the fixture is whole")
}

fn trained(fixture: &Fixture) -> DenseSom<8, 6, 4> {
    let mut som = DenseSom::new();
    let prototypes = som.prototypes_mut().as_mut_slice();
    prototypes.copy_from_slice(&fixture.initial);
    let [from, to] = fixture.sigma;
    let sigma = Schedule::linear(from, to, fixture.steps).expect("a schedule");
    let [from, to] = fixture.alpha;
    let alpha = Schedule::linear(from, to, fixture.steps).expect("a schedule");
    for (step, sample) in (0..fixture.steps).zip(fixture.samples.iter().cycle()) {
        let near = Neighbourhood::gaussian(sigma.at(step), 0.0).expect("a width");
        let best = som.best_matching_unit(sample).expect("finite samples");
        som.train(sample, best.node, alpha.at(step), &near);
    }
    som
}

#[test]
fn every_weight_ends_where_minisoms_does() {
    let fixture = fixture();
    let som = trained(&fixture);
    let mut moved = 0.0_f64;
    let prototypes = som.prototypes().as_slice();
    for ((ours, theirs), start) in prototypes.iter().zip(&fixture.last).zip(&fixture.initial) {
        for ((&ours, theirs), &start) in ours.iter().zip(theirs).zip(start) {
            let ours = f64::from(ours);
            assert!((ours - theirs).abs() < 1e-5, "{ours} {theirs}");
            moved = moved.max((ours - f64::from(start)).abs());
        }
    }
    assert!(moved > 0.5, "a map that was not trained would agree too");
}

#[test]
fn quantization_and_topographic_error_are_minisoms() {
    let fixture = fixture();
    let som = trained(&fixture);
    let quantization = quantization_error(&som, fixture.samples.iter()).expect("finite samples");
    let topographic = topographic_error(&som, fixture.samples.iter()).expect("finite samples");
    assert!((f64::from(quantization) - fixture.quantization_error).abs() < 1e-5);
    assert!((f64::from(topographic) - fixture.topographic_error).abs() < 1e-6);
}
