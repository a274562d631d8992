//! Worlds that show less than there is: an item that stays unknown, readings that get lost.
//!
//! [`Veiled`] wraps any world; what happens there is the same, only the percept changes.
//! A reading that is lost is unknown, or it shows what was read last, or off: three ways in which a
//! driver may pass a silent sensor on.

use cla_core::num::Rng;
use cla_core::word::ItemId;
use serde::{Deserialize, Serialize};

use super::{Percept, World};

/// What is not shown.
///
/// ```
/// use host_sim::world::veil::{Lost, Veil};
/// let tenth = Veil::Share(0.1, Lost::Unknown);
/// assert_ne!(tenth, Veil::Share(0.1, Lost::Held));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Veil {
    /// Every reading of the item with this index.
    Item(u16, Lost),
    /// Each reading of each item with this probability, in `[0, 1]`.
    Share(f32, Lost),
}

/// What stands in place of a lost reading.
///
/// ```
/// use host_sim::world::veil::Lost;
/// assert_eq!(Lost::default(), Lost::Unknown);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Lost {
    /// Nothing: the item is unknown.
    #[default]
    Unknown,
    /// What was read last; off before the first reading.
    Held,
    /// Off.
    Off,
}

/// Any world behind a veil.
///
/// ```
/// use cla_core::word::ItemId;
/// use host_sim::world::{World, lake::Lake, veil::{Lost, Veil, Veiled}};
/// let veiled = Veiled::new(Lake::new(1), Veil::Item(0, Lost::Unknown), 1);
/// assert_eq!(veiled.sense().get(ItemId(0)), None);
/// assert_eq!(veiled.sense().get(ItemId(1)), Some(false));
/// ```
#[derive(Clone, Debug)]
pub struct Veiled<W> {
    world: W,
    veil: Veil,
    rng: Rng,
    percept: Percept,
}

impl<W: World> Veiled<W> {
    /// Hides a part of a world; `seed` decides which readings get lost.
    #[must_use]
    pub fn new(world: W, veil: Veil, seed: u64) -> Self {
        let mut it = Self {
            percept: Percept::all_off(world.items().len() as u16),
            world,
            veil,
            rng: Rng::stream(seed, 65),
        };
        it.look();
        it
    }

    /// The world behind the veil.
    pub const fn world(&self) -> &W {
        &self.world
    }

    fn look(&mut self) {
        let (real, last) = (self.world.sense(), self.percept);
        let mut shown = real;
        for item in (0..self.world.items().len() as u16).map(ItemId) {
            let lost = match self.veil {
                Veil::Item(hidden, lost) => (hidden == item.0).then_some(lost),
                Veil::Share(share, lost) => self.rng.chance(share).then_some(lost),
            };
            let state = match lost {
                None => continue,
                Some(Lost::Unknown) => None,
                Some(Lost::Held) => last.get(item),
                Some(Lost::Off) => Some(false),
            };
            let fits = shown.set(item, state);
            debug_assert!(fits.is_ok(), "a world's items fit its percept");
        }
        self.percept = shown;
    }
}

impl<W: World> World for Veiled<W> {
    around!(self => self.world; items actions obtained finished earned episode_ended suffer);

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
    use super::{Lost, Veil, Veiled};
    use crate::world::config::PioneerConfig;
    use crate::world::lake::Lake;
    use crate::world::microworld::{Body, Microworld};
    use crate::world::pioneer::Pioneer;
    use crate::world::vacuum::Vacuum;
    use crate::world::{Percept, World};
    use cla_core::word::ItemId;

    fn states(percept: &Percept, items: u16) -> Vec<Option<bool>> {
        (0..items).map(|it| percept.get(ItemId(it))).collect()
    }

    #[test]
    fn behind_a_veil_the_same_happens_and_a_share_of_the_readings_is_unknown() {
        let mut bare = Vacuum::new(1);
        let mut veiled = Veiled::new(Vacuum::new(1), Veil::Share(0.1, Lost::Unknown), 1);
        let mut unknown = 0;
        for step in 0..10_000 {
            let action = step * 7 % 5;
            bare.act(action);
            veiled.act(action);
            let (real, shown) = (states(&bare.sense(), 15), states(&veiled.sense(), 15));
            for (real, shown) in real.iter().zip(&shown) {
                assert!(shown.is_none() || shown == real);
                unknown += u32::from(shown.is_none());
            }
        }
        assert_eq!(bare.obtained(), veiled.obtained());
        assert!((14_500..15_500).contains(&unknown), "{unknown}");
    }

    #[test]
    fn a_lost_reading_that_is_held_is_what_was_read_last_and_never_unknown() {
        let mut bare = Vacuum::new(2);
        let mut veiled = Veiled::new(Vacuum::new(2), Veil::Share(0.5, Lost::Held), 2);
        let mut stale = 0;
        for step in 0..2000 {
            let before = states(&veiled.sense(), 15);
            bare.act(step * 7 % 5);
            veiled.act(step * 7 % 5);
            let (real, shown) = (states(&bare.sense(), 15), states(&veiled.sense(), 15));
            for item in 0..15 {
                assert!(shown[item] == real[item] || shown[item] == before[item]);
                stale += u32::from(shown[item] != real[item]);
            }
        }
        assert!(stale > 500, "{stale}");
    }

    #[test]
    fn one_item_can_stay_unknown_or_off_whatever_the_others_do() {
        let (mut hidden, mut seen) = (Vec::new(), 0);
        for lost in [Lost::Unknown, Lost::Off, Lost::Held] {
            let veil = Veil::Item(2, lost);
            let mut world = Veiled::new(Pioneer::new(PioneerConfig::NOISY, 1).unwrap(), veil, 1);
            for _ in 0..200 {
                world.act(2);
                while world.reflex().is_some() {}
                hidden.push(world.sense().get(ItemId(2)));
                seen += world.sense().on().len();
            }
            let all = hidden
                .iter()
                .all(|&it| it == (lost != Lost::Unknown).then_some(false));
            assert!(all, "{lost:?}");
            hidden.clear();
        }
        assert!(seen > 100);
    }

    #[test]
    fn each_of_the_microworlds_items_can_be_hidden_alone() {
        let count = Microworld::new(1, Body::Visible, 0.0).items().len() as u16;
        for item in 0..count {
            let bare = Microworld::new(1, Body::Visible, 0.0);
            let mut world = Veiled::new(bare, Veil::Item(item, Lost::Unknown), 1);
            world.act(3);
            let (real, shown) = (world.world().sense(), world.sense());
            assert_eq!(shown.known().len(), count - 1);
            let same = |it| it == item || real.get(ItemId(it)) == shown.get(ItemId(it));
            assert!((0..count).all(same));
        }
    }

    #[test]
    fn a_new_episode_is_looked_at() {
        let mut world = Veiled::new(Lake::new(1), Veil::Item(3, Lost::Unknown), 1);
        while !world.episode_ended() {
            world.act(1);
        }
        assert_eq!(world.sense().get(ItemId(0)), Some(false));
        world.begin_episode();
        assert_eq!(world.sense().get(ItemId(0)), Some(true));
    }
}
