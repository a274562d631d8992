//! The forager with a second level harvested from Action SOMs: the book's form (6.2.6).
//!
//! Level 1 lives as always; the second level listens, and decides wherever it knows what has just
//! succeeded and level 1 neither explores nor escapes.

use cla_core::agent::{Adaptation, Lesson, Reason, Stage};
use cla_core::choice::ValueConfig;
use cla_core::forager::pioneer::{Brain, Percept};
use cla_core::level2::{Learning, SomLevel, SomLevelConfig};
use cla_core::num::Rng;
use cla_core::word::ActionId;

use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::native::narrowed;
use crate::world;

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
        level.be_born(config, &mut Rng::stream(seed, 4))?;
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
        let now = &narrowed(now);
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
        let now = &narrowed(now);
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
        let (before, after) = (&narrowed(before), &narrowed(after));
        let action = ActionId(action as u16);
        self.listen(before, action, after);
        let lesson = self.brain.observe(before, action, after)?;
        self.follow(lesson);
        Ok(())
    }
}
