//! Any world in Cassandra's `.POMDP` format: its observations are items, its rewards a number beside
//! the percept.
//!
//! [`Pomdp`] is what a file says, [`PomdpWorld`] a life in it, [`planner`] the best that can be done
//! by who knows the file but not the state.

mod entries;
mod model;
mod parse;
mod parser;
pub mod planner;
mod words;
mod world;

pub use model::{Pomdp, SHUTTLE};
pub use words::{Place, PomdpError};
pub use world::{PomdpWorld, shuttle};

#[cfg(test)]
#[path = "pomdp_tests.rs"]
mod tests;
