//! A learner of one's own, without touching the library: `cargo run -p host-sim --example new_learner`.
//!
//! It remembers for each percept how much every action has brought soon after it, and does mostly
//! what has brought most; it forages in the Pioneer's world, beside random actions.

use std::collections::BTreeMap;

use cla_core::num::Rng;
use host_sim::baseline::random::Random;
use host_sim::failure::Failure;
use host_sim::learner::controller::Untaught;
use host_sim::learner::{Learner, live};
use host_sim::world::Percept;
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::{ACTIONS, INGRIP, Pioneer};

/// How much of the credit for a reward the action before gets.
const FADING: f64 = 0.8;
/// Actions that get credit.
const MEMORY: usize = 30;

/// What an action has brought in a percept: credit, and how often it was tried.
type Experience = [(f64, f64); ACTIONS.len()];

/// Counts what followed.
struct Bookkeeper {
    book: BTreeMap<Vec<u16>, Experience>,
    /// The newest last.
    done: Vec<(Vec<u16>, usize)>,
    explore: f32,
    chance: Rng,
}

/// The items that are on: all that it goes by.
fn on(now: &Percept) -> Vec<u16> {
    now.on().iter().map(|item| item.0).collect()
}

impl Bookkeeper {
    fn new(seed: u64) -> Self {
        Self {
            book: BTreeMap::new(),
            done: Vec::new(),
            explore: 0.3,
            chance: Rng::stream(seed, 9),
        }
    }

    /// The oldest action that is remembered will get no more credit.
    fn forget(&mut self) {
        let (percept, action) = self.done.remove(0);
        self.book.entry(percept).or_default()[action].1 += 1.0;
    }
}

impl Learner for Bookkeeper {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        let now = on(now);
        let known = self.book.get(&now).copied().unwrap_or_default();
        let worth = |action: usize| (known[action].0 + 0.1) / (known[action].1 + 1.0);
        let best = (0..ACTIONS.len()).max_by(|&a, &b| worth(a).total_cmp(&worth(b)));
        let action = match best {
            Some(best) if !self.chance.chance(self.explore) => best,
            _ => self.chance.below(ACTIONS.len() as u32) as usize,
        };
        self.done.push((now, action));
        Ok(action)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        if on(now).contains(&INGRIP) {
            let mut credit = 1.0;
            for (percept, action) in self.done.iter().rev() {
                self.book.entry(percept.clone()).or_default()[*action].0 += credit;
                credit *= FADING;
            }
            while !self.done.is_empty() {
                self.forget();
            }
        }
        if self.done.len() > MEMORY {
            self.forget();
        }
        Ok(())
    }

    /// Reflexes are nobody's choice.
    fn observe(&mut self, _: &Percept, _: usize, _: &Percept) -> Result<(), Failure> {
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.explore = 0.05;
        Ok(())
    }
}

fn main() -> Result<(), Failure> {
    let (mut ours, mut chance) = (0, 0);
    for seed in 0..3 {
        let world = |seed| Pioneer::new(PioneerConfig::NOISY, seed);
        let mut learner = Bookkeeper::new(seed);
        live(&mut learner, &mut world(seed)?, 10_000)?;
        learner.act()?;
        ours += live(&mut learner, &mut world(1000 + seed)?, 3000)?.total();
        let mut random = Untaught::new(Random { actions: 6 }, seed);
        chance += live(&mut random, &mut world(1000 + seed)?, 3000)?.total();
    }
    println!("captures in 3 × 3000 actions: {ours}, by random actions {chance}");
    assert!(ours > 3 * chance, "{ours} {chance}");
    Ok(())
}
