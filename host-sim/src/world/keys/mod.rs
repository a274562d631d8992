//! Keys and doors: three rooms in a row, two locked doors, a prize in the last; 48 items, of which 29
//! have nothing to do with it.
//!
//! The red key lies in the first room and opens the door to the second, where the blue key lies,
//! which opens the door to the third.
//! A try begins anywhere in the first room and ends with the prize or after 200 actions.
//! Lamps blink at random, machines go on and off now and then.
//! What has to be done takes at least [`LEAST`] actions; the shortest way of every try is known.

mod plan;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Percept, World};
pub use plan::{COLUMNS, LEAST, Layout, ROWS, Situation};
use seeker::Item;

cla_core::brain! {
    /// What the one who seeks the prize senses and does.
    pub mod seeker {
        items: [
            col0, col1, col2, col3, col4, col5, row0, row1, row2,
            red_here, blue_here, red_door, blue_door, prize_here,
            has_red, has_blue, red_open, blue_open, prize,
            lamp0, lamp1, lamp2, lamp3, lamp4, lamp5, lamp6, lamp7,
            lamp8, lamp9, lamp10, lamp11, lamp12, lamp13, lamp14,
            machine0, machine1, machine2, machine3, machine4, machine5, machine6,
            machine7, machine8, machine9, machine10, machine11, machine12, machine13,
        ],
        actions: [north, east, south, west, take, open],
        values: [prize = 10.0],
        maps: 20 x 20,
        patterns: 512,
        schemas: 2048,
        synthetic: 384,
        beliefs: 3072,
        ram: 1_109_000,
    }
}

/// Actions of the longest try.
pub const STEPS: u32 = 200;

/// The first item that has nothing to do with the prize.
const FIRST_IDLE: usize = Item::lamp0 as usize;

/// The share of steps in which a machine goes on or off.
const SWITCHES: f32 = 0.05;

/// The rooms and who seeks in them.
///
/// ```
/// use host_sim::world::{World, keys::{Keys, LEAST}};
/// let world = Keys::new(1);
/// assert_eq!(world.items().len(), 48);
/// assert!(world.shortest() >= LEAST);
/// ```
#[derive(Clone, Debug)]
pub struct Keys {
    layout: Layout,
    now: Situation,
    steps: u32,
    shortest: u32,
    has_prize: bool,
    prizes: u32,
    tries: u32,
    efficiency: f64,
    rng: Rng,
    idle: Vec<bool>,
    percept: Percept,
}

impl Keys {
    /// Rooms whose keys, doors and prize `seed` decides, and where each try begins.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut rng = Rng::stream(seed, 69);
        let layout = Layout::random(&mut rng);
        let idle = (FIRST_IDLE..seeker::ITEMS.len()).map(|_| rng.chance(0.5));
        let mut it = Self {
            idle: idle.collect(),
            now: Situation::START,
            layout,
            steps: 0,
            shortest: 0,
            has_prize: false,
            prizes: 0,
            tries: 0,
            efficiency: 0.0,
            rng,
            percept: Percept::UNKNOWN,
        };
        it.begin_episode();
        it
    }

    /// Where everything is.
    #[must_use]
    pub const fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Where the seeker is, what it has and which doors are open.
    #[must_use]
    pub const fn situation(&self) -> Situation {
        self.now
    }

    /// Actions of the shortest way from where this try began.
    #[must_use]
    pub const fn shortest(&self) -> u32 {
        self.shortest
    }

    /// Tries that have ended.
    #[must_use]
    pub const fn tries(&self) -> u32 {
        self.tries
    }

    /// Of all tries that have ended, the sum of shortest way / actions, 0 for those without a prize:
    /// divided by [`tries`](Self::tries), 1 is the best.
    #[must_use]
    pub const fn efficiency(&self) -> f64 {
        self.efficiency
    }

    /// The first action of a shortest way, for who knows everything.
    #[must_use]
    pub fn planned(&self) -> usize {
        self.layout.planned(self.now)
    }

    fn look(&mut self) {
        let mut on = [false; seeker::ITEMS.len()];
        let (row, column) = (self.now.cell / COLUMNS, self.now.cell % COLUMNS);
        on[column] = true;
        on[Item::row0 as usize + row] = true;
        let mut set = |item: Item, state: bool| on[item as usize] = state;
        let cell = self.now.cell;
        set(Item::red_here, self.layout.red == cell && !self.now.has_red);
        set(
            Item::blue_here,
            self.layout.blue == cell && !self.now.has_blue,
        );
        set(
            Item::red_door,
            self.layout.at_red_door(cell) && !self.now.red_open,
        );
        set(
            Item::blue_door,
            self.layout.at_blue_door(cell) && !self.now.blue_open,
        );
        set(
            Item::prize_here,
            self.layout.prize == cell && !self.has_prize,
        );
        set(Item::has_red, self.now.has_red);
        set(Item::has_blue, self.now.has_blue);
        set(Item::red_open, self.now.red_open);
        set(Item::blue_open, self.now.blue_open);
        set(Item::prize, self.has_prize);
        for (index, idle) in self.idle.iter_mut().enumerate() {
            let lamp = FIRST_IDLE + index < Item::machine0 as usize;
            *idle ^= self.rng.chance(if lamp { 0.5 } else { SWITCHES });
            on[FIRST_IDLE + index] = *idle;
        }
        let mut percept = Percept::all_off(seeker::ITEMS.len() as u16);
        for (index, on) in on.into_iter().enumerate() {
            let fits = percept.set(ItemId(index as u16), Some(on));
            debug_assert!(fits.is_ok(), "48 items fit a percept");
        }
        self.percept = percept;
    }
}

impl World for Keys {
    fn items(&self) -> &'static [&'static str] {
        seeker::VOCABULARY.items
    }

    fn actions(&self) -> &'static [&'static str] {
        seeker::VOCABULARY.actions
    }

    fn sense(&self) -> Percept {
        self.percept
    }

    fn act(&mut self, action: usize) {
        if self.episode_ended() {
            self.begin_episode();
        }
        self.steps += 1;
        if self.layout.takes_prize(self.now, action) {
            self.has_prize = true;
            self.prizes += 1;
            self.efficiency += f64::from(self.shortest) / f64::from(self.steps);
        } else {
            self.now = self.layout.after(self.now, action);
        }
        self.tries += u32::from(self.episode_ended());
        self.look();
    }

    fn reflex(&mut self) -> Option<usize> {
        None
    }

    /// Prizes taken.
    fn obtained(&self) -> u32 {
        self.prizes
    }

    fn finished(&self) -> bool {
        false
    }

    fn episode_ended(&self) -> bool {
        self.has_prize || self.steps >= STEPS
    }

    fn begin_episode(&mut self) {
        self.now = Situation::START;
        let (row, column) = (self.rng.below(ROWS as u32), self.rng.below(2));
        self.now.cell = row as usize * COLUMNS + column as usize;
        (self.steps, self.has_prize) = (0, false);
        self.shortest = self.layout.distance(self.now);
        self.look();
    }
}

#[cfg(test)]
#[path = "keys_tests.rs"]
mod tests;
