//! A room to keep clean: dirt that comes back elsewhere, obstacles, a dock, a battery.
//!
//! The robot stands on one field of a 7 × 7 grid and looks in one of four directions.
//! It sees dirt on its field and along a line ahead, to the left and to the right as far as an
//! obstacle, obstacles next to it, and where the way to the dock goes on; every sensor errs in 2 % of
//! its readings.
//! Without power it is carried to the dock, which takes 30 actions.
//! What it cannot see, the whole room, is what [`planner`] knows.

pub mod planner;
mod room;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Percept, World};
use cleaner::Item;
pub use room::{FIELDS, Pose, Room, SIDE};

cla_core::brain! {
    /// What a vacuum cleaner senses, does and is for.
    pub mod cleaner {
        items: [
            dirt_here, dirt_ahead, dirt_left, dirt_right,
            wall_ahead, wall_left, wall_right, bump,
            dock_here, dock_ahead, dock_left, dock_right,
            battery_low, charging, cleaned,
        ],
        actions: [forward, turnl, turnr, suck, charge],
        values: [cleaned = 10.0],
        maps: 20 x 20,
        patterns: 512,
        schemas: 2048,
        synthetic: 384,
        beliefs: 3072,
        ram: 411_000,
    }
}

/// Pieces of dirt in the room at any time.
pub const DIRT: usize = 8;

/// Actions that a full battery lasts.
pub const FULL: u32 = 100;

/// Actions left below which the battery counts as low.
pub const LOW: u32 = 30;

/// What one action of charging adds.
pub const CHARGE: u32 = 25;

/// Actions that it takes to be carried to the dock.
pub const CARRIED: u32 = 30;

/// The share of readings in which a sensor errs.
pub const NOISE: f32 = 0.02;

/// Sensors that err: all but what the robot knows of itself, that it charges and has cleaned.
const ERRING: usize = Item::charging as usize;

/// The room and the robot in it.
///
/// ```
/// use host_sim::world::{World, vacuum::Vacuum};
/// let mut world = Vacuum::new(1);
/// for _ in 0..1000 {
///     world.act(0); // into a wall, until the battery is empty
/// }
/// assert_eq!(world.obtained(), 0);
/// assert!(world.times_carried() >= 7);
/// ```
#[derive(Clone, Debug)]
pub struct Vacuum {
    room: Room,
    pose: Pose,
    dirt: [bool; FIELDS],
    battery: u32,
    carried: u32,
    times_carried: u32,
    cleaned: u32,
    bump: bool,
    charging: bool,
    just_cleaned: bool,
    rng: Rng,
    percept: Percept,
}

