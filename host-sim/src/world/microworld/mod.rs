//! The Microworld: an eye, a hand and a ball on a 7 × 7 grid (book, 5.4; Drescher 1991).
//!
//! Its physics are in `state`, what the agent perceives of it in `items`, the truth about all of it
//! in `oracle`; here it is a world to live in.
//! It knows nothing of brains and draws no random number except for the start and for slips.

mod items;
mod oracle;
mod state;

pub use items::{ACTIONS, Family, ITEMS, Items, VOCABULARY, WORDS, action, item, set_of};
pub use oracle::{Oracle, Recall, StateSet};
pub use state::{Body, Cell, Hand, REACH, State};

use cla_core::num::Rng;

use super::{Percept, World};

/// The Microworld as a world to live in.
///
/// ```
/// use host_sim::world::World;
/// use host_sim::world::microworld::{Body, Microworld, action};
/// let mut world = Microworld::new(1, Body::Visible, 0.0);
/// world.act(action("grasp").unwrap());
/// let hcl = world.items().iter().position(|&name| name == "hcl").unwrap();
/// assert!(world.sense().on().iter().any(|item| usize::from(item.0) == hcl));
/// ```
#[derive(Clone, Debug)]
pub struct Microworld {
    state: State,
    body: Body,
    slip: f32,
    rng: Rng,
}

impl Microworld {
    /// A world that starts at random by `seed`; with probability `slip` an action does nothing.
    #[must_use]
    pub fn new(seed: u64, body: Body, slip: f32) -> Self {
        let mut rng = Rng::stream(seed, 51);
        Self {
            state: State::random(&mut rng),
            body,
            slip,
            rng,
        }
    }

    /// Where everything is.
    #[must_use]
    pub const fn state(&self) -> State {
        self.state
    }

    /// Puts everything where `state` says.
    pub const fn set_state(&mut self, state: State) {
        self.state = state;
    }

    /// The items that are on now.
    #[must_use]
    pub fn on(&self) -> Items {
        items::perceive(&self.state, self.body)
    }
}

impl World for Microworld {
    fn items(&self) -> &'static [&'static str] {
        ITEMS
    }

    fn actions(&self) -> &'static [&'static str] {
        ACTIONS
    }

    fn sense(&self) -> Percept {
        let mut percept = Percept::all_off(ITEMS.len() as u16);
        for item in self.on().iter() {
            percept
                .set(item, Some(true))
                .expect("the Microworld's items fit a percept");
        }
        percept
    }

    fn act(&mut self, action: usize) {
        // Without slip no number is drawn: a life stays the same when others add noise.
        if self.slip > 0.0 && self.rng.chance(self.slip) {
            return;
        }
        self.state = self.state.after(action);
    }

    fn obtained(&self) -> u32 {
        0
    }
}
