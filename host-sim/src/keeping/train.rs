//! One Pioneer, trained for a while: born or taken from a file, and kept in another.

use std::path::PathBuf;

use cla_core::agent::{Adaptation, AgentConfig, Stage};
use cla_core::forager::pioneer::VOCABULARY;

use super::file::{keep, recall};
use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::forager::Forager;
use crate::learner::live;
use crate::world::setting::WorldOptions;

/// What is to be done.
#[derive(Clone, Debug)]
pub struct Training {
    /// Of the world, and of the brain unless it comes from a file.
    pub seed: u64,
    /// Where it lives.
    pub world: WorldOptions,
    /// How it learns, unless it comes from a file.
    pub brain: AgentConfig,
    /// Own actions.
    pub actions: u32,
    /// Ends training first, and adapts in this way from then on.
    pub act: Option<Adaptation>,
    /// The brain's file.
    pub load: Option<PathBuf>,
    /// Where the brain is kept afterwards.
    pub save: Option<PathBuf>,
}

/// Trains, and says what came of it.
///
/// The brain goes on to the bit; the world begins anew, as it is not the brain's to keep.
///
/// # Errors
/// When a file cannot be read or written, or the world cannot be built.
pub fn train(order: &Training) -> Result<String, Failure> {
    let adaptation = order.act.unwrap_or(Adaptation::Frozen);
    let mut forager = Forager::born(order.brain, adaptation, order.seed)?;
    let mut lines = Vec::new();
    if let Some(path) = &order.load {
        let bytes = recall(forager.brain_mut(), VOCABULARY.names(), path)?;
        lines.push(format!("loaded {}, {bytes} bytes", path.display()));
    }
    if order.act.is_some() {
        forager.act()?;
    }
    let mut world = order.world.build(order.seed)?;
    let lived = live(&mut forager, &mut world, order.actions)?;
    let brain = forager.brain();
    let doing = match brain.stage() {
        Stage::Unborn | Stage::Training => "trained",
        Stage::Acting(_) => "acted",
    };
    lines.push(format!(
        "{doing} for {} actions: {} captures; {} schemas, {} synthetic items",
        order.actions,
        lived.total(),
        brain.knowledge().schemas().len(),
        brain.second_level().items(),
    ));
    if let Some(path) = &order.save {
        let bytes = keep(brain, VOCABULARY.names(), path)?;
        lines.push(format!("saved {}, {bytes} bytes", path.display()));
    }
    Ok(lines.join("\n"))
}
