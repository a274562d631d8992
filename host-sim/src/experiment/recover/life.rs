//! One life of one learner with one damage: childhood, undamaged actions, damaged actions.
//!
//! Everything that learns lives the same protocol in the same worlds; only the learner differs.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::recovery::recovered_at;
use crate::device::meter::Load;
use crate::experiment::record::floats;
use crate::failure::{Failure, Impossible};
use crate::learner::forager::Forager;
use crate::learner::{Learner, STRIDE, Watch, live, watched};
use crate::world::damage::{Damage, Damaged};
use crate::world::pioneer::Pioneer;
use crate::world::setting::{MOST_ACTIONS, WorldOptions, rooms};

/// How long each part of a life is, in actions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Protocol {
    /// Each half of a childhood (book: 10,000 for each level).
    pub training: u32,
    /// Acting undamaged, which says what a whole robot collects (book: 3000).
    pub before: u32,
    /// Acting damaged.
    pub after: u32,
}

impl Protocol {
    /// The protocol of the committed results.
    pub const STANDARD: Self = Self {
        training: 10_000,
        before: 3_000,
        after: 13_000,
    };

    /// Whether lives can be so long.
    ///
    /// # Errors
    /// [`Impossible`] for a part that is too long, and for a damaged life without an action.
    pub fn check(&self) -> Result<(), Impossible> {
        for (name, actions) in [
            ("training", self.training),
            ("before", self.before),
            ("after", self.after),
        ] {
            if actions > MOST_ACTIONS {
                let sentence = format!("protocol.{name} is at most {MOST_ACTIONS}, not {actions}");
                return Err(Impossible::new(sentence));
            }
        }
        if self.after == 0 {
            return Err(Impossible::new("protocol.after is at least 1"));
        }
        Ok(())
    }
}

/// The captures of each [`STRIDE`] of a life's later parts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Course {
    /// Undamaged.
    pub before: Vec<u32>,
    /// Damaged.
    pub after: Vec<u32>,
    /// The reliabilities of its schemas when the damage came, and at the end.
    pub reliabilities: [Vec<f64>; 2],
    /// Shares of the second level's predictions that came true, undamaged and damaged; NaN for who
    /// makes none.
    #[serde(with = "floats")]
    pub predictions: [f64; 2],
    /// How often it was alarmed, undamaged and damaged.
    pub alarms: [u32; 2],
    /// What its worst step would have cost.
    pub load: Load,
}

/// Actions over which a rate of captures is averaged.
const WINDOW: u32 = 1000;

impl Course {
    /// Captures in 1000 undamaged actions.
    #[must_use]
    pub fn rate_before(&self) -> f64 {
        let actions = self.before.len() as f64 * f64::from(STRIDE);
        f64::from(self.before.iter().sum::<u32>()) / actions * f64::from(WINDOW)
    }

    /// Captures in the damaged actions from `from` to `to`, in thousands; NaN when the life was
    /// shorter.
    #[must_use]
    pub fn captures(&self, from: u32, to: u32) -> f64 {
        let at = |thousands: u32| (thousands * WINDOW / STRIDE) as usize;
        let part = self.after.get(at(from)..at(to));
        part.map_or(f64::NAN, |part| f64::from(part.iter().sum::<u32>()))
    }

    /// Captures in the damaged actions from `from` to `to` over what the whole robot collects in as
    /// many.
    #[must_use]
    pub fn share(&self, from: u32, to: u32) -> f64 {
        self.captures(from, to) / (self.rate_before() * f64::from(to - from))
    }

    /// Captures of each thousand damaged actions; a rest is left out.
    #[must_use]
    pub fn windows(&self) -> Vec<u32> {
        let windows = self.after.chunks_exact((WINDOW / STRIDE) as usize);
        windows.map(|window| window.iter().sum()).collect()
    }

    /// Damaged actions until it has recovered what its undamaged twin takes; infinite is never (see
    /// [`recovery`](super::recovery)).
    #[must_use]
    pub fn recovered_after(&self, twin: &Self) -> f64 {
        let window = recovered_at(&self.windows(), &twin.windows());
        window.map_or(f64::INFINITY, |it| it as f64 * f64::from(WINDOW))
    }
}

/// A childhood by quarters: two in the world of the seed, then two in another, as those of the second
/// level are (6.2.4).
pub struct Childhood {
    worlds: [Pioneer; 2],
    half: u32,
    lived: u32,
}

impl Childhood {
    /// One that has not begun.
    ///
    /// # Errors
    /// [`Failure`] when the world cannot be built.
    pub fn new(world: &WorldOptions, protocol: &Protocol, seed: u64) -> Result<Self, Failure> {
        Ok(Self {
            worlds: [world.build(seed)?, second(world, seed)?],
            half: protocol.training,
            lived: 0,
        })
    }

    /// Lives the next quarter, after the last as long as the last; answers what its worst step would
    /// have cost.
    ///
    /// # Errors
    /// [`Failure`] when the learner cannot learn.
    pub fn quarter(&mut self, learner: &mut dyn Learner) -> Result<Load, Failure> {
        let actions = if self.lived.is_multiple_of(2) {
            self.half / 2
        } else {
            self.half - self.half / 2
        };
        let [first, other] = &mut self.worlds;
        let world = if self.lived < 2 { first } else { other };
        self.lived += 1;
        Ok(live(learner, world, actions)?.load)
    }
}

