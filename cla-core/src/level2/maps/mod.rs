//! The second level as the book has it: from Action SOMs of its own (5.3.1, 6.2.6).
//!
//! Maps see what has just succeeded beside the percept; their nodes count what the next action
//! reveals; nodes that say the same are read into one level-2 schema, and its counters imply beliefs.

mod config;
mod implication;
mod labels;
mod reading;
mod som_level;

pub use config::SomLevelConfig;
pub use implication::Reading;
pub use som_level::{Learning, SomLevel, SomLevelLosses};
