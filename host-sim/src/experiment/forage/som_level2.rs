//! The forager with a second level harvested from Action SOMs: the book's form (6.2.6).
//!
//! Level 1 lives as always; the second level listens, and decides wherever it knows what has just
//! succeeded and level 1 neither explores nor escapes.

use cla_core::clasm::{
    ActionId, Adaptation, AgentConfig, Learning, Lesson, Reason, SomLevel, SomLevelConfig, Stage,
    ValueConfig,
};
use cla_core::forager::pioneer::{self, Brain, Percept};
use cla_core::num::Rng;

use super::ForageOptions;
use super::level2_schemas::{Finding, findings};
use super::trial::{Captures, fresh};
use crate::learner::forager::percept;
use crate::learner::{Learner, live};
use crate::options::Failure;
use crate::world;
use crate::world::config::AfterCapture;

/// The level: 7 primitive items and 377 synthetic ones, 24 × 24 nodes for each of 6 actions.
pub type Level = SomLevel<1, 7, 12, 384, 24, 24, 6, 4096, 16_384>;

/// A forager of two levels.
#[derive(Clone, Debug)]
pub struct TwoLevels {
    /// The first level, whose own second level is off.
    pub brain: Box<Brain>,
    /// The second.
    pub level: Box<Level>,
    values: ValueConfig,
    now: Percept,
    action: ActionId,
}

impl TwoLevels {
    /// Puts a second level that knows nothing on a brain.
    ///
    /// # Errors
    /// [`Failure`] of a configuration that cannot work.
    pub fn new(
        brain: Box<Brain>,
        values: ValueConfig,
        config: SomLevelConfig,
        seed: u64,
    ) -> Result<Self, Failure> {
        let mut level = Box::new(Level::new());
        level.begin(config, &mut Rng::stream(seed, 4))?;
        Ok(Self {
            brain,
            level,
            values,
            now: Percept::UNKNOWN,
            action: ActionId(0),
        })
    }

    /// Ends training: harvests a last time and settles the values.
    ///
    /// # Errors
    /// [`Failure`] of a brain that was not born.
    pub fn act(&mut self, adaptation: Adaptation) -> Result<(), Failure> {
        self.brain.act(adaptation)?;
        self.level.follow(self.brain.knowledge());
        self.level.harvest();
        for _ in 0..30 {
            let items = self.level.items();
            self.level
                .improve_values(self.brain.knowledge_mut(), items, &self.values);
        }
        Ok(())
    }

    fn follow(&mut self, lesson: Lesson) {
        if lesson.harvested {
            self.level.follow(self.brain.knowledge());
        }
    }

    fn listen(&mut self, before: &Percept, action: ActionId, after: &Percept) {
        let learning = match self.brain.stage() {
            Stage::Acting(Adaptation::Frozen) | Stage::Unborn => Learning::Nothing,
            Stage::Acting(Adaptation::Reliabilities) => Learning::Counters,
            Stage::Acting(Adaptation::Relearning) | Stage::Training => Learning::Maps,
        };
        let knowledge = self.brain.knowledge_mut();
        self.level
            .learn(knowledge, before, action, after, &self.values, learning);
    }
}

impl Learner for TwoLevels {
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        let now = &percept(now);
        let choice = self.brain.choose(now)?;
        let mut action = choice.action;
        if matches!(choice.reason, Reason::Value | Reason::NothingApplies) {
            let knowledge = self.brain.knowledge_mut();
            if let Some(above) = self.level.prefer(knowledge, now, &self.values) {
                action = above.action;
                self.brain.redirect(action)?;
            }
        }
        self.now = *now;
        self.action = action;
        Ok(usize::from(action.0))
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        let now = &percept(now);
        let before = self.now;
        self.listen(&before, self.action, now);
        let lesson = self.brain.learn(now)?;
        self.follow(lesson);
        Ok(())
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        let (before, after) = (&percept(before), &percept(after));
        let action = ActionId(action as u16);
        self.listen(before, action, after);
        let lesson = self.brain.observe(before, action, after)?;
        self.follow(lesson);
        Ok(())
    }
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
    use crate::options::WorldOptions;
    use crate::world::config::PioneerConfig;
    use cla_core::clasm::{AgentConfig, SomLevelConfig};

    #[test]
    fn a_forager_with_a_level_from_maps_forages_and_the_same_seed_does_so_again() {
        let options = ForageOptions {
            seeds: vec![0],
            world: WorldOptions {
                config: PioneerConfig::NOISY,
                layout: None,
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
