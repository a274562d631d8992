//! The agent: one life that senses, chooses and learns (book, 6.2).
//!
//! A control step goes through all storeys below: what applies and what it is worth decides, what
//! came of it is recorded, trains a map and moves a few values; now and then the maps are harvested.

mod config;
mod deciding;
mod doubting;
mod life;
mod step;

pub use config::{Adaptation, AgentConfig, Escape};
pub use life::{Agent, Stage};
pub use step::{AgentError, Choice, Lesson, Level, Reason};
