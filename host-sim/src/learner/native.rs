//! The brain that any `brain!` makes, as a [`Learner`]: level 1, both levels, whatever its
//! configuration says.
//!
//! It learns from its valued items; rewards beside the percept are not its own.

use cla_core::agent::{Adaptation, Agent};
use cla_core::snapshot::{Names, Stored};
use cla_core::som::Prototypes;
use cla_core::word::{ActionId, Cost, ItemSet, ItemStates};

use super::image::{image_of, take};
use super::{Learner, Worth};
use crate::failure::Failure;
use crate::world;

/// The world's percept in `WORDS` words; items beyond do not exist.
#[must_use]
pub fn narrowed<const WORDS: usize>(now: &world::Percept) -> ItemStates<WORDS> {
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

/// A brain that was born, and how it adapts when it acts.
///
/// ```
/// use cla_core::agent::{Adaptation, AgentConfig};
/// use host_sim::learner::{native::Native, rewarded::rewarded};
/// use host_sim::world::lake::{Lake, skater};
/// let mut brain = Box::new(skater::brain());
/// skater::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// let mut learner = Native::new(brain, Adaptation::Relearning);
/// let income = rewarded(&mut learner, &mut Lake::new(1), 200)?;
/// assert_eq!(income.actions, 200);
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
#[derive(Clone)]
pub struct Native<A> {
    brain: Box<A>,
    adaptation: Adaptation,
    value: f32,
}

impl<A> Native<A> {
    /// A brain that has been born.
    #[must_use]
    pub const fn new(brain: Box<A>, adaptation: Adaptation) -> Self {
        Self {
            brain,
            adaptation,
            value: 0.0,
        }
    }

    /// The brain.
    #[must_use]
    pub const fn brain(&self) -> &A {
        &self.brain
    }

    /// The brain, to be hit or mended.
    pub const fn brain_mut(&mut self) -> &mut A {
        &mut self.brain
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const W: usize,
    const H: usize,
    const ACTIONS: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored + 'static,
> Learner for Native<Agent<WORDS, ITEMS, W, H, ACTIONS, P, S, Y, B, M>>
{
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        let choice = self.brain.choose(&narrowed(now))?;
        self.value = choice.value;
        Ok(usize::from(choice.action.0))
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        self.brain.learn(&narrowed(now))?;
        Ok(())
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        let action = ActionId(action as u16);
        self.brain
            .observe(&narrowed(before), action, &narrowed(after))?;
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.brain.act(self.adaptation)?;
        Ok(())
    }

    fn cost(&self) -> Option<Cost> {
        Some(self.brain.cost())
    }

    fn alarms(&self) -> u32 {
        self.brain.alarms()
    }

    fn worth(&self, now: &world::Percept) -> Worth {
        let habits = self.brain.habits();
        let habits = habits.worth(narrowed(now).on(), self.brain.trace());
        Worth {
            choice: self.value,
            habit: habits.into_iter().fold(0.0, f32::max),
        }
    }

    fn image(&self, names: Names) -> Result<Option<Vec<u8>>, Failure> {
        image_of(&*self.brain, names).map(Some)
    }

    fn go_on_from(&mut self, names: Names, image: &[u8]) -> Result<u32, Failure> {
        take(&mut *self.brain, names, image)
    }
}
