//! The second level on trial: the same childhood, then as long again with and without it (6.2.4).
//!
//! Both brains begin as copies of the trained one and go on in the same world.
//! Each explores as suits it best: level 1 in runs of 50, of which four in five are greedy (250
//! captures; as level 2 does, 246), level 2 at every tenth action (seeds 20 to 43).

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::choice::HabitConfig;
use cla_core::forager::pioneer::Brain;
use cla_core::knowledge::Estimate;
use cla_core::level2::Level2Config;
use serde::{Deserialize, Serialize};

use super::bench::{Bench, Captures, fresh};
use super::options::{ForageOptions, SNAPSHOT};
use crate::failure::Failure;
use crate::learner::live;
use crate::world::config::AfterCapture;
use crate::world::damage::{Damage, Damaged};
use crate::world::setting::{WorldOptions, rooms};

/// Share of greedy runs when level 1 goes on alone.
const LEVEL1_GREEDY: f32 = 0.8;

/// Radius of the large room, metres: specimens are rarer there.
pub const LARGE: f64 = 12.0;

/// What two brains of the same childhood collect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Level 1 alone.
    pub level1: Captures,
    /// With the second level.
    pub level2: Captures,
}

/// What the second level and habits bring, each without the other, after the same childhood.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ablation {
    /// The second level without habits.
    pub level2: Captures,
    /// Level 1 with habits.
    pub habits: Captures,
}

/// Gives the second level and habits their trials apart.
///
/// # Errors
/// [`Failure`] when a world cannot be built or a brain cannot go on.
pub(super) fn apart(
    bench: &Bench<'_>,
    young: &Brain,
    world: &WorldOptions,
) -> Result<Ablation, Failure> {
    let level2 = AgentConfig {
        habits: None,
        ..with_level2(bench.options)
    };
    let habits = AgentConfig {
        habits: Some(HabitConfig::FORAGER),
        ..level1_alone(bench.options)
    };
    let captures = |config| bench.test(&*grown(bench, young, config, world)?, world);
    Ok(Ablation {
        level2: captures(level2)?,
        habits: captures(habits)?,
    })
}

fn with_level2(options: &ForageOptions) -> AgentConfig {
    AgentConfig {
        greedy_share: AgentConfig::FORAGER_LEVEL2.greedy_share,
        training_run: AgentConfig::FORAGER_LEVEL2.training_run,
        level2: Some(Level2Config::FORAGER),
        habits: Some(HabitConfig::FORAGER),
        ..options.brain
    }
}

fn level1_alone(options: &ForageOptions) -> AgentConfig {
    AgentConfig {
        greedy_share: LEVEL1_GREEDY,
        ..options.brain
    }
}

/// What is known of the second level of one brain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Insight {
    /// Share of the predictions in the second half of training that came true: said before.
    pub prospective: f64,
    /// Mean reliability of its schemas in the book's way: labelled in hindsight.
    pub hindsight: f64,
    /// The same after 13,000 actions with a turned camera in which only reliabilities adapted (6.3).
    pub hindsight_damaged: f64,
    /// Synthetic items.
    pub items: f64,
    /// Counters of beliefs.
    pub beliefs: f64,
}

/// Trains a brain as long again, once with level 1 alone and once with both, and tests them.
///
/// # Errors
/// [`Failure`] when a world cannot be built or a brain cannot go on.
pub(super) fn compare(
    bench: &Bench<'_>,
    young: &Brain,
    world: &WorldOptions,
) -> Result<(Pair, Insight), Failure> {
    let level2 = grown(bench, young, with_level2(bench.options), world)?;
    compared(bench, young, &level2, world)
}

/// A second half of training that was looked at.
pub(super) struct Watched {
    pub(super) pair: Pair,
    pub(super) insight: Insight,
    /// Tests of the young brain, and of both levels after each thousand actions.
    pub(super) snapshots: Vec<Captures>,
    /// Of each level-2 schema at the end, labelled in hindsight.
    pub(super) reliabilities: Vec<f64>,
    /// Both levels at the end.
    pub(super) brain: Box<Brain>,
}

/// As [`compare`], looked at on the way.
///
/// # Errors
/// As [`compare`].
pub(super) fn watched(
    bench: &Bench<'_>,
    young: &Brain,
    world: &WorldOptions,
) -> Result<Watched, Failure> {
    let mut snapshots = Vec::new();
    let look = |brain: &Brain| {
        snapshots.push(bench.test(brain, world)?);
        Ok(())
    };
    let level2 = grown_and(bench, young, with_level2(bench.options), world, look)?;
    let (pair, insight) = compared(bench, young, &level2, world)?;
    Ok(Watched {
        pair,
        insight,
        snapshots,
        reliabilities: hindsight_reliabilities(&level2),
        brain: level2,
    })
}

