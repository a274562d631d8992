//! The tables: every schema, in fixed memory, and everything that may write one (5.3.1, 6.2.4).
//!
//! Harvest fills them with what the maps say, each prediction is recorded as right or wrong, and
//! which schemas apply in a state is found by their contexts.
//! A row also holds the mark of its synthetic item and what it keeps in a doubt; who uses these
//! stands above.
//! This is all that a robot needs to act.

mod applicable;
mod audit;
mod carried;
mod chains;
mod harvest;
mod record;
mod reliability;
mod schema;
mod tables;

pub use record::Outcome;
pub use reliability::{Estimate, Reliability};
pub use schema::{Doubt, PatternId, Schema, SchemaId, SyntheticId};
pub use tables::{KnowledgeBase, Losses, TableFull};

pub(crate) use applicable::Others;
