//! Maps of actions: completed actions become candidate schemas (book, 5.3.1).
//!
//! One completed action is a sample [context | result]; it trains the map of its action alone;
//! a node whose weights are near 0 or 1 reads as a schema.
//! How often each item is on at all tells which negative items of a context say anything.
//! Nothing here knows of tables: after harvest no weight is read.

mod action_som;
mod base_rate;
mod harvest;
mod sample;

pub use action_som::{ActionSom, ActionSomBank, Recruitment, Trained, TrainingConfig};
pub use base_rate::BaseRates;
pub use harvest::{HarvestConfig, HarvestedNode, harvest_node};
pub use sample::{ResultCoding, Sample};
