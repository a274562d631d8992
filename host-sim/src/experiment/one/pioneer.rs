//! Lives in the forager's room: trainings of several lengths, lost readings, distractors, harm, a
//! teacher.
//!
//! Half of a training is lived in the seed's own room, half in another; the test is in a third.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forest::Mind;

use super::measured::Trial;
use super::options::OneOptions;
use crate::baseline::told::Told;
use crate::failure::Failure;
use crate::learner::forager::Forager;
use crate::learner::mind::Minded;
use crate::learner::{Learner, live};
use crate::world::World;
use crate::world::config::PioneerConfig;
use crate::world::distracted::Distracted;
use crate::world::pioneer::{BUMP, INGRIP, ITEMS, Pioneer};
use crate::world::setting::rooms;
use crate::world::veil::{Lost, Veil, Veiled};

/// The one learner in the Pioneer.
pub(super) type ForagerMind = Minded<1, 7, 6>;

/// The same for parts with 128 KiB: `samples: 1_024, states: 512` in `brain!`.
pub(super) type SmallMind = Mind<1, 7, 6, 64, 28, 512, 512, 2048>;

/// What a specimen is worth, as in the forager's `brain!`.
const SPECIMEN: f32 = 10.0;
/// What a bump is worth where it harms.
const HARM: f32 = -10.0;
/// Actions of a training, and of a test.
pub(super) const TRAINING: u32 = 20_000;
pub(super) const TEST: u32 = 3000;
/// Actions of a teacher that are watched, and of the own life beside it.
const LESSON: u32 = 2000;
/// Trainings of other lengths.
const LENGTHS: [u32; 2] = [5_000, 50_000];
/// A life without end, for those who have the time.
const LONG: u32 = 200_000;
const BLOCK: u32 = 100_000;
const BLOCKS: u32 = 98;

/// The room of this seed.
pub(super) fn room(seed: u64) -> Result<Pioneer, Failure> {
    Ok(Pioneer::new(PioneerConfig::NOISY, seed)?)
}

/// The room of the second half of a training.
pub(super) fn second(seed: u64) -> u64 {
    let [_, second, _] = rooms(seed);
    second
}

/// The room of the tests, as in the experiment on recovery.
pub(super) fn fresh(seed: u64) -> u64 {
    let [_, _, fresh] = rooms(seed);
    fresh
}

fn values<const ALL: usize>(bump: f32) -> [f32; ALL] {
    let mut values = [0.0; ALL];
    for (item, worth) in [(INGRIP, SPECIMEN), (BUMP, bump)] {
        if let Some(value) = values.get_mut(usize::from(item)) {
            *value = worth;
        }
    }
    values
}

/// A mind that has not lived; a bump is worth `bump` to it.
///
/// # Errors
/// [`Failure`] when it cannot be born.
pub(super) fn newborn(options: &OneOptions, bump: f32, seed: u64) -> Result<ForagerMind, Failure> {
    Minded::born(options.config, values(bump), seed)
}

/// Trains in two rooms, half of the actions in each, and makes the learner act.
///
/// # Errors
/// Those of the learner.
fn raise(learner: &mut dyn Learner, actions: u32, seed: u64) -> Result<(), Failure> {
    live(learner, &mut room(seed)?, actions / 2)?;
    live(learner, &mut room(second(seed))?, actions / 2)?;
    learner.act()
}

/// Captures of a test in a room where nobody has lived, and that room afterwards.
///
/// # Errors
/// Those of the learner.
pub(super) fn tested(
    learner: &mut dyn Learner,
    options: &OneOptions,
    seed: u64,
) -> Result<(f64, Pioneer), Failure> {
    let mut world = room(fresh(seed))?;
    let captures = live(learner, &mut world, options.length(TEST))?.total();
    Ok((f64::from(captures), world))
}

/// A mind after its training, and what its test says.
pub(super) struct Raised {
    /// Trained, and acting; its test was done by a copy.
    pub(super) trained: ForagerMind,
    /// Captures and bumps of the test.
    pub(super) captures: f64,
    pub(super) bumps: f64,
}

impl Raised {
    /// Trains a mind to which a bump is worth `bump`, and tests it.
    ///
    /// # Errors
    /// [`Failure`] when it cannot live.
    pub(super) fn new(options: &OneOptions, bump: f32, seed: u64) -> Result<Self, Failure> {
        let mut trained = newborn(options, bump, seed)?;
        raise(&mut trained, options.length(TRAINING), seed)?;
        let (captures, world) = tested(&mut trained.clone(), options, seed)?;
        Ok(Self {
            trained,
            bumps: f64::from(world.bump_reflexes()),
            captures,
        })
    }
}

