//! One robot's life on film: what every frame of the page shows.
//!
//! The last undamaged actions and the first damaged ones.

use std::collections::BTreeMap;

use cla_core::agent::{Adaptation, AgentConfig};
use serde::{Deserialize, Serialize};

use super::life::{Protocol, grown, watched_course};
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::world::damage::Damage;
use crate::world::geometry::Point;
use crate::world::pioneer::Pioneer;
use crate::world::setting::WorldOptions;
use crate::world::{Percept, World};

/// Undamaged actions that are shown.
const BEFORE: u32 = 600;
/// Damaged actions that are shown.
const AFTER: u32 = 3000;

/// What the page plays; all lists but the last three have one entry a frame.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Film {
    /// Where the robot is and its heading in degrees.
    pub poses: Vec<[f64; 3]>,
    /// The items that are on, one bit each.
    pub on: Vec<u32>,
    /// The chosen actions.
    pub actions: Vec<usize>,
    /// What they were worth.
    pub values: Vec<f64>,
    /// Captures so far.
    pub captures: Vec<u32>,
    /// The thoughts, by their place in `spoken`.
    pub thoughts: Vec<usize>,
    /// Specimens that are elsewhere than in the frame before: which, and where if anywhere.
    pub moved: Vec<Vec<(usize, Option<[f64; 2]>)>>,
    /// Every thought once.
    pub spoken: Vec<String>,
    /// The places of the specimens in the first frame.
    pub first: Vec<Option<[f64; 2]>>,
    /// Frames from and to which the robot doubted.
    pub doubts: Vec<[usize; 2]>,
    /// The frame in which the damage came.
    pub knocked: usize,
}

/// A length in metres to a tenth of a millimetre.
fn short(metres: f64) -> f64 {
    libm::round(metres * 1e4) / 1e4
}

impl Film {
    /// Films the life of a seed's robot with both levels and surprise.
    ///
    /// # Errors
    /// [`Failure`] when the world cannot be built or damaged so.
    pub fn shot(
        world: &WorldOptions,
        protocol: &Protocol,
        damage: Damage,
        seed: u64,
    ) -> Result<Self, Failure> {
        let protocol = Protocol {
            after: AFTER.min(protocol.after),
            ..*protocol
        };
        let both = AgentConfig::RESILIENT_LEVEL2;
        let mut load = Load::default();
        let forager = grown(both, world, &protocol, seed, &mut load)?;
        let mut forager = forager.acting(Adaptation::Relearning, both.surprise)?;
        let mut crew = Crew::default();
        crew.film.knocked = protocol.before.min(BEFORE) as usize;
        let (mut seen, skip) = (0, protocol.before.saturating_sub(BEFORE));
        watched_course(
            &mut forager,
            world,
            &protocol,
            damage,
            seed,
            &mut |learner, world| {
                if seen >= skip {
                    crew.shoot(learner, world.world(), &world.sense(), world.obtained());
                }
                seen += 1;
            },
        )?;
        Ok(crew.film)
    }
}

/// Shoots a film, frame by frame.
#[derive(Clone, Debug, Default)]
pub struct Crew {
    /// What was shot so far.
    pub film: Film,
    places: Vec<Option<Point>>,
    words: BTreeMap<String, usize>,
}

impl Crew {
    /// Adds the frame of a choice that was made and is not done yet: where `percept` was sensed and so
    /// much had been obtained.
    pub fn shoot(
        &mut self,
        learner: &dyn Learner,
        world: &Pioneer,
        percept: &Percept,
        obtained: u32,
    ) {
        let Self {
            film,
            places,
            words,
        } = self;
        let robot = world.robot();
        let thought = learner.reason();
        let at = robot.position;
        let heading = short(robot.heading().to_degrees());
        film.poses.push([short(at.x), short(at.y), heading]);
        let on = percept.on().iter().filter(|item| item.0 < 32);
        film.on.push(on.fold(0, |bits, item| bits | 1 << item.0));
        film.actions.push(thought.action);
        film.values
            .push(f64::from(libm::roundf(thought.value * 100.0)) / 100.0);
        film.captures.push(obtained);
        let next = words.len();
        let index = *words.entry(thought.schema.clone()).or_insert(next);
        if index == film.spoken.len() {
            film.spoken.push(thought.schema);
        }
        film.thoughts.push(index);
        let frame = film.poses.len() - 1;
        match film.doubts.last_mut() {
            Some(doubt) if thought.alarmed && doubt[1] == frame => doubt[1] += 1,
            _ if thought.alarmed => film.doubts.push([frame, frame + 1]),
            _ => {}
        }
        let now = world.specimens();
        let pair = |at: &Option<Point>| at.map(|at| [short(at.x), short(at.y)]);
        if places.is_empty() {
            film.first = now.iter().map(pair).collect();
            *places = now.to_vec();
        }
        let mut moved = Vec::new();
        for (index, (new, old)) in now.iter().zip(places.iter_mut()).enumerate() {
            if new != old {
                moved.push((index, pair(new)));
                *old = *new;
            }
        }
        film.moved.push(moved);
    }
}
