//! Brains with images of some kilobytes, and what they live through.

use cla_core::forest::Mind;
use cla_core::num::Rng;
use cla_core::snapshot::{self, Names, SliceSink, Snapshot};
use cla_core::word::{ActionId, ItemId, ItemStates};
use cla_core::{AgentConfig, MindConfig};

use crate::failure::Failure;

cla_core::brain! {
    /// A robot of four items and three actions.
    pub mod robot {
        items: [left, ahead, right, there],
        actions: [turn_left, forward, turn_right],
        values: [there = 10.0],
        maps: 4 x 3 of bytes,
        patterns: 16,
        schemas: 32,
        synthetic: 12,
        beliefs: 24,
        ram: 20_000,
    }
}

pub use robot::Brain;

/// The one learner for the same robot, with room for 96 samples.
pub type SmallMind = Mind<1, 4, 3, 8, 12, 32, 48, 96>;

/// A brain that can be saved at some age.
pub trait Toy: Snapshot + Clone {
    /// One that is not born, for a load.
    fn empty() -> Box<Self>;

    /// One that is born.
    ///
    /// # Errors
    /// When the brain refuses, which it does not.
    fn born(seed: u64) -> Result<Box<Self>, Failure>;

    /// Chooses.
    ///
    /// # Errors
    /// When the brain refuses, which it does not.
    fn chosen(&mut self, now: &ItemStates<1>) -> Result<ActionId, Failure>;

    /// Learns what that led to.
    ///
    /// # Errors
    /// When the brain refuses, which it does not.
    fn learned(&mut self, now: &ItemStates<1>) -> Result<(), Failure>;
}

impl Toy for Brain {
    fn empty() -> Box<Self> {
        Box::new(robot::brain())
    }

    fn born(seed: u64) -> Result<Box<Self>, Failure> {
        let mut brain = Self::empty();
        robot::be_born(&mut brain, AgentConfig::FORAGER_LEVEL2, seed)?;
        Ok(brain)
    }

    fn chosen(&mut self, now: &ItemStates<1>) -> Result<ActionId, Failure> {
        Ok(self.choose(now)?.action)
    }

    fn learned(&mut self, now: &ItemStates<1>) -> Result<(), Failure> {
        self.learn(now)?;
        Ok(())
    }
}

impl Toy for SmallMind {
    fn empty() -> Box<Self> {
        Box::new(Self::new())
    }

    fn born(seed: u64) -> Result<Box<Self>, Failure> {
        let mut brain = Self::empty();
        brain.be_born(MindConfig::DEFAULT, [0.0, 0.0, 0.0, 10.0], seed)?;
        Ok(brain)
    }

    fn chosen(&mut self, now: &ItemStates<1>) -> Result<ActionId, Failure> {
        Ok(self.choose(now)?.action)
    }

    fn learned(&mut self, now: &ItemStates<1>) -> Result<(), Failure> {
        self.learn(now)?;
        Ok(())
    }
}

/// A brain at some age, and its image.
pub type Age<B = Brain> = (Box<B>, Vec<u8>);

/// A life at different ages, with its images; each image is another, and so are those of each seed.
///
/// # Errors
/// When the brain refuses, which it does not.
pub fn ages<B: Toy>(number: usize, seed: u64) -> Result<Vec<Age<B>>, Failure> {
    let mut brain = B::born(seed)?;
    let mut rng = Rng::stream(seed, 7);
    let mut now = percept(&mut rng);
    let mut ages = Vec::new();
    for age in 0..number {
        for _ in 0..30 + 40 * age as u32 + rng.below(40) {
            let action = brain.chosen(&now)?;
            now = percept(&mut rng);
            let there = action.0 == 1 && rng.chance(0.5);
            // What a set of four items holds.
            let _ = now.set(ItemId(3), Some(there));
            brain.learned(&now)?;
        }
        let image = image(&*brain);
        ages.push((brain.clone(), image));
    }
    Ok(ages)
}

fn percept(rng: &mut Rng) -> ItemStates<1> {
    let mut now = ItemStates::all_off(4);
    let _ = now.set(ItemId(rng.below(3) as u16), Some(true));
    now
}

/// The image of a brain; empty where it cannot be saved.
#[must_use]
pub fn image<B: Snapshot>(brain: &B) -> Vec<u8> {
    let mut image = vec![0; size_of::<B>() + 1024];
    match snapshot::save(brain, names(), &mut SliceSink::new(&mut image)) {
        Ok(length) => image.truncate(length as usize),
        Err(_) => image.clear(),
    }
    image
}

/// What its items and actions are called.
#[must_use]
pub fn names() -> Names {
    robot::VOCABULARY.names()
}
