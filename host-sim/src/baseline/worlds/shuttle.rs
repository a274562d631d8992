//! The shuttle's rivals.
//!
//! The one written by hand drives until a station is near, turns its back to it, and backs up until
//! it has docked.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::{Tuned, linear, q, sarsa};
use crate::baseline::tabular::History;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::pomdp::shuttle::{Action, Item};

/// The learners that did best here.
pub const TUNED: Tuned = Tuned {
    q: q(History::None, 0.3, 0.98, 0.0),
    q_history: q(History::TwoSteps, 0.1, 0.8, 5.0),
    sarsa: sarsa(History::None, 0.03, 0.9, 0.9, 5.0),
    sarsa_history: sarsa(History::TwoSteps, 0.03, 0.8, 0.5, 5.0),
    linear: linear(History::None, 0.03, 0.98, 0.9),
    linear_history: linear(History::TwoSteps, 0.3, 0.98, 0.5),
};

/// Drives, turns round, backs up.
///
/// ```
/// use host_sim::baseline::worlds::shuttle::Docker;
/// assert!(!Docker::default().backs_up());
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Docker {
    backing: bool,
}

impl Docker {
    /// Whether it has turned its back to a station.
    #[must_use]
    pub const fn backs_up(&self) -> bool {
        self.backing
    }
}

impl Controller for Docker {
    fn choose(&mut self, percept: &Percept, _: &mut Rng) -> usize {
        let on = |item: Item| percept.get(ItemId(item as u16)) == Some(true);
        if on(Item::docked_LRV) || on(Item::docked_MRV) {
            self.backing = false;
        }
        if self.backing {
            return Action::Backup as usize;
        }
        // The station that was visited last is no goal: away from it.
        if on(Item::LRV) {
            self.backing = true;
        }
        if on(Item::LRV) || on(Item::MRV) {
            Action::TurnAround as usize
        } else {
            Action::GoForward as usize
        }
    }
}
