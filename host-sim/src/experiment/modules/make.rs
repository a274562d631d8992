//! Modules by their kind, and the settings that each kind was tried with.

use cla_core::num::Rng;

use super::batch::{Batch, Contrast};
use super::gas::Gas;
use super::map::Map;
use super::means::Means;
use super::module::{Kind, Module, Plan};
use super::online::Online;
use crate::failure::Failure;

/// Settings that each kind was tried with, as many as of any other.
pub const TRIALS: usize = 6;

/// The setting of each kind that was kept, in the order of [`Kind::ALL`].
pub const KEPT: [usize; 5] = [2, 2, 2, 1, 5];

/// What a setting varies.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Setting {
    /// Of activations, times that of the plan; of components, the inverse of their gain.
    width: f32,
    /// Which of two: the last neighbourhood of a map, whole or half; the rate of a gas, .05 or .2; the least
    /// rate of a mean, 0 or .01; the contrast of a batch, tanh or cube; the rate of the online form, .002
    /// or .01.
    second: bool,
}

const fn setting(trial: usize) -> Setting {
    Setting {
        width: [0.7, 1.0, 1.4][trial % 3],
        second: trial % TRIALS >= 3,
    }
}

/// A module of a kind, with the setting of a trial (below [`TRIALS`]; beyond, they begin anew).
///
/// # Errors
/// [`Failure`] for a map of a size that is not compiled in, and for schedules that are none.
pub fn made(
    kind: Kind,
    plan: &Plan,
    trial: usize,
    rng: &mut Rng,
) -> Result<Box<dyn Module>, Failure> {
    let Setting { width, second } = setting(trial);
    let plan = Plan {
        width: width * plan.width,
        ..*plan
    };
    let pick = |a: f32, b: f32| if second { b } else { a };
    let gain = 1.0 / width;
    Ok(match kind {
        Kind::Map => {
            let plan = Plan {
                neighbourhood: pick(1.0, 0.5) * plan.neighbourhood,
                ..plan
            };
            map(&plan, rng)?
        }
        Kind::Gas => Box::new(Gas::new(&plan, pick(0.05, 0.2))),
        Kind::Means => Box::new(Means::new(&plan, pick(0.0, 0.01))),
        Kind::Batch => {
            let contrast = if second {
                Contrast::Cube
            } else {
                Contrast::Tanh
            };
            Box::new(Batch::new(&plan, gain, contrast, rng))
        }
        Kind::Online => Box::new(Online::new(&plan, gain, pick(0.002, 0.01))),
    })
}

/// A map of one of the sizes that the studies have.
fn map(plan: &Plan, rng: &mut Rng) -> Result<Box<dyn Module>, Failure> {
    Ok(match (plan.side, plan.features) {
        // Causal study: Position, Movement, Top, and Position through a window.
        (12, 20) => Box::new(Map::<12, 20>::new(plan, rng)?),
        (6, 60) => Box::new(Map::<6, 60>::new(plan, rng)?),
        (8, 180) => Box::new(Map::<8, 180>::new(plan, rng)?),
        (12, 12) => Box::new(Map::<12, 12>::new(plan, rng)?),
        // Angle study: orientations, midpoints, Top.
        (6, 12) => Box::new(Map::<6, 12>::new(plan, rng)?),
        (6, 16) => Box::new(Map::<6, 16>::new(plan, rng)?),
        (8, 108) => Box::new(Map::<8, 108>::new(plan, rng)?),
        // An action of the forager: contexts and results.
        (10, 14) => Box::new(Map::<10, 14>::new(plan, rng)?),
        (side, features) => {
            return Err(format!(
                "there is no map of {side} × {side} nodes on {features} features; \
                 experiment/modules/make.rs lists those that are compiled in"
            )
            .into());
        }
    })
}
