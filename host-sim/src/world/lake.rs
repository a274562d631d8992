//! The frozen lake: 4 × 4 fields of ice with four holes, from one corner to the other, slippery.
//!
//! Each action leads where it should in a third of the cases, and to either side in a third each.
//! An episode ends at the goal, in a hole, or after 100 steps.
//! Source: the FrozenLake-v1 of OpenAI Gym (Brockman et al. 2016), map `4x4`, `is_slippery`.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::solve::{Horizon, Mdp};
use super::{Percept, World};

cla_core::brain! {
    /// What a robot on the lake knows: the field it stands on.
    pub mod skater {
        items: [
            a1, b1, c1, d1,
            a2, b2, c2, d2,
            a3, b3, c3, d3,
            a4, b4, c4, goal,
        ],
        actions: [left, down, right, up],
        values: [goal = 10.0],
        maps: 10 x 10,
        patterns: 64,
        schemas: 256,
        synthetic: 128,
        beliefs: 1024,
        ram: 87_000,
    }
}

/// Fields along one side.
const SIDE: usize = 4;

/// Steps of the longest episode.
pub const STEPS: u32 = 100;

/// The field at the far corner.
pub const GOAL: usize = SIDE * SIDE - 1;

/// The fields without ice.
pub const HOLES: [usize; 4] = [5, 7, 11, 12];

/// Where a step leads that does not slip; the bank stops it.
#[must_use]
pub const fn neighbour(field: usize, direction: usize) -> usize {
    let (row, column) = (field / SIDE, field % SIDE);
    match direction {
        0 if column > 0 => field - 1,
        1 if row + 1 < SIDE => field + SIDE,
        2 if column + 1 < SIDE => field + 1,
        3 if row > 0 => field - SIDE,
        _ => field,
    }
}

/// Whether an episode ends on this field.
#[must_use]
pub fn is_end(field: usize) -> bool {
    field == GOAL || HOLES.contains(&field)
}

/// The directions that an action may take: its own and both sides, a third each.
#[must_use]
pub const fn directions(action: usize) -> [usize; 3] {
    [(action + 3) % 4, action % 4, (action + 1) % 4]
}

/// The lake.
///
/// ```
/// use host_sim::world::{World, lake::Lake};
/// let mut world = Lake::new(1);
/// for _ in 0..100 {
///     world.act(2);
/// }
/// assert!(world.episodes() > 0);
/// ```
#[derive(Clone, Debug)]
pub struct Lake {
    field: usize,
    steps: u32,
    goals: u32,
    episodes: u32,
    rng: Rng,
}

impl Lake {
    /// A lake on which `seed` decides every slip.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            field: 0,
            steps: 0,
            goals: 0,
            episodes: 0,
            rng: Rng::stream(seed, 61),
        }
    }

    /// The field that the robot stands on, row by row from the start.
    #[must_use]
    pub const fn field(&self) -> usize {
        self.field
    }

    /// Steps that are left in this episode.
    #[must_use]
    pub const fn left(&self) -> u32 {
        STEPS - self.steps
    }

    /// Episodes that have ended.
    #[must_use]
    pub const fn episodes(&self) -> u32 {
        self.episodes
    }

    /// The truth about the lake; the ends lead nowhere.
    #[must_use]
    pub fn model() -> Mdp {
        Mdp::new(SIDE * SIDE, 4, |field, action| {
            if is_end(field) {
                return (vec![(field, 1.0)], 0.0);
            }
            let to = directions(action).map(|direction| neighbour(field, direction));
            let goals = to.iter().filter(|&&next| next == GOAL).count();
            let outcomes = to.iter().map(|&next| (next, 1.0 / 3.0)).collect();
            (outcomes, goals as f64 / 3.0)
        })
    }

    /// The best policy for an episode; [`Horizon::value`] of field 0 is the share of episodes that
    /// it brings to the goal.
    #[must_use]
    pub fn optimum() -> Horizon {
        Self::model().within(STEPS as usize)
    }
}

impl World for Lake {
    fn items(&self) -> &'static [&'static str] {
        skater::VOCABULARY.items
    }

    fn actions(&self) -> &'static [&'static str] {
        skater::VOCABULARY.actions
    }

    fn sense(&self) -> Percept {
        let mut percept = Percept::all_off(skater::ITEMS.len() as u16);
        let here = percept.set(ItemId(self.field as u16), Some(true));
        debug_assert!(here.is_ok(), "the fields fit a percept");
        percept
    }

    fn act(&mut self, action: usize) {
        if self.episode_ended() {
            self.begin_episode();
        }
        let direction = directions(action)[self.rng.below(3) as usize];
        self.field = neighbour(self.field, direction);
        self.steps += 1;
        self.goals += u32::from(self.field == GOAL);
        self.episodes += u32::from(self.episode_ended());
    }

    fn reflex(&mut self) -> Option<usize> {
        None
    }

    /// Goals reached.
    fn obtained(&self) -> u32 {
        self.goals
    }

    fn finished(&self) -> bool {
        false
    }

    fn episode_ended(&self) -> bool {
        is_end(self.field) || self.steps >= STEPS
    }

    fn begin_episode(&mut self) {
        (self.field, self.steps) = (0, 0);
    }
}

#[cfg(test)]
#[path = "lake_tests.rs"]
mod tests;
