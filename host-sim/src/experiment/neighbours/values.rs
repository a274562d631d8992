//! Values of nodes and actions, learned by Sarsa(0), which neighbours on the map may share.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::places::{NODES, Places};
use super::room::{ACTIONS, Place, anywhere, apart, stepped};
use crate::failure::Failure;

/// The discount of a step.
const DISCOUNT: f32 = 0.95;
/// How often an action is tried by chance.
const CHANCE: f32 = 0.1;
/// A goal is reached within this many metres.
pub(super) const REACHED: f32 = 0.8;
/// Steps of an episode at most.
const LIMIT: u32 = 200;
/// An episode begins at least this far from the goal.
const FAR: f32 = 3.0;

/// How a robot learns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Learning {
    /// The learning rate.
    pub rate: f32,
    /// What share of an update each neighbour takes; 0 without neighbours.
    pub shared: f32,
}

/// Values of a goal.
pub(super) struct Values<'a> {
    places: &'a Places,
    learning: Learning,
    goal: Place,
    of: Vec<[f32; ACTIONS]>,
    chance: Rng,
}

impl<'a> Values<'a> {
    /// No values yet.
    pub(super) fn new(places: &'a Places, learning: Learning, goal: Place, chance: Rng) -> Self {
        Self {
            places,
            learning,
            goal,
            of: vec![[0.0; ACTIONS]; NODES],
            chance,
        }
    }

    fn choose(&mut self, node: usize) -> usize {
        let values = self.of[node];
        let most = values.into_iter().fold(f32::NEG_INFINITY, f32::max);
        if self.chance.chance(CHANCE) {
            return self.chance.below(ACTIONS as u32) as usize;
        }
        let best: Vec<usize> = (0..ACTIONS).filter(|&it| values[it] >= most).collect();
        best[self.chance.below(best.len() as u32) as usize]
    }

    fn update(&mut self, node: usize, action: usize, to: f32) {
        let change = self.learning.rate * (to - self.of[node][action]);
        self.of[node][action] += change;
        if self.learning.shared > 0.0 {
            for neighbour in Places::neighbours(node) {
                let old = self.of[neighbour][action];
                let change = self.learning.rate * (to - old);
                self.of[neighbour][action] = old + self.learning.shared * change;
            }
        }
    }

    /// Steps to the goal from a place by chance; so many as there may be when it is not reached.
    pub(super) fn episode(&mut self, swapped: bool) -> Result<u32, Failure> {
        let mut place = loop {
            let place = anywhere(&mut self.chance);
            if apart(place, self.goal) >= FAR {
                break place;
            }
        };
        let mut node = self.places.node(place)?;
        let mut action = self.choose(node);
        for step in 1..=LIMIT {
            place = stepped(place, action, swapped, &mut self.chance);
            if apart(place, self.goal) < REACHED {
                self.update(node, action, 1.0);
                return Ok(step);
            }
            let next = self.places.node(place)?;
            let then = self.choose(next);
            let worth = DISCOUNT * self.of[next][then];
            self.update(node, action, worth);
            (node, action) = (next, then);
        }
        Ok(LIMIT)
    }

    /// The mean steps of so many episodes.
    pub(super) fn mean_steps(&mut self, episodes: u32, swapped: bool) -> Result<f64, Failure> {
        let mut sum = 0.0;
        for _ in 0..episodes {
            sum += f64::from(self.episode(swapped)?);
        }
        Ok(sum / f64::from(episodes))
    }
}
