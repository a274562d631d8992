//! The one learner of `cla-core` as a [`Learner`], with the capacities that all worlds share.

use cla_core::forest::{Actions, Mind, MindConfig, Motive};
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
    allowed: Actions,
    last: Thought,
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> Minded<WORDS, ITEMS, ACTIONS> {
    /// A newborn mind; `values` says what items are worth.
    ///
    /// # Errors
    /// When the configuration or a value cannot work.
    pub fn born(config: MindConfig, values: [f32; ITEMS], seed: u64) -> Result<Self, Failure> {
        Self::born_among(config, values, ACTIONS, seed)
    }

    /// The same for a robot that has only the first so many of the actions; it does no other.
    ///
    /// # Errors
    /// As [`born`](Self::born).
    pub fn born_among(
        config: MindConfig,
        values: [f32; ITEMS],
        actions: usize,
        seed: u64,
    ) -> Result<Self, Failure> {
        let mut mind = Box::new(Mind::new());
        mind.be_born(config, values, seed)?;
        let others = (actions..ACTIONS).map(|it| ActionId(it as u16));
        Ok(Self {
            mind,
            allowed: others.fold(Actions::ALL, Actions::without),
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
        let choice = self.mind.choose_among(&narrowed(now), self.allowed)?;
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

    within!(self => *self.mind;
        learn learn_with interrupt observe act alarms image go_on_from);

    fn worth(&self, _: &world::Percept) -> Worth {
        Worth {
            choice: self.last.value,
            habit: 0.0,
        }
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

#[cfg(test)]
mod tests {
    use cla_core::forest::MindConfig;

    use super::Minded;
    use crate::learner::Learner;
    use crate::learner::digest::{Digest, Digested};
    use crate::learner::rewarded::rewarded;
    use crate::world::lake::Lake;

    #[test]
    fn a_mind_with_room_for_more_actions_does_those_of_its_robot_alone() {
        let born = |actions| {
            let born = Minded::<1, 16, 6>::born_among;
            born(MindConfig::DEFAULT, [0.0; 16], actions, 5).unwrap()
        };
        let mut roomy = born(4);
        let (mut done, lake) = ([0_u32; 6], Lake::new(5));
        for _ in 0..2000 {
            let now = crate::world::World::sense(&lake);
            done[Learner::choose(&mut roomy, &now).unwrap()] += 1;
            Learner::learn(&mut roomy, &now).unwrap();
        }
        assert!(done[..4].iter().all(|&it| it > 0), "{done:?}");
        assert_eq!(done[4..], [0, 0]);
        // Who has all of its actions is who was born without a word on them.
        let life = |mut mind: Minded<1, 16, 4>| {
            let mut it = Digested::new(&mut mind, Digest::NEW);
            rewarded(&mut it, &mut Lake::new(5), 3000).unwrap();
            it.digest()
        };
        let config = MindConfig::DEFAULT;
        let plain = Minded::born(config, [0.0; 16], 5).unwrap();
        let among = Minded::born_among(config, [0.0; 16], 4, 5).unwrap();
        assert_eq!(life(plain), life(among));
    }
}
