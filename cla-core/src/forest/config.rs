//! Everything about the learner that is a choice, in one place; one default for all worlds.

use crate::check::{Config, ConfigError, Range};

use crate::snapshot::{stored, stored_as, stored_codes};

/// Who may decide.
///
/// ```
/// use cla_core::forest::Voice;
/// assert_ne!(Voice::Trees, Voice::Habits);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Voice {
    /// Trees and habits, half each.
    TreesAndHabits,
    /// Context trees.
    Trees,
    /// Habits.
    Habits,
    /// The model of what follows what.
    Model,
    /// Model and habits, half each.
    ModelAndHabits,
    /// What reason foresees, habits where it foresees nothing; only where there is a reason.
    Plans,
}

impl Voice {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::TreesAndHabits,
        Self::Trees,
        Self::Habits,
        Self::Model,
        Self::ModelAndHabits,
        Self::Plans,
    ];
}

/// The voices that may lead; what cannot be heard learns as ever.
///
/// ```
/// use cla_core::forest::{Heard, Voice};
/// let two = Heard::only(Voice::Trees).and(Voice::Model);
/// assert!(two.contains(Voice::Model) && !two.contains(Voice::Habits));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heard(u8);

impl Heard {
    /// Those that a robot hears when it asks for nothing else.
    pub const DEFAULT: Self = Self::only(Voice::TreesAndHabits)
        .and(Voice::Habits)
        .and(Voice::Model)
        .and(Voice::ModelAndHabits)
        .and(Voice::Plans);

    pub(super) const NOBODY: Self = Self(0);

    /// One voice.
    #[must_use]
    pub const fn only(voice: Voice) -> Self {
        Self(1 << voice as u8)
    }

    /// One voice more.
    #[must_use]
    pub const fn and(self, voice: Voice) -> Self {
        Self(self.0 | 1 << voice as u8)
    }

    /// Whether a voice is heard.
    #[must_use]
    pub const fn contains(self, voice: Voice) -> bool {
        self.0 >> voice as u8 & 1 == 1
    }

    /// All but one voice.
    #[must_use]
    pub const fn without(self, voice: Voice) -> Self {
        Self(self.0 & !(1 << voice as u8))
    }

    /// Those of it that are also in another.
    pub(super) const fn among(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    pub(super) const fn bits(self) -> u8 {
        self.0
    }
}

/// A list of voices.
#[cfg(feature = "serde")]
impl serde::Serialize for Heard {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(Voice::ALL.iter().filter(|&&voice| self.contains(voice)))
    }
}

#[cfg(feature = "serde")]
impl<'a> serde::Deserialize<'a> for Heard {
    fn deserialize<D: serde::Deserializer<'a>>(from: D) -> Result<Self, D::Error> {
        struct Voices;
        impl<'a> serde::de::Visitor<'a> for Voices {
            type Value = Heard;

            fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str("a list of voices")
            }

            fn visit_seq<A: serde::de::SeqAccess<'a>>(
                self,
                mut list: A,
            ) -> Result<Heard, A::Error> {
                let mut heard = Heard::NOBODY;
                while let Some(voice) = list.next_element()? {
                    heard = heard.and(voice);
                }
                Ok(heard)
            }
        }
        from.deserialize_seq(Voices)
    }
}

/// What it does when rewards stay away.
///
/// ```
/// use cla_core::forest::{Doubting, MindConfig};
/// assert_ne!(MindConfig::DEFAULT.doubting, Doubting::Never);
/// ```
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Doubting {
    /// Nothing.
    Never,
    /// It doubts in what it knew: new experience counts for more for a while.
    WhenRewardsStayAway,
}

