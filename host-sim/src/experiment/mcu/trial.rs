//! A trial on microcontrollers: what is measured once, or the lives of a seed.
//!
//! Measures only; what the numbers mean is said in `claims`.

use std::sync::{PoisonError, RwLock};

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::{pioneer, small};
use cla_core::snapshot::Stored;
use cla_core::som::Prototypes;
use firmware_example::replay::{Forager, be_born};
use serde::{Deserialize, Serialize};

use super::bench::Bench;
use crate::device::target::Target;
use crate::experiment::hil::trial::{Life, controller, run as live_in_the_loop};
use crate::failure::Failure;
use crate::learner::live;
use crate::world::config::PioneerConfig;
use crate::world::pioneer::Pioneer;
use crate::world::setting::rooms;

/// Actions of training and of a test, as in `forage`.
const ACTIONS: (u32, u32) = (10_000, 3_000);

/// What a trial is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Case {
    /// What is the same for all seeds.
    Bench,
    /// The lives of a seed.
    Seed(u64),
}

/// What a trial measures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Trial {
    /// What is the same for all seeds.
    Bench(Bench),
    /// The lives of a seed.
    Lives(Lives),
}

/// The lives of one seed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lives {
    /// With the brain in the loop.
    pub in_the_loop: Life,
    /// Captures of the profile for small parts.
    pub small: u32,
    /// Captures of the host's profile.
    pub large: u32,
}

/// Held by lives together and by what is timed alone: nothing else runs beside it.
static QUIET: RwLock<()> = RwLock::new(());

/// Makes one trial.
///
/// # Errors
/// [`Failure`] when a program cannot be built or ends badly.
pub(super) fn run(case: Case) -> Result<Trial, Failure> {
    match case {
        Case::Bench => {
            let _alone = QUIET.write().unwrap_or_else(PoisonError::into_inner);
            Ok(Trial::Bench(Bench::measured()?))
        }
        Case::Seed(seed) => {
            let _together = QUIET.read().unwrap_or_else(PoisonError::into_inner);
            Ok(Trial::Lives(Lives {
                in_the_loop: live_in_the_loop(
                    Target::M4f,
                    controller()?,
                    seed,
                    ACTIONS.0,
                    ACTIONS.1,
                )?,
                small: captures(small::brain(), seed)?,
                large: captures(pioneer::brain(), seed)?,
            }))
        }
    }
}

/// Captures of one profile in the test of `forage`.
fn captures<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored + 'static,
>(
    brain: Forager<W, H, P, S, Y, B, M>,
    seed: u64,
) -> Result<u32, Failure> {
    let mut brain: Box<Forager<W, H, P, S, Y, B, M>> = Box::new(brain);
    be_born(&mut brain, AgentConfig::FORAGER, seed)?;
    let [first, second, third] = rooms(seed);
    let mut world = Pioneer::new(PioneerConfig::NOISY, first)?;
    live(&mut *brain, &mut world, ACTIONS.0)?;
    brain.reconfigure(AgentConfig::FORAGER_LEVEL2)?;
    let mut world = Pioneer::new(PioneerConfig::NOISY, second)?;
    live(&mut *brain, &mut world, ACTIONS.0)?;
    brain.act(Adaptation::Reliabilities)?;
    let mut world = Pioneer::new(PioneerConfig::NOISY, third)?;
    Ok(live(&mut *brain, &mut world, ACTIONS.1)?.total())
}
