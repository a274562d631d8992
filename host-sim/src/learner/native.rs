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

/// A bare brain of any capacity; when it acts, its reliabilities go on adapting.
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
> Learner for Agent<WORDS, ITEMS, W, H, ACTIONS, P, S, Y, B, M>
{
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        Ok(usize::from(Self::choose(self, &narrowed(now))?.action.0))
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        Self::learn(self, &narrowed(now))?;
        Ok(())
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        let action = ActionId(action as u16);
        Self::observe(self, &narrowed(before), action, &narrowed(after))?;
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        Self::act(self, Adaptation::Reliabilities)?;
        Ok(())
    }

    fn cost(&self) -> Option<Cost> {
        Some(Self::cost(self))
    }

    fn alarms(&self) -> u32 {
        Self::alarms(self)
    }

    fn image(&self, names: Names) -> Result<Option<Vec<u8>>, Failure> {
        image_of(self, names).map(Some)
    }

    fn go_on_from(&mut self, names: Names, image: &[u8]) -> Result<u32, Failure> {
        take(self, names, image)
    }
}

/// What habits alone hold the best action to be worth.
pub(super) fn habit<
    const WORDS: usize,
    const ITEMS: usize,
    const W: usize,
    const H: usize,
    const ACTIONS: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &Agent<WORDS, ITEMS, W, H, ACTIONS, P, S, Y, B, M>,
    now: &world::Percept,
) -> f32 {
    let worth = brain.habits().worth(narrowed(now).on(), brain.trace());
    worth.into_iter().fold(0.0, f32::max)
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
        let choice = Agent::choose(&mut self.brain, &narrowed(now))?;
        self.value = choice.value;
        Ok(usize::from(choice.action.0))
    }

    within!(self => *self.brain; learn observe cost alarms image go_on_from);

    fn act(&mut self) -> Result<(), Failure> {
        Agent::act(&mut self.brain, self.adaptation)?;
        Ok(())
    }

    fn worth(&self, now: &world::Percept) -> Worth {
        Worth {
            choice: self.value,
            habit: habit(&self.brain, now),
        }
    }
}
