//! One seed: robots on each map, with neighbours and without.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::options::NeighboursOptions;
use super::places::{Places, Topology};
use super::room::anywhere;
use super::strategies;
use super::values::Values;
use crate::failure::Failure;

/// Goals of a seed, in each study.
const GOALS: u32 = 10;
/// Episodes of learning that are measured.
const FIRST: u32 = 30;
/// Further episodes before the wheels are swapped.
const MORE: u32 = 70;
/// Episodes after that.
const AFTER: u32 = 30;

/// What robots did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Done {
    /// Mean steps to the goal in the first 30 episodes.
    pub learning: f64,
    /// Mean steps in the 70 after that.
    pub learned: f64,
    /// Mean steps in the 30 after two of the actions were swapped.
    pub recovery: f64,
    /// The share of attempts that reach goals without a schema.
    pub reached: f64,
}

/// Robots on one map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OnMap {
    /// Mean distance of the prototypes of neighbours.
    pub spread: f64,
    /// Nothing comes from neighbours.
    pub alone: Done,
    /// Values and strategies come from neighbours, too.
    pub shared: Done,
}

/// What was measured with one seed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The seed.
    pub seed: u64,
    /// On each map of [`Topology::ALL`].
    pub maps: [OnMap; 3],
}

impl Trial {
    /// The robots on a map.
    pub(super) const fn on(&self, map: Topology) -> &OnMap {
        &self.maps[map as usize]
    }
}

/// Runs one seed.
pub(super) fn run(options: &NeighboursOptions, seed: u64) -> Result<Trial, Failure> {
    let on = |map: Topology| -> Result<OnMap, Failure> {
        let places = Places::learned(map, seed)?;
        Ok(OnMap {
            spread: places.spread(),
            alone: done(options, &places, false, seed)?,
            shared: done(options, &places, true, seed)?,
        })
    };
    let [ordered, shuffled, winner_only] = Topology::ALL.map(on);
    Ok(Trial {
        seed,
        maps: [ordered?, shuffled?, winner_only?],
    })
}

fn done(
    options: &NeighboursOptions,
    places: &Places,
    with: bool,
    seed: u64,
) -> Result<Done, Failure> {
    let learning = options.learning(with);
    let goals = options.length(GOALS);
    let share = 1.0 / f64::from(goals);
    let mut rng = Rng::stream(seed, 1);
    let mut done = Done::default();
    for goal in 0..goals {
        let chance = Rng::stream(seed, 100 + u64::from(goal));
        let mut values = Values::new(places, learning, anywhere(&mut rng), chance);
        done.learning += share * values.mean_steps(FIRST, false)?;
        done.learned += share * values.mean_steps(MORE, false)?;
        done.recovery += share * values.mean_steps(AFTER, true)?;
    }
    done.reached = strategies::reached(places, goals, learning.shared, seed)?;
    Ok(done)
}

/// A number of each seed, on a map, with neighbours or without.
pub(super) fn of(
    trials: &[Trial],
    map: Topology,
    shared: bool,
    measure: fn(&Done) -> f64,
) -> Vec<f64> {
    let side = |it: &Trial| {
        let robots = it.on(map);
        measure(if shared {
            &robots.shared
        } else {
            &robots.alone
        })
    };
    trials.iter().map(side).collect()
}
