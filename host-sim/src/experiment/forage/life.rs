//! How a brain lives in a world: the loop of sensing, choosing, acting and learning.

use cla_core::clasm::AgentError;
use cla_core::forager::pioneer::{Action, Brain, Item};

pub use crate::learner::forager::percept;
use crate::world::World;

/// What came of some actions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Actions done; fewer than asked for when the world ended.
    pub actions: u32,
    /// Specimens obtained.
    pub captures: u32,
}

/// Lets the body's reflexes run; the brain observes each as the action that it ends with.
///
/// The book's reflexes (6.2.1): what is in the gripper is gripped; a bumped robot backs and turns
/// around.
/// A brain that did not see them would take a bump for the end of the world: no action would ever
/// have followed one.
fn feel_reflexes(brain: &mut Brain, world: &mut dyn World) -> Result<(), AgentError> {
    loop {
        let before = percept(&world.sense());
        if !world.reflex() {
            return Ok(());
        }
        let gripped = before.get(Item::ingrip.id()) == Some(true);
        let action = if gripped {
            Action::grip
        } else {
            Action::turnaround
        };
        brain.observe(&before, action.id(), &percept(&world.sense()))?;
    }
}

/// Lets a brain do up to `actions` actions; reflexes run in between and are not counted.
///
/// # Errors
/// [`AgentError::NotBegun`] for an unborn brain.
pub fn live(brain: &mut Brain, world: &mut dyn World, actions: u32) -> Result<Tally, AgentError> {
    let before = world.captures();
    let mut done = 0;
    while done < actions && !world.finished() {
        let now = percept(&world.sense());
        let choice = brain.choose(&now)?;
        world.act(usize::from(choice.action.0));
        brain.learn(&percept(&world.sense()))?;
        feel_reflexes(brain, world)?;
        done += 1;
    }
    Ok(Tally {
        actions: done,
        captures: world.captures() - before,
    })
}