/// The childhood of a learner, so many quarters of it, and ready to act.
///
/// # Errors
/// [`Failure`] when the world cannot be built or the learner cannot learn.
pub fn raise(
    learner: &mut dyn Learner,
    world: &WorldOptions,
    protocol: &Protocol,
    seed: u64,
    quarters: u32,
) -> Result<Load, Failure> {
    let mut childhood = Childhood::new(world, protocol, seed)?;
    let mut load = Load::default();
    for _ in 0..quarters {
        load.merge(&childhood.quarter(learner)?);
    }
    learner.act()?;
    Ok(load)
}

/// A forager that was trained for as long again in another way (6.2.4).
///
/// # Errors
/// [`Failure`] when the world cannot be built or the configuration cannot work.
pub fn grown(
    config: AgentConfig,
    world: &WorldOptions,
    protocol: &Protocol,
    seed: u64,
    load: &mut Load,
) -> Result<Forager, Failure> {
    let mut forager = Forager::born(AgentConfig::FORAGER, Adaptation::Relearning, seed)?;
    load.merge(&live(&mut forager, &mut world.build(seed)?, protocol.training)?.load);
    let brain = forager.brain_mut();
    brain.reconfigure(config)?;
    let mut other = second(world, seed)?;
    load.merge(&live(&mut forager, &mut other, protocol.training)?.load);
    forager.act()?;
    Ok(forager)
}

/// The world of the second half of a childhood.
///
/// # Errors
/// [`Failure`] when it cannot be built.
pub fn second(world: &WorldOptions, seed: u64) -> Result<Pioneer, Failure> {
    let [_, second, _] = rooms(seed);
    Ok(world.build(second)?)
}

/// The world in which a seed's learners act; nobody has lived in it.
///
/// # Errors
/// [`Failure`] when it cannot be built.
pub fn fresh(world: &WorldOptions, seed: u64) -> Result<Pioneer, Failure> {
    let [_, _, fresh] = rooms(seed);
    Ok(world.build(fresh)?)
}

/// Lives the later parts; the damage comes between them, and only who listens is told.
///
/// # Errors
/// [`Failure`] when the world cannot be built or damaged so, or the learner cannot go on.
pub fn course(
    learner: &mut dyn Learner,
    world: &WorldOptions,
    protocol: &Protocol,
    damage: Damage,
    seed: u64,
) -> Result<Course, Failure> {
    watched_course(learner, world, protocol, damage, seed, &mut |_, _| {})
}

/// As [`course`], and somebody watches.
///
/// # Errors
/// As [`course`].
pub fn watched_course(
    learner: &mut dyn Learner,
    world: &WorldOptions,
    protocol: &Protocol,
    damage: Damage,
    seed: u64,
    watch: Watch<'_, Damaged<Pioneer>>,
) -> Result<Course, Failure> {
    let mut world = Damaged::new(fresh(world, seed)?, Damage::None, seed)?;
    let start = learner.predictions();
    let before = watched(learner, &mut world, protocol.before, watch)?;
    let (then, calm) = (learner.reliabilities(), learner.alarms());
    let middle = learner.predictions();
    let mut world = Damaged::new(world.into_world(), damage, seed)?;
    learner.hear(&damage);
    let after = watched(learner, &mut world, protocol.after, watch)?;
    let mut load = before.load;
    load.merge(&after.load);
    Ok(Course {
        before: before.obtained,
        after: after.obtained,
        reliabilities: [then, learner.reliabilities()],
        predictions: [
            came_true(start, middle),
            came_true(middle, learner.predictions()),
        ],
        alarms: [calm, learner.alarms() - calm],
        load,
    })
}

/// The later parts of an undamaged life whose chance is another from the moment on at which damage
/// comes to others: how far apart two undamaged lives are.
///
/// # Errors
/// [`Failure`] when the world cannot be built or the learner cannot go on.
pub fn control(
    learner: &mut dyn Learner,
    world: &WorldOptions,
    protocol: &Protocol,
    seed: u64,
) -> Result<Course, Failure> {
    let before = live(learner, &mut fresh(world, seed)?, protocol.before)?;
    let mut other = world.build(Rng::stream(seed, 7).next_seed())?;
    let after = live(learner, &mut other, protocol.after)?;
    Ok(Course {
        before: before.obtained,
        after: after.obtained,
        predictions: [f64::NAN; 2],
        ..Course::default()
    })
}

/// The share of the predictions between two counts of (right ones, all).
fn came_true(from: (u32, u32), to: (u32, u32)) -> f64 {
    f64::from(to.0 - from.0) / f64::from(to.1 - from.1)
}

#[cfg(test)]
mod tests {
    use super::{Course, came_true};

    #[test]
    fn predictions_are_shared_out_to_the_parts_of_a_life() {
        assert_eq!(came_true((10, 20), (13, 24)), 0.75);
        assert!(came_true((0, 0), (0, 0)).is_nan());
    }

    #[test]
    fn a_course_is_read_in_thousands() {
        let course = Course {
            before: vec![2; 120],
            after: [vec![0; 40], vec![1; 40], vec![2; 40]].concat(),
            ..Course::default()
        };
        assert_eq!(course.rate_before(), 80.0);
        assert_eq!(course.captures(0, 3), 120.0);
        assert_eq!(course.share(0, 3), 0.5);
        assert!(course.captures(3, 6).is_nan());
        assert_eq!(course.windows(), [0, 40, 80]);
        assert_eq!(course.recovered_after(&course), f64::INFINITY);
    }
}
