//! Who survives: the agent's named configurations and the one learner, in the Pioneer and at the lamp.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forest::MindConfig;

use super::lamp::floats;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::forager::Forager;
use crate::learner::mind::Minded;
use crate::learner::native::Native;
use crate::world::pioneer::{INGRIP, ITEMS};

/// What the one valued item is worth in both worlds.
pub(super) const VALUE: f32 = 10.0;

/// A configuration with its name; without one of an agent it is the one learner.
pub(super) type Named = (&'static str, Option<AgentConfig>);

/// Those whose habits drift in millions of actions, or that have none, and the one learner.
pub(super) const CONFIGURATIONS: [Named; 6] = [
    ("book", Some(AgentConfig::BOOK)),
    ("forager", Some(AgentConfig::FORAGER)),
    ("forager_level2", Some(AgentConfig::FORAGER_LEVEL2)),
    ("resilient", Some(AgentConfig::RESILIENT)),
    ("resilient_level2", Some(AgentConfig::RESILIENT_LEVEL2)),
    ("mind", None),
];

/// Those whose habits last.
pub(super) const LASTING: [Named; 2] = [
    ("forager_lasting", Some(AgentConfig::FORAGER_LASTING)),
    ("resilient_lasting", Some(AgentConfig::RESILIENT_LASTING)),
];

/// Everybody.
pub(super) const ALL: [Named; 8] = [
    CONFIGURATIONS[0],
    CONFIGURATIONS[1],
    CONFIGURATIONS[2],
    CONFIGURATIONS[3],
    CONFIGURATIONS[4],
    CONFIGURATIONS[5],
    LASTING[0],
    LASTING[1],
];

/// Born for the Pioneer.
pub(super) fn forager(config: Option<AgentConfig>, seed: u64) -> Result<Box<dyn Learner>, Failure> {
    Ok(match config {
        Some(config) => Box::new(Forager::born(config, Adaptation::Relearning, seed)?),
        None => {
            let mut values = [0.0; ITEMS.len()];
            values[usize::from(INGRIP)] = VALUE;
            let config = MindConfig::DEFAULT;
            Box::new(Minded::<1, 7, 6>::born(config, values, seed)?)
        }
    })
}

/// Born to circle a lamp.
pub(super) fn moth(config: Option<AgentConfig>, seed: u64) -> Result<Box<dyn Learner>, Failure> {
    Ok(match config {
        Some(config) => {
            let mut brain = Box::new(floats::brain());
            floats::be_born(&mut brain, config, seed)?;
            Box::new(Native::new(brain, Adaptation::Relearning))
        }
        None => {
            let values = [0.0, 0.0, 0.0, VALUE];
            let config = MindConfig::DEFAULT;
            Box::new(Minded::<1, 4, 3>::born(config, values, seed)?)
        }
    })
}
