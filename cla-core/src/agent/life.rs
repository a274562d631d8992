//! A whole brain: senses, chooses, learns (book, 6.2).
//!
//! One control step is [`choose`](Agent::choose), the action, [`learn`](Agent::learn).
//! Maps are trained on completed actions and harvested from time to time; the knowledge base that
//! results chooses.
//! All memory is inside the value, all of it zero at first: a static agent costs no flash.

use super::config::{Adaptation, AgentConfig, Settings, check_values};
use super::exploring::Exploration;
use super::faculties::Faculties;
use super::step::{AgentError, Choice, Lesson, Reason, Transition};
use crate::adaptation::SurpriseConfig;
use crate::check::{Config, ConfigError};
use crate::choice::Habits;
use crate::knowledge::{KnowledgeBase, SyntheticId};
use crate::level2::SecondLevel;
use crate::map::{ActionSomBank, Sample};
use crate::num::Rng;
use crate::snapshot::stored_codes;
use crate::som::{BinarySom, Prototypes};
use crate::word::{
    ActionId, BEARABLE, Cost, Gauge, Health, ItemId, ItemStates, State, Told, fullest,
};

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
    pub(super) bank: ActionSomBank<WIDTH, HEIGHT, ITEMS, ACTIONS, M>,
    pub(super) faculties: Faculties<WORDS, ITEMS, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS>,
    pub(super) exploration: Exploration,
    pub(super) config: Settings,
    pub(super) rng: Rng,
    pub(super) stage: Stage,
    /// What was so when an action was chosen that waits for its result.
    pub(super) context: ItemStates<WORDS>,
    pub(super) chosen: Option<ActionId>,
    /// The trace at that choice: what is observed before its result comes may change it.
    pub(super) decided_after: Option<SyntheticId>,
    pub(super) since_harvest: u32,
    pub(super) gauge: Gauge,
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
            faculties: Faculties::new(),
            exploration: Exploration::NONE,
            config: Settings::Absent,
            rng: Rng::UNSEEDED,
            stage: Stage::Unborn,
            context: ItemStates::UNKNOWN,
            chosen: None,
            decided_after: None,
            since_harvest: 0,
            gauge: Gauge::NONE,
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
        self.config = Settings::Present(config);
        self.rng = Rng::stream(seed, 1);
        self.bank.randomize(&mut self.rng);
        self.faculties.be_born(values);
        self.exploration = Exploration::NONE;
        self.stage = Stage::Training;
        self.context = ItemStates::UNKNOWN;
        self.chosen = None;
        self.decided_after = None;
        self.since_harvest = 0;
        self.begin_health();
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
        self.born()?;
        self.begin_step();
        let Self {
            config: Settings::Present(config),
            exploration,
            rng,
            faculties,
            ..
        } = self
        else {
            return Err(AgentError::NotBorn);
        };
        let choice = if self.stage == Stage::Training && exploration.explores(config, rng) {
            random::<ACTIONS>(rng, Reason::Exploration)
        } else if exploration.escapes(config.escape.as_ref()) {
            random::<ACTIONS>(rng, Reason::Escape)
        } else {
            match faculties.prefer(config, now) {
                Some((level, preference)) => Choice {
                    action: preference.action,
                    reason: Reason::Value,
                    level: Some(level),
                    schema: preference.schema,
                    value: preference.value,
                },
                None => random::<ACTIONS>(rng, Reason::NothingApplies),
            }
        };
        self.context = *now;
        self.decided_after = self.faculties.trail.item_in(now);
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
        self.born()?;
        let action = self.chosen.ok_or(AgentError::NothingChosen)?;
        let context = self.context;
        let step = self.transition(&context, action, now);
        if let Settings::Present(config) = &self.config
            && self.stage != Stage::Acting(Adaptation::Frozen)
        {
            self.faculties.practise(config, &step, self.decided_after);
        }
        let lesson = self.take_in(&step)?;
        self.chosen = None;
        let rewarded = step.reward > 0.0;
        let relearns = self.relearns();
        if let Settings::Present(config) = &self.config
            && let Some(surprise) = config.surprise.as_ref().filter(|_| relearns)
        {
            self.faculties.feel(config, surprise, rewarded);
        }
        self.exploration.count(rewarded);
        Ok(lesson)
    }

    /// How it is doing: what it foresees, what found no room, whether it is too small.
    #[must_use]
    pub fn health(&self) -> Health {
        self.gauge.health(State {
            fullest: fullest(&self.faculties.filled()),
            alarms: self.alarms(),
            pending: false,
            bearable: BEARABLE,
        })
    }

    pub(super) fn begin_health(&mut self) {
        self.gauge.begin(self.faculties.losses());
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
        self.born()?;
        if usize::from(action.0) >= ACTIONS {
            return Err(AgentError::NoSuchAction(action));
        }
        let step = self.transition(before, action, after);
        let lesson = self.take_in(&step)?;
        if self.stage != Stage::Acting(Adaptation::Frozen) {
            self.faculties.habits.add(step.reward);
        }
        Ok(lesson)
    }

    /// What an action has led to, and what that is worth.
    fn transition(
        &self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> Transition<WORDS> {
        Transition {
            before: *before,
            action,
            after: *after,
            reward: self.faculties.knowledge.reward(after),
        }
    }

    /// The pipeline: a transition is recorded, followed to level 2, shown to its map, and a few
    /// values move.
    #[inline(never)]
    fn take_in(&mut self, step: &Transition<WORDS>) -> Result<Lesson, AgentError> {
        // What is observed while a choice waits for its result belongs to that step.
        if self.chosen.is_none() {
            self.begin_step();
        }
        let frozen = self.stage == Stage::Acting(Adaptation::Frozen);
        let relearns = self.relearns();
        let Settings::Present(config) = &self.config else {
            return Err(AgentError::NotBorn);
        };
        let relearns = relearns && config.surprise.is_some();
        let mut lesson = Lesson {
            reward: step.reward,
            outcome: self.faculties.record(config, step, relearns, frozen),
            ..Lesson::default()
        };
        let told = Told {
            foreseen: lesson.outcome.foreseen(),
            unknown: lesson.outcome.activated == 0,
        };
        self.gauge.count(told, self.faculties.losses());
        lesson.cramped = self.gauge.cramped(BEARABLE);
        self.faculties
            .follow(config, step, lesson.outcome.schema, frozen);
        if frozen {
            return Ok(lesson);
        }
        // A map would count a win for what nobody saw.
        let blind = step.before.known().is_empty() && step.after.known().is_empty();
        if self.stage != Stage::Acting(Adaptation::Reliabilities) && !blind {
            let sample = Sample::new(&step.before, &step.after, config.coding, ITEMS as u16);
            lesson.trained = self.bank.train(step.action, &sample, &config.training);
            self.since_harvest = self.since_harvest.saturating_add(1);
            lesson.harvested = self.since_harvest >= config.harvest_every;
        }
        if lesson.harvested {
            self.harvest();
        }
        if let Settings::Present(config) = &self.config {
            self.faculties.improve_values(config);
        }
        Ok(lesson)
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
        self.faculties.harvest(config, self.bank.maps());
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
        self.born()?;
        if self.stage == Stage::Training {
            self.harvest();
        }
        if let Settings::Present(config) = &self.config {
            self.faculties.settle(config);
        }
        self.stage = Stage::Acting(adaptation);
        self.faculties.habits.pause();
        self.exploration.pause();
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
        let mut cost = self.faculties.cost();
        cost.add(&self.bank.cost());
        cost
    }

    fn begin_step(&mut self) {
        self.faculties.forget_cost();
        self.bank.forget_cost();
    }

    /// Who is not born yet can do nothing.
    fn born(&self) -> Result<(), AgentError> {
        if self.stage == Stage::Unborn {
            return Err(AgentError::NotBorn);
        }
        Ok(())
    }

    /// Whether something can be learned from an alarm.
    fn relearns(&self) -> bool {
        self.stage == Stage::Acting(Adaptation::Relearning)
    }

    /// Ends a doubt that nothing can be learned from any more: acting or the configuration changed.
    fn settle_doubt(&mut self) {
        let suspects = match &self.config {
            Settings::Present(config) => config.surprise.is_some() && self.relearns(),
            Settings::Absent => false,
        };
        if !suspects {
            self.faculties.end_doubt();
        }
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
            self.faculties.trail.leave();
        }
        if config.habits.is_none() {
            self.faculties.habits.pause();
        }
        self.settle_doubt();
        Ok(())
    }

    /// Gives the agent another sense of surprise, or none, from now on; what it knows stays.
    ///
    /// # Errors
    /// [`ConfigError`]; nothing has changed.
    pub fn set_surprise(&mut self, surprise: Option<SurpriseConfig>) -> Result<(), ConfigError> {
        if let Settings::Present(config) = self.config {
            self.reconfigure(AgentConfig {
                surprise,
                ..*config
            })?;
        }
        Ok(())
    }

    /// Doubts what it knows from now on, as after an alarm.
    ///
    /// Nothing happens unless it acts, re-learns and can be surprised.
    pub fn doubt(&mut self) {
        let relearns = self.relearns();
        if let Settings::Present(config) = &self.config
            && let Some(surprise) = config.surprise.as_ref().filter(|_| relearns)
        {
            self.faculties.doubt(surprise);
        }
    }

    /// Alarms so far.
    #[must_use]
    pub const fn alarms(&self) -> u32 {
        self.faculties.alarm.alarms()
    }

    /// Whether the agent doubts what it knows: it was alarmed a short time ago.
    #[must_use]
    pub const fn doubts(&self) -> bool {
        self.faculties.alarm.doubts()
    }

    /// The second level.
    #[must_use]
    pub const fn second_level(&self) -> &SecondLevel<ACTIONS, SYNTHETIC, BELIEFS> {
        &self.faculties.level2
    }

    /// What experience says of the actions, beside the schemas.
    #[must_use]
    pub const fn habits(&self) -> &Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC> {
        &self.faculties.habits
    }

    /// The synthetic item of the schema that has just succeeded.
    #[must_use]
    pub const fn trace(&self) -> Option<SyntheticId> {
        self.faculties.trail.item()
    }

    /// What the agent knows.
    #[must_use]
    pub const fn knowledge(&self) -> &KnowledgeBase<WORDS, PATTERNS, SCHEMAS> {
        &self.faculties.knowledge
    }

    /// What the agent knows, to give inherent values or to insert schemas by hand.
    pub const fn knowledge_mut(&mut self) -> &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS> {
        &mut self.faculties.knowledge
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
}

/// An action by chance.
fn random<const ACTIONS: usize>(rng: &mut Rng, reason: Reason) -> Choice {
    Choice {
        action: ActionId(rng.below(ACTIONS as u32) as u16),
        reason,
        level: None,
        schema: None,
        value: 0.0,
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

stored_codes!(Stage {
    0: (Self::Unborn),
    1: (Self::Training),
    2: (Self::Acting(Adaptation::Frozen)),
    3: (Self::Acting(Adaptation::Reliabilities)),
    4: (Self::Acting(Adaptation::Relearning)),
});

#[cfg(test)]
#[path = "life_tests.rs"]
mod tests;
