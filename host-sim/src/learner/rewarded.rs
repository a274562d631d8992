//! A life that is judged by what it earns: rewards beside the percept, episodes that end.
//!
//! [`rewarded`] is the life of a [`Learner`], [`driven`] that of anything that may look at the world
//! itself, as a planner does that knows everything.

use super::{Learner, STRIDE, feel_reflexes};
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
    Ok(paced(learner, world, actions, Hears::Numbers)?.income)
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

/// What a learner hears of its rewards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hears {
    /// What its valued items say.
    Items,
    /// A number after each action, too.
    Numbers,
}

/// A life in strides.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paced {
    /// What was obtained in each [`STRIDE`] of actions.
    pub obtained: Vec<u32>,
    /// What was earned and done.
    pub income: Income,
}

/// As [`rewarded`], or as [`live`](super::live) for who hears items alone; what is obtained is told
/// stride by stride.
///
/// Episodes end and begin in either.
///
/// # Errors
/// Those of the learner.
pub fn paced<W: World + ?Sized>(
    learner: &mut dyn Learner,
    world: &mut W,
    actions: u32,
    hears: Hears,
) -> Result<Paced, Failure> {
    let mut paced = Paced::default();
    let start = world.earned();
    for done in 0..actions {
        if world.finished() {
            break;
        }
        if done % STRIDE == 0 {
            paced.obtained.push(0);
        }
        let action = learner.choose(&world.sense())?;
        let (before, had) = (world.earned(), world.obtained());
        world.act(action);
        match hears {
            Hears::Items => learner.learn(&world.sense())?,
            Hears::Numbers => {
                let reward = world.earned() - before;
                learner.learn_with(&world.sense(), reward as f32)?;
            }
        }
        feel_reflexes(learner, world)?;
        if let Some(stride) = paced.obtained.last_mut() {
            *stride += world.obtained() - had;
        }
        paced.income.actions += 1;
        if world.episode_ended() {
            learner.interrupt()?;
            world.begin_episode();
            paced.income.episodes += 1;
        }
    }
    paced.income.earned = world.earned() - start;
    Ok(paced)
}

#[cfg(test)]
mod tests {
    use super::{Hears, paced, rewarded};
    use crate::baseline::tabular::{Tabular, TabularConfig};
    use crate::learner::live;
    use crate::world::World;
    use crate::world::config::PioneerConfig;
    use crate::world::lake::Lake;
    use crate::world::pioneer::Pioneer;

    #[test]
    fn a_life_in_strides_is_the_life_that_all_others_live() {
        let room = || Pioneer::new(PioneerConfig::NOISY, 3).unwrap();
        let born = || Tabular::new(TabularConfig::SARSA_HISTORY, 3);
        let lived = live(&mut born(), &mut room(), 1510).unwrap();
        let strides = paced(&mut born(), &mut room(), 1510, Hears::Items).unwrap();
        assert_eq!(strides.obtained, lived.obtained);
        assert_eq!(strides.income.earned, f64::from(lived.total()));
        let lake = Lake::new(3);
        let born = || Tabular::with_actions(TabularConfig::Q, lake.actions(), 3);
        let income = rewarded(&mut born(), &mut Lake::new(3), 3000).unwrap();
        let strides = paced(&mut born(), &mut Lake::new(3), 3000, Hears::Numbers).unwrap();
        assert_eq!(strides.income, income);
        assert_eq!(strides.obtained.len(), 120);
    }
}
