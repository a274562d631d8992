//! One seed of the recovery experiment: who takes part, and what each of them lived through.
//!
//! Measures only; what the numbers mean is said in `claims`.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer::VOCABULARY;
use cla_core::level2::{Fallback, Level2Config};
use cla_core::word::Cost;
use serde::{Deserialize, Serialize};

use super::film::Film;
use super::life::{Course, Protocol, control, course, fresh, grown, raise};
use super::options::RecoverOptions;
use super::rivals::{Rival, Tuned};
use crate::baseline::random::Random;
use crate::baseline::sector::Sector;
use crate::baseline::told::Told;
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::learner::controller::Untaught;
use crate::learner::forager::Forager;
use crate::learner::{Learner, Thought, live};
use crate::progress::Ticker;
use crate::world::Percept;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::damage::{Damage, Damaged};
use crate::world::setting::WorldOptions;

/// Who takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Entrant {
    /// Both levels with habits, re-learning, which can be surprised and then fall back on level 1.
    Both,
    /// The same without habits.
    BothNoHabits,
    /// The same without the second level: schemas of level 1, habits, surprise.
    NoLevel2,
    /// Both levels, re-learning without surprise.
    BothPlain,
    /// Both levels; the second is overloaded while its predictions are worse than they were (6.3).
    BothMean,
    /// Both levels; the one that promises more decides (6.2.3).
    BothValue,
    /// Level 1 that re-learns and can be surprised.
    Surprise,
    /// Level 1 that re-learns (book, 7.1.1).
    Plain,
    /// Level 1 whose reliabilities alone adapt (book, 6.3).
    Reliabilities,
    /// Level 1 that stops adapting when the damage comes: directly after it (book, 6.3).
    Frozen,
    /// Sarsa(λ).
    Sarsa,
    /// Sarsa(λ) with history.
    SarsaHistory,
    /// Sarsa(λ) with linear values of items.
    Linear,
    /// Sarsa(λ) with linear values of what habits see.
    Habits,
    /// Q-learning.
    Q,
    /// Q-learning with history.
    QHistory,
    /// A servo that is told of the damage.
    Told,
    /// The same servo, which is not.
    Sector,
    /// Any action.
    Random,
}

impl Entrant {
    /// Everybody.
    pub const ALL: [Self; 19] = [
        Self::Both,
        Self::BothNoHabits,
        Self::BothPlain,
        Self::NoLevel2,
        Self::BothMean,
        Self::BothValue,
        Self::Surprise,
        Self::Plain,
        Self::Reliabilities,
        Self::Frozen,
        Self::Sarsa,
        Self::SarsaHistory,
        Self::Linear,
        Self::Habits,
        Self::Q,
        Self::QHistory,
        Self::Told,
        Self::Sector,
        Self::Random,
    ];

    /// Those whom every damage meets; the book's damage meets everybody.
    pub const FEW: [Self; 14] = [
        Self::Both,
        Self::BothNoHabits,
        Self::BothPlain,
        Self::NoLevel2,
        Self::Surprise,
        Self::Plain,
        Self::Sarsa,
        Self::SarsaHistory,
        Self::Linear,
        Self::Habits,
        Self::Q,
        Self::QHistory,
        Self::Told,
        Self::Random,
    ];

    /// Who was tuned as a rival, and is raised as suits it best.
    #[must_use]
    pub const fn rival(self) -> Option<Rival> {
        match self {
            Self::Sarsa => Some(Rival::Sarsa),
            Self::SarsaHistory => Some(Rival::SarsaHistory),
            Self::Linear => Some(Rival::Linear),
            Self::Habits => Some(Rival::Habits),
            Self::Q => Some(Rival::Q),
            Self::QHistory => Some(Rival::QHistory),
            _ => None,
        }
    }

