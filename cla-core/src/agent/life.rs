//! A whole brain: senses, chooses, learns (book, 6.2).
//!
//! One control step is [`choose`](Agent::choose), the action, [`learn`](Agent::learn).
//! Maps are trained on completed actions and harvested from time to time; the knowledge base that
//! results chooses.
//! All memory is inside the value, all of it zero at first: a static agent costs no flash.

use super::config::{Adaptation, AgentConfig, Settings, check_values};
use super::step::{AgentError, Choice, Lesson, Reason};
use crate::adaptation::Alarm;
use crate::check::{Checked, Config, ConfigError};
use crate::choice::{ChoiceRule, Habits, ValueConfig};
use crate::knowledge::{KnowledgeBase, SchemaId, SyntheticId};
use crate::level2::SecondLevel;
use crate::map::{ActionSomBank, Sample};
use crate::num::Rng;
use crate::som::{BinarySom, Prototypes};
use crate::word::{ActionId, Cost, ItemId, ItemStates};

/// What an agent is doing with its life.
///
/// ```
/// use cla_core::agent::{Adaptation, Stage};
/// assert_ne!(Stage::Training, Stage::Acting(Adaptation::Frozen));
/// ```
// With a tag of its own, so that `Unborn` is 0 and a static agent needs no initial data.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Stage {
    /// Not born: it can neither choose nor learn.
    Unborn,
    /// Mostly random actions; maps, schemas, reliabilities and values all learn (6.2.3).
    Training,
    /// Chooses by value.
    Acting(Adaptation),
}

/// A learning controller in fixed memory; [`brain!`](crate::brain) names its nine capacities.
///
/// Items in words and in number, the sides of the maps, actions, the capacities of the knowledge
/// base and those of the second level, 0 for a brain of one level.
/// `M` is what a map's weights are stored in: [`BinarySom`] for `f32`, [`ByteSom`](crate::som::ByteSom)
/// for a byte each.
///
/// ```
/// use cla_core::{Agent, AgentConfig, ItemId, Percept};
/// let mut agent = Box::new(Agent::<1, 7, 8, 8, 6, 64, 256, 0, 0>::new());
/// agent.be_born(AgentConfig::FORAGER, &[(ItemId(6), 10.0)], 1)?;
/// let now = Percept::all_off(7);
/// let choice = agent.choose(&now)?;
/// let lesson = agent.learn(&now)?; // nothing happened
/// assert!(lesson.trained.is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Agent<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize = 0,
    const BELIEFS: usize = 0,
    M = BinarySom<WIDTH, HEIGHT, ITEMS>,
