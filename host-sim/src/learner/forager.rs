//! The brain of `cla-core` as a [`Learner`]: percepts in its words, reasons in the book's notation.

use cla_core::adaptation::SurpriseConfig;
use cla_core::agent::{Adaptation, Agent, AgentConfig, Choice, Reason};
use cla_core::forager::pioneer::{self, Brain, VOCABULARY};
use cla_core::knowledge::Estimate;
use cla_core::snapshot::{Names, Stored};
use cla_core::som::Prototypes;
use cla_core::word::{ActionId, Cost, Detail, ItemSet, ItemStates};

use super::image::{image_of, take};
use super::{Learner, Thought, Worth};
use crate::failure::Failure;
use crate::world;

/// The world's percept in the words of the forager's brain.
#[must_use]
pub fn percept(now: &world::Percept) -> pioneer::Percept {
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

/// A bare brain of any capacity; when it acts, its reliabilities go on adapting.
impl<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored + 'static,
> Learner for Agent<1, 7, W, H, 6, P, S, Y, B, M>
{
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        Ok(usize::from(Self::choose(self, &percept(now))?.action.0))
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        Self::learn(self, &percept(now))?;
        Ok(())
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        let action = ActionId(action as u16);
        Self::observe(self, &percept(before), action, &percept(after))?;
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        Self::act(self, Adaptation::Reliabilities)?;
        Ok(())
    }

    fn cost(&self) -> Option<Cost> {
        Some(Self::cost(self))
    }

    fn image(&self, names: Names) -> Result<Option<Vec<u8>>, Failure> {
        image_of(self, names).map(Some)
    }

    fn go_on_from(&mut self, names: Names, image: &[u8]) -> Result<u32, Failure> {
        take(self, names, image)
    }
}

/// A forager with level 1, and how it adapts when it acts.
#[derive(Clone)]
pub struct Forager {
    brain: Box<Brain>,
    adaptation: Adaptation,
    last: Option<Choice>,
}

impl Forager {
    /// A newborn forager.
    ///
    /// # Errors
    /// When the configuration cannot work.
    pub fn born(config: AgentConfig, adaptation: Adaptation, seed: u64) -> Result<Self, Failure> {
        let mut brain = Box::new(pioneer::brain());
        pioneer::be_born(&mut brain, config, seed)?;
        Ok(Self {
            brain,
            adaptation,
            last: None,
        })
    }

    /// The same forager with the same past, which will act and adapt in this way.
    ///
    /// # Errors
    /// When it has not begun or the surprise cannot work.
    pub fn acting(
        &self,
        adaptation: Adaptation,
        surprise: Option<SurpriseConfig>,
    ) -> Result<Self, Failure> {
        let mut it = self.clone();
        it.adaptation = adaptation;
        it.brain.set_surprise(surprise)?;
        it.act()?;
        Ok(it)
    }

    /// The brain.
    #[must_use]
    pub fn brain(&self) -> &Brain {
        &self.brain
    }

    /// The brain, to change what is not learned.
    pub fn brain_mut(&mut self) -> &mut Brain {
        &mut self.brain
    }
}

impl Learner for Forager {
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        let choice = Agent::choose(&mut self.brain, &percept(now))?;
        self.last = Some(choice);
        Ok(usize::from(choice.action.0))
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        Learner::learn(&mut *self.brain, now)
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        Learner::observe(&mut *self.brain, before, action, after)
    }

    fn act(&mut self) -> Result<(), Failure> {
        Agent::act(&mut self.brain, self.adaptation)?;
        Ok(())
    }

    fn cost(&self) -> Option<Cost> {
        Some(self.brain.cost())
    }

    fn reliabilities(&self) -> Vec<f64> {
        let schemas = self.brain.knowledge().schemas().iter();
        schemas
            .filter(|schema| schema.reliability.activations() > 0)
            .map(|schema| f64::from(schema.reliability.value(Estimate::Recent)))
            .collect()
    }

    fn predictions(&self) -> (u32, u32) {
        let all = self.brain.second_level().predictions();
        (all.successes(), all.activations())
    }

    fn alarms(&self) -> u32 {
        self.brain.alarms()
    }

    fn image(&self, names: Names) -> Result<Option<Vec<u8>>, Failure> {
        image_of(&*self.brain, names).map(Some)
    }

    fn go_on_from(&mut self, names: Names, image: &[u8]) -> Result<u32, Failure> {
        take(&mut *self.brain, names, image)
    }

    fn worth(&self, now: &world::Percept) -> Worth {
        let habits = self.brain.habits();
        let habits = habits.worth(percept(now).on(), self.brain.trace());
        Worth {
            choice: self.last.map_or(0.0, |it| it.value),
            habit: habits.into_iter().fold(0.0, f32::max),
        }
    }

    fn reason(&self) -> Thought {
        let Some(choice) = self.last else {
            return Thought::default();
        };
        let knowledge = self.brain.knowledge();
        let schema = choice.schema.and_then(|schema| knowledge.text(schema));
        let schema = match (schema, choice.reason) {
            (Some(text), _) => text.display(&VOCABULARY, Detail::Abbreviated).to_string(),
            (None, Reason::Exploration) => "exploring".to_owned(),
            (None, Reason::Escape) => "escaping from a loop".to_owned(),
            (None, _) => "nothing applies".to_owned(),
        };
        Thought {
            schema,
            action: usize::from(choice.action.0),
            value: choice.value,
            alarmed: self.brain.doubts(),
        }
    }
}
