//! A life in the world of a file, and what Chrisman's shuttle sees of its own.

use std::sync::Arc;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::model::{Pomdp, draw};
use crate::world::{Percept, World};

cla_core::brain! {
    /// What Chrisman's shuttle sees and does, in the order of its file.
    pub mod shuttle {
        items: [LRV, MRV, docked_MRV, Nothing, docked_LRV],
        actions: [TurnAround, GoForward, Backup],
        values: [docked_LRV = 10.0],
        maps: 8 x 8,
        patterns: 64,
        schemas: 256,
        synthetic: 128,
        beliefs: 1024,
        ram: 38_000,
    }
}

/// A life in a world of a file.
///
/// ```
/// use std::sync::Arc;
/// use host_sim::world::World;
/// use host_sim::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE};
/// let mut world = PomdpWorld::new(Arc::new(Pomdp::parse(SHUTTLE)?), 1);
/// world.act(1);
/// assert_eq!(world.sense().on().len(), 1);
/// # Ok::<(), host_sim::world::pomdp::PomdpError>(())
/// ```
#[derive(Clone, Debug)]
pub struct PomdpWorld {
    model: Arc<Pomdp>,
    state: usize,
    seen: Option<usize>,
    earned: f64,
    rewards: u32,
    rng: Rng,
}

impl PomdpWorld {
    /// A life whose every chance is decided by `seed`; nothing is seen before the first action.
    #[must_use]
    pub fn new(model: Arc<Pomdp>, seed: u64) -> Self {
        let mut rng = Rng::stream(seed, 62);
        Self {
            state: draw(&model.start, &mut rng),
            model,
            seen: None,
            earned: 0.0,
            rewards: 0,
            rng,
        }
    }

    /// What the file says.
    #[must_use]
    pub fn model(&self) -> &Pomdp {
        &self.model
    }

    /// The state, which no percept shows.
    #[must_use]
    pub const fn state(&self) -> usize {
        self.state
    }
}

impl World for PomdpWorld {
    fn items(&self) -> &'static [&'static str] {
        self.model.observations
    }

    fn actions(&self) -> &'static [&'static str] {
        self.model.actions
    }

    fn sense(&self) -> Percept {
        let mut percept = Percept::all_off(self.model.observations.len() as u16);
        if let Some(seen) = self.seen {
            let here = percept.set(ItemId(seen as u16), Some(true));
            debug_assert!(here.is_ok(), "a file has no more observations than fit");
        }
        percept
    }

    /// An action beyond the file's is its last.
    fn act(&mut self, action: usize) {
        let action = action.min(self.model.actions.len() - 1);
        let next = draw(self.model.next(action, self.state), &mut self.rng);
        let seen = draw(self.model.observed(action, next), &mut self.rng);
        let reward = self.model.reward(action, self.state, next, seen);
        self.earned += reward;
        self.rewards += u32::from(reward > 0.0);
        (self.state, self.seen) = (next, Some(seen));
    }

    fn reflex(&mut self) -> Option<usize> {
        None
    }

    /// Steps that earned something.
    fn obtained(&self) -> u32 {
        self.rewards
    }

    fn finished(&self) -> bool {
        false
    }

    fn earned(&self) -> f64 {
        self.earned
    }
}