    /// The rival as it takes part.
    #[must_use]
    pub const fn of(rival: Rival) -> Self {
        match rival {
            Rival::Sarsa => Self::Sarsa,
            Rival::SarsaHistory => Self::SarsaHistory,
            Rival::Linear => Self::Linear,
            Rival::Habits => Self::Habits,
            Rival::Q => Self::Q,
            Rival::QHistory => Self::QHistory,
        }
    }

    /// Its name in tables and figures.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Both => "CLA, two levels, surprise",
            Self::BothNoHabits => "CLA, two levels, surprise, no habits",
            Self::BothPlain => "CLA, two levels, re-learning",
            Self::NoLevel2 => "CLA, one level, habits, surprise",
            Self::BothMean => "CLA, two levels, fallback by mean",
            Self::BothValue => "CLA, two levels, fallback by value",
            Self::Surprise => "CLA, surprise",
            Self::Plain => "CLA, re-learning",
            Self::Reliabilities => "CLA, reliabilities only",
            Self::Frozen => "CLA, frozen",
            Self::Sarsa => Rival::Sarsa.name(),
            Self::SarsaHistory => Rival::SarsaHistory.name(),
            Self::Linear => Rival::Linear.name(),
            Self::Habits => Rival::Habits.name(),
            Self::Q => Rival::Q.name(),
            Self::QHistory => Rival::QHistory.name(),
            Self::Told => "servo, told",
            Self::Sector => "servo, not told",
            Self::Random => "random",
        }
    }
}

/// What every entrant lived through, damage by damage.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// In the order of the damages of the options.
    pub damages: Vec<Vec<(Entrant, Course)>>,
    /// The same learners in the same rooms with the same chance, and nothing happens.
    pub twins: Vec<(Entrant, Course)>,
    /// Both levels once more, undamaged, from the same moment on with other chance.
    pub control: Course,
    /// Captures of 28 in 3000 actions with the first damage: frozen, and after the reliabilities
    /// have adapted; counted as the book counts.
    pub removed: [u32; 2],
    /// What the worst step of all brains would have cost.
    pub load: Load,
    /// The first seed's robot with both levels, filmed as the first damage comes.
    pub film: Option<Film>,
}

impl Trial {
    /// The course of one entrant with one damage.
    #[must_use]
    pub fn course(&self, damage: usize, who: Entrant) -> Option<&Course> {
        course_of(self.damages.get(damage)?, who)
    }

    /// The undamaged course of the same learner.
    #[must_use]
    pub fn twin(&self, who: Entrant) -> Option<&Course> {
        course_of(&self.twins, who)
    }
}

fn course_of(all: &[(Entrant, Course)], who: Entrant) -> Option<&Course> {
    let found = all.iter().find(|(it, _)| *it == who);
    found.map(|(_, course)| course)
}

/// Who meets a damage.
pub(super) fn entrants(damage: &Damage) -> &'static [Entrant] {
    match damage {
        Damage::Camera(12.0) => &Entrant::ALL,
        _ => &Entrant::FEW,
    }
}

/// Who has a twin: everybody who meets one of the damages.
fn with_twins(options: &RecoverOptions) -> &'static [Entrant] {
    let longest = options
        .damages
        .iter()
        .map(entrants)
        .max_by_key(|it| it.len());
    longest.unwrap_or(&[])
}

/// How many actions one seed takes, for the progress bar.
#[must_use]
pub(super) fn work(options: &RecoverOptions) -> u64 {
    let Protocol { before, after, .. } = options.protocol;
    let hurt = options.damages.iter().filter(|it| **it != Damage::None);
    let courses: usize = hurt.map(|it| entrants(it).len()).sum();
    (courses + with_twins(options).len() + 1) as u64 * u64::from(before + after)
}

