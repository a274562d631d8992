//! The lake's rivals.
//!
//! The one written by hand keeps away from holes: of the actions it takes the one that may end in
//! fewest of them, among equals the one that ends beside fewest, and then the one that comes closest
//! to the goal.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Tuned, linear, q, sarsa};
use crate::baseline::tabular::History;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::lake::{GOAL, HOLES, directions, neighbour};

/// The learners that did best here.
pub const TUNED: Tuned = Tuned {
    q: q(History::None, 0.1, 0.98, 0.5),
    q_history: q(History::TwoSteps, 0.3, 0.98, 0.5),
    sarsa: sarsa(History::None, 0.1, 0.98, 0.5, 0.5),
    sarsa_history: sarsa(History::TwoSteps, 0.3, 0.98, 0.5, 0.5),
    linear: linear(History::None, 0.1, 0.98, 0.5),
    linear_history: linear(History::TwoSteps, 0.1, 0.98, 0.5),
};

/// Keeps away from holes.
///
/// ```
/// use host_sim::{learner::controller::Controller, baseline::worlds::lake::Careful};
/// use host_sim::world::{World, lake::Lake};
/// // At the start all is safe; left keeps to the bank.
/// let action = Careful.choose(&Lake::new(1).sense(), &mut cla_core::num::Rng::new(1));
/// assert_eq!(action, 0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Careful;

/// Steps to the goal as the crow walks.
const fn distance(field: usize) -> usize {
    (GOAL / 4 - field / 4) + (GOAL % 4 - field % 4)
}

fn holes_beside(field: usize) -> usize {
    let beside = (0..4).map(|direction| neighbour(field, direction));
    beside.filter(|field| HOLES.contains(field)).count()
}

impl Controller for Careful {
    fn choose(&mut self, percept: &Percept, _: &mut Rng) -> usize {
        let here = (0..=GOAL).find(|&field| percept.get(ItemId(field as u16)) == Some(true));
        let cost = |action: &usize| {
            let to = directions(*action).map(|it| neighbour(here.unwrap_or(0), it));
            let falls = to.iter().filter(|field| HOLES.contains(field)).count();
            let sum = |of: fn(usize) -> usize| to.iter().fold(0, |sum, &field| sum + of(field));
            (falls, sum(holes_beside), sum(distance))
        };
        (0..4).min_by_key(cost).unwrap_or(0)
    }
}