fn compared(
    bench: &Bench<'_>,
    young: &Brain,
    level2: &Brain,
    world: &WorldOptions,
) -> Result<(Pair, Insight), Failure> {
    let level1 = grown(bench, young, level1_alone(bench.options), world)?;
    let second = level2.second_level();
    let insight = Insight {
        prospective: f64::from(second.predictions().value(Estimate::Plain)),
        hindsight: hindsight_reliability(level2),
        hindsight_damaged: damaged_reliability(bench, level2, world)?,
        items: f64::from(second.items()),
        beliefs: second.beliefs().len() as f64,
    };
    let pair = Pair {
        level1: bench.test(&level1, world)?,
        level2: bench.test(level2, world)?,
    };
    Ok((pair, insight))
}

/// Actions with the book's damage.
const DAMAGED: u32 = 13_000;

/// As [`hindsight_reliability`], after a life with the book's damage.
fn damaged_reliability(
    bench: &Bench<'_>,
    brain: &Brain,
    world: &WorldOptions,
) -> Result<f64, Failure> {
    let mut copy = Box::new(brain.clone());
    copy.act(Adaptation::Reliabilities)?;
    let whole = fresh(world, AfterCapture::Replaced, bench.seed)?;
    let mut damaged = Damaged::new(whole, Damage::Camera(12.0), bench.seed)?;
    live(&mut *copy, &mut damaged, DAMAGED)?;
    Ok(hindsight_reliability(&copy))
}

/// A copy of a trained brain after as many actions again under another configuration.
fn grown(
    bench: &Bench<'_>,
    young: &Brain,
    config: AgentConfig,
    world: &WorldOptions,
) -> Result<Box<Brain>, Failure> {
    grown_and(bench, young, config, world, |_| Ok(()))
}

/// As [`grown`], looked at before the first and after each thousand actions.
fn grown_and(
    bench: &Bench<'_>,
    young: &Brain,
    config: AgentConfig,
    world: &WorldOptions,
    mut look: impl FnMut(&Brain) -> Result<(), Failure>,
) -> Result<Box<Brain>, Failure> {
    let mut brain = Box::new(young.clone());
    look(&brain)?;
    brain.reconfigure(config)?;
    let [_, second, _] = rooms(bench.seed);
    let mut world = world.build(second)?;
    for _ in 0..bench.options.actions / SNAPSHOT {
        bench.live(&mut brain, &mut world, SNAPSHOT)?;
        look(&brain)?;
    }
    Ok(brain)
}

/// Evidence from which on an item may stand in a schema's result.
const EVIDENCE: f32 = 5.0;
/// The book's threshold of a harvested item (5.3.1).
const ON: f32 = 0.9;

/// The mean reliability of the level-2 schemas as the book counts it.
///
/// A level-2 schema says: in the state in which a schema would succeed, doing its action brings its
/// result and the synthetic items that were on afterwards in nine of ten cases.
/// Its own item is in the context, labelled in hindsight, so its primitive result comes by
/// definition; what can fail are the synthetic items of the result.
fn hindsight_reliability(brain: &Brain) -> f64 {
    let all = hindsight_reliabilities(brain);
    let sum = all.iter().fold(0.0, |sum, reliability| sum + reliability);
    sum / f64::from(all.len().max(1) as u32)
}

/// Those of which [`hindsight_reliability`] is the mean.
fn hindsight_reliabilities(brain: &Brain) -> Vec<f64> {
    let (second, knowledge) = (brain.second_level(), brain.knowledge());
    let mut all = Vec::new();
    for schema in knowledge.schemas() {
        let Some(trace) = schema.synthetic().filter(|&item| second.uses(item) > 0.0) else {
            continue;
        };
        let mut reliability = 1.0_f64;
        for belief in second.beliefs().iter().filter(|it| it.trace == trace) {
            let item = second.schema(belief.item);
            let action = item.and_then(|id| knowledge.schemas().get(usize::from(id.0)));
            let tried = action.map_or(0.0, |it| second.tried(trace, it.action));
            if tried >= EVIDENCE && belief.on > ON * tried {
                reliability = reliability.min(f64::from(belief.on / tried));
            }
        }
        all.push(reliability);
    }
    all
}
