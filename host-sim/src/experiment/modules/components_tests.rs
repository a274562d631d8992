//! Sources that were mixed are found again, by the batch and in fixed memory.

use cla_core::num::Rng;

use super::batch::{Batch, Contrast};
use super::module::{Module, Plan};
use super::online::Online;

const PLAN: Plan = Plan {
    side: 2,
    features: 3,
    samples: 20_000,
    ..Plan::DEFAULT
};

/// Two sources far from Gaussian, which are mostly near 0, mixed into three features.
fn mixed(rng: &mut Rng) -> ([f32; 2], [f32; 3]) {
    let mut source = || {
        let sign = if rng.chance(0.5) { 1.0 } else { -1.0 };
        -sign * cla_core::num::ln(1.0 - rng.unit())
    };
    let [s, t] = [source(), source()];
    ([s, t], [1.0 + 2.0 * s + t, s - 1.5 * t, 0.3 * t])
}

/// The larger of how each source goes with either component, as |correlation|.
fn found(module: &dyn Module) -> [f64; 2] {
    let mut rng = Rng::new(8);
    let mut sums = [[0.0; 2]; 2];
    let mut squares = [[0.0; 2]; 2];
    for _ in 0..4000 {
        let (sources, stimulus) = mixed(&mut rng);
        let mut units = [0.0; 4];
        module.respond(&stimulus, &mut units);
        for component in 0..2 {
            let y = f64::from(units[2 * component] - units[2 * component + 1]);
            squares[1][component] += y * y;
            for (source, &s) in sources.iter().enumerate() {
                // Units are squashed, and so is what they are compared with.
                let s = libm::tanh(f64::from(s) / 2.0_f64.sqrt());
                sums[source][component] += s * y;
                if component == 0 {
                    squares[0][source] += s * s;
                }
            }
        }
    }
    [0, 1].map(|source| {
        let with = [0, 1].map(|component| {
            let norm: f64 = squares[0][source] * squares[1][component];
            (sums[source][component] / norm.sqrt()).abs()
        });
        with[0].max(with[1])
    })
}

fn taught(mut module: Box<dyn Module>) -> Box<dyn Module> {
    let mut rng = Rng::new(7);
    for _ in 0..PLAN.samples {
        module.learn(&mixed(&mut rng).1);
    }
    module.settle();
    module
}

#[test]
fn the_batch_finds_both_sources_by_either_contrast() {
    for contrast in [Contrast::Tanh, Contrast::Cube] {
        let batch = taught(Box::new(Batch::new(&PLAN, 1.0, contrast, &mut Rng::new(3))));
        let found = found(&*batch);
        assert!(found.iter().all(|&it| it > 0.97), "{contrast:?} {found:?}");
    }
}

#[test]
fn both_sources_are_found_in_fixed_memory() {
    let online = Online::new(&PLAN, 1.0, 0.005);
    let before = online.bytes();
    let online = taught(Box::new(online));
    let found = found(&*online);
    assert!(found.iter().all(|&it| it > 0.95), "{found:?}");
    assert_eq!(online.bytes(), before);
}

#[test]
fn what_no_component_says_is_new() {
    let batch = taught(Box::new(Batch::new(
        &PLAN,
        1.0,
        Contrast::Tanh,
        &mut Rng::new(3),
    )));
    let online = taught(Box::new(Online::new(&PLAN, 1.0, 0.005)));
    let (_, known) = mixed(&mut Rng::new(9));
    // Both sources fill a plane; this lies beside it.
    let beside = [known[0], known[1], known[2] + 2.0];
    for module in [batch, online] {
        let mut units = [0.0; 4];
        assert!(module.respond(&known, &mut units) < 0.02);
        assert!(module.respond(&beside, &mut units) > 2.0);
    }
}