/// Runs one seed.
///
/// # Errors
/// [`Failure`] when a world cannot be built or damaged so.
pub(super) fn run(options: &RecoverOptions, seed: u64, ticker: &Ticker) -> Result<Trial, Failure> {
    let RecoverOptions {
        world, protocol, ..
    } = options;
    let mut load = Load::default();
    // Level 1 goes on as suits it best, see `forage::second`.
    let alone = AgentConfig {
        greedy_share: 0.8,
        ..AgentConfig::FORAGER
    };
    let forager = grown(alone, world, protocol, seed, &mut load)?;
    let both = grown(
        AgentConfig::FORAGER_LEVEL2,
        world,
        protocol,
        seed,
        &mut load,
    )?;
    let no_habits = AgentConfig {
        habits: None,
        ..AgentConfig::FORAGER_LEVEL2
    };
    let without = grown(no_habits, world, protocol, seed, &mut load)?;
    let with = |fallback, surprise| -> Result<Box<dyn Learner>, Failure> {
        let mut it = both.clone();
        let level2 = Level2Config {
            fallback,
            ..Level2Config::FORAGER
        };
        it.brain_mut().reconfigure(AgentConfig {
            level2: Some(level2),
            ..AgentConfig::FORAGER_LEVEL2
        })?;
        Ok(Box::new(it.acting(Adaptation::Relearning, surprise)?))
    };
    let no_level2 = AgentConfig {
        level2: None,
        ..AgentConfig::FORAGER_LEVEL2
    };
    let one_level = grown(no_level2, world, protocol, seed, &mut load)?;
    for (name, brain) in [("level1", &forager), ("both", &both)] {
        let names = VOCABULARY.names();
        ticker.keep(&format!("recover-{seed}-{name}"), || brain.image(names))?;
    }
    let mut rivals = Vec::new();
    for rival in Rival::ALL {
        let Tuned { setup, quarters } = rival.tuned();
        let mut learner = setup.newborn(world, seed)?;
        raise(&mut *learner, world, protocol, seed, quarters)?;
        rivals.push((rival, learner));
    }
    let forward = world.config.forward;
    let enter = |who| -> Result<Box<dyn Learner>, Failure> {
        let surprise = AgentConfig::RESILIENT.surprise;
        let rival = rivals.iter().find(|(it, _)| Entrant::of(*it) == who);
        if let Some((_, learner)) = rival {
            return Ok(learner.copy());
        }
        Ok(match who {
            Entrant::Both => with(Fallback::Never, surprise)?,
            Entrant::BothNoHabits => Box::new(without.acting(Adaptation::Relearning, surprise)?),
            Entrant::BothPlain => with(Fallback::Never, None)?,
            Entrant::NoLevel2 => Box::new(one_level.acting(Adaptation::Relearning, surprise)?),
            Entrant::BothMean => with(Fallback::MeanReliability(OVERLOADED), None)?,
            Entrant::BothValue => with(Fallback::ValueThenReliability, None)?,
            Entrant::Surprise => Box::new(forager.acting(Adaptation::Relearning, surprise)?),
            Entrant::Plain => Box::new(forager.acting(Adaptation::Relearning, None)?),
            Entrant::Reliabilities => Box::new(forager.acting(Adaptation::Reliabilities, None)?),
            Entrant::Frozen => Box::new(Freezing(forager.acting(Adaptation::Reliabilities, None)?)),
            Entrant::Told => Box::new(Told::new(forward, seed)),
            Entrant::Sector => Box::new(Untaught::new(Sector::new(forward), seed)),
            // The rivals have been found above.
            _ => Box::new(Untaught::new(Random { actions: 6 }, seed)),
        })
    };
    let mut trial = Trial {
        load,
        ..Trial::default()
    };
    let step = u64::from(protocol.before + protocol.after);
    for &who in with_twins(options) {
        let twin = course(&mut *enter(who)?, world, protocol, Damage::None, seed)?;
        trial.load.merge(&twin.load);
        trial.twins.push((who, twin));
        ticker.advance(step);
    }
    trial.control = control(&mut *enter(Entrant::Both)?, world, protocol, seed)?;
    ticker.advance(step);
    for (index, &damage) in options.damages.iter().enumerate() {
        let mut lived = Vec::new();
        for &who in entrants(&damage) {
            if let (Damage::None, Some(twin)) = (damage, trial.twin(who)) {
                lived.push((who, twin.clone()));
                continue;
            }
            let mut learner = enter(who)?;
            let course = course(&mut *learner, world, protocol, damage, seed)?;
            trial.load.merge(&course.load);
            lived.push((who, course));
            ticker.advance(step);
            let place = match who {
                _ if index > 0 => None,
                Entrant::Frozen => Some(0),
                Entrant::Reliabilities => Some(1),
                _ => None,
            };
            if let Some(place) = place {
                trial.removed[place] = of_28(&mut *learner, world, damage, seed)?;
            }
        }
        trial.damages.push(lived);
    }
    if let (Some(&first), Some(&damage)) = (options.seeds.first(), options.damages.first())
        && first == seed
    {
        trial.film = Some(Film::shot(world, protocol, damage, seed)?);
    }
    Ok(trial)
}

