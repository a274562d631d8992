//! The one learner of `cla-core` as a [`Learner`], with the capacities that all worlds share.

use cla_core::forest::{Mind, MindConfig, Motive};
use cla_core::snapshot::Names;
use cla_core::word::ActionId;

use super::image::{image_of, take};
use super::native::narrowed;
use super::{Learner, Thought, Worth};
use crate::failure::Failure;
use crate::world;

/// Stretches of sixteen samples: 7168 samples.
pub const STRETCHES: usize = 448;
/// Leaves of the trees of a member.
pub const LEAVES: usize = 200;
/// Rows of the habits.
pub const ROWS: usize = 512;
/// States of the model.
pub const STATES: usize = 512;
/// Links of the model.
pub const LINKS: usize = 2048;

/// The mind of a robot with so many words, items and actions.
pub type Brain<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> =
    Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS>;

/// A mind that was born.
///
/// ```
/// use cla_core::forest::MindConfig;
/// use host_sim::learner::mind::Minded;
/// use host_sim::learner::rewarded::rewarded;
/// use host_sim::world::lake::Lake;
/// let mut learner = Minded::<1, 16, 4>::born(MindConfig::DEFAULT, [0.0; 16], 1)?;
/// let income = rewarded(&mut learner, &mut Lake::new(1), 2000)?;
/// assert!(income.episodes > 50);
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
#[derive(Clone)]
pub struct Minded<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> {
    mind: Box<Brain<WORDS, ITEMS, ACTIONS>>,
    last: Thought,
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> Minded<WORDS, ITEMS, ACTIONS> {
    /// A newborn mind; `values` says what items are worth.
    ///
    /// # Errors
    /// When the configuration or a value cannot work.
    pub fn born(config: MindConfig, values: [f32; ITEMS], seed: u64) -> Result<Self, Failure> {
        let mut mind = Box::new(Mind::new());
        mind.be_born(config, values, seed)?;
        Ok(Self {
            mind,
            last: Thought::default(),
        })
    }

    /// The mind.
    #[must_use]
    pub const fn mind(&self) -> &Brain<WORDS, ITEMS, ACTIONS> {
        &self.mind
    }

    /// The mind, to be hit or mended.
    pub const fn mind_mut(&mut self) -> &mut Brain<WORDS, ITEMS, ACTIONS> {
        &mut self.mind
    }
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> Learner
    for Minded<WORDS, ITEMS, ACTIONS>
{
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        let choice = self.mind.choose(&narrowed(now))?;
        let why = match choice.motive {
            Motive::Voice(voice) => format!("{voice:?}"),
            Motive::Chance => "exploring".to_owned(),
            Motive::Escape => "escaping from a loop".to_owned(),
            Motive::Goal => "pursuing a goal".to_owned(),
        };
        self.last = Thought {
            schema: why,
            action: usize::from(choice.action.0),
            value: choice.value,
            alarmed: self.mind.doubts(),
        };
        Ok(self.last.action)
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        self.mind.learn(&narrowed(now))?;
        Ok(())
    }

    fn learn_with(&mut self, now: &world::Percept, reward: f32) -> Result<(), Failure> {
        self.mind.learn_with(&narrowed(now), reward)?;
        Ok(())
    }

    fn interrupt(&mut self) -> Result<(), Failure> {
        self.mind.interrupt()?;
        Ok(())
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        let action = ActionId(action as u16);
        self.mind
            .observe(&narrowed(before), action, &narrowed(after))?;
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.mind.act()?;
        Ok(())
    }

    fn alarms(&self) -> u32 {
        self.mind.alarms()
    }

    fn worth(&self, _: &world::Percept) -> Worth {
        Worth {
            choice: self.last.value,
            habit: 0.0,
        }
    }

    fn image(&self, names: Names) -> Result<Option<Vec<u8>>, Failure> {
        image_of(&*self.mind, names).map(Some)
    }

    fn go_on_from(&mut self, names: Names, image: &[u8]) -> Result<u32, Failure> {
        take(&mut *self.mind, names, image)
    }

    fn reason(&self) -> Thought {
        self.last.clone()
    }
}

/// A bare mind of any capacity, without a reason.
impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
> Learner for Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS>
{
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        Ok(usize::from(Self::choose(self, &narrowed(now))?.action.0))
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        Self::learn(self, &narrowed(now))?;
        Ok(())
    }

    fn learn_with(&mut self, now: &world::Percept, reward: f32) -> Result<(), Failure> {
        Self::learn_with(self, &narrowed(now), reward)?;
        Ok(())
    }

    fn interrupt(&mut self) -> Result<(), Failure> {
        Self::interrupt(self)?;
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
        Self::act(self)?;
        Ok(())
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
