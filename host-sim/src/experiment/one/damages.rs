//! Lives with a damage that comes after a training and a test: the mind, two rivals, and a newborn.
//!
//! The mind is trained once; every damage meets a copy of it, which has lived the test before.

use super::measured::Trial;
use super::options::OneOptions;
use super::pioneer::{Raised, TEST, TRAINING, fresh, newborn, room, second};
use crate::experiment::recover::rivals::Rival;
use crate::failure::Failure;
use crate::learner::{Learner, live};
use crate::world::config::PioneerConfig;
use crate::world::damage::{Damage, Damaged};
use crate::world::pioneer::{ACTIONS, ITEMS};
use crate::world::setting::WorldOptions;

/// Actions of one number of a course.
const THOUSAND: u32 = 1000;
/// Numbers of a course: 13,000 damaged actions, of which the last three are the end.
pub(super) const COURSE: usize = 13;
/// The first 3000 damaged actions.
pub(super) const FIRST: usize = 3;
/// The name of the life that stays undamaged.
pub(super) const TWIN: &str = "recover.none.mind";

/// The damages, with their part of a claim's id.
///
/// # Errors
/// [`Failure`] for a damage that the Pioneer cannot suffer.
pub(super) fn all() -> Result<Vec<(String, Damage)>, Failure> {
    let one = |text: &&str| -> Result<_, Failure> {
        let damage = Damage::parse(text, &ITEMS, &ACTIONS)?;
        Ok((damage.id(), damage))
    };
    Damage::REPORTED.iter().map(one).collect()
}

/// The damages by their parts of ids alone.
pub(super) fn ids() -> Vec<String> {
    // What a test holds: the Pioneer can suffer all that are reported.
    let all = all().unwrap_or_default().into_iter();
    all.map(|(id, _)| id).collect()
}

/// By what a course is found.
pub(super) fn name(id: &str, who: &str) -> String {
    format!("recover.{id}.{who}")
}

/// Captures in each thousand of damaged actions; `before` is lived in the room first, undamaged.
fn course(
    learner: &mut dyn Learner,
    before: u32,
    damage: Damage,
    thousands: usize,
    options: &OneOptions,
    seed: u64,
) -> Result<Vec<f64>, Failure> {
    let mut world = room(fresh(seed))?;
    live(learner, &mut world, before)?;
    let mut world = Damaged::new(world, damage, seed)?;
    let mut captures = Vec::new();
    for _ in 0..thousands {
        let lived = live(learner, &mut world, options.length(THOUSAND))?;
        captures.push(f64::from(lived.total()));
    }
    Ok(captures)
}

/// Everybody's lives with every damage.
///
/// # Errors
/// [`Failure`] when a learner cannot go on.
pub(super) fn lives(
    options: &OneOptions,
    raised: &Raised,
    seed: u64,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let before = options.length(TEST);
    let mut mind = |name: &str, damage| -> Result<(), Failure> {
        let mut learner = raised.trained.clone();
        let captures = course(&mut learner, before, damage, COURSE, options, seed)?;
        trial.note_all(name, captures);
        Ok(())
    };
    mind(TWIN, Damage::None)?;
    for (id, damage) in all()? {
        mind(&name(&id, "mind"), damage)?;
    }
    for (id, damage) in all()? {
        // What a robot would do that is born again as the damage comes.
        let mut learner = newborn(options, 0.0, seed)?;
        let captures = course(&mut learner, 0, damage, COURSE, options, seed)?;
        trial.note_all(name(&id, "newborn"), captures);
    }
    let noisy = WorldOptions {
        config: PioneerConfig::NOISY,
        layout: None,
        path: None,
    };
    for (who, config) in [("sarsa", Rival::Sarsa), ("history", Rival::SarsaHistory)] {
        let tuned = config.tuned();
        let mut rival = tuned.setup.newborn(&noisy, seed)?;
        // As it was tuned: two quarters of a childhood in the first room, then as many in another.
        let quarter = options.length(TRAINING) / 4;
        let first = tuned.quarters.min(2);
        live(&mut *rival, &mut room(seed)?, first * quarter)?;
        live(
            &mut *rival,
            &mut room(second(seed))?,
            (tuned.quarters - first) * quarter,
        )?;
        rival.act()?;
        for (id, damage) in all()? {
            let mut rival = rival.copy();
            let captures = course(&mut *rival, before, damage, FIRST, options, seed)?;
            trial.note_all(name(&id, who), captures);
        }
    }
    Ok(())
}
