//! Worlds with items that have nothing to do with anything: they blink at random.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::names::{Names, kept};
use super::{Percept, WORLD_WORDS, World};

/// Any world with distractors after its own items, `blink0` and so on, each on in half of the
/// percepts.
///
/// ```
/// use host_sim::world::{World, distracted::Distracted, lake::Lake};
/// let world = Distracted::new(Lake::new(1), 20, 1);
/// assert_eq!(world.items().len(), 36);
/// assert_eq!(world.items()[16], "blink0");
/// ```
#[derive(Clone, Debug)]
pub struct Distracted<W> {
    world: W,
    items: Names,
    rng: Rng,
    percept: Percept,
}

impl<W: World> Distracted<W> {
    /// Adds so many distractors, or as many as fit a percept; `seed` decides when they are on.
    #[must_use]
    pub fn new(world: W, distractors: usize, seed: u64) -> Self {
        let own = world.items();
        let most = (32 * WORLD_WORDS).saturating_sub(own.len());
        let mut names: Vec<String> = own.iter().map(|&name| name.to_owned()).collect();
        names.extend((0..distractors.min(most)).map(|it| format!("blink{it}")));
        let mut it = Self {
            world,
            items: kept(&names),
            rng: Rng::stream(seed, 66),
            percept: Percept::UNKNOWN,
        };
        it.look();
        it
    }

    /// The world without its distractors.
    pub const fn world(&self) -> &W {
        &self.world
    }

    fn look(&mut self) {
        let mut percept = self.world.sense();
        for item in self.world.items().len()..self.items.len() {
            let on = self.rng.chance(0.5);
            let fits = percept.set(ItemId(item as u16), Some(on));
            debug_assert!(fits.is_ok(), "no more distractors than fit were added");
        }
        self.percept = percept;
    }
}

impl<W: World> World for Distracted<W> {
    around!(self => self.world; actions obtained finished earned episode_ended suffer);

    fn items(&self) -> &'static [&'static str] {
        self.items
    }

    fn sense(&self) -> Percept {
        self.percept
    }

    fn act(&mut self, action: usize) {
        self.world.act(action);
        self.look();
    }

    fn reflex(&mut self) -> Option<usize> {
        let fired = self.world.reflex();
        if fired.is_some() {
            self.look();
        }
        fired
    }

    fn begin_episode(&mut self) {
        self.world.begin_episode();
        self.look();
    }
}

#[cfg(test)]
mod tests {
    use super::Distracted;
    use crate::world::World;
    use crate::world::lake::Lake;
    use cla_core::word::ItemId;

    #[test]
    fn distractors_are_on_half_of_the_time_and_change_nothing_else() {
        let mut bare = Lake::new(4);
        let mut world = Distracted::new(Lake::new(4), 20, 4);
        let mut on = [0_u32; 20];
        for step in 0..10_000 {
            bare.act(step % 4);
            world.act(step % 4);
            let (real, shown) = (bare.sense(), world.sense());
            assert!((0..16).all(|it| real.get(ItemId(it)) == shown.get(ItemId(it))));
            for (item, on) in (16..).zip(&mut on) {
                *on += u32::from(shown.get(ItemId(item)) == Some(true));
            }
        }
        assert!(on.iter().all(|it| (4700..5300).contains(it)), "{on:?}");
        assert_eq!(bare.obtained(), world.obtained());
    }

    #[test]
    fn no_more_distractors_are_added_than_a_percept_holds() {
        let world = Distracted::new(Lake::new(1), 1000, 1);
        assert_eq!(world.items().len(), 128);
        assert!(world.sense().get(ItemId(127)).is_some());
    }
}
