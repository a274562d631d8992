//! Lives and tests that all parts of one seed share: how a brain is tested, and a controller.
//!
//! Every test is made in worlds of its own that nobody has lived in.

use std::cell::Cell;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer::{self, Brain};
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::options::ForageOptions;
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::learner::controller::{self, Controller};
use crate::learner::live;
use crate::progress::Ticker;
use crate::world::Percept;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::pioneer::Pioneer;
use crate::world::setting::WorldOptions;

/// Captures of one controller in a test, both ways of counting.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Captures {
    /// With specimens that reappear elsewhere.
    pub replaced: u32,
    /// With specimens that are gone: of 28.
    pub removed: u32,
}

/// A world that nobody has lived in; each way of counting has its own.
///
/// # Errors
/// [`Failure`] when it cannot be built.
pub fn fresh(
    world: &WorldOptions,
    after_capture: AfterCapture,
    seed: u64,
) -> Result<Pioneer, Failure> {
    let config = PioneerConfig {
        after_capture,
        ..world.config
    };
    let other = WorldOptions {
        config,
        layout: world.layout.clone(),
        path: world.path.clone(),
    };
    let stream = match after_capture {
        AfterCapture::Replaced => 1,
        AfterCapture::Removed => 2,
    };
    // Far from every seed that a person names, so that no test repeats a training world.
    Ok(other.build(Rng::stream(seed, stream).next_seed())?)
}

/// A newborn brain.
pub(super) fn born(config: AgentConfig, seed: u64) -> Result<Box<Brain>, Failure> {
    let mut brain = Box::new(pioneer::brain());
    pioneer::be_born(&mut brain, config, seed)?;
    Ok(brain)
}

/// What every test of one seed shares.
pub(super) struct Bench<'a> {
    pub(super) options: &'a ForageOptions,
    pub(super) seed: u64,
    pub(super) ticker: &'a Ticker,
    pub(super) load: Cell<Load>,
}

impl Bench<'_> {
    /// Lets a brain live for some actions, and counts them; returns its captures.
    pub(super) fn live(
        &self,
        brain: &mut Brain,
        world: &mut Pioneer,
        actions: u32,
    ) -> Result<u32, Failure> {
        let lived = live(brain, world, actions)?;
        let mut load = self.load.get();
        load.merge(&lived.load);
        self.load.set(load);
        self.ticker.advance(u64::from(actions));
        Ok(lived.total())
    }

    /// Tests a copy of a brain: greedy, with reliabilities that go on adapting.
    pub(super) fn test(&self, brain: &Brain, world: &WorldOptions) -> Result<Captures, Failure> {
        let count = |after_capture| -> Result<u32, Failure> {
            let mut copy = Box::new(brain.clone());
            copy.act(Adaptation::Reliabilities)?;
            let mut world = fresh(world, after_capture, self.seed)?;
            self.live(&mut copy, &mut world, self.options.test_actions)
        };
        Ok(Captures {
            replaced: count(AfterCapture::Replaced)?,
            removed: count(AfterCapture::Removed)?,
        })
    }

    /// A brain with a whole childhood under another configuration or in another world.
    pub(super) fn trained(
        &self,
        config: AgentConfig,
        world: &WorldOptions,
    ) -> Result<Box<Brain>, Failure> {
        let mut brain = born(config, self.seed)?;
        self.live(
            &mut brain,
            &mut world.build(self.seed)?,
            self.options.actions,
        )?;
        Ok(brain)
    }

    /// Tests a controller that does not learn.
    pub(super) fn rival(
        &self,
        driver: &mut dyn Controller,
        sense: impl Fn(&Pioneer) -> Percept,
        world: &WorldOptions,
    ) -> Result<Captures, Failure> {
        let mut count = |after_capture| -> Result<u32, Failure> {
            let mut world = fresh(world, after_capture, self.seed)?;
            let mut rng = Rng::stream(self.seed, 3);
            let actions = self.options.test_actions;
            let captures = controller::live(&mut world, &sense, driver, &mut rng, actions);
            self.ticker.advance(u64::from(actions));
            Ok(captures)
        };
        Ok(Captures {
            replaced: count(AfterCapture::Replaced)?,
            removed: count(AfterCapture::Removed)?,
        })
    }
}
