//! How a brain lives in a world: the loop of sensing, choosing, acting and learning.

use cla_core::clasm::{ActionId, Agent};
use cla_core::forager::pioneer::{Action, Item, Percept};
use cla_core::som::Prototypes;

pub use crate::learner::forager::percept;
use crate::options::Failure;
use crate::world::World;

/// What chooses and learns for a forager's body: a brain here, or one at the end of a wire.
pub trait Mind {
    /// What to do now.
    ///
    /// # Errors
    /// [`Failure`] of a brain that was not born, or of the wire to it.
    fn choose(&mut self, now: &Percept) -> Result<ActionId, Failure>;

    /// Learns what the chosen action led to.
    ///
    /// # Errors
    /// As [`choose`](Self::choose).
    fn learn(&mut self, now: &Percept) -> Result<(), Failure>;

    /// Learns from a reflex.
    ///
    /// # Errors
    /// As [`choose`](Self::choose).
    fn observe(
        &mut self,
        before: &Percept,
        action: ActionId,
        after: &Percept,
    ) -> Result<(), Failure>;
}

impl<
    const WIDTH: usize,
    const HEIGHT: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
> Mind for Agent<1, 7, WIDTH, HEIGHT, 6, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    fn choose(&mut self, now: &Percept) -> Result<ActionId, Failure> {
        Ok(Self::choose(self, now)?.action)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        Self::learn(self, now)?;
        Ok(())
    }

    fn observe(
        &mut self,
        before: &Percept,
        action: ActionId,
        after: &Percept,
    ) -> Result<(), Failure> {
        Self::observe(self, before, action, after)?;
        Ok(())
    }
}

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
fn feel_reflexes(mind: &mut dyn Mind, world: &mut dyn World) -> Result<(), Failure> {
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
        mind.observe(&before, action.id(), &percept(&world.sense()))?;
    }
}

/// Lets a brain do up to `actions` actions; reflexes run in between and are not counted.
///
/// # Errors
/// [`Failure`] of an unborn brain, or of the wire to a distant one.
pub fn live(mind: &mut dyn Mind, world: &mut dyn World, actions: u32) -> Result<Tally, Failure> {
    let before = world.captures();
    let mut done = 0;
    while done < actions && !world.finished() {
        let now = percept(&world.sense());
        let action = mind.choose(&now)?;
        world.act(usize::from(action.0));
        mind.learn(&percept(&world.sense()))?;
        feel_reflexes(mind, world)?;
        done += 1;
    }
    Ok(Tally {
        actions: done,
        captures: world.captures() - before,
    })
}
