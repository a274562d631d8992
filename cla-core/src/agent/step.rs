//! What an agent says of a control step: its choice, its lesson, or why it refused.

use core::fmt;

use crate::knowledge::{Outcome, SchemaId};
use crate::map::Trained;
use crate::word::{ActionId, ItemStates};

/// A completed action: made once for each, and handed from part to part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Transition<const WORDS: usize> {
    pub(super) before: ItemStates<WORDS>,
    pub(super) action: ActionId,
    pub(super) after: ItemStates<WORDS>,
    /// The inherent value of what is on afterwards.
    pub(super) reward: f32,
}

/// Why an action was chosen.
///
/// ```
/// use cla_core::agent::Reason;
/// assert_ne!(Reason::Value, Reason::Exploration);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Reason {
    /// It is the best by the rule.
    Value,
    /// Training asked for a random action.
    Exploration,
    /// No schema that promises anything applies: random.
    NothingApplies,
    /// Too long without reward: random.
    Escape,
}

/// A level of the hierarchy of schemas.
///
/// ```
/// use cla_core::agent::Level;
/// assert!(Level::One < Level::Two);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Level {
    /// Schemas of primitive items.
    One,
    /// Schemas with synthetic items.
    Two,
}

/// A chosen action.
///
/// ```
/// use cla_core::agent::{Choice, Reason};
/// use cla_core::word::ActionId;
/// let it = Choice { action: ActionId(0), reason: Reason::Escape, level: None, schema: None, value: 0.0 };
/// assert_eq!(it.schema, None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Choice {
    /// What to do.
    pub action: ActionId,
    /// Why.
    pub reason: Reason,
    /// The level that decided; `None` for a random action.
    pub level: Option<Level>,
    /// The schema that speaks for it most, when the choice was by value.
    pub schema: Option<SchemaId>,
    /// The value that decided; 0 for a random action.
    pub value: f32,
}

/// What one completed action taught.
///
/// ```
/// let it = cla_core::agent::Lesson::default();
/// assert_eq!(it.reward, 0.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lesson {
    /// Inherent value of what is on now.
    pub reward: f32,
    /// How the predictions fared.
    pub outcome: Outcome,
    /// What the action's map did; `None` when maps are at rest.
    pub trained: Option<Trained>,
    /// Whether the maps were harvested.
    pub harvested: bool,
    /// Whether larger tables are likely to bring more: see [`Health`](crate::word::Health).
    pub cramped: bool,
}

/// A call out of turn; nothing has changed.
///
/// ```
/// use cla_core::agent::AgentError;
/// assert_eq!(AgentError::NotBorn.to_string(), "the agent is not born: call be_born first");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AgentError {
    /// [`Agent::be_born`](super::Agent::be_born) was not called.
    NotBorn,
    /// [`Agent::learn`](super::Agent::learn) without a [`Agent::choose`](super::Agent::choose) before
    /// it.
    NothingChosen,
    /// The action is not one of the robot's.
    NoSuchAction(ActionId),
}

impl fmt::Display for AgentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotBorn => f.write_str("the agent is not born: call be_born first"),
            Self::NothingChosen => f.write_str("no action is waiting for its result"),
            Self::NoSuchAction(action) => write!(f, "the robot has no action {}", action.0),
        }
    }
}

impl core::error::Error for AgentError {}
