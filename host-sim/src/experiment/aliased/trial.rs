//! One seed: everybody lives in every world, and a twin is tested on the way.
//!
//! Measures only; what the numbers mean is said in `claims`.

use std::collections::BTreeMap;

use cla_core::agent::AgentConfig;
use cla_core::num::Rng;
use cla_core::snapshot::Names;
use serde::{Deserialize, Serialize};

use super::constructed::{self, Constructed};
use super::options::AliasedOptions;
use super::places::Place;
use super::rivals::Rival;
use super::who::Living;
use crate::baseline::random::Random;
use crate::baseline::tabular::Tabular;
use crate::baseline::worlds::believer::Believer;
use crate::failure::Failure;
use crate::learner::controller::Untaught;
use crate::learner::live;
use crate::learner::rewarded::rewarded;
use crate::progress::Ticker;
use crate::world::World;
use crate::world::barriers::Barriers;
use crate::world::pomdp::{Pomdp, PomdpWorld};

/// What was measured with one seed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The seed.
    pub seed: u64,
    /// By world and learner: what an action of a test earns after each length of training.
    pub courses: BTreeMap<String, Vec<f64>>,
    /// By world: what the items of the second level say of the state.
    pub constructed: BTreeMap<String, Constructed>,
}

impl Trial {
    /// What an action of the last test earned; NaN where nobody lived.
    #[must_use]
    pub fn last(&self, place: Place, who: &str) -> f64 {
        let course = self.courses.get(&key(place, who));
        course.and_then(|it| it.last()).map_or(f64::NAN, |&it| it)
    }
}

/// The name of a course.
pub(super) fn key(place: Place, who: &str) -> String {
    format!("{}.{who}", place.name())
}

/// Runs one seed.
///
/// # Errors
/// [`Failure`] when a world cannot be built or a learner cannot go on.
pub(super) fn run(options: &AliasedOptions, seed: u64, ticker: &Ticker) -> Result<Trial, Failure> {
    let mut trial = Trial {
        seed,
        ..Trial::default()
    };
    for &place in &options.places {
        match place.model()? {
            None => barriers(options, place, seed, ticker, &mut trial)?,
            Some(model) => file(options, place, &model, seed, ticker, &mut trial)?,
        }
        ticker.advance(1);
    }
    Ok(trial)
}

/// Learners by name.
type Everybody = Vec<(&'static str, Box<dyn Living>)>;

/// Everybody whom a world has, by name.
fn all(place: Place, world: &dyn World, seed: u64) -> Result<Everybody, Failure> {
    let (items, actions) = (world.items(), world.actions());
    let mut all = vec![
        ("mind", place.mind(items, seed)?),
        ("level1", place.book(AgentConfig::FORAGER, items, seed)?),
        (
            "level2",
            place.book(AgentConfig::RESILIENT_LEVEL2, items, seed)?,
        ),
    ];
    for rival in Rival::ALL {
        let table = Tabular::with_actions(rival.tuned(place)?, actions, seed);
        all.push((rival.name(), Box::new(table)));
    }
    let wild = Random {
        actions: actions.len() as u32,
    };
    all.push(("random", Box::new(Untaught::new(wild, seed))));
    Ok(all)
}

/// Those who have a brain, which has an image; tables have none.
const BRAINS: [&str; 3] = ["mind", "level1", "level2"];

/// Keeps the brain of a life that is over, where brains are kept.
fn keep(
    (place, who): (Place, &str),
    seed: u64,
    learner: &dyn Living,
    names: Names,
    ticker: &Ticker,
) -> Result<(), Failure> {
    if !BRAINS.contains(&who) {
        return Ok(());
    }
    let name = format!("aliased-{seed}-{}-{who}", place.name());
    ticker.keep(&name, || learner.image(names))
}

/// A world of a file.
fn file(
    options: &AliasedOptions,
    place: Place,
    model: &std::sync::Arc<Pomdp>,
    seed: u64,
    ticker: &Ticker,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let world = PomdpWorld::new(std::sync::Arc::clone(model), seed);
    let names = Names::of(world.items(), world.actions());
    for (name, mut learner) in all(place, &world, seed)? {
        let (course, after) = course(options, place, &mut *learner, world.clone())?;
        keep((place, name), seed, &*learner, names, ticker)?;
        trial.courses.insert(key(place, name), course);
        if name == "level2" {
            let told = constructed::of(
                &mut *learner,
                after,
                options.length(constructed::ACTIONS),
                seed,
            )?;
            trial.constructed.insert(place.name().to_owned(), told);
        }
    }
    // It has nothing to learn: one test.
    let mut planner = Untaught::new(Believer::new(place.plan(model)), seed);
    let income = rewarded(
        &mut planner,
        &mut world.clone(),
        options.length(4 * place.test()),
    )?;
    trial
        .courses
        .insert(key(place, "planner"), vec![income.per_action()]);
    Ok(())
}

/// A life, with a test of a twin after each length of training, and the world at its end.
pub(super) fn course(
    options: &AliasedOptions,
    place: Place,
    learner: &mut dyn Living,
    mut world: PomdpWorld,
) -> Result<(Vec<f64>, PomdpWorld), Failure> {
    let (mut course, mut lived) = (Vec::new(), 0);
    for &length in place.lengths() {
        let length = options.length(length);
        rewarded(learner, &mut world, length - lived)?;
        lived = length;
        let mut twin = learner.twin();
        twin.act()?;
        let income = rewarded(&mut *twin, &mut world.clone(), options.length(place.test()))?;
        course.push(income.per_action());
    }
    Ok((course, world))
}

/// The forager's room: one to learn in, another for the tests.
fn barriers(
    options: &AliasedOptions,
    place: Place,
    seed: u64,
    ticker: &Ticker,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let room = Barriers::new(seed)?;
    let names = Names::of(room.items(), room.actions());
    for (name, mut learner) in all(place, &room, seed)? {
        let course = forage(options, place, &mut *learner, seed)?;
        keep((place, name), seed, &*learner, names, ticker)?;
        trial.courses.insert(key(place, name), course);
    }
    Ok(())
}

/// A life among barriers: specimens in an action of each test.
pub(super) fn forage(
    options: &AliasedOptions,
    place: Place,
    learner: &mut dyn Living,
    seed: u64,
) -> Result<Vec<f64>, Failure> {
    let mut room = Barriers::new(seed)?;
    let other = Rng::stream(seed, 1).next_seed();
    let (mut course, mut lived) = (Vec::new(), 0);
    for &length in place.lengths() {
        let length = options.length(length);
        live(learner, &mut room, length - lived)?;
        lived = length;
        let mut twin = learner.twin();
        twin.act()?;
        let test = options.length(place.test());
        let captures = live(&mut *twin, &mut Barriers::new(other)?, test)?.total();
        course.push(f64::from(captures) / f64::from(test));
    }
    Ok(course)
}
