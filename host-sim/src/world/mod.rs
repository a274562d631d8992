//! Worlds that a brain can live in.

#[macro_use]
mod within;

pub mod arena;
pub mod barriers;
pub mod body;
pub mod camera;
pub mod config;
pub mod damage;
pub mod distracted;
pub mod fault;
pub mod generated;
pub mod geometry;
pub mod keys;
pub mod lake;
pub mod launching;
pub mod layout;
pub mod microworld;
pub mod names;
pub mod pioneer;
pub mod pomdp;
pub mod setting;
pub mod solve;
pub mod sought;
pub mod vacuum;
pub mod veil;

use cla_core::num::Rng;
use cla_core::word::ItemStates;

use fault::{Fault, Unbreakable};

/// Words of the item sets that worlds report in: up to 128 primitive items.
pub const WORLD_WORDS: usize = 4;

/// What the robot's sensors report at one moment.
pub type Percept = ItemStates<WORLD_WORDS>;

/// A body in a surrounding: primitive items to sense, primitive actions to do.
///
/// A world is deterministic: the same seed and the same actions give the same percepts.
pub trait World {
    /// The names of the primitive items, in the order of their ids.
    fn items(&self) -> &'static [&'static str];

    /// The names of the primitive actions, in the order of their ids.
    fn actions(&self) -> &'static [&'static str];

    /// What the sensors report now; the same until the next action or reflex.
    fn sense(&self) -> Percept;

    /// Does one primitive action, given by its index in [`actions`](Self::actions), to its end.
    fn act(&mut self, action: usize);

    /// If a built-in reflex fires on the present percept, runs it; the index of the action that it
    /// ended as, `None` when none fired.
    ///
    /// Who lives here is shown a reflex as if it had done that action, but it is not counted as one.
    /// A body has no reflexes unless it says so.
    fn reflex(&mut self) -> Option<usize> {
        None
    }

    /// What has been obtained so far, in pieces: specimens, or whatever this world rewards.
    fn obtained(&self) -> u32;

    /// Whether nothing is left to do: the world has ended. One goes on for ever unless it says so.
    fn finished(&self) -> bool {
        false
    }

    /// All that has been earned so far, rewards less costs; without signed rewards, what was obtained.
    ///
    /// The reward of an action is what this has grown by.
    fn earned(&self) -> f64 {
        f64::from(self.obtained())
    }

    /// Whether the last action ended an episode: what is sensed now is its end, and what comes after
    /// [`begin_episode`](Self::begin_episode) does not follow from it.
    ///
    /// Never in worlds that are one long episode.
    fn episode_ended(&self) -> bool {
        false
    }

    /// Begins the next episode, which an action in an ended one does by itself, too.
    fn begin_episode(&mut self) {}

    /// Something in the body breaks, and stays broken.
    ///
    /// # Errors
    /// [`Unbreakable`] when the world has no such part, which is the answer of worlds without a
    /// body, or when it cannot break so; nothing has changed.
    fn suffer(&mut self, _: &Fault) -> Result<(), Unbreakable> {
        Err(Unbreakable::no_such_part())
    }
}

/// A world of which only the program knows which it is.
impl<W: World + ?Sized> World for Box<W> {
    around!(self => **self;
        items actions sense act reflex obtained finished earned episode_ended begin_episode suffer);
}

/// Puts things in an order by chance, every order as likely as any other (Fisher and Yates).
pub(crate) fn shuffle<T>(things: &mut [T], rng: &mut Rng) {
    for last in (1..things.len()).rev() {
        things.swap(last, rng.below(last as u32 + 1) as usize);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn every_order_comes_as_often_as_any_other() {
        let mut rng = Rng::new(1);
        let mut orders: BTreeMap<[u8; 3], u32> = BTreeMap::new();
        for _ in 0..6_000 {
            let mut things = [1, 2, 3];
            shuffle(&mut things, &mut rng);
            *orders.entry(things).or_default() += 1;
        }
        assert_eq!(orders.len(), 6);
        // Four standard errors of 1000.
        assert!(
            orders.values().all(|it| (885..=1_115).contains(it)),
            "{orders:?}"
        );
        let mut none: [u8; 0] = [];
        shuffle(&mut none, &mut rng);
    }
}
