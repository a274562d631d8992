//! The agent: one life that senses, chooses and learns (book, 6.2).
//!
//! A control step is a pipeline through all storeys below: what applies and what it is worth decides;
//! what came of it is one transition, which is recorded, followed to level 2, shown to its map, and
//! moves a few values; now and then the maps are harvested.
//! The agent has the turns and the stage of a life, and beside its maps its faculties, which know
//! and prefer; chance and the trail of what has succeeded are small states of their own.

mod audit;
mod config;
mod exploring;
mod faculties;
mod image;
mod knowledge;
mod life;
mod step;
mod trail;

pub use crate::snapshot::Audit;
pub use config::{Adaptation, AgentConfig, Escape};
pub use life::{Agent, Stage};
pub use step::{AgentError, Choice, Lesson, Level, Reason};
