//! Brain in the loop: the simulated robot lives, the brain in the emulated controller decides.
//!
//! A brain on the host lives beside it, sees the same percepts, and must choose the same with the
//! same value, bit for bit; at the end both must know the same.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use cla_core::agent::{Agent, AgentConfig};
use cla_core::forager::pioneer::{self, Brain};
use cla_core::word::Cost;
use firmware_example::controller::knowledge;
use firmware_example::link::{Answer, Order};
use serde::{Deserialize, Serialize};

use super::distant::Distant;
use crate::device::board::Build;
use crate::device::meter::Load;
use crate::device::target::Target;
use crate::failure::Failure;
use crate::learner::native::narrowed;
use crate::learner::{Learner, live};
use crate::world::Percept;
use crate::world::config::PioneerConfig;
use crate::world::pioneer::Pioneer;
use crate::world::setting::rooms;

/// What came of one life.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Life {
    /// Choices, in training and test.
    pub choices: u32,
    /// Choices that were those of the host's brain, with its value, to the bit.
    pub same: u32,
    /// Captures in the test.
    pub captures: u32,
    /// What the worst step would cost by estimate.
    pub load: Load,
    /// Whether both brains know the same schemas with the same counts at the end.
    pub same_knowledge: bool,
    /// Questions asked and answered over the wire.
    pub round_trips: u32,
    /// How long that took, the world's and the host brain's work included.
    pub took: Duration,
}

/// The program of the controller, built once.
///
/// # Errors
/// [`Failure`] when it cannot be built.
pub fn controller() -> Result<&'static Path, Failure> {
    // Every life runs the same file, which a second build would overwrite under it.
    static PROGRAM: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    let built = PROGRAM.get_or_init(|| {
        let build = Build::new(Target::M4f, "controller").build();
        build.map_err(|error| error.to_string())
    });
    match built {
        Ok(program) => Ok(program),
        Err(why) => Err(why.clone().into()),
    }
}

/// Two brains with one life; the distant one decides.
struct Twins {
    distant: Distant,
    here: Box<Brain>,
    choices: u32,
    same: u32,
}

impl Learner for Twins {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        let action = self.distant.choose(now)?;
        let here = self.here.choose(&narrowed(now))?;
        self.choices += 1;
        let agrees = usize::from(here.action.0) == action;
        let same = agrees && here.value.to_bits() == self.distant.last_value();
        self.same += u32::from(same);
        if !agrees {
            // The host's brain would learn from what it did not do.
            return Err(format!("choice {} differs: {here:?}, not {action}", self.choices).into());
        }
        Ok(action)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.distant.learn(now)?;
        Learner::learn(&mut *self.here, now)
    }

    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure> {
        self.distant.observe(before, action, after)?;
        Learner::observe(&mut *self.here, before, action, after)
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.distant.act()?;
        Learner::act(&mut *self.here)
    }

    fn cost(&self) -> Option<Cost> {
        Some(self.here.cost())
    }
}

/// Lives `actions` actions of training with one level, as many with both, and a test, as in
/// `forage`, with a program of the firmware.
///
/// # Errors
/// [`Failure`] when the firmware cannot be started, dies, or chooses another action.
pub fn run(
    target: Target,
    program: &Path,
    seed: u64,
    actions: u32,
    test_actions: u32,
) -> Result<Life, Failure> {
    let started = Instant::now();
    let mut here: Box<Brain> = Box::new(Agent::new());
    pioneer::be_born(&mut here, AgentConfig::FORAGER, seed)?;
    let mut twins = Twins {
        distant: Distant::start(target, program, seed)?,
        here,
        choices: 0,
        same: 0,
    };
    let [first, second, third] = rooms(seed);
    let mut world = Pioneer::new(PioneerConfig::NOISY, first)?;
    let young = live(&mut twins, &mut world, actions)?;
    twins.distant.begin_second_level()?;
    twins.here.reconfigure(AgentConfig::FORAGER_LEVEL2)?;
    let mut world = Pioneer::new(PioneerConfig::NOISY, second)?;
    let grown = live(&mut twins, &mut world, actions)?;
    twins.act()?;
    // The test world of `forage`.
    let mut world = Pioneer::new(PioneerConfig::NOISY, third)?;
    let tested = live(&mut twins, &mut world, test_actions)?;
    let mut load = young.load;
    load.merge(&grown.load);
    load.merge(&tested.load);
    let same_knowledge = match twins.distant.ask(Order::Report)? {
        Answer::Report {
            knowledge: theirs, ..
        } => theirs == knowledge(&twins.here),
        _ => false,
    };
    Ok(Life {
        choices: twins.choices,
        same: twins.same,
        captures: tested.total(),
        load,
        same_knowledge,
        round_trips: twins.distant.round_trips(),
        took: started.elapsed(),
    })
}