/// Trainings of other lengths, the small mind, and the agent with both levels beside the usual one.
pub(super) fn lengths(options: &OneOptions, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    for actions in LENGTHS {
        let mut mind = newborn(options, 0.0, seed)?;
        raise(&mut mind, options.length(actions), seed)?;
        let (captures, _) = tested(&mut mind, options, seed)?;
        trial.note(format!("forager.{actions}"), captures);
    }
    let mut small = Box::new(SmallMind::new());
    small.be_born(options.config, values(0.0), seed)?;
    raise(&mut *small, options.length(TRAINING), seed)?;
    let (captures, _) = tested(&mut *small, options, seed)?;
    trial.note("forager.small", captures);
    let config = AgentConfig::FORAGER_LEVEL2;
    let mut both = Forager::born(config, Adaptation::Reliabilities, seed)?;
    raise(&mut both, options.length(TRAINING), seed)?;
    let (captures, _) = tested(&mut both, options, seed)?;
    trial.note("forager.both_levels", captures);
    if options.long {
        let mut mind = newborn(options, 0.0, seed)?;
        raise(&mut mind, options.length(LONG), seed)?;
        let (captures, mut world) = tested(&mut mind, options, seed)?;
        trial.note(format!("forager.{LONG}"), captures);
        let mut blocks = Vec::new();
        for _ in 0..BLOCKS {
            let lived = live(&mut mind, &mut world, options.length(BLOCK))?;
            blocks.push(f64::from(lived.total()));
        }
        trial.note_all("forager.blocks", blocks);
    }
    Ok(())
}

/// Tests in which readings get lost.
pub(super) fn unknown(
    options: &OneOptions,
    raised: &Raised,
    seed: u64,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let mut test = |name: String, veil| -> Result<(), Failure> {
        let mut mind = raised.trained.clone();
        let mut world = Veiled::new(room(fresh(seed))?, veil, seed);
        let captures = live(&mut mind, &mut world, options.length(TEST))?.total();
        trial.note(name, captures);
        Ok(())
    };
    for (item, name) in (0..).zip(ITEMS) {
        test(format!("unknown.{name}"), Veil::Item(item, Lost::Unknown))?;
        test(format!("off.{name}"), Veil::Item(item, Lost::Off))?;
    }
    test("unknown.tenth".into(), Veil::Share(0.1, Lost::Unknown))?;
    test("held.tenth".into(), Veil::Share(0.1, Lost::Held))
}

/// Lives among items that blink at random.
pub(super) fn distractors(
    options: &OneOptions,
    seed: u64,
    trial: &mut Trial,
) -> Result<(), Failure> {
    trial.note("distractors.8", among::<15>(options, 8, seed)?);
    trial.note("distractors.20", among::<27>(options, 20, seed)?);
    Ok(())
}

fn among<const ALL: usize>(options: &OneOptions, more: usize, seed: u64) -> Result<f64, Failure> {
    let mut mind = Minded::<1, ALL, 6>::born(options.config, values(0.0), seed)?;
    let around = |seed| -> Result<_, Failure> { Ok(Distracted::new(room(seed)?, more, seed)) };
    let half = options.length(TRAINING) / 2;
    live(&mut mind, &mut around(seed)?, half)?;
    live(&mut mind, &mut around(second(seed))?, half)?;
    mind.act()?;
    let lived = live(&mut mind, &mut around(fresh(seed))?, options.length(TEST))?;
    Ok(f64::from(lived.total()))
}

/// The same training and test where a bump harms.
pub(super) fn harm(options: &OneOptions, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let harmed = Raised::new(options, HARM, seed)?;
    trial.note("harm.captures", harmed.captures);
    trial.note("harm.bumps", harmed.bumps);
    Ok(())
}

/// A mind that has watched a servo, and one that has lived as long itself.
pub(super) fn teach(options: &OneOptions, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let mut own = newborn(options, 0.0, seed)?;
    live(&mut own, &mut room(seed)?, options.length(LESSON))?;
    own.act()?;
    trial.note("teach.own", tested(&mut own, options, seed)?.0);
    let mut pupil = newborn(options, 0.0, seed)?;
    watch(&mut pupil, &mut room(seed)?, options.length(LESSON), seed)?;
    pupil.act()?;
    trial.note("teach.watched", tested(&mut pupil, options, seed)?.0);
    Ok(())
}

/// Shows a learner what a servo does, and what comes of it.
fn watch(
    pupil: &mut dyn Learner,
    world: &mut Pioneer,
    actions: u32,
    seed: u64,
) -> Result<(), Failure> {
    let mut teacher = Told::new(PioneerConfig::NOISY.forward, seed);
    for _ in 0..actions {
        let before = world.sense();
        let action = teacher.choose(&before)?;
        world.act(action);
        let after = world.sense();
        teacher.learn(&after)?;
        pupil.observe(&before, action, &after)?;
        loop {
            let before = world.sense();
            let Some(reflex) = world.reflex() else { break };
            teacher.observe(&before, reflex, &world.sense())?;
            pupil.observe(&before, reflex, &world.sense())?;
        }
    }
    Ok(())
}
