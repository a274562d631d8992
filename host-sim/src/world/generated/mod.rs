//! Worlds by chance, of the size that a `brain!` has: 6 to 64 items, 3 to 12 actions.
//!
//! Behind each stand two to four variables; an action changes one of them, if another has the right
//! value; some combination of values is the goal.
//! Items show values, with errors and sometimes two values by one item; the others blink or drift
//! and show nothing. The reward may come some actions late.
//! [`Spec`] is what a seed has made of all this, and its optimum is known by value iteration.

mod spec;

use std::collections::VecDeque;
use std::sync::Arc;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::names::Names;
use super::{Percept, World};
pub use spec::{ACTIONS, Change, Effect, ITEMS, Shown, Spec};

cla_core::brain! {
    /// A robot for the largest of these worlds; in a smaller one the other items are off for ever, and
    /// the other actions do again what the first ones do.
    pub mod dweller {
        items: [
            reward, i1, i2, i3, i4, i5, i6, i7, i8, i9, i10, i11, i12, i13, i14, i15,
            i16, i17, i18, i19, i20, i21, i22, i23, i24, i25, i26, i27, i28, i29, i30, i31,
            i32, i33, i34, i35, i36, i37, i38, i39, i40, i41, i42, i43, i44, i45, i46, i47,
            i48, i49, i50, i51, i52, i53, i54, i55, i56, i57, i58, i59, i60, i61, i62, i63,
        ],
        actions: [a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11],
        values: [reward = 10.0],
        maps: 16 x 16,
        patterns: 512,
        schemas: 2048,
        synthetic: 384,
        beliefs: 3072,
        ram: 1_792_000,
    }
}

/// A life in a generated world.
///
/// ```
/// use std::sync::Arc;
/// use host_sim::world::{World, generated::{Generated, Spec}};
/// let mut world = Generated::new(Arc::new(Spec::random(1)), 1);
/// for step in 0..1000 {
///     world.act(step % 7);
/// }
/// assert_eq!(world.earned(), f64::from(world.obtained()));
/// ```
#[derive(Clone, Debug)]
pub struct Generated {
    spec: Arc<Spec>,
    names: (Names, Names),
    state: usize,
    /// Actions until each reward that is on its way.
    coming: VecDeque<usize>,
    rewarded: bool,
    rewards: u32,
    drifting: Vec<bool>,
    rng: Rng,
    percept: Percept,
}

impl Generated {
    /// A life in which `seed` decides every chance; the world's own seed is another.
    #[must_use]
    pub fn new(spec: Arc<Spec>, seed: u64) -> Self {
        let mut rng = Rng::stream(seed, 68);
        let drifting = spec.shown.iter().map(|_| rng.chance(0.5)).collect();
        let mut it = Self {
            names: (spec.items(), spec.actions()),
            state: 0,
            coming: VecDeque::new(),
            rewarded: false,
            rewards: 0,
            drifting,
            rng,
            percept: Percept::UNKNOWN,
            spec,
        };
        it.begin();
        it.look();
        it
    }

    /// What the world is made of.
    #[must_use]
    pub const fn spec(&self) -> &Arc<Spec> {
        &self.spec
    }

    /// What the best policy earns in an action when the state is known.
    #[must_use]
    pub fn optimum(&self) -> f64 {
        self.spec.model().rate(1e-6).gain
    }

    /// The state, which the percept shows in part.
    #[must_use]
    pub const fn state(&self) -> usize {
        self.state
    }

    /// Any state but the goal.
    fn begin(&mut self) {
        loop {
            self.state = self.rng.below(self.spec.states() as u32) as usize;
            if !self.spec.is_goal(self.state) {
                return;
            }
        }
    }

    fn look(&mut self) {
        let spec = Arc::clone(&self.spec);
        let mut percept = Percept::all_off(ITEMS.1 as u16);
        for (index, shown) in spec.shown.iter().enumerate() {
            let on = match *shown {
                Shown::Reward => self.rewarded,
                Shown::Value { variable, values } => {
                    let has = values >> spec.value(self.state, variable) & 1 == 1;
                    has != self.rng.chance(spec.noise)
                }
                Shown::Blinks(share) => self.rng.chance(share),
                Shown::Drifts(share) => {
                    self.drifting[index] ^= self.rng.chance(share);
                    self.drifting[index]
                }
            };
            let fits = percept.set(ItemId(index as u16), Some(on));
            debug_assert!(fits.is_ok(), "no more items than fit a percept are made");
        }
        self.percept = percept;
    }
}

impl World for Generated {
    fn items(&self) -> &'static [&'static str] {
        self.names.0
    }

    fn actions(&self) -> &'static [&'static str] {
        self.names.1
    }

    fn sense(&self) -> Percept {
        self.percept
    }

    /// An action beyond the world's does what the action does that remains when theirs are counted
    /// off.
    fn act(&mut self, action: usize) {
        let effect = self.spec.effects[action % self.spec.effects.len()];
        for actions in &mut self.coming {
            *actions -= 1;
        }
        if self.spec.is_goal(self.state) {
            self.begin();
        } else if !self.rng.chance(self.spec.slip) {
            self.state = self.spec.after(self.state, &effect);
            if self.spec.is_goal(self.state) {
                self.coming.push_back(self.spec.delay);
            }
        }
        self.rewarded = self.coming.front() == Some(&0);
        if self.rewarded {
            self.coming.pop_front();
            self.rewards += 1;
        }
        self.look();
    }

    fn reflex(&mut self) -> Option<usize> {
        None
    }

    /// Rewards that have come.
    fn obtained(&self) -> u32 {
        self.rewards
    }

    fn finished(&self) -> bool {
        false
    }
}

#[cfg(test)]
#[path = "generated_tests.rs"]
mod tests;
