//! What a mind says of a step: the action it chose and why, what it was taught, what it cannot do;
//! and the actions that a choice is made among.

use core::fmt;

use super::config::Voice;
use crate::check::ConfigError;
use crate::snapshot::{stored, stored_codes};
use crate::word::{ActionId, ItemId};

/// The greatest reward, and the greatest harm, of one action.
pub const MOST_REWARD: f32 = 1.0e4;

/// The most that a step brings: an item's worth for each of fewer than 255, and a reward beside.
pub(super) const MOST_EARNED: f32 = 256.0 * MOST_REWARD;

/// The most that anything is worth: more than the most of every step, for ever, where the future is
/// discounted by as little as a number can tell.
pub(super) const MOST_WORTH: f32 = 1.0e14;

/// The most that squared differences of what samples are worth sum up to.
pub(super) const MOST_SQUARES: f32 = 65_536.0 * 4.0 * MOST_WORTH * MOST_WORTH;

/// A set of actions, for a choice among some of them.
///
/// ```
/// use cla_core::word::ActionId;
/// use cla_core::forest::Actions;
/// let some = Actions::NONE.with(ActionId(2)).with(ActionId(5));
/// assert!(some.contains(ActionId(2)) && !some.contains(ActionId(3)));
/// assert!(Actions::ALL.without(ActionId(3)).contains(ActionId(4)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Actions(u32);

impl Actions {
    /// Every action.
    pub const ALL: Self = Self(u32::MAX);
    /// No action.
    pub const NONE: Self = Self(0);

    const fn bit(action: ActionId) -> u32 {
        if action.0 < 32 { 1 << action.0 } else { 0 }
    }

    /// With an action more; actions above 31 do not exist.
    #[must_use]
    pub const fn with(self, action: ActionId) -> Self {
        Self(self.0 | Self::bit(action))
    }

    /// Without an action.
    #[must_use]
    pub const fn without(self, action: ActionId) -> Self {
        Self(self.0 & !Self::bit(action))
    }

    /// Whether an action is in the set.
    #[must_use]
    pub const fn contains(self, action: ActionId) -> bool {
        self.0 & Self::bit(action) != 0
    }
}

/// What an action is chosen for.
///
/// ```
/// use cla_core::forest::{Motive, Voice};
/// assert_ne!(Motive::Voice(Voice::Trees), Motive::Chance);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Motive {
    /// This voice says so.
    Voice(Voice),
    /// It tries something.
    Chance,
    /// Nothing was earned for so long that anything else is better.
    Escape,
    /// It leads to the goal that is pursued.
    Goal,
}

/// An action, and why.
///
/// ```
/// use cla_core::word::{ActionId, ItemStates};
/// use cla_core::forest::{Mind, MindConfig};
/// let mut mind = Mind::<1, 2, 3, 16, 32, 32, 64, 256>::new();
/// mind.be_born(MindConfig::DEFAULT, [0.0, 1.0], 7)?;
/// let choice = mind.choose(&ItemStates::all_off(2))?;
/// assert!(choice.action < ActionId(3));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Deliberation {
    /// What to do.
    pub action: ActionId,
    /// What the leading voice holds it to be worth, in discounted rewards.
    pub value: f32,
    /// Who decided.
    pub motive: Motive,
}

/// The last choice, if any. Not an `Option`: none of those would be all zero, and a static mind must be,
/// or its whole memory is copied from flash.
#[derive(Clone, Copy, Debug)]
pub(super) struct Said {
    there: bool,
    choice: Deliberation,
}

impl Said {
    pub(super) const NOTHING: Self = Self {
        there: false,
        choice: Deliberation {
            action: ActionId(0),
            value: 0.0,
            motive: Motive::Voice(Voice::TreesAndHabits),
        },
    };

    pub(super) const fn of(choice: Deliberation) -> Self {
        Self {
            there: true,
            choice,
        }
    }

    pub(super) const fn get(self) -> Option<Deliberation> {
        if self.there { Some(self.choice) } else { None }
    }
}

/// Why a mind cannot do what it is asked.
///
/// ```
/// use cla_core::word::ItemStates;
/// use cla_core::forest::{Mind, MindError};
/// let mut mind = Mind::<1, 2, 3, 16, 32, 32, 64, 256>::new();
/// assert_eq!(mind.learn(&ItemStates::all_off(2)), Err(MindError::Unborn));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MindError {
    /// It was never born; nothing was learned.
    Unborn,
    /// The configuration cannot work; it is as it was.
    Config(ConfigError),
    /// A reward, or what an item is worth, is no number or beyond [`MOST_REWARD`]; nothing was
    /// learned.
    Reward,
    /// No action is allowed; nothing was chosen.
    NothingAllowed,
    /// Nothing was chosen whose result this could be; nothing was learned.
    NothingChosen,
    /// There is no such action; nothing was learned.
    NoSuchAction(ActionId),
    /// There is no such item; nothing has changed.
    NoSuchItem(ItemId),
    /// It has no reason that could pursue a goal.
    NoReason,
}

impl fmt::Display for MindError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unborn => f.write_str("the mind was never born"),
            Self::Config(error) => error.fmt(f),
            Self::Reward => write!(
                f,
                "a reward is a number from −{MOST_REWARD} to {MOST_REWARD}"
            ),
            Self::NothingAllowed => f.write_str("no action is allowed"),
            Self::NothingChosen => f.write_str("nothing was chosen whose result this could be"),
            Self::NoSuchAction(action) => write!(f, "there is no action {}", action.0),
            Self::NoSuchItem(item) => write!(f, "there is no item {}", item.0),
            Self::NoReason => f.write_str("it has no reason that could pursue a goal"),
        }
    }
}

impl core::error::Error for MindError {}

/// What a step has taught.
///
/// ```
/// use cla_core::word::ItemStates;
/// use cla_core::forest::{Mind, MindConfig};
/// let mut mind = Mind::<1, 2, 3, 16, 32, 32, 64, 256>::new();
/// mind.be_born(MindConfig::DEFAULT, [0.0, 1.0], 7)?;
/// mind.choose(&ItemStates::all_off(2))?;
/// let taught = mind.learn_with(&ItemStates::all_off(2), -0.5)?;
/// assert_eq!(taught.reward, -0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Taught {
    /// What the action brought: the values of the items that are on, and what was given beside.
    pub reward: f32,
    /// Whether other items matter from now on.
    pub refocused: bool,
    /// Whether larger tables are likely to bring more: see [`Health`](crate::word::Health).
    pub cramped: bool,
}

/// Whether a reward, or what an item is worth, is a number that may be learned from.
pub(super) fn check_reward(reward: f32) -> Result<(), MindError> {
    if (-MOST_REWARD..=MOST_REWARD).contains(&reward) {
        Ok(())
    } else {
        Err(MindError::Reward)
    }
}

stored! { impl[] Deliberation { action, value, motive } }
stored! { impl[] Said { there, choice } }
stored_codes!(Motive {
    0: (Self::Voice(Voice::TreesAndHabits)),
    1: (Self::Voice(Voice::Trees)),
    2: (Self::Voice(Voice::Habits)),
    3: (Self::Voice(Voice::Model)),
    4: (Self::Voice(Voice::ModelAndHabits)),
    5: (Self::Chance),
    6: (Self::Escape),
    7: (Self::Goal),
    8: (Self::Voice(Voice::Plans)),
});
