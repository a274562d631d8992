//! Everything about an agent that is a choice, in one place, with the book's values by name.

use crate::adaptation::SurpriseConfig;
use crate::check::{Checked, Config, ConfigError, Range, check_some};
use crate::choice::{ChoiceRule, HabitConfig, ValueConfig};
use crate::level2::Level2Config;
use crate::map::{HarvestConfig, ResultCoding, TrainingConfig};
use crate::snapshot::{Flip, Mender, Reader, Stored, Writer, stored};
use crate::word::ItemId;

/// How an agent learns and chooses.
///
/// ```
/// use cla_core::AgentConfig;
/// use cla_core::check::Config;
/// use cla_core::choice::ChoiceRule;
/// let config = AgentConfig { rule: ChoiceRule::Lexicographic, ..AgentConfig::FORAGER };
/// assert!(config.check().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
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
    /// Patterns whose expected value is brought up to date at every step; more than 1024 count as that, so
    /// that a step ends whoever wrote the configuration.
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
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
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
/// In the field: a burst of random exploration.
///
/// The same coarse percept can hide different places, and a deterministic choice repeats itself.
///
/// ```
/// use cla_core::agent::Escape;
/// assert_eq!(Escape { after: 60, burst: 10 }.burst, 10);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
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
    Present(Checked<AgentConfig>),
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
    ///
    /// It stays what it is, for comparison; its habits drift after some million actions
    /// ([`Traces::Replacing`](crate::choice::Traces::Replacing)), those of
    /// [`FORAGER_LASTING`](Self::FORAGER_LASTING) do not.
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
    /// Its habits drift after some million actions, as those of [`FORAGER_LEVEL2`](Self::FORAGER_LEVEL2);
    /// [`RESILIENT_LASTING`](Self::RESILIENT_LASTING) is for a robot that is not switched off.
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

    /// Both levels for a life without an end: habits whose traces accumulate.
    pub const FORAGER_LASTING: Self = Self {
        habits: Some(HabitConfig::LASTING),
        ..Self::FORAGER_LEVEL2
    };

    /// Both levels, surprise and habits that last: for a robot that must go on when something breaks, for
    /// millions of actions.
    ///
    /// ```
    /// use cla_core::agent::AgentConfig;
    /// assert!(AgentConfig::RESILIENT_LASTING.habits != AgentConfig::RESILIENT_LEVEL2.habits);
    /// ```
    pub const RESILIENT_LASTING: Self = Self {
        surprise: Some(SurpriseConfig::FORAGER),
        ..Self::FORAGER_LASTING
    };
}

impl Config for Escape {
    fn check(&self) -> Result<(), ConfigError> {
        Range::AT_LEAST_ONE.check("Escape::after", f32::from(self.after))?;
        Range::AT_LEAST_ONE.check("Escape::burst", f32::from(self.burst))
    }
}

impl Config for AgentConfig {
    fn check(&self) -> Result<(), ConfigError> {
        self.training.check()?;
        self.harvest.check()?;
        let every = self.harvest_every as f32;
        Range::AT_LEAST_ONE.check("AgentConfig::harvest_every", every)?;
        self.values.check()?;
        Range::SHARE.check("AgentConfig::forgetting", self.forgetting)?;
        Range::SHARE.check("AgentConfig::greedy_share", self.greedy_share)?;
        Range::AT_LEAST_ONE.check("AgentConfig::training_run", f32::from(self.training_run))?;
        check_some(&self.surprise)?;
        check_some(&self.escape)?;
        check_some(&self.level2)?;
        check_some(&self.habits)
    }
}

/// Whether something is worth having, and all that is has a value and is one of `items` items.
pub(crate) fn check_values(values: &[(ItemId, f32)], items: usize) -> Result<(), ConfigError> {
    let mut most = 0.0;
    for &(item, value) in values {
        Range::below(items as f32).check("values: an item", f32::from(item.0))?;
        Range::VALUE.check("values: a value", value)?;
        if value > most {
            most = value;
        }
    }
    Range::ABOVE_ZERO.check("values: the largest", most)
}

stored! {
    impl[] AgentConfig {
        training, harvest, coding, harvest_every, values, values_per_step, rule, forgetting,
        greedy_share, training_run, surprise, escape, level2, habits
    }
    sound |it, _limits| it.check().is_ok()
}
stored! { impl[] Escape { after, burst } }
impl Stored for Settings {
    const BLANK: Self = Self::Absent;

    fn store(&self, to: &mut Writer<'_>) {
        match self {
            Self::Absent => to.refuse(),
            Self::Present(config) => config.store(to),
        }
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        let mut config = AgentConfig::BLANK;
        config.restore(from);
        match config.checked() {
            Ok(config) => *self = Self::Present(config),
            Err(_) => from.refuse(),
        }
    }

    // What cannot work is not replaced: nobody else knows what was meant.
    fn mend(&mut self, _: &mut Mender) {}

    fn flip(&mut self, by: &mut Flip) {
        if let Self::Present(config) = self {
            config.0.flip(by);
        }
    }
}