/// How a [`Mind`](super::Mind) learns and chooses.
///
/// ```
/// use cla_core::check::Config;
/// use cla_core::forest::MindConfig;
/// let config = MindConfig { exploring: 0.2, ..MindConfig::DEFAULT };
/// assert!(config.check().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct MindConfig {
    /// Share of random actions while training, in `[0, 1]`; with a reason they come twenty in a row.
    pub exploring: f32,
    /// The same afterwards.
    pub exploring_acting: f32,
    /// Discount of the trees, in `[0, 1)`.
    pub discount: f32,
    /// How far what was really felt reaches back in the trees, in `[0, 1]`.
    pub lambda: f32,
    /// Discount of the habits, in `[0, 1)`.
    pub habit_discount: f32,
    /// How far what was felt reaches back in habits, in `[0, 1]`.
    pub habit_lambda: f32,
    /// The share of a surprise that habits learn, in `[0, 1]`.
    pub habit_rate: f32,
    /// Remembered samples from which habits learn again after every action, 0 for none.
    pub replayed: u16,
    /// The share of a surprise that they learn then, in `[0, 1]`.
    pub replay_rate: f32,
    /// The same in a doubt, in `[0, 1]`.
    pub replay_rate_doubting: f32,
    /// The share of what habits hold things to be worth that a doubt keeps, in `[0, 1]`.
    pub kept_doubting: f32,
    /// Actions for which one voice leads, at least 1.
    pub block: u16,
    /// Share of the blocks that any voice may lead while training, in `[0, 1]`.
    pub trying: f32,
    /// The same afterwards.
    pub trying_acting: f32,
    /// Actions without reward after which it acts at random for a while, at least 1; it waits longer
    /// where rewards are rare.
    pub patience: u16,
    /// How many random actions that are.
    pub burst: u16,
    /// The same in a doubt, in `[0, 1]`.
    pub habit_rate_doubting: f32,
    /// Which voices may lead.
    pub heard: Heard,
    /// The same in a doubt; as ever where none of them may lead at all.
    pub heard_doubting: Heard,
    /// Discount of the model, in `[0, 1)`.
    pub model_discount: f32,
    /// Trials that a count of the model remembers, above 1.
    pub remembered: f32,
    /// The same in a doubt.
    pub remembered_doubting: f32,
    /// Trials that a doubt leaves of what each action led to in a state, at least 0; all of them where
    /// it is not below [`remembered`](Self::remembered).
    pub trials_doubting: f32,
    /// Actions that a doubt lasts, at least 1.
    pub doubt_lasts: u16,
    /// Whether it doubts when rewards stay away.
    pub doubting: Doubting,
    /// Trials that what is known of a percept alone weighs against what is known of the last step, above
    /// 0.
    pub prior: f32,
    /// The share of what really followed in what a state is worth, in `[0, 1]`.
    pub felt: f32,
    /// Units of the model's work a step.
    pub spread: u32,
    /// Units of work of a [`learn`](super::Mind::learn).
    pub work: u32,
}

impl MindConfig {
    /// What a robot gets when it asks for nothing else.
    pub const DEFAULT: Self = Self {
        exploring: 0.1,
        exploring_acting: 0.0,
        discount: 0.95,
        lambda: 0.8,
        habit_discount: 0.95,
        habit_lambda: 0.8,
        habit_rate: 0.03,
        replayed: 16,
        replay_rate: 0.003,
        replay_rate_doubting: 0.01,
        kept_doubting: 0.3,
        block: 50,
        trying: 0.2,
        trying_acting: 0.02,
        patience: 100,
        burst: 10,
        habit_rate_doubting: 0.1,
        heard: Heard::DEFAULT,
        heard_doubting: Heard::only(Voice::Habits).and(Voice::Plans),
        model_discount: 0.97,
        remembered: 100.0,
        remembered_doubting: 15.0,
        trials_doubting: 1.0,
        doubt_lasts: 1600,
        doubting: Doubting::WhenRewardsStayAway,
        prior: 10.0,
        felt: 0.1,
        spread: 300,
        work: 2800,
    };
}

