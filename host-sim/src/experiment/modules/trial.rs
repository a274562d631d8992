//! One seed: each kind of module in each study.
//!
//! Measures only; what the numbers mean is said in `claims`.

use serde::{Deserialize, Serialize};

use super::angle::{self, Angles};
use super::causal::{self, Causality};
use super::invariance::{self, Invariance};
use super::module::Kind;
use super::options::ModulesOptions;
use super::schemas::{self, Schemas, Transitions};
use crate::failure::Failure;

/// Training events of the causal study, as many as in `causal`.
const EVENTS: u32 = 6500;
/// Training events of the study of shifts.
const SHIFTED: u32 = 1000;
/// Training trials of the angle study, as many as in `angle`.
const ANGLES: u32 = 4000;
/// Actions of the random forager.
const ACTIONS: u32 = 12_000;

/// What one kind of module did.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Launching events.
    pub causal: Causality,
    /// Angles.
    pub angle: Angles,
    /// An action of the forager.
    pub schemas: Schemas,
    /// Launching events that are shifted.
    pub invariance: Invariance,
}

/// What was measured with one seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The seed.
    pub seed: u64,
    /// Each of [`Kind::ALL`].
    pub kinds: [Measured; 5],
    /// The Action SOM of the forager, with recruitment.
    pub action_som: Schemas,
    /// The share of the forager's transitions that can be predicted from the items: the most frequent
    /// result of each context.
    pub ceiling: f64,
}

impl Trial {
    /// What a kind did.
    pub(super) const fn of(&self, kind: Kind) -> &Measured {
        &self.kinds[kind as usize]
    }
}

/// A number of each seed.
pub(super) fn of(trials: &[Trial], kind: Kind, measure: impl Fn(&Measured) -> f64) -> Vec<f64> {
    trials.iter().map(|it| measure(it.of(kind))).collect()
}

/// Runs one seed; `done` is called after each kind.
pub(super) fn run(options: &ModulesOptions, seed: u64, done: impl Fn()) -> Result<Trial, Failure> {
    let transitions = Transitions::lived(options.length(ACTIONS), seed)?;
    let of = |kind: Kind| -> Result<Measured, Failure> {
        let setting = options.setting(kind);
        let measured = Measured {
            causal: causal::run(kind, setting, options.length(EVENTS), seed)?,
            angle: angle::run(kind, setting, options.length(ANGLES), seed)?,
            schemas: schemas::run(kind, setting, &transitions, seed)?,
            invariance: invariance::run(kind, setting, options.length(SHIFTED), seed)?,
        };
        done();
        Ok(measured)
    };
    let [map, gas, means, batch, online] = Kind::ALL.map(of);
    Ok(Trial {
        seed,
        kinds: [map?, gas?, means?, batch?, online?],
        action_som: schemas::action_som(&transitions, seed),
        ceiling: transitions.ceiling(),
    })
}
