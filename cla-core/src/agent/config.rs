//! Everything about an agent that is a choice, in one place, with the book's values by name.

use crate::adaptation::SurpriseConfig;
use crate::check::{ConfigError, is_share};
use crate::choice::{ChoiceRule, HabitConfig, ValueConfig};
use crate::level2::Level2Config;
use crate::map::{HarvestConfig, ResultCoding, TrainingConfig};

/// How an agent learns and chooses.
///
/// ```
/// use cla_core::agent::AgentConfig;
/// use cla_core::choice::ChoiceRule;
/// let config = AgentConfig { rule: ChoiceRule::Lexicographic, ..AgentConfig::FORAGER };
/// assert!(config.check().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AgentConfig {
    /// How maps are trained.
    pub training: TrainingConfig,
    /// How maps are read.
    pub harvest: HarvestConfig,
    /// How results are written into maps.
    pub coding: ResultCoding,
    /// Learned actions between two harvests, at least 1.
    pub harvest_every: u32,
    /// How values spread.
    pub values: ValueConfig,
    /// Patterns whose expected value is brought up to date at every step.
    pub values_per_step: u16,
    /// By which rule an action is chosen.
    pub rule: ChoiceRule,
    /// The least weight of a new trial in a recent reliability, in `[0, 1]`; 0 never forgets.
    pub forgetting: f32,
    /// In training, the share of actions chosen by value; the others are random (book: .2, 6.2.3).
    pub greedy_share: f32,
    /// Actions in a row that training chooses the same way, by value or at random; at least 1.
    /// With 1 (the book's reading) a robot never follows its own policy for more than a moment, so
    /// it never sees the states that this policy leads to.
    pub training_run: u16,
    /// Alarms of an agent that acts and re-learns, and what follows; without it nothing is doubted.
    pub surprise: Option<SurpriseConfig>,
    /// A way out of loops; without it a robot may shuttle forever.
    pub escape: Option<Escape>,
    /// The second level; without it level 1 decides alone.
    pub level2: Option<Level2Config>,
    /// What experience says beside the schemas; without it they decide alone.
    pub habits: Option<HabitConfig>,
}

/// What goes on learning while an agent acts (book, 6.3 and 7.1.1).
///
/// ```
/// use cla_core::agent::Adaptation;
/// assert_ne!(Adaptation::Frozen, Adaptation::Reliabilities);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Adaptation {
    /// Nothing.
    Frozen,
    /// Reliabilities and the values that follow from them: the book's recovery (6.3); with a second
    /// level and habits also beliefs and what was felt.
    Reliabilities,
    /// Maps and schemas too (7.1.1).
    Relearning,
}

/// Random actions after a long time without reward.
///
/// The same coarse percept can hide different places, and a deterministic choice repeats itself.
///
/// ```
/// use cla_core::agent::Escape;
/// assert_eq!(Escape { after: 60, burst: 10 }.burst, 10);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Escape {
    /// Actions without reward before a burst.
    pub after: u16,
    /// Random actions in a burst.
    pub burst: u16,
}

/// A configuration, once there is one; like an `Option` whose `None` is zero, which an `Option`
/// of something with a tag inside is not.
#[repr(u8)]
#[derive(Clone, Copy, Debug)]
pub(crate) enum Settings {
    Absent,
    Present(AgentConfig),
}

impl AgentConfig {
    /// The book's forager: straight schedules, thresholds .1 and .9 on every node, the
    /// lexicographic rule over plain reliabilities (6.2).
    pub const BOOK: Self = Self {
        training: TrainingConfig::BOOK,
        harvest: HarvestConfig::BOOK,
        coding: ResultCoding::EndState,
        harvest_every: 250,
        values: ValueConfig::BOOK,
        values_per_step: 0,
        rule: ChoiceRule::Lexicographic,
        forgetting: 0.0,
        greedy_share: 0.2,
        training_run: 1,
        surprise: None,
        escape: None,
        level2: None,
        habits: None,
    };

    /// What works best on the simulated Pioneer: rare events recruited, expected value, escape.
    pub const FORAGER: Self = Self {
        training: TrainingConfig::FORAGER,
        harvest: HarvestConfig::FORAGER,
        values: ValueConfig::FORAGER,
        values_per_step: 4,
        forgetting: 0.01,
        training_run: 50,
        rule: ChoiceRule::ExpectedValue,
        escape: Some(Escape {
            after: 100,
            burst: 10,
        }),
        ..Self::BOOK
    };

    /// The forager with both levels and habits: the second needs to see where the robot's own ways
    /// lead, so nine actions of ten are greedy, and every tenth tries something else on the way.
    pub const FORAGER_LEVEL2: Self = Self {
        greedy_share: 0.9,
        training_run: 1,
        level2: Some(Level2Config::FORAGER),
        habits: Some(HabitConfig::FORAGER),
        ..Self::FORAGER
    };

    /// A forager that notices when its predictions fail, and learns anew what no longer holds.
    pub const RESILIENT: Self = Self {
        surprise: Some(SurpriseConfig::FORAGER),
        ..Self::FORAGER
    };

    /// Both levels, habits and surprise: for a robot that must go on when something breaks.
    ///
    /// ```
    /// use cla_core::agent::AgentConfig;
    /// let it = AgentConfig::RESILIENT_LEVEL2;
    /// assert!(it.surprise.is_some() && it.level2.is_some() && it.habits.is_some());
    /// ```
    pub const RESILIENT_LEVEL2: Self = Self {
        surprise: Some(SurpriseConfig::FORAGER),
        ..Self::FORAGER_LEVEL2
    };

    /// Whether the values make sense together.
    ///
    /// # Errors
    /// The first [`ConfigError`] found.
    pub fn check(&self) -> Result<(), ConfigError> {
        if !is_share(self.greedy_share) {
            return Err(ConfigError::GreedyShare);
        }
        if !is_share(self.forgetting) {
            return Err(ConfigError::Forgetting);
        }
        if !(0.0..1.0).contains(&self.values.discount) {
            return Err(ConfigError::Discount);
        }
        let relevance = self.values.chain_relevance;
        if !is_share(self.values.chain_reliability) || !relevance.is_finite() || relevance < 0.0 {
            return Err(ConfigError::Chain);
        }
        if self.escape.is_some_and(|it| it.after == 0 || it.burst == 0) {
            return Err(ConfigError::Escape);
        }
        if self.level2.is_some_and(|it| !it.is_sound()) {
            return Err(ConfigError::Level2);
        }
        if self.surprise.is_some_and(|it| !it.is_valid()) {
            return Err(ConfigError::Surprise);
        }
        if self.habits.is_some_and(|it| !it.is_sound()) {
            return Err(ConfigError::Habits);
        }
        self.harvest.check()?;
        if self.harvest_every == 0 || self.training_run == 0 {
            return Err(ConfigError::NoActions);
        }
        self.training.check()?;
        Ok(())
    }
}
