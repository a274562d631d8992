//! A life in which every kind of step comes, to weigh what a brain says that a step has touched.

use cla_core::agent::Adaptation;
use cla_core::word::Cost;

use crate::replay::{Forager, Moment, ReplayError, relive};
use crate::trace;

/// Actions without maps that follow the recorded life, for each way of acting without them.
const WITHOUT_MAPS: u32 = 500;

/// Which part of the life a step belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Level 1 learns alone.
    Level1,
    /// Both levels learn.
    Level2,
    /// Both levels act, and no map is trained.
    Acting,
}

/// Relives the first `actions` recorded actions, then some that only correct reliabilities, and some
/// that learn nothing; hands over the instructions and the counts of every step.
///
/// A step is choosing and learning; steps that harvest, and reflexes, are left out.
///
/// # Errors
/// [`ReplayError`] when the brain refuses.
pub fn steps<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
>(
    brain: &mut Forager<W, H, P, S, Y, B>,
    actions: u32,
    mut lap: impl FnMut() -> u32,
    mut step: impl FnMut(Part, u32, Cost),
) -> Result<(), ReplayError> {
    let (mut part, mut choosing) = (Part::Level1, None);
    relive(brain, trace::SEED, actions, |moment, cost| {
        let instructions = lap();
        match moment {
            Moment::Chosen => choosing = Some(instructions),
            Moment::Learned => {
                if let Some(choosing) = choosing.take() {
                    step(part, choosing + instructions, cost);
                }
            }
            Moment::Harvested => choosing = None,
            Moment::SecondLevel => part = Part::Level2,
            Moment::Sensed | Moment::Settled => {}
        }
    })?;
    for adaptation in [Adaptation::Reliabilities, Adaptation::Frozen] {
        brain.act(adaptation).map_err(ReplayError::Agent)?;
        for it in trace::steps(WITHOUT_MAPS) {
            lap();
            if !it.reflex {
                brain.choose(&it.before).map_err(ReplayError::Agent)?;
            }
            let chosen = lap();
            let lesson = brain.observe(&it.before, it.action, &it.after);
            lesson.map_err(ReplayError::Agent)?;
            let learned = lap();
            if !it.reflex {
                step(Part::Acting, chosen + learned, brain.cost());
            }
        }
    }
    Ok(())
}