impl Vacuum {
    /// A room whose obstacles, dirt and noise `seed` decides; the robot begins at the dock, full.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut rng = Rng::stream(seed, 64);
        let room = Room::random(&mut rng);
        let mut world = Self {
            pose: Pose {
                field: room.dock(),
                heading: 0,
            },
            room,
            dirt: [false; FIELDS],
            battery: FULL,
            carried: 0,
            times_carried: 0,
            cleaned: 0,
            bump: false,
            charging: false,
            just_cleaned: false,
            rng,
            percept: Percept::UNKNOWN,
        };
        for _ in 0..DIRT {
            world.soil();
        }
        world.look();
        world
    }

    /// The room.
    #[must_use]
    pub const fn room(&self) -> &Room {
        &self.room
    }

    /// Where the robot stands and looks.
    #[must_use]
    pub const fn pose(&self) -> Pose {
        self.pose
    }

    /// Whether there is dirt on a field.
    #[must_use]
    pub fn is_dirty(&self, field: usize) -> bool {
        self.dirt.get(field).is_some_and(|&it| it)
    }

    /// Actions that are left in the battery.
    #[must_use]
    pub const fn battery(&self) -> u32 {
        self.battery
    }

    /// How often it had to be carried to the dock.
    #[must_use]
    pub const fn times_carried(&self) -> u32 {
        self.times_carried
    }

    /// A piece of dirt falls on a clean field where the robot is not.
    fn soil(&mut self) {
        let free: Vec<usize> = (0..FIELDS)
            .filter(|&it| self.room.is_free(it) && !self.dirt[it] && it != self.pose.field)
            .collect();
        let which = self.rng.below(free.len() as u32) as usize;
        if let Some(&field) = free.get(which) {
            self.dirt[field] = true;
        }
    }

    /// What is really there, item by item.
    fn truth(&self) -> [bool; cleaner::ITEMS.len()] {
        let mut on = [false; cleaner::ITEMS.len()];
        let mut set = |item: Item, state: bool| on[item as usize] = state;
        set(Item::battery_low, self.battery < LOW);
        set(Item::charging, self.charging);
        set(Item::cleaned, self.just_cleaned);
        if self.carried > 0 {
            return on;
        }
        let sees = |side: usize| {
            self.room
                .line(self.pose.turned(side))
                .any(|it| self.dirt[it])
        };
        let wall = |side: usize| self.room.ahead(self.pose.turned(side)).is_none();
        let nearer = |side: usize| {
            let next = self.room.ahead(self.pose.turned(side));
            let here = self.room.to_dock(self.pose.field);
            next.is_some_and(|it| self.room.to_dock(it) < here)
        };
        let mut set = |item: Item, state: bool| on[item as usize] = state;
        set(Item::dirt_here, self.dirt[self.pose.field]);
        set(Item::dirt_ahead, sees(0));
        set(Item::dirt_left, sees(3));
        set(Item::dirt_right, sees(1));
        set(Item::wall_ahead, wall(0));
        set(Item::wall_left, wall(3));
        set(Item::wall_right, wall(1));
        set(Item::bump, self.bump);
        set(Item::dock_here, self.pose.field == self.room.dock());
        set(Item::dock_ahead, nearer(0));
        set(Item::dock_left, nearer(3));
        set(Item::dock_right, nearer(1));
        on
    }

    fn look(&mut self) {
        let mut percept = Percept::all_off(cleaner::ITEMS.len() as u16);
        for (index, on) in self.truth().into_iter().enumerate() {
            let errs = index < ERRING && self.rng.chance(NOISE);
            let fits = percept.set(ItemId(index as u16), Some(on != errs));
            debug_assert!(fits.is_ok(), "fifteen items fit a percept");
        }
        self.percept = percept;
    }

    fn go(&mut self, action: usize) {
        self.battery -= 1;
        match action {
            0 => match self.room.ahead(self.pose) {
                Some(field) => self.pose.field = field,
                None => self.bump = true,
            },
            1 => self.pose = self.pose.turned(3),
            2 => self.pose = self.pose.turned(1),
            3 if self.dirt[self.pose.field] => {
                self.dirt[self.pose.field] = false;
                self.just_cleaned = true;
                self.cleaned += 1;
                self.soil();
            }
            4 if self.pose.field == self.room.dock() => {
                self.charging = true;
                self.battery = FULL.min(self.battery + CHARGE);
            }
            _ => {}
        }
        if self.battery == 0 {
            self.carried = CARRIED;
            self.times_carried += 1;
        }
    }
}

impl World for Vacuum {
    fn items(&self) -> &'static [&'static str] {
        cleaner::VOCABULARY.items
    }

    fn actions(&self) -> &'static [&'static str] {
        cleaner::VOCABULARY.actions
    }

    fn sense(&self) -> Percept {
        self.percept
    }

    fn act(&mut self, action: usize) {
        (self.bump, self.charging, self.just_cleaned) = (false, false, false);
        if self.carried > 0 {
            self.carried -= 1;
            if self.carried == 0 {
                self.pose.field = self.room.dock();
                self.battery = FULL;
            }
        } else {
            self.go(action);
        }
        self.look();
    }

    fn reflex(&mut self) -> Option<usize> {
        None
    }

    /// Pieces of dirt cleaned.
    fn obtained(&self) -> u32 {
        self.cleaned
    }

    fn finished(&self) -> bool {
        false
    }
}

#[cfg(test)]
#[path = "vacuum_tests.rs"]
mod tests;