> {
    bank: ActionSomBank<WIDTH, HEIGHT, ITEMS, ACTIONS, M>,
    pub(crate) knowledge: KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    pub(crate) level2: SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>,
    pub(crate) habits: Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC>,
    /// The item of the schema that has succeeded last, and the state that it led to.
    trace: Option<SyntheticId>,
    arrived: ItemStates<WORDS>,
    pub(crate) config: Settings,
    pub(crate) rng: Rng,
    pub(crate) stage: Stage,
    context: ItemStates<WORDS>,
    chosen: Option<ActionId>,
    /// The trace at that choice: what is observed before its result comes may change it.
    decided_after: Option<SyntheticId>,
    since_harvest: u32,
    pub(crate) since_reward: u16,
    pub(crate) burst: u16,
    pub(crate) run: u16,
    pub(crate) exploring: bool,
    pub(crate) alarm: Alarm,
    /// Values of habits that have moved in this step.
    practised: u32,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
> Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS>
{
    /// An unborn agent of all-zero memory, with maps of `f32` weights.
    #[must_use]
    pub const fn new() -> Self {
        Self::zeroed()
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
> Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    /// As `new`, for weights of any kind.
    #[must_use]
    pub const fn zeroed() -> Self {
        const {
            assert!(ITEMS <= WORDS * 32, "an item needs a bit: 32 for each word");
            assert!(
                ACTIONS > 0 && ACTIONS <= 256,
                "a robot has 1 to 256 actions"
            );
        }
        Self {
            bank: ActionSomBank::zeroed(),
            knowledge: KnowledgeBase::new(),
            level2: SecondLevel::new(),
            habits: Habits::new(),
            trace: None,
            arrived: ItemStates::UNKNOWN,
            config: Settings::Absent,
            rng: Rng::UNSEEDED,
            stage: Stage::Unborn,
            context: ItemStates::UNKNOWN,
            chosen: None,
            decided_after: None,
            since_harvest: 0,
            since_reward: 0,
            burst: 0,
            run: 0,
            exploring: false,
            alarm: Alarm::NONE,
            practised: 0,
        }
    }

    /// Is born: random maps, no schema, [`Stage::Training`]; `values` alone are worth having for
    /// their own sake.
    ///
    /// The same seed and the same percepts give the same life, to the bit, on every target.
    ///
    /// # Errors
    /// [`ConfigError`] for a configuration that cannot work, a value that is none, an item that the
    /// robot does not have, or nothing that is worth having; the agent is as it was.
    pub fn be_born(
        &mut self,
        config: AgentConfig,
        values: &[(ItemId, f32)],
        seed: u64,
    ) -> Result<(), ConfigError> {
        let config = config.checked()?;
        check_values(values, ITEMS)?;
        self.knowledge.set_inherent_values(values);
        self.config = Settings::Present(config);
        self.rng = Rng::stream(seed, 1);
        self.bank.randomize(&mut self.rng);
        self.knowledge.forget_schemas();
        self.level2.clear();
        self.habits.clear();
        self.trace = None;
        self.stage = Stage::Training;
        self.chosen = None;
        self.since_harvest = 0;
        self.since_reward = 0;
        self.burst = 0;
        self.run = 0;
        self.alarm = Alarm::NONE;
        self.begin_step();
        Ok(())
    }

    /// Chooses what to do now and remembers `now` as the context of it.
    ///
    /// A choice whose result never came (the action did not complete) is forgotten: nothing is
    /// learned from it.
    ///
    /// # Errors
    /// [`AgentError::NotBorn`].
    // A frame of its own, here and below: the steps of a life follow each other, and inlined their
    // stacks would add up.
    #[inline(never)]
    pub fn choose(&mut self, now: &ItemStates<WORDS>) -> Result<Choice, AgentError> {
        if self.stage == Stage::Unborn {
            return Err(AgentError::NotBorn);
        }
        self.begin_step();
        let choice = if self.stage == Stage::Training && self.explores() {
            self.random(Reason::Exploration)
        } else if self.escapes() {
            self.random(Reason::Escape)
        } else {
            match self.prefer(now) {
                Some((level, preference)) => Choice {
                    action: preference.action,
                    reason: Reason::Value,
                    level: Some(level),
                    schema: preference.schema,
                    value: preference.value,
                },
                None => self.random(Reason::NothingApplies),
            }
        };
        self.context = *now;
        self.decided_after = self.trace_in(now);
        self.chosen = Some(choice.action);
        Ok(choice)
    }

    /// Does something else than what was chosen last: a level above knows better.
    ///
    /// # Errors
    /// [`AgentError::NothingChosen`] or [`AgentError::NoSuchAction`]; nothing changes.
    pub fn redirect(&mut self, action: ActionId) -> Result<(), AgentError> {
        if usize::from(action.0) >= ACTIONS {
            return Err(AgentError::NoSuchAction(action));
        }
        *self.chosen.as_mut().ok_or(AgentError::NothingChosen)? = action;
        Ok(())
    }

    /// Learns from the action that was chosen last, which has led to `now`.
    ///
    /// # Errors
    /// [`AgentError::NotBorn`] or [`AgentError::NothingChosen`].
    #[inline(never)]
    pub fn learn(&mut self, now: &ItemStates<WORDS>) -> Result<Lesson, AgentError> {
        if self.stage == Stage::Unborn {
            return Err(AgentError::NotBorn);
        }
        let action = self.chosen.ok_or(AgentError::NothingChosen)?;
        let before = self.context;
        self.practise(&before, action, now);
        let lesson = self.take_in(&before, action, now)?;
        self.chosen = None;
        self.feel(lesson.reward > 0.0);
        self.since_reward = if lesson.reward > 0.0 {
            0
        } else {
            self.since_reward.saturating_add(1)
        };
        Ok(lesson)
    }

    /// Learns from an action that the agent did not choose: a reflex, or a teacher's.
    ///
    /// Where no item was known, before and after, maps learn nothing; habits take its reward for what
    /// followed the last own action.
    ///
    /// # Errors
    /// [`AgentError::NotBorn`] or [`AgentError::NoSuchAction`].
    pub fn observe(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> Result<Lesson, AgentError> {
        let lesson = self.take_in(before, action, after)?;
        if self.stage != Stage::Acting(Adaptation::Frozen) {
            self.habits.add(lesson.reward);
        }
        Ok(lesson)
    }

    #[inline(never)]
    fn take_in(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> Result<Lesson, AgentError> {
        let Settings::Present(Checked(AgentConfig {
            coding,
            harvest_every,
            forgetting,
            ..
        })) = self.config
        else {
            return Err(AgentError::NotBorn);
        };
        if self.stage == Stage::Unborn {
            return Err(AgentError::NotBorn);
        }
        if usize::from(action.0) >= ACTIONS {
            return Err(AgentError::NoSuchAction(action));
        }
        // What is observed while a choice waits for its result belongs to that step.
        if self.chosen.is_none() {
            self.begin_step();
        }
        let mut lesson = Lesson {
            reward: self.knowledge.reward(after),
            ..Lesson::default()
        };
        let frozen = self.stage == Stage::Acting(Adaptation::Frozen);
        if self.suspects().is_some() && self.alarm.doubts() {
            self.knowledge.count_hits(before, action, after);
        }
        lesson.outcome = if frozen {
            self.knowledge.explain(before, action, after)
        } else {
            self.knowledge.record(before, action, after, forgetting)
        };
        self.follow_trace(before, action, after, lesson.outcome.schema);
        if frozen {
            return Ok(lesson);
        }
        // A map would count a win for what nobody saw.
        let blind = before.known().is_empty() && after.known().is_empty();
        if self.stage != Stage::Acting(Adaptation::Reliabilities) && !blind {
            let sample = Sample::new(before, after, coding, ITEMS as u16);
            if let Settings::Present(config) = &self.config {
                lesson.trained = self.bank.train(action, &sample, &config.training);
            }
            self.since_harvest += 1;
            if self.since_harvest >= harvest_every {
                self.harvest();
                lesson.harvested = true;
            }
        }
        self.improve_values();
        Ok(lesson)
    }

    /// Brings some values of both levels up to date.
    #[inline(never)]
    fn improve_values(&mut self) {
        let Self {
            config: Settings::Present(config),
            level2: level,
            knowledge,
            trace,
            ..
        } = self
        else {
            return;
        };
        let values = &config.values;
        knowledge.improve_values::<ACTIONS>(config.values_per_step, values);
        if let Some(level2) = &config.level2 {
            if let Some(trace) = *trace {
                level.improve(knowledge, trace, values, level2);
            }
            level.improve_values(knowledge, level2.values_per_step, values, level2);
        }
    }

    /// Reads the maps into schemas now; the book's rule also gets its values of items.
    ///
    /// Happens by itself every `harvest_every` learned actions; does nothing before birth.
    pub fn harvest(&mut self) {
        let Settings::Present(config) = &self.config else {
            return;
        };
        if self.stage == Stage::Unborn {
            return;
        }
        self.knowledge
            .harvest(self.bank.maps(), config.coding, &config.harvest);
        if config.rule == ChoiceRule::Lexicographic {
            self.knowledge.defer_values(&config.values);
        }
        if self.alarm.doubts() {
            self.knowledge.doubt_new();
        }
        self.level2.follow(&self.knowledge);
        let trace = self.trace;
        self.trace = trace.filter(|&trace| self.level2.schema(trace).is_some());
        self.since_harvest = 0;
    }

    /// Ends training: from now on the agent chooses by value and adapts as told.
    ///
    /// Harvests a last time and settles the values, so the first action is already the best known.
    ///
    /// # Errors
    /// [`AgentError::NotBorn`].
    #[inline(never)]
    pub fn act(&mut self, adaptation: Adaptation) -> Result<(), AgentError> {
        let Settings::Present(Checked(AgentConfig {
            rule,
            values,
            level2,
            ..
        })) = self.config
        else {
            return Err(AgentError::NotBorn);
        };
        if self.stage == Stage::Unborn {
            return Err(AgentError::NotBorn);
        }
        if self.stage == Stage::Training {
            self.harvest();
        }
        if rule == ChoiceRule::ExpectedValue {
            self.knowledge.settle_values::<ACTIONS>(100, &values);
            if let Some(level2) = &level2 {
                let items = self.level2.table.rows.len() as u16;
                for _ in 0..30 {
                    self.level2
                        .improve_values(&mut self.knowledge, items, &values, level2);
                }
            }
        }
        self.stage = Stage::Acting(adaptation);
        self.habits.pause();
        self.since_reward = 0;
        self.burst = 0;
        self.settle_doubt();
        // What comes once is no part of a step.
        self.begin_step();
        Ok(())
    }

    /// What the last control step has touched.
    ///
    /// A step begins with [`choose`](Self::choose), and goes on until the next one; an observation
    /// with no choice before it is a step of its own.
    /// Harvests, and weighing the evidence in a doubt, are left out.
    ///
    /// ```
    /// use cla_core::{Agent, AgentConfig, ItemId, Percept};
    /// let mut agent = Box::new(Agent::<1, 7, 8, 8, 6, 64, 256, 0, 0>::new());
    /// agent.be_born(AgentConfig::FORAGER, &[(ItemId(6), 10.0)], 1)?;
    /// let now = Percept::all_off(7);
    /// agent.choose(&now)?;
    /// agent.learn(&now)?;
    /// assert_eq!(agent.cost().units, 2 * 64);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn cost(&self) -> Cost {
        let mut cost = self.knowledge.cost;
        cost.add(&self.bank.cost());
        cost.add(&self.level2.table.cost);
        cost.habits = self.practised;
        cost
    }

    fn begin_step(&mut self) {
        self.knowledge.cost = Cost::NONE;
        self.level2.table.cost = Cost::NONE;
        self.bank.forget_cost();
        self.practised = 0;
    }

    /// Goes on with another configuration; what has been learned stays.
    ///
    /// This is how a second level begins: the book trains level 1 alone first (6.2.4).
    /// It is no birth: an unborn agent stays unborn, and [`be_born`](Self::be_born) brings its own.
    ///
    /// # Errors
    /// [`ConfigError`]; the agent is as it was.
    pub fn reconfigure(&mut self, config: AgentConfig) -> Result<(), ConfigError> {
        self.config = Settings::Present(config.checked()?);
        if config.level2.is_none() {
            self.trace = None;
        }
        if config.habits.is_none() {
            self.habits.pause();
        }
        self.settle_doubt();
        Ok(())
    }

    /// The second level.
    #[must_use]
    pub const fn second_level(&self) -> &SecondLevel<ACTIONS, SYNTHETIC, BELIEFS> {
        &self.level2
    }

    /// What experience says of the actions, beside the schemas.
    #[must_use]
    pub const fn habits(&self) -> &Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC> {
        &self.habits
    }

    /// The synthetic item of the schema that has just succeeded.
    #[must_use]
    pub const fn trace(&self) -> Option<SyntheticId> {
        self.trace
    }

    /// What the agent knows.
    #[must_use]
    pub const fn knowledge(&self) -> &KnowledgeBase<WORDS, PATTERNS, SCHEMAS> {
        &self.knowledge
    }

    /// What the agent knows, to give inherent values or to insert schemas by hand.
    pub const fn knowledge_mut(&mut self) -> &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS> {
        &mut self.knowledge
    }

    /// The maps.
    #[must_use]
    pub const fn bank(&self) -> &ActionSomBank<WIDTH, HEIGHT, ITEMS, ACTIONS, M> {
        &self.bank
    }

    /// What the agent is doing with its life.
    #[must_use]
    pub const fn stage(&self) -> Stage {
        self.stage
    }

    /// Feels what an action of its own has brought.
    #[inline(never)]
    fn practise(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) {
        let Settings::Present(Checked(AgentConfig {
            habits: Some(habits),
            ..
        })) = self.config
        else {
            return;
        };
        if self.stage == Stage::Acting(Adaptation::Frozen) {
            return;
        }
        let rate = if self.alarm.doubts() {
            habits.doubting_rate
        } else {
            habits.learning_rate
        };
        let deed = (*before.on(), self.decided_after, action);
        let reward = self.knowledge.reward(after);
        self.practised = self.habits.feel(deed, reward, rate, &habits);
    }

    /// The trace, if the robot is still where its schema has led.
    pub(crate) fn trace_in(&self, state: &ItemStates<WORDS>) -> Option<SyntheticId> {
        self.trace.filter(|_| self.arrived == *state)
    }

    #[inline(never)]
    fn follow_trace(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        succeeded: Option<SchemaId>,
    ) {
        let Settings::Present(Checked(AgentConfig {
            level2: Some(level2),
            values: ValueConfig { discount, .. },
            ..
        })) = self.config
        else {
            return;
        };
        let frozen = self.stage == Stage::Acting(Adaptation::Frozen);
        let trace = self.trace_in(before);
        let meant = trace.and_then(|trace| self.level2.schema(trace));
        let item = succeeded.and_then(|schema| {
            let known = self.level2.item_of(&self.knowledge, schema);
            if known.is_some() || frozen {
                return known;
            }
            let item = self.level2.reify(&mut self.knowledge, schema)?;
            self.habits.renew(item);
            Some(item)
        });
        // A new item may have taken the row of the trace.
        let trace = trace.filter(|&trace| self.level2.schema(trace) == meant);
        if let (Some(trace), false) = (trace, frozen) {
            self.level2.judge(trace, action, item);
        }
        if let (Some(trace), Some(to), false) = (trace, item, frozen) {
            let reward = self.knowledge.reward(after);
            self.level2.experience(trace, to, reward, discount, &level2);
            let table = &mut self.level2.table;
            table.record(trace, action, item, level2.forgetting);
        }
        if let (Some(item), false) = (item, frozen) {
            self.level2.table.meet(item);
        }
        self.trace = item;
        self.arrived = *after;
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
> Default
    for Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    fn default() -> Self {
        Self::zeroed()
    }
}

#[cfg(test)]
#[path = "life_tests.rs"]
mod tests;
