//! A learner with more actions than its world has: the others do again what the first ones do.

use super::{Learner, Thought};
use crate::failure::Failure;
use crate::world::Percept;

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

    within!(self => self.learner;
        learn learn_with interrupt observe act cost hear reliabilities predictions alarms worth image
        go_on_from);

    fn reason(&self) -> Thought {
        Thought {
            action: self.learner.reason().action % self.actions,
            ..self.learner.reason()
        }
    }
}
