//! A brain lives a recorded life again: it chooses and learns at every step, and everything that it
//! computes goes into fingerprints.
//!
//! Equal fingerprints on two machines mean equal weights, distances, schemas and choices, to the
//! last bit.

use core::fmt;

use cla_core::agent::{Adaptation, Agent, AgentConfig, AgentError};
use cla_core::check::ConfigError;
use cla_core::forager::pioneer::{ITEMS, VALUES};
use cla_core::som::{BinarySom, Prototypes};
use cla_core::word::Cost;

use crate::fingerprint::Fingerprint;
use crate::trace;

/// The brain of a forager, whatever its capacities.
pub type Forager<
    const W: usize,
    const H: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M = BinarySom<W, H, 7>,
> = Agent<1, 7, W, H, 6, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>;

/// A moment of a step, for whoever measures what lies between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    /// The percept is there.
    Sensed,
    /// The brain has chosen.
    Chosen,
    /// The brain has learned from what came of it.
    Learned,
    /// The brain has learned and read its maps into schemas.
    Harvested,
    /// The second level has begun.
    SecondLevel,
    /// Training is over: the brain has settled its values.
    Settled,
}

/// What a life left behind, as fingerprints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Echo {
    /// Actions done.
    pub actions: u32,
    /// Actions of them for which the brain chose what is recorded.
    pub agreed: u32,
    /// Schemas at the end.
    pub schemas: u32,
    /// Every weight of every map at the end.
    pub weights: Fingerprint,
    /// Every distance to every node at every step.
    pub distances: Fingerprint,
    /// Every schema at the end, with its counts.
    pub table: Fingerprint,
    /// Every belief of the second level at the end.
    pub beliefs: Fingerprint,
    /// Every choice, with its level, reason and value.
    pub choices: Fingerprint,
}

/// Actions of a life before its second level begins.
#[must_use]
pub const fn second_level_at(actions: u32) -> u32 {
    actions / 2
}

/// Actions of a life before training is over.
#[must_use]
pub const fn acting_at(actions: u32) -> u32 {
    actions / 10 * 9
}

/// Begins the life of a forager: what is in the gripper is worth having.
///
/// # Errors
/// [`ConfigError`] for a configuration that cannot work.
pub fn be_born<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    config: AgentConfig,
    seed: u64,
) -> Result<(), ConfigError> {
    brain.be_born(config, VALUES, seed)
}

/// Lives the first `actions` recorded actions with a brain that is born for it.
///
/// The second level begins after half of them; after nine tenths training is over, and the brain
/// acts and goes on learning.
/// Where the brain would choose otherwise than recorded it is shown the recorded action instead, so
/// that an old recording stays usable, and other brains can live it too.
///
/// # Errors
/// [`ReplayError`] when the brain refuses.
pub fn relive<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    seed: u64,
    actions: u32,
    mut at: impl FnMut(Moment, Cost),
) -> Result<Echo, ReplayError> {
    be_born(brain, AgentConfig::FORAGER, seed).map_err(ReplayError::Config)?;
    let mut echo = Echo::default();
    for step in trace::steps(actions) {
        if !step.reflex && echo.actions == second_level_at(actions) {
            brain
                .reconfigure(AgentConfig::FORAGER_LEVEL2)
                .map_err(ReplayError::Config)?;
            at(Moment::SecondLevel, Cost::default());
        }
        if !step.reflex && echo.actions == acting_at(actions) {
            at(Moment::Sensed, Cost::default());
            brain
                .act(Adaptation::Relearning)
                .map_err(ReplayError::Agent)?;
            at(Moment::Settled, brain.cost());
        }
        at(Moment::Sensed, Cost::default());
        let mut agreed = false;
        if !step.reflex {
            let choice = brain.choose(&step.before).map_err(ReplayError::Agent)?;
            at(Moment::Chosen, brain.cost());
            agreed = choice.action == step.action;
            echo.actions += 1;
            echo.agreed += u32::from(agreed);
            echo.choices.number(choice.action.0.into());
            echo.choices.number(choice.reason as u32);
            echo.choices
                .number(choice.level.map_or(0, |level| level as u32 + 1));
            echo.choices.float(choice.value);
            at(Moment::Sensed, Cost::default());
        }
        let learned = if agreed {
            brain.learn(&step.after)
        } else {
            brain.observe(&step.before, step.action, &step.after)
        };
        let lesson = learned.map_err(ReplayError::Agent)?;
        let moment = if lesson.harvested {
            Moment::Harvested
        } else {
            Moment::Learned
        };
        at(moment, brain.cost());
        if lesson.trained.is_some() {
            for &distance in brain.bank().last_distances().as_slice() {
                echo.distances.float(distance);
            }
        }
    }
    add_weights(&mut echo.weights, brain);
    add_schemas(&mut echo.table, brain);
    add_beliefs(&mut echo.beliefs, brain);
    echo.schemas = brain.knowledge().schemas().len() as u32;
    Ok(echo)
}

/// Lives the last 100 recorded actions again in doubt, as after an alarm; `at` hears of every
/// learning step, and in each 25th the evidence is weighed.
///
/// # Errors
/// [`ReplayError`] when the brain refuses.
// A frame of its own: in the frame of its caller it would lie below the whole life.
#[inline(never)]
pub fn doubt<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    actions: u32,
    mut at: impl FnMut(Moment),
) -> Result<(), ReplayError> {
    brain
        .set_surprise(AgentConfig::RESILIENT.surprise)
        .map_err(ReplayError::Config)?;
    brain.doubt();
    let own = trace::steps(actions).filter(|step| !step.reflex);
    for step in own.skip(actions.saturating_sub(100) as usize) {
        brain.choose(&step.before).map_err(ReplayError::Agent)?;
        brain.redirect(step.action).map_err(ReplayError::Agent)?;
        at(Moment::Chosen);
        let lesson = brain.learn(&step.after).map_err(ReplayError::Agent)?;
        at(match lesson.harvested || !brain.doubts() {
            true => Moment::Harvested,
            false => Moment::Learned,
        });
    }
    Ok(())
}

fn add_weights<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    print: &mut Fingerprint,
    brain: &Forager<W, H, P, S, Y, B, M>,
) {
    for map in brain.bank().maps() {
        for node in map.nodes() {
            for item in 0..ITEMS.len() as u16 {
                print.float(map.context_weight(node, item));
                print.float(map.result_weight(node, item));
            }
        }
    }
}

/// Adds every schema with its counts.
pub(crate) fn add_schemas<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    print: &mut Fingerprint,
    brain: &Forager<W, H, P, S, Y, B, M>,
) {
    let knowledge = brain.knowledge();
    for schema in knowledge.schemas() {
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
}

/// Adds every belief of the second level.
pub(crate) fn add_beliefs<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    print: &mut Fingerprint,
    brain: &Forager<W, H, P, S, Y, B, M>,
) {
    for belief in brain.second_level().beliefs() {
        print.number(belief.trace.0.into());
        print.number(belief.item.0.into());
        print.float(belief.on);
    }
}

impl fmt::Display for Echo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "actions {}, as recorded {}", self.actions, self.agreed)?;
        writeln!(f, "weights {}", self.weights)?;
        writeln!(f, "distances {}", self.distances)?;
        writeln!(f, "schemas {} ({})", self.table, self.schemas)?;
        writeln!(f, "beliefs {}", self.beliefs)?;
        writeln!(f, "choices {}", self.choices)
    }
}

/// Why a recorded life could not be lived again.
#[derive(Clone, Copy, Debug, PartialEq)]
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