impl Config for MindConfig {
    fn check(&self) -> Result<(), ConfigError> {
        let shares = [
            ("MindConfig::exploring", self.exploring),
            ("MindConfig::exploring_acting", self.exploring_acting),
            ("MindConfig::trying", self.trying),
            ("MindConfig::trying_acting", self.trying_acting),
            ("MindConfig::lambda", self.lambda),
            ("MindConfig::habit_lambda", self.habit_lambda),
            ("MindConfig::habit_rate", self.habit_rate),
            ("MindConfig::habit_rate_doubting", self.habit_rate_doubting),
            ("MindConfig::replay_rate", self.replay_rate),
            (
                "MindConfig::replay_rate_doubting",
                self.replay_rate_doubting,
            ),
            ("MindConfig::kept_doubting", self.kept_doubting),
            ("MindConfig::felt", self.felt),
        ];
        for (field, value) in shares {
            Range::SHARE.check(field, value)?;
        }
        let discounts = [
            ("MindConfig::discount", self.discount),
            ("MindConfig::habit_discount", self.habit_discount),
            ("MindConfig::model_discount", self.model_discount),
        ];
        for (field, value) in discounts {
            Range::BELOW_ONE.check(field, value)?;
        }
        let trials = Range::above(1.0);
        trials.check("MindConfig::remembered", self.remembered)?;
        trials.check("MindConfig::remembered_doubting", self.remembered_doubting)?;
        // What was never done in a state of which nothing else is known is worth 0 of 0 trials.
        Range::ABOVE_ZERO.check("MindConfig::prior", self.prior)?;
        Range::NOT_NEGATIVE.check("MindConfig::trials_doubting", self.trials_doubting)?;
        let lasts = f32::from(self.doubt_lasts);
        Range::AT_LEAST_ONE.check("MindConfig::doubt_lasts", lasts)?;
        Range::AT_LEAST_ONE.check("MindConfig::block", f32::from(self.block))?;
        Range::AT_LEAST_ONE.check("MindConfig::patience", f32::from(self.patience))?;
        Range::AT_LEAST_ONE.check("MindConfig::heard", f32::from(self.heard.bits()))?;
        let doubting = f32::from(self.heard_doubting.bits());
        Range::AT_LEAST_ONE.check("MindConfig::heard_doubting", doubting)
    }
}

/// The all-zero configuration of the unborn.
pub(super) const NO_CONFIG: MindConfig = MindConfig {
    exploring: 0.0,
    exploring_acting: 0.0,
    discount: 0.0,
    lambda: 0.0,
    habit_discount: 0.0,
    habit_lambda: 0.0,
    habit_rate: 0.0,
    replayed: 0,
    replay_rate: 0.0,
    replay_rate_doubting: 0.0,
    kept_doubting: 0.0,
    habit_rate_doubting: 0.0,
    remembered_doubting: 0.0,
    trials_doubting: 0.0,
    doubt_lasts: 0,
    heard_doubting: Heard::NOBODY,
    doubting: Doubting::Never,
    block: 0,
    trying: 0.0,
    trying_acting: 0.0,
    patience: 0,
    burst: 0,
    heard: Heard::NOBODY,
    model_discount: 0.0,
    remembered: 0.0,
    prior: 0.0,
    felt: 0.0,
    spread: 0,
    work: 0,
};

stored_as!(impl[] Heard);
stored_codes!(Doubting {
    0: (Self::Never),
    1: (Self::WhenRewardsStayAway)
});
stored! {
    impl[] MindConfig {
        exploring, exploring_acting, discount, lambda, habit_discount, habit_lambda, habit_rate,
        replayed, replay_rate, replay_rate_doubting, kept_doubting, block, trying, trying_acting, patience, burst, habit_rate_doubting, heard, heard_doubting, model_discount,
        remembered, remembered_doubting, trials_doubting, doubt_lasts, doubting, prior, felt, spread, work
    }
    sound |it, _limits| it.check().is_ok()
}

#[cfg(test)]
#[path = "config_tests.rs"]
mod tests;
