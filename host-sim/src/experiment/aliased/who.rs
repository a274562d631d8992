//! The learners that are not rivals: the one learner and the book's agent, in any of the worlds.

use cla_core::agent::{Adaptation, Agent, AgentConfig};
use cla_core::forest::MindConfig;
use cla_core::level2::SecondLevel;
use cla_core::word::{Detail, ItemId, Vocabulary};

use super::places::Place;
use crate::baseline::random::Random;
use crate::baseline::tabular::Tabular;
use crate::baseline::worlds::believer::Believer;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::controller::Untaught;
use crate::learner::mind::Minded;
use crate::learner::native::Native;
use crate::world::names::Names;

/// The book's agent with room for all that these worlds have to tell.
pub type Book<const ITEMS: usize, const ACTIONS: usize> =
    Agent<1, ITEMS, 8, 8, ACTIONS, 64, 256, 128, 1024>;

/// What an item is worth to the book's agent, and a specimen to everybody.
const WORTH: f32 = 10.0;

/// A learner that was born, unless it cannot be.
pub(super) type Born = Result<Box<dyn Living>, Failure>;

/// A learner that can be tested without its life going on: a twin is.
pub(super) trait Living: Learner {
    /// The same learner with the same past.
    fn twin(&self) -> Box<dyn Living>;

    /// The synthetic item that is on, for who has such.
    fn believes(&self) -> Option<u16> {
        None
    }

    /// What a synthetic item stands for, in the book's notation.
    fn tells(&self, _item: u16, _names: (Names, Names)) -> String {
        String::new()
    }
}

impl Living for Tabular {
    fn twin(&self) -> Box<dyn Living> {
        Box::new(self.clone())
    }
}

impl Living for Untaught<Random> {
    fn twin(&self) -> Box<dyn Living> {
        Box::new(self.clone())
    }
}

impl Living for Untaught<Believer> {
    fn twin(&self) -> Box<dyn Living> {
        Box::new(self.clone())
    }
}

impl<const ITEMS: usize, const ACTIONS: usize> Living for Minded<1, ITEMS, ACTIONS> {
    fn twin(&self) -> Box<dyn Living> {
        Box::new(self.clone())
    }
}

impl<const ITEMS: usize, const ACTIONS: usize> Living for Native<Book<ITEMS, ACTIONS>> {
    fn twin(&self) -> Box<dyn Living> {
        Box::new(self.clone())
    }

    fn believes(&self) -> Option<u16> {
        self.brain().trace().map(|it| it.0)
    }

    fn tells(&self, item: u16, (items, actions): (Names, Names)) -> String {
        let brain = self.brain();
        let schema =
            SecondLevel::schema(brain.second_level(), cla_core::knowledge::SyntheticId(item));
        let text = schema.and_then(|it| brain.knowledge().text(it));
        let words = Vocabulary { items, actions };
        text.map_or_else(String::new, |it| {
            it.display(&words, Detail::Abbreviated).to_string()
        })
    }
}

/// The one learner and the book's agent, in the shape of a world.
pub(super) struct Shape {
    pub(super) mind: fn([f32; 2], u64) -> Born,
    pub(super) book: fn(AgentConfig, ItemId, u64) -> Born,
}

fn mind<const ITEMS: usize, const ACTIONS: usize>([item, worth]: [f32; 2], seed: u64) -> Born {
    let mut values = [0.0; ITEMS];
    if let Some(value) = values.get_mut(item as usize) {
        *value = worth;
    }
    let it = Minded::<1, ITEMS, ACTIONS>::born(MindConfig::DEFAULT, values, seed)?;
    Ok(Box::new(it))
}

fn book<const ITEMS: usize, const ACTIONS: usize>(
    config: AgentConfig,
    valued: ItemId,
    seed: u64,
) -> Born {
    let mut brain = Box::new(Book::<ITEMS, ACTIONS>::new());
    brain.be_born(config, &[(valued, WORTH)], seed)?;
    Ok(Box::new(Native::new(brain, Adaptation::Relearning)))
}

const fn shape<const ITEMS: usize, const ACTIONS: usize>() -> Shape {
    Shape {
        mind: mind::<ITEMS, ACTIONS>,
        book: book::<ITEMS, ACTIONS>,
    }
}

impl Place {
    const fn shape(self) -> Shape {
        match self {
            Self::Barriers => shape::<7, 6>(),
            Self::Shuttle => shape::<5, 3>(),
            Self::Cheese => shape::<7, 4>(),
            Self::TMaze2 | Self::TMaze4 | Self::TMaze8 | Self::TMaze16 => shape::<6, 3>(),
            Self::Hallway => shape::<21, 5>(),
        }
    }

    /// The one learner, newborn; where rewards are no numbers, the valued item has its worth.
    ///
    /// # Errors
    /// [`Failure`] when it cannot be born.
    pub(super) fn mind(self, items: Names, seed: u64) -> Born {
        let worth = if self == Self::Barriers { WORTH } else { 0.0 };
        (self.shape().mind)([f32::from(self.valued_id(items).0), worth], seed)
    }

    /// The book's agent, newborn.
    ///
    /// # Errors
    /// [`Failure`] when it cannot be born.
    pub(super) fn book(self, config: AgentConfig, items: Names, seed: u64) -> Born {
        (self.shape().book)(config, self.valued_id(items), seed)
    }

    fn valued_id(self, items: Names) -> ItemId {
        let at = items.iter().position(|&it| it == self.valued());
        ItemId(at.unwrap_or(0) as u16)
    }
}
