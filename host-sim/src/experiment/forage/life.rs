//! How a brain lives in a world: the loop of sensing, choosing, acting and learning.

use cla_core::clasm::{AgentError, ItemSet, ItemStates};
use cla_core::forager::pioneer::{Brain, Percept};

use crate::world::{self, World};

/// What came of some actions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Actions done; fewer than asked for when the world ended.
    pub actions: u32,
    /// Specimens obtained.
    pub captures: u32,
}

/// The world's percept in the words of the forager's brain.
#[must_use]
pub fn percept(now: &world::Percept) -> Percept {
    let narrow = |set: &ItemSet<{ world::WORLD_WORDS }>| {
        let mut out = ItemSet::EMPTY;
        for item in set.iter() {
            // Items beyond the brain's capacity do not exist for it.
            let _ = out.insert(item);
        }
        out
    };
    ItemStates::from_sets(&narrow(now.on()), &narrow(now.off()))
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
        while world.reflex() {}
        done += 1;
    }
    Ok(Tally {
        actions: done,
        captures: world.captures() - before,
    })
}
