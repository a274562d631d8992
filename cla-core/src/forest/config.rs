//! Everything about the learner that is a choice, in one place; one default for all worlds.

use core::fmt;

use crate::snapshot::{stored, stored_as, stored_codes};

/// Who may decide.
///
/// ```
/// use cla_core::forest::Voice;
/// assert_ne!(Voice::Trees, Voice::Habits);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

    pub(super) const fn bits(self) -> u8 {
        self.0
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
pub enum Doubting {
    /// Nothing.
    Never,
    /// It doubts in what it knew: new experience counts for more for a while.
    WhenRewardsStayAway,
}

/// How a [`Mind`](super::Mind) learns and chooses.
///
/// ```
/// use cla_core::forest::MindConfig;
/// let config = MindConfig { exploring: 0.2, ..MindConfig::DEFAULT };
/// assert!(config.check().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MindConfig {
    /// Share of random actions while training, in `[0, 1]`.
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
    /// Discount of the model, in `[0, 1)`.
    pub model_discount: f32,
    /// Trials that a count of the model remembers, above 1.
    pub remembered: f32,
    /// The same in a doubt.
    pub remembered_doubting: f32,
    /// Whether it doubts when rewards stay away.
    pub doubting: Doubting,
    /// Trials that what is known of a percept alone weighs against what is known of the last step, at
    /// least 0.
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
        habit_discount: 0.85,
        habit_lambda: 0.8,
        habit_rate: 0.03,
        block: 50,
        trying: 0.2,
        trying_acting: 0.02,
        patience: 100,
        burst: 10,
        habit_rate_doubting: 0.2,
        heard: Heard::DEFAULT,
        model_discount: 0.95,
        remembered: 100.0,
        remembered_doubting: 15.0,
        doubting: Doubting::WhenRewardsStayAway,
        prior: 2.0,
        felt: 0.25,
        spread: 300,
        work: 3000,
    };

    /// Whether it can work.
    ///
    /// # Errors
    /// [`MindConfigError`] names what cannot.
    pub fn check(&self) -> Result<(), MindConfigError> {
        let share = |value: f32| (0.0..=1.0).contains(&value);
        let shares = [
            self.exploring,
            self.exploring_acting,
            self.trying,
            self.trying_acting,
        ];
        if !shares.into_iter().all(share) {
            return Err(MindConfigError::Share);
        }
        let rates = [
            self.lambda,
            self.habit_lambda,
            self.habit_rate,
            self.habit_rate_doubting,
            self.felt,
        ];
        if !rates.into_iter().all(share) {
            return Err(MindConfigError::Rate);
        }
        let below_one = |value: f32| (0.0..1.0).contains(&value);
        let discounts = [self.discount, self.habit_discount, self.model_discount];
        if !discounts.into_iter().all(below_one) {
            return Err(MindConfigError::Discount);
        }
        let trials = |value: f32| value.is_finite() && value > 1.0;
        if !trials(self.remembered)
            || !trials(self.remembered_doubting)
            || !self.prior.is_finite()
            || self.prior < 0.0
        {
            return Err(MindConfigError::Trials);
        }
        if self.heard == Heard::NOBODY {
            return Err(MindConfigError::Nobody);
        }
        if self.block == 0 || self.patience == 0 {
            return Err(MindConfigError::NoActions);
        }
        Ok(())
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
    habit_rate_doubting: 0.0,
    remembered_doubting: 0.0,
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

/// What cannot work in a [`MindConfig`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MindConfigError {
    /// A share is outside `[0, 1]` or NaN.
    Share,
    /// A λ or a rate is outside `[0, 1]` or NaN.
    Rate,
    /// A discount is outside `[0, 1)` or NaN.
    Discount,
    /// Remembered trials are not above 1, or a prior is negative, or NaN.
    Trials,
    /// No voice is heard.
    Nobody,
    /// A block or a patience of 0 actions.
    NoActions,
}

impl fmt::Display for MindConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Share => "a share of actions is outside 0 to 1",
            Self::Rate => "a rate or λ is outside 0 to 1",
            Self::Discount => "a discount is outside 0 to below 1",
            Self::Trials => "more than one trial is remembered, and a prior is at least 0",
            Self::Nobody => "no voice is heard",
            Self::NoActions => "a block and a patience have at least one action",
        })
    }
}

impl core::error::Error for MindConfigError {}

stored_as!(impl[] Heard);
stored_codes!(Doubting {
    0: (Self::Never),
    1: (Self::WhenRewardsStayAway)
});
stored! {
    impl[] MindConfig {
        exploring, exploring_acting, discount, lambda, habit_discount, habit_lambda, habit_rate,
        block, trying, trying_acting, patience, burst, habit_rate_doubting, heard, model_discount,
        remembered, remembered_doubting, doubting, prior, felt, spread, work
    }
    sound |it, _limits| it.check().is_ok()
}

#[cfg(test)]
#[path = "config_tests.rs"]
mod tests;