/// Share of its usual predictions below which the second level is overloaded.
const OVERLOADED: f32 = 0.8;

/// Captures in 3000 actions when what is taken is gone.
fn of_28(
    learner: &mut dyn Learner,
    world: &WorldOptions,
    damage: Damage,
    seed: u64,
) -> Result<u32, Failure> {
    let world = world.with(PioneerConfig {
        after_capture: AfterCapture::Removed,
        ..world.config
    });
    let mut world = Damaged::new(fresh(&world, seed)?, damage, seed)?;
    Ok(live(learner, &mut world, 3000)?.total())
}

/// A forager that stops adapting when the damage comes: what the experimenter freezes, not the
/// robot.
struct Freezing(Forager);

impl Learner for Freezing {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        self.0.choose(now)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.0.learn(now)
    }

    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure> {
        self.0.observe(before, action, after)
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.0.act()
    }

    fn hear(&mut self, _: &Damage) {
        // A forager that has acted can be frozen.
        let _ = self.0.brain_mut().act(Adaptation::Frozen);
    }

    fn cost(&self) -> Option<Cost> {
        Some(self.0.brain().cost())
    }

    fn reliabilities(&self) -> Vec<f64> {
        self.0.reliabilities()
    }

    fn reason(&self) -> Thought {
        self.0.reason()
    }
}

/// All seeds of one damage.
pub(super) struct Lived<'a> {
    pub(super) trials: &'a [Trial],
    pub(super) index: usize,
}

impl Lived<'_> {
    /// A number of each seed; NaN where the entrant did not take part.
    pub(super) fn of(&self, who: Entrant, number: impl Fn(&Course) -> f64) -> Vec<f64> {
        let of = |trial: &Trial| trial.course(self.index, who).map_or(f64::NAN, &number);
        self.trials.iter().map(of).collect()
    }

    pub(super) fn captures(&self, who: Entrant, from: u32, to: u32) -> Vec<f64> {
        self.of(who, |course| course.captures(from, to))
    }

    /// What the twins capture meanwhile.
    pub(super) fn of_twins(&self, who: Entrant, from: u32, to: u32) -> Vec<f64> {
        let captures = |it: &Course| it.captures(from, to);
        let of = |trial: &Trial| trial.twin(who).map_or(f64::NAN, captures);
        self.trials.iter().map(of).collect()
    }

    /// Actions until each has recovered; infinite is never, NaN for who did not take part.
    pub(super) fn times(&self, who: Entrant) -> Vec<f64> {
        let of = |trial: &Trial| match (trial.course(self.index, who), trial.twin(who)) {
            (Some(course), Some(twin)) => course.recovered_after(twin),
            _ => f64::NAN,
        };
        self.trials.iter().map(of).collect()
    }
}

/// Captures before the damage.
pub(super) fn before(course: &Course) -> f64 {
    f64::from(course.before.iter().sum::<u32>())
}
