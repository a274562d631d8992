//! One seed: what everybody lived through, undamaged and damaged.
//!
//! The protocol is that of `recover`: a childhood in two rooms, then a third in which a life goes on
//! undamaged or is damaged; who is damaged has the past of its undamaged twin.

use serde::{Deserialize, Serialize};

use super::inhabitant::Inhabitant;
use super::options::LiveOptions;
use crate::experiment::recover::recovery::recovered_at;
use crate::failure::Failure;
use crate::learner::rewarded::{Hears, Income, Paced, paced};
use crate::learner::{Learner, STRIDE};
use crate::progress::Ticker;
use crate::world::damage::{Damage, Damaged};
use crate::world::setting::rooms;

/// The later part of a life.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Course {
    /// What was obtained in each stride of actions before the damage, and after it.
    pub obtained: [Vec<u32>; 2],
    /// What was earned in them, rewards less costs.
    pub earned: [f64; 2],
    /// Actions that were done in them: fewer where a world has ended.
    pub actions: [u32; 2],
    /// How often it suspected a change before the damage, and after it.
    pub alarms: [u32; 2],
}

impl Course {
    /// What was obtained in up to so many of the damaged actions.
    #[must_use]
    pub fn first(&self, actions: u32) -> f64 {
        let strides = actions.div_ceil(STRIDE) as usize;
        let first = self.obtained[1].iter().take(strides);
        f64::from(first.sum::<u32>())
    }

    /// What was obtained in all damaged actions.
    #[must_use]
    pub fn all(&self) -> f64 {
        f64::from(self.obtained[1].iter().sum::<u32>())
    }

    /// Reward a damaged action.
    #[must_use]
    pub fn per_action(&self) -> f64 {
        self.earned[1] / f64::from(self.actions[1].max(1))
    }

    /// What was obtained in each thousand damaged actions; a rest is left out.
    fn windows(&self) -> Vec<u32> {
        let windows = self.obtained[1].chunks_exact((1000 / STRIDE) as usize);
        windows.map(|it| it.iter().sum()).collect()
    }

    /// Damaged actions until it has recovered what its twin obtains; infinite is never.
    #[must_use]
    pub fn recovered_after(&self, twin: &Self) -> f64 {
        let window = recovered_at(&self.windows(), &twin.windows());
        window.map_or(f64::INFINITY, |it| 1000.0 * it as f64)
    }
}

/// All lives of one learner with one seed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Lives {
    /// Its name.
    pub who: String,
    /// What was obtained in each stride of its childhood.
    pub childhood: Vec<u32>,
    /// The life to which nothing happens.
    pub twin: Course,
    /// The damaged lives, in the order of the damages.
    pub damaged: Vec<Course>,
}

/// Everybody's lives with one seed, the agent's first.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trial(pub Vec<Lives>);

/// Bytes of stack: the largest brain passes over it once, on its way to the heap.
const STACK: usize = 64 << 20;

/// How many actions one seed takes, for the progress bar.
pub(super) fn work(options: &LiveOptions) -> u64 {
    let protocol = options.protocol;
    let later = u64::from(protocol.before) + u64::from(protocol.after);
    let one = 2 * u64::from(protocol.training) + (options.damages.len() as u64 + 1) * later;
    one * options.everybody().count() as u64
}

/// Runs one seed.
///
/// # Errors
/// [`Failure`] when a world cannot be built, or a learner cannot go on.
pub(super) fn run(options: &LiveOptions, seed: u64, ticker: &Ticker) -> Result<Trial, Failure> {
    if options.everybody().all(|who| !who.has_brain()) {
        // Asked only where brains are kept.
        ticker.keep("", || {
            Err("nobody here has a brain that can be kept: mind and the book's agents have".into())
        })?;
    }
    std::thread::scope(|scope| {
        let job = move || -> Result<Trial, Failure> {
            let lives = options
                .everybody()
                .map(|who| lives(options, who, seed, ticker));
            Ok(Trial(lives.collect::<Result<_, _>>()?))
        };
        let builder = std::thread::Builder::new().stack_size(STACK);
        let handle = builder.spawn_scoped(scope, job)?;
        match handle.join() {
            Ok(lived) => lived,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

fn lives(
    options: &LiveOptions,
    who: &Inhabitant,
    seed: u64,
    ticker: &Ticker,
) -> Result<Lives, Failure> {
    let world = &options.world;
    let hears = if world.gives_numbers() {
        Hears::Numbers
    } else {
        Hears::Items
    };
    let mut grown = who.born(world, seed)?;
    let mut childhood = Vec::new();
    let [first, second, _] = rooms(seed);
    for room in [first, second] {
        let mut room = world.build(seed, room)?;
        let part = paced(&mut *grown, &mut room, options.protocol.training, hears)?;
        childhood.extend(part.obtained);
        ticker.advance(u64::from(options.protocol.training));
    }
    grown.act()?;
    let course = |damage: Damage| -> Result<Course, Failure> {
        let mut learner = grown.copy();
        let course = course(&mut *learner, options, damage, hears, seed)?;
        if who.has_brain() {
            let name = kept_as(who.name(), damage, seed);
            ticker.keep(&name, || learner.image(who.names(world, seed)?))?;
        }
        ticker.advance(u64::from(options.protocol.before + options.protocol.after));
        Ok(course)
    };
    Ok(Lives {
        who: who.name().to_owned(),
        childhood,
        twin: course(Damage::None)?,
        damaged: options
            .damages
            .iter()
            .map(|&damage| course(damage))
            .collect::<Result<_, _>>()?,
    })
}

/// The name of the file in which a brain is kept at the end of a life.
fn kept_as(who: &str, damage: Damage, seed: u64) -> String {
    let damage = damage.to_string().replace([':', ','], "_");
    format!("live-{seed}-{who}-{damage}")
}

/// The later part of a life; the damage comes in its middle, and only who listens is told.
fn course(
    learner: &mut dyn Learner,
    options: &LiveOptions,
    damage: Damage,
    hears: Hears,
    seed: u64,
) -> Result<Course, Failure> {
    let [_, _, fresh] = rooms(seed);
    let fresh = options.world.build(seed, fresh)?;
    let mut world = Damaged::new(fresh, Damage::None, seed)?;
    let born = learner.alarms();
    let before = paced(learner, &mut world, options.protocol.before, hears)?;
    let calm = learner.alarms();
    let mut world = Damaged::new(world.into_world(), damage, seed)?;
    learner.hear(&damage);
    let after = paced(learner, &mut world, options.protocol.after, hears)?;
    let parts = [before, after];
    let of = |number: fn(&Income) -> f64| [0, 1].map(|it| number(&parts[it].income));
    Ok(Course {
        earned: of(|it| it.earned),
        actions: [0, 1].map(|it| parts[it].income.actions),
        alarms: [calm - born, learner.alarms() - calm],
        obtained: parts.map(|it: Paced| it.obtained),
    })
}
