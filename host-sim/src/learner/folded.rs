//! A learner with more actions than its world has: the others do again what the first ones do.

use cla_core::word::Cost;

use super::{Learner, Thought};
use crate::failure::Failure;
use crate::world::Percept;
use crate::world::damage::Damage;

/// Any learner, in a world of so many actions.
///
/// ```
/// use host_sim::baseline::random::Random;
/// use host_sim::learner::{Learner, controller::Untaught, folded::Folded};
/// use host_sim::world::Percept;
/// let wild = Untaught::new(Random { actions: 12 }, 1);
/// let mut tame = Folded::new(wild, 3);
/// assert!((0..50).all(|_| tame.choose(&Percept::UNKNOWN).is_ok_and(|it| it < 3)));
/// ```
#[derive(Clone, Debug)]
pub struct Folded<L> {
    learner: L,
    actions: usize,
}

impl<L> Folded<L> {
    /// Folds the actions of a learner into the first ones, of which there is at least one.
    #[must_use]
    pub fn new(learner: L, actions: usize) -> Self {
        Self {
            learner,
            actions: actions.max(1),
        }
    }
}

impl<L: Learner> Learner for Folded<L> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        Ok(self.learner.choose(now)? % self.actions)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.learner.learn(now)
    }

    fn learn_with(&mut self, now: &Percept, reward: f32) -> Result<(), Failure> {
        self.learner.learn_with(now, reward)
    }

    fn interrupt(&mut self) -> Result<(), Failure> {
        self.learner.interrupt()
    }

    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure> {
        self.learner.observe(before, action, after)
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.learner.act()
    }

    fn cost(&self) -> Option<Cost> {
        self.learner.cost()
    }

    fn hear(&mut self, damage: &Damage) {
        self.learner.hear(damage);
    }

    fn reliabilities(&self) -> Vec<f64> {
        self.learner.reliabilities()
    }

    fn predictions(&self) -> (u32, u32) {
        self.learner.predictions()
    }

    fn alarms(&self) -> u32 {
        self.learner.alarms()
    }

    fn reason(&self) -> Thought {
        Thought {
            action: self.learner.reason().action % self.actions,
            ..self.learner.reason()
        }
    }
}
