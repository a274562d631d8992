//! Adaptation: how an agent notices that the world has changed, and what it then still believes.
//!
//! Reward that stays away rings an alarm; after it every prediction is doubted for a while, and the
//! evidence decides how much of each survives (the book leaves this open, 7.1.1).

mod alarm;
mod doubt;

pub use alarm::SurpriseConfig;

pub(crate) use alarm::Alarm;
