//! A life that is judged by what it earns: rewards beside the percept, episodes that end.
//!
//! [`rewarded`] is the life of a [`Learner`], [`driven`] that of anything that may look at the world
//! itself, as a planner does that knows everything.

use super::{Learner, feel_reflexes};
use crate::failure::Failure;
use crate::world::World;

/// What came of a life.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Income {
    /// Rewards less costs.
    pub earned: f64,
    /// Actions done.
    pub actions: u32,
    /// Episodes that ended.
    pub episodes: u32,
}

impl Income {
    /// Mean reward of an action; 0 without any.
    #[must_use]
    pub fn per_action(&self) -> f64 {
        self.earned / f64::from(self.actions.max(1))
    }

    /// Mean reward of an episode; 0 without any.
    #[must_use]
    pub fn per_episode(&self) -> f64 {
        self.earned / f64::from(self.episodes.max(1))
    }
}

/// Lets a learner do up to `actions` actions, which tells it every reward and the end of an episode.
///
/// Reflexes run in between; what they earn counts, but is no reward of the action before.
///
/// # Errors
/// Those of the learner; what it has learned until then stays.
pub fn rewarded<W: World + ?Sized>(
    learner: &mut dyn Learner,
    world: &mut W,
    actions: u32,
) -> Result<Income, Failure> {
    let mut income = Income::default();
    let start = world.earned();
    for _ in 0..actions {
        if world.finished() {
            break;
        }
        let action = learner.choose(&world.sense())?;
        let before = world.earned();
        world.act(action);
        let reward = world.earned() - before;
        learner.learn_with(&world.sense(), reward as f32)?;
        feel_reflexes(learner, world)?;
        income.actions += 1;
        if world.episode_ended() {
            learner.interrupt()?;
            world.begin_episode();
            income.episodes += 1;
        }
    }
    income.earned = world.earned() - start;
    Ok(income)
}

/// Lets `decide`, which sees all of the world, do up to `actions` actions.
pub fn driven<W: World>(
    world: &mut W,
    actions: u32,
    mut decide: impl FnMut(&W) -> usize,
) -> Income {
    let mut income = Income::default();
    let start = world.earned();
    for _ in 0..actions {
        if world.finished() {
            break;
        }
        let action = decide(world);
        world.act(action);
        while world.reflex().is_some() {}
        income.actions += 1;
        if world.episode_ended() {
            world.begin_episode();
            income.episodes += 1;
        }
    }
    income.earned = world.earned() - start;
    income
}
