//! The Constructivist Learning Architecture for a robot's own controller (Chaput 2004).
//!
#![doc = include_str!("../README.md")]
//!
//! The storeys, in the book's order; each knows only those before it:
//! [`snapshot`] (images of brains) →
//! [`num`] (arithmetic with the same bits everywhere) → [`som`] (self-organizing maps) →
//! [`layer`] (maps joined into hierarchies, overload, fallback) and, beside it, sensorimotor schemas:
//! [`word`] (items, actions, notation) → [`map`] (one for each action) → [`knowledge`] (the tables) →
//! [`choice`] (values, habits, rules) → [`level2`] (synthetic items) → [`adaptation`] (alarm, doubt) →
//! [`agent`] (one life); [`forager`] describes the book's robot.
//! [`growth`] is the other learner: it stands on the words alone; [`reason`] plans with its schemas, and
//! [`forest`] is one learner for any world.
//!
#![doc = include_str!("../glossary.md")]
#![no_std]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::todo,
        clippy::unimplemented,
        clippy::unreachable,
        clippy::panic_in_result_fn
    )
)]

#[cfg(test)]
extern crate std;

pub mod adaptation;
pub mod agent;
#[doc(hidden)]
pub mod brain;
pub mod check;
pub mod choice;
#[cfg(feature = "flash")]
pub mod flash;
pub mod forager;
pub mod forest;
pub mod growth;
pub mod knowledge;
pub mod layer;
pub mod level2;
pub mod map;
pub mod num;
pub mod reason;
pub mod snapshot;
pub mod som;
pub mod word;

pub use agent::{Adaptation, Agent, AgentConfig, AgentError, Choice, Lesson, Level, Reason, Stage};
pub use check::ConfigError;
pub use forest::{Mind, MindConfig};
pub use word::{
    ActionId, Health, ItemId, ItemStates as Percept, SchemaText, Threshold, Vocabulary,
};
