//! The brain of `cla-core` as a [`Learner`]: percepts in its words, reasons in the book's notation.

use cla_core::adaptation::SurpriseConfig;
use cla_core::agent::{Adaptation, Agent, AgentConfig, Choice, Reason};
use cla_core::forager::pioneer::{self, Brain, VOCABULARY};
use cla_core::knowledge::Estimate;
use cla_core::word::Detail;

use super::native::{habit, narrowed};
use super::{Learner, Thought, Worth};
use crate::failure::Failure;
use crate::world;

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
        let choice = Agent::choose(&mut self.brain, &narrowed(now))?;
        self.last = Some(choice);
        Ok(usize::from(choice.action.0))
    }

    within!(self => *self.brain; learn observe cost alarms image go_on_from);

    fn act(&mut self) -> Result<(), Failure> {
        Agent::act(&mut self.brain, self.adaptation)?;
        Ok(())
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

    fn worth(&self, now: &world::Percept) -> Worth {
        Worth {
            choice: self.last.map_or(0.0, |it| it.value),
            habit: habit(&self.brain, now),
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
