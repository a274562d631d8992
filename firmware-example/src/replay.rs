//! A brain lives a recorded life again: it chooses and learns at every step, and everything that it
//! computes goes into fingerprints.
//!
//! Equal fingerprints on two machines mean equal weights, distances, schemas and choices, to the
//! last bit.

use core::fmt;

use cla_core::clasm::{AgentConfig, AgentError, ConfigError};
use cla_core::forager::pioneer::{self, Brain};

use crate::fingerprint::Fingerprint;
use crate::trace::Step;

/// A moment of a step, for whoever measures what lies between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    /// The percept is there.
    Sensed,
    /// The brain has chosen.
    Chosen,
    /// The brain has learned from what came of it.
    Learned,
}

/// What a life left behind, as fingerprints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Echo {
    /// Steps lived.
    pub steps: u32,
    /// Steps in which the brain chose the recorded action.
    pub agreed: u32,
    /// Schemas at the end.
    pub schemas: u32,
    /// Every weight of every map at the end.
    pub weights: Fingerprint,
    /// Every distance to every node at every step.
    pub distances: Fingerprint,
    /// Every schema at the end, with its counts.
    pub table: Fingerprint,
    /// Every choice, with its reason and value.
    pub choices: Fingerprint,
}

/// Lives the recorded steps with a brain that is born for it.
///
/// Where the brain would choose otherwise than recorded it is shown the recorded action instead, so
/// that an old recording stays usable.
///
/// # Errors
/// [`ReplayError`] when the brain refuses.
pub fn relive(
    brain: &mut Brain,
    seed: u64,
    steps: impl Iterator<Item = Step>,
    mut at: impl FnMut(Moment),
) -> Result<Echo, ReplayError> {
    pioneer::be_born(brain, AgentConfig::FORAGER, seed).map_err(ReplayError::Config)?;
    let mut echo = Echo::default();
    for step in steps {
        at(Moment::Sensed);
        let choice = brain.choose(&step.before).map_err(ReplayError::Agent)?;
        at(Moment::Chosen);
        let agreed = choice.action == step.action;
        let learned = if agreed {
            brain.learn(&step.after)
        } else {
            brain.observe(&step.before, step.action, &step.after)
        };
        at(Moment::Learned);
        let lesson = learned.map_err(ReplayError::Agent)?;
        echo.steps += 1;
        echo.agreed += u32::from(agreed);
        echo.choices.number(choice.action.0.into());
        echo.choices.number(choice.reason as u32);
        echo.choices.float(choice.value);
        if lesson.trained.is_some() {
            for &distance in brain.bank().last_distances().as_slice() {
                echo.distances.float(distance);
            }
        }
    }
    add_weights(&mut echo.weights, brain);
    add_schemas(&mut echo, brain);
    Ok(echo)
}

fn add_weights(print: &mut Fingerprint, brain: &Brain) {
    for map in brain.bank().maps() {
        for node in map.nodes() {
            for item in 0..pioneer::ITEMS.len() as u16 {
                print.float(map.context_weight(node, item));
                print.float(map.result_weight(node, item));
            }
        }
    }
}

fn add_schemas(echo: &mut Echo, brain: &Brain) {
    let knowledge = brain.knowledge();
    for schema in knowledge.schemas() {
        let print = &mut echo.table;
        for pattern in [schema.context, schema.result] {
            let Some(items) = knowledge.pattern(pattern) else {
                continue;
            };
            for words in [items.positive().words(), items.negative().words()] {
                words.iter().for_each(|&word| print.number(word));
            }
        }
        print.number(schema.action.0.into());
        print.number(schema.reliability.activations());
        print.number(schema.reliability.successes());
    }
    echo.schemas = knowledge.schemas().len() as u32;
}

impl fmt::Display for Echo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "steps {}, as recorded {}", self.steps, self.agreed)?;
        writeln!(f, "weights {}", self.weights)?;
        writeln!(f, "distances {}", self.distances)?;
        writeln!(f, "schemas {} ({})", self.table, self.schemas)?;
        writeln!(f, "choices {}", self.choices)
    }
}

/// Why a recorded life could not be lived again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReplayError {
    /// The brain could not be born.
    Config(ConfigError),
    /// The brain refused a step: the recording has an action that the robot does not have.
    Agent(AgentError),
}

impl fmt::Display for ReplayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Config(error) => error.fmt(f),
            Self::Agent(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ReplayError {}
