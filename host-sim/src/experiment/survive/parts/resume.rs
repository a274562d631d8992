//! A life that is stopped, stored and gone on with in another brain, beside the same life without a
//! stop: every named configuration of the agent, and the one learner, in the Pioneer.

use cla_core::agent::AgentConfig;
use cla_core::num::Rng;
use cla_core::snapshot::Names;

use super::super::configurations::{ALL, forager};
use super::super::part::{Part, Scale, never, tried};
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::learner::{Learner, live};
use crate::report::Claim;
use crate::world::World;
use crate::world::config::PioneerConfig;
use crate::world::damage::{Damage, Damaged};
use crate::world::pioneer::{ACTIONS, ITEMS, Pioneer};

/// The part.
pub(crate) const PART: Part = Part {
    name: "resume",
    measure,
    claims,
    ..Part::QUICK
};

/// Actions of the training, and then of the life with a turned camera.
const TRAINING: u32 = 1500;
const ACTING: u32 = 1500;
/// Stops in each life.
const STOPS: u32 = 20;

fn measure(scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let (mut stops, mut differing) = (0, 0);
    for (index, (name, config)) in (0..).zip(ALL) {
        let (training, acting) = (scale.of(TRAINING), scale.of(ACTING));
        let whole = life(config, seed, training, acting, &[])?;
        let mut rng = Rng::stream(seed, 73 + index);
        let mut places: Vec<u32> = (0..scale.of(STOPS).max(2))
            .map(|_| rng.below(training + acting))
            .collect();
        places.sort_unstable();
        let stopped = life(config, seed, training, acting, &places)?;
        let other = u32::from(stopped != whole);
        trial.note(format!("resume.{name}"), other);
        stops += places.len() as u32;
        differing += other;
    }
    trial.note("resume.stops", stops);
    trial.note("resume.differing", differing);
    Ok(())
}

/// The image at the end of a life, and what was obtained; it is stopped after each of so many actions.
fn life(
    config: Option<AgentConfig>,
    seed: u64,
    training: u32,
    acting: u32,
    stops: &[u32],
) -> Result<(Vec<u8>, u32), Failure> {
    let mut learner = forager(config, seed)?;
    let room = |seed| Pioneer::new(PioneerConfig::NOISY, seed);
    // The brain that the life goes on in has lived, so that what is not read over would be seen.
    let mut other = forager(config.map(|_| AgentConfig::RESILIENT_LEVEL2), seed + 1)?;
    live(&mut *other, &mut room(seed + 1)?, 200)?;
    let (before, after): (Vec<u32>, Vec<u32>) = stops.iter().partition(|&&it| it < training);
    let mut world = room(seed)?;
    stopped(&mut learner, &mut other, &mut world, training, &before)?;
    learner.act()?;
    let mut world = Damaged::new(world, Damage::Camera(12.0), seed)?;
    let after: Vec<u32> = after.iter().map(|it| it - training).collect();
    stopped(&mut learner, &mut other, &mut world, acting, &after)?;
    Ok((image_of(&*learner)?, world.obtained()))
}

/// Lives, and goes on in the other brain after each stop.
fn stopped<W: World>(
    learner: &mut Box<dyn Learner>,
    other: &mut Box<dyn Learner>,
    world: &mut W,
    actions: u32,
    stops: &[u32],
) -> Result<(), Failure> {
    let mut done = 0;
    for &stop in stops {
        live(&mut **learner, world, stop - done)?;
        other.go_on_from(names(), &image_of(&**learner)?)?;
        std::mem::swap(learner, other);
        done = stop;
    }
    live(&mut **learner, world, actions - done)?;
    Ok(())
}

fn names() -> Names {
    Names::of(&ITEMS, &ACTIONS)
}

fn image_of(learner: &dyn Learner) -> Result<Vec<u8>, Failure> {
    Ok(learner.image(names())?.ok_or("a brain has an image")?)
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    vec![
        never(
            "resume",
            "lives",
            "of six lives of 3000 actions, those that were stopped, stored and gone on with in another \
             brain and did not end in the same bytes",
            &of(trials, "resume.differing"),
        ),
        tried("resume.stops", "stops", 1000.0, &of(trials, "resume.stops")),
    ]
}
