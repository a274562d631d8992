//! The rivals of the one who seeks the prize.
//!
//! The one written by hand knows that there are three rooms of two columns, but not where anything
//! lies: it looks into every cell of a room until it has seen what it needs there, and remembers it
//! for all tries that follow.

use std::collections::VecDeque;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Tuned, linear, q, sarsa};
use crate::baseline::tabular::History;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::keys::seeker::{Action, Item};
use crate::world::keys::{COLUMNS, ROWS};

/// The learners that did best here; no percept comes twice, so all tables are equally empty.
pub const TUNED: Tuned = Tuned {
    q: q(History::None, 0.03, 0.8, 0.0),
    q_history: q(History::TwoSteps, 0.03, 0.8, 0.0),
    sarsa: sarsa(History::None, 0.03, 0.8, 0.5, 0.0),
    sarsa_history: sarsa(History::TwoSteps, 0.03, 0.8, 0.5, 0.0),
    linear: linear(History::None, 0.6, 0.98, 0.5),
    linear_history: linear(History::TwoSteps, 0.6, 0.98, 0.5),
};

const CELLS: usize = COLUMNS * ROWS;

/// Searches room by room, and remembers.
///
/// ```
/// use host_sim::{learner::controller::Controller, baseline::worlds::keys::Searcher};
/// use host_sim::world::{World, keys::Keys};
/// let (mut world, mut rng) = (Keys::new(1), cla_core::num::Rng::new(1));
/// let mut searcher = Searcher::default();
/// while !world.episode_ended() {
///     world.act(searcher.choose(&world.sense(), &mut rng));
/// }
/// assert_eq!(world.earned(), 1.0);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Searcher {
    visited: [bool; CELLS],
    red: Option<usize>,
    blue: Option<usize>,
    red_door: Option<usize>,
    blue_door: Option<usize>,
    prize: Option<usize>,
}

impl Searcher {
    fn look(&mut self, cell: usize, on: &impl Fn(Item) -> bool) {
        self.visited[cell] = true;
        for (item, place) in [
            (Item::red_here, &mut self.red),
            (Item::blue_here, &mut self.blue),
            (Item::red_door, &mut self.red_door),
            (Item::blue_door, &mut self.blue_door),
            (Item::prize_here, &mut self.prize),
        ] {
            if on(item) {
                *place = Some(cell);
            }
        }
    }

    /// Whether it can walk east from here, as far as it knows.
    fn passes(&self, cell: usize, on: &impl Fn(Item) -> bool) -> bool {
        match cell % COLUMNS {
            1 => on(Item::red_open) && self.red_door == Some(cell),
            3 => on(Item::blue_open) && self.blue_door == Some(cell),
            column => column + 1 < COLUMNS,
        }
    }

    /// The first step of a shortest way to a cell that is wanted.
    fn towards(
        &self,
        from: usize,
        wanted: impl Fn(usize) -> bool,
        on: &impl Fn(Item) -> bool,
    ) -> Option<Action> {
        let mut first = [None; CELLS];
        let mut queue = VecDeque::from([from]);
        while let Some(cell) = queue.pop_front() {
            if cell != from && wanted(cell) {
                return first[cell];
            }
            let (row, column) = (cell / COLUMNS, cell % COLUMNS);
            let east = self.passes(cell, on).then(|| cell + 1);
            let west = (column > 0 && self.passes(cell - 1, on)).then(|| cell - 1);
            let north = (row > 0).then(|| cell - COLUMNS);
            let south = (row + 1 < ROWS).then(|| cell + COLUMNS);
            for (next, action) in [
                (north, Action::north),
                (east, Action::east),
                (south, Action::south),
                (west, Action::west),
            ] {
                if let Some(next) = next.filter(|&it| it != from && first[it].is_none()) {
                    first[next] = first[cell].or(Some(action));
                    queue.push_back(next);
                }
            }
        }
        None
    }
}

impl Controller for Searcher {
    fn choose(&mut self, percept: &Percept, rng: &mut Rng) -> usize {
        let on = |item: Item| percept.get(ItemId(item as u16)) == Some(true);
        let which = |first: Item, count: u16| {
            let items = first as u16..first as u16 + count;
            items
                .clone()
                .position(|it| percept.get(ItemId(it)) == Some(true))
        };
        let column = which(Item::col0, COLUMNS as u16).unwrap_or(0);
        let row = which(Item::row0, ROWS as u16).unwrap_or(0);
        let cell = row * COLUMNS + column;
        self.look(cell, &on);
        let (room, target, then) = if !on(Item::has_red) {
            (0, self.red, Action::take)
        } else if !on(Item::red_open) {
            (0, self.red_door, Action::open)
        } else if !on(Item::has_blue) {
            (1, self.blue, Action::take)
        } else if !on(Item::blue_open) {
            (1, self.blue_door, Action::open)
        } else {
            (2, self.prize, Action::take)
        };
        let step = match target {
            Some(target) if target == cell => Some(then),
            Some(target) => self.towards(cell, |it| it == target, &on),
            None => {
                let unseen = |it: usize| it % COLUMNS / 2 == room && !self.visited[it];
                self.towards(cell, unseen, &on)
            }
        };
        step.map_or_else(|| rng.below(4) as usize, |action| action as usize)
    }
}
