//! The second level in the book's form on trial: childhoods with maps of its own, and their tests.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer;
use cla_core::level2::{Reading, SomLevelConfig};
use serde::{Deserialize, Serialize};

use super::bench::{Bench, Captures, fresh};
use super::level2_schemas::{Finding, findings};
use super::options::ForageOptions;
use super::som_level2::TwoLevels;
use crate::failure::Failure;
use crate::learner::live;
use crate::world::config::AfterCapture;
use crate::world::setting::WorldOptions;

/// What a second level harvested from Action SOMs collects (see `som_level2`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Harvested {
    /// Its nodes count how often items were on.
    pub counters: Captures,
    /// Only items that were on in nine of ten cases are read, as the book says.
    pub cut: Captures,
    /// With counters, in the large room.
    pub large: Captures,
    /// What the first of them knows of the book's level-2 schemas.
    pub findings: [Finding; 5],
    /// What it would know had it explored as the book's robot did.
    pub exploring: [Finding; 5],
}

/// Gives the second level in the book's form its trials.
///
/// # Errors
/// [`Failure`] when a world cannot be built or a brain cannot go on.
pub(super) fn harvested(bench: &Bench<'_>, large: &WorldOptions) -> Result<Harvested, Failure> {
    let there = ForageOptions {
        world: large.clone(),
        ..bench.options.clone()
    };
    let counters = SomLevelConfig::FORAGER;
    let cut = SomLevelConfig {
        reading: Reading::Cut(0.9),
        ..counters
    };
    let (first, known) = examined(bench.options, counters, bench.seed)?;
    let one = |options: &ForageOptions, config| -> Result<Captures, Failure> {
        let captures = captures(options, config, bench.seed)?;
        let actions = 2 * (bench.options.actions + bench.options.test_actions);
        bench.ticker.advance(u64::from(actions));
        Ok(captures)
    };
    let explorer = trained(
        bench.options,
        counters,
        AgentConfig::BOOK.greedy_share,
        bench.seed,
    )?;
    let actions = 2 * u64::from(bench.options.actions);
    bench.ticker.advance(actions);
    Ok(Harvested {
        counters: first,
        findings: known,
        exploring: findings(&explorer)?,
        cut: one(bench.options, cut)?,
        large: one(&there, counters)?,
    })
}

/// Stack for what handles a level by value, in bytes; a level takes some 6 MB.
const STACK: usize = 64 << 20;

/// Runs `job` on a thread whose stack has room for a level or two.
fn with_room<T: Send>(job: impl FnOnce() -> Result<T, Failure> + Send) -> Result<T, Failure> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK);
        match thread.spawn_scoped(scope, job)?.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

/// A forager with a whole childhood: `options.actions` with level 1 alone, then as many with both,
/// of which `greedy_share` are chosen by value.
///
/// # Errors
/// [`Failure`] when a world cannot be built or a configuration cannot work.
pub fn trained(
    options: &ForageOptions,
    config: SomLevelConfig,
    greedy_share: f32,
    seed: u64,
) -> Result<TwoLevels, Failure> {
    with_room(|| childhood(options, config, greedy_share, seed))
}

fn childhood(
    options: &ForageOptions,
    config: SomLevelConfig,
    greedy_share: f32,
    seed: u64,
) -> Result<TwoLevels, Failure> {
    let mut brain = Box::new(pioneer::brain());
    let alone = AgentConfig {
        level2: None,
        ..options.brain
    };
    pioneer::be_born(&mut brain, alone, seed)?;
    let mut world = options.world.build(seed)?;
    live(&mut *brain, &mut world, options.actions)?;
    brain.reconfigure(AgentConfig {
        greedy_share,
        training_run: AgentConfig::FORAGER_LEVEL2.training_run,
        ..alone
    })?;
    let mut both = TwoLevels::new(brain, alone.values, config, seed)?;
    live(&mut both, &mut world, options.actions)?;
    Ok(both)
}

/// Captures in a test after such a childhood, both ways of counting.
///
/// # Errors
/// As [`trained`].
pub fn captures(
    options: &ForageOptions,
    config: SomLevelConfig,
    seed: u64,
) -> Result<Captures, Failure> {
    with_room(|| Ok(tested(options, config, seed)?.0))
}

/// As [`captures`], and what that forager knows of the book's level-2 schemas.
///
/// # Errors
/// As [`trained`].
pub fn examined(
    options: &ForageOptions,
    config: SomLevelConfig,
    seed: u64,
) -> Result<(Captures, [Finding; 5]), Failure> {
    with_room(|| tested(options, config, seed))
}

fn tested(
    options: &ForageOptions,
    config: SomLevelConfig,
    seed: u64,
) -> Result<(Captures, [Finding; 5]), Failure> {
    let greedy_share = AgentConfig::FORAGER_LEVEL2.greedy_share;
    let both = childhood(options, config, greedy_share, seed)?;
    let count = |after_capture| -> Result<u32, Failure> {
        let mut copy = both.clone();
        copy.act(Adaptation::Reliabilities)?;
        let mut world = fresh(&options.world, after_capture, seed)?;
        Ok(live(&mut copy, &mut world, options.test_actions)?.total())
    };
    let captures = Captures {
        replaced: count(AfterCapture::Replaced)?,
        removed: count(AfterCapture::Removed)?,
    };
    Ok((captures, findings(&both)?))
}

#[cfg(test)]
mod tests {
    use super::captures;
    use crate::experiment::forage::ForageOptions;
    use crate::world::config::PioneerConfig;
    use crate::world::setting::WorldOptions;
    use cla_core::agent::AgentConfig;
    use cla_core::level2::SomLevelConfig;

    #[test]
    fn a_forager_with_a_level_from_maps_forages_and_the_same_seed_does_so_again() {
        let options = ForageOptions {
            seeds: vec![0],
            world: WorldOptions {
                config: PioneerConfig::NOISY,
                layout: None,
                path: None,
            },
            brain: AgentConfig::FORAGER,
            actions: 3_000,
            test_actions: 1_000,
        };
        let first = captures(&options, SomLevelConfig::FORAGER, 0).unwrap();
        assert!(first.replaced >= 20, "{first:?}");
        let again = captures(&options, SomLevelConfig::FORAGER, 0).unwrap();
        assert_eq!(first, again);
    }
}
