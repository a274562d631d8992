//! A brain with an image of some kilobytes, and what it lives through.

use cla_core::AgentConfig;
use cla_core::num::Rng;
use cla_core::snapshot::{Names, Snapshot};
use cla_core::word::{ItemId, ItemStates};

use crate::failure::Failure;
use crate::learner::image::image_of;

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

/// A brain at some age, and its image.
pub type Age = (Box<Brain>, Vec<u8>);

/// Some lives of the brain at different ages, with their images; each image is another.
///
/// # Errors
/// When the brain refuses, which it does not.
pub fn ages(number: usize) -> Result<Vec<Age>, Failure> {
    let mut brain = Box::new(robot::brain());
    robot::be_born(&mut brain, AgentConfig::FORAGER_LEVEL2, 3)?;
    let mut rng = Rng::new(7);
    let mut now = percept(&mut rng);
    let mut ages = Vec::new();
    for age in 0..number {
        for _ in 0..30 + 40 * age {
            let choice = brain.choose(&now)?;
            now = percept(&mut rng);
            let there = choice.action.0 == 1 && rng.chance(0.5);
            // What a set of four items holds.
            let _ = now.set(ItemId(3), Some(there));
            brain.learn(&now)?;
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
    image_of(brain, names()).unwrap_or_default()
}

/// What its items and actions are called.
#[must_use]
pub fn names() -> Names {
    robot::VOCABULARY.names()
}
