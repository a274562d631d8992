//! The vacuum cleaner's rivals.
//!
//! The one written by hand cleans what it stands on, goes for dirt that it sees, wanders where it
//! sees none, and follows the beacon to the dock when the battery is low.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Tuned, linear, q, sarsa};
use crate::baseline::tabular::History;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::vacuum::cleaner::{Action, Item};

/// The learners that did best here.
pub const TUNED: Tuned = Tuned {
    q: q(History::None, 0.3, 0.9, 0.5),
    q_history: q(History::TwoSteps, 0.03, 0.8, 0.0),
    sarsa: sarsa(History::None, 0.3, 0.8, 0.5, 0.5),
    sarsa_history: sarsa(History::TwoSteps, 0.1, 0.98, 0.5, 0.5),
    linear: linear(History::None, 0.3, 0.9, 0.5),
    linear_history: linear(History::TwoSteps, 0.1, 0.8, 0.5),
};

/// Charging actions that fill a battery.
const FILLS: u32 = 4;

/// Readings of a low battery in a row that are believed: one may be an error.
const BELIEVED: u32 = 2;

/// Cleans, wanders, charges.
///
/// ```
/// use host_sim::baseline::worlds::vacuum::Sweeper;
/// assert!(!Sweeper::default().goes_home());
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Sweeper {
    low: u32,
    charges: Option<u32>,
    last: Option<usize>,
}

impl Sweeper {
    /// Whether it is on its way to the dock.
    #[must_use]
    pub const fn goes_home(&self) -> bool {
        self.charges.is_some()
    }

    fn decide(&mut self, on: impl Fn(Item) -> bool, rng: &mut Rng) -> Action {
        self.low = if on(Item::battery_low) {
            self.low + 1
        } else {
            0
        };
        if self.low >= BELIEVED && self.charges.is_none() {
            self.charges = Some(0);
        }
        let sucked = self.last == Some(Action::suck as usize);
        // Dirt that has just been sucked and was not cleaned was an error.
        if on(Item::dirt_here) && (!sucked || on(Item::cleaned)) {
            return Action::suck;
        }
        if let Some(charges) = self.charges {
            if on(Item::charging) {
                self.charges = (charges + 1 < FILLS).then_some(charges + 1);
            }
            if self.charges.is_some() {
                return Self::home(on);
            }
        }
        // The opposite turn would only undo the last.
        let may =
            |turn: Action, undone: Action| (self.last != Some(undone as usize)).then_some(turn);
        let towards = |item: Item, turn, undone| {
            let seen = on(item);
            seen.then(|| may(turn, undone)).flatten()
        };
        if on(Item::dirt_ahead) && !on(Item::wall_ahead) {
            return Action::forward;
        }
        let left = towards(Item::dirt_left, Action::turnl, Action::turnr);
        let right = towards(Item::dirt_right, Action::turnr, Action::turnl);
        if let Some(turn) = left.or(right) {
            return turn;
        }
        if !on(Item::wall_ahead) && !on(Item::bump) && !rng.chance(0.1) {
            return Action::forward;
        }
        match (on(Item::wall_left), on(Item::wall_right)) {
            (true, false) => Action::turnr,
            (false, true) => Action::turnl,
            _ if self.last == Some(Action::turnr as usize) => Action::turnr,
            _ if self.last == Some(Action::turnl as usize) => Action::turnl,
            _ if rng.chance(0.5) => Action::turnl,
            _ => Action::turnr,
        }
    }

    /// One step along the beacon.
    fn home(on: impl Fn(Item) -> bool) -> Action {
        if on(Item::dock_here) {
            Action::charge
        } else if on(Item::dock_ahead) && !on(Item::wall_ahead) {
            Action::forward
        } else if on(Item::dock_right) {
            Action::turnr
        } else {
            Action::turnl
        }
    }
}

impl Controller for Sweeper {
    fn choose(&mut self, percept: &Percept, rng: &mut Rng) -> usize {
        let on = |item: Item| percept.get(ItemId(item as u16)) == Some(true);
        let action = self.decide(on, rng) as usize;
        self.last = Some(action);
        action
    }
}
