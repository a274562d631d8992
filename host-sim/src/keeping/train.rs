//! One Pioneer, trained for a while: born or taken from a file, and kept in another.

use std::path::PathBuf;

use cla_core::agent::{Adaptation, AgentConfig, Stage};
use cla_core::forager::pioneer::VOCABULARY;
use cla_core::forest::MindConfig;

use super::file::{read, whole};
use crate::experiment::recover::film::Crew;
use crate::failure::Failure;
use crate::learner::forager::Forager;
use crate::learner::mind::Minded;
use crate::learner::{Learner, watched};
use crate::logs::{Life, steps, write_log};
use crate::whole::write;
use crate::world::World;
use crate::world::pioneer::{INGRIP, ITEMS, Pioneer};
use crate::world::setting::WorldOptions;

/// Who is born, unless the brain comes from a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Raised {
    /// The book's learner.
    Agent(AgentConfig),
    /// The one learner.
    Mind,
}

/// What is to be done.
#[derive(Clone, Debug)]
pub struct Training {
    /// Of the world, and of the brain unless it comes from a file.
    pub seed: u64,
    /// Where it lives.
    pub world: WorldOptions,
    /// How it learns, unless it comes from a file.
    pub brain: Raised,
    /// Own actions.
    pub actions: u32,
    /// Ends training first, and adapts in this way from then on; a mind has its own way.
    pub act: Option<Adaptation>,
    /// The brain's file.
    pub load: Option<PathBuf>,
    /// Where the brain is kept afterwards.
    pub save: Option<PathBuf>,
    /// Where its actions are logged.
    pub log: Vec<PathBuf>,
}

/// What a specimen is worth to a mind, as in the forager's `brain!`.
const SPECIMEN: f32 = 10.0;
/// Where an image says what kind of brain it is of, and the number of minds.
const KIND: (usize, u8) = (14, 2);

/// Who is trained.
enum Pupil {
    Agent(Box<Forager>),
    Mind(Box<Minded<1, 7, 6>>),
}

impl Pupil {
    fn born(order: &Training, image: Option<&[u8]>) -> Result<Self, Failure> {
        let is_mind = match (image, order.brain) {
            (Some(image), _) => image.get(KIND.0) == Some(&KIND.1),
            (None, brain) => brain == Raised::Mind,
        };
        if is_mind {
            let mut values = [0.0; ITEMS.len()];
            values[usize::from(INGRIP)] = SPECIMEN;
            let mind = Minded::born(MindConfig::DEFAULT, values, order.seed)?;
            return Ok(Self::Mind(Box::new(mind)));
        }
        let config = match order.brain {
            Raised::Agent(config) => config,
            // It will be that of the file.
            Raised::Mind => AgentConfig::FORAGER,
        };
        let adaptation = order.act.unwrap_or(Adaptation::Frozen);
        let forager = Forager::born(config, adaptation, order.seed)?;
        Ok(Self::Agent(Box::new(forager)))
    }

    fn learner(&mut self) -> &mut dyn Learner {
        match self {
            Self::Agent(it) => &mut **it,
            Self::Mind(it) => &mut **it,
        }
    }

    /// What it has done, and what it knows.
    fn said(&self, actions: u32, captures: u32) -> String {
        let done = |acts| if acts { "acted" } else { "trained" };
        match self {
            Self::Agent(it) => {
                let brain = it.brain();
                format!(
                    "{} for {actions} actions: {captures} captures; {} schemas, {} synthetic items",
                    done(matches!(brain.stage(), Stage::Acting(_))),
                    brain.knowledge().schemas().len(),
                    brain.second_level().items(),
                )
            }
            Self::Mind(it) => {
                let (samples, leaves, _) = it.mind().size();
                format!(
                    "{} for {actions} actions: {captures} captures; {samples} samples, {leaves} leaves",
                    done(it.mind().acts()),
                )
            }
        }
    }
}

/// Trains, and says what came of it.
///
/// The brain goes on to the bit; the world begins anew, as it is not the brain's to keep.
///
/// # Errors
/// When a file cannot be read or written, or the world cannot be built.
pub fn train(order: &Training) -> Result<String, Failure> {
    let names = VOCABULARY.names();
    let image = order.load.as_deref().map(read).transpose()?;
    let mut pupil = Pupil::born(order, image.as_deref())?;
    let mut lines = Vec::new();
    if let (Some(path), Some(image)) = (&order.load, &image) {
        let taken = pupil.learner().go_on_from(names, image);
        let length = taken.map_err(|it| format!("{}: {it}", path.display()))?;
        let bytes = whole(length, image, path)?;
        lines.push(format!("loaded {}, {bytes} bytes", path.display()));
    }
    let other = order.act.filter(|&it| it != Adaptation::Relearning);
    if matches!(pupil, Pupil::Mind(_)) && other.is_some() {
        return Err("a mind adapts in its own way: --act relearning".into());
    }
    if order.act.is_some() {
        pupil.learner().act()?;
    }
    let mut world = order.world.build(order.seed)?;
    let mut crew = Crew::default();
    let mut watch = |learner: &dyn Learner, world: &Pioneer| {
        if !order.log.is_empty() {
            crew.shoot(learner, world, &world.sense(), world.obtained());
        }
    };
    let lived = watched(pupil.learner(), &mut world, order.actions, &mut watch)?;
    lines.push(pupil.said(order.actions, lived.total()));
    if !order.log.is_empty() {
        // What the last action has led to.
        crew.shoot(pupil.learner(), &world, &world.sense(), world.obtained());
        let config = &order.world.config;
        let who = match (&order.load, order.brain) {
            (Some(path), _) => format!("the brain of {}", path.display()),
            (None, Raised::Agent(_)) => "a newborn agent".to_owned(),
            (None, Raised::Mind) => "a newborn mind".to_owned(),
        };
        let about = format!("Seed {}: {who} in the Pioneer's room", order.seed);
        let life = Life::of(&crew.film, &about, config.radius, config.camera_range);
        let steps = steps(&crew.film);
        for path in &order.log {
            write_log(path, &life, &steps)?;
            lines.push(format!(
                "logged {} actions in {}",
                steps.len() - 1,
                path.display()
            ));
        }
    }
    if let Some(path) = &order.save {
        let image = pupil.learner().image(names)?.ok_or("it has no image")?;
        write(path, &image)?;
        lines.push(format!("saved {}, {} bytes", path.display(), image.len()));
    }
    Ok(lines.join("\n"))
}
