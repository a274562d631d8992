//! Any world in Cassandra's `.POMDP` format: its observations are items, its rewards a number beside
//! the percept.
//!
//! [`Pomdp`] is what a file says, [`CHEESE`], [`t_maze`] and [`hallway`] are some of the literature,
//! [`PomdpWorld`] is a life in one, [`planner`] the best that can be done
//! by who knows the file but not the state.

mod entries;
mod mazes;
mod model;
mod parse;
mod parser;
pub mod planner;
mod words;
mod world;

pub use mazes::{CHEESE, hallway, t_maze};
pub use model::{Pomdp, SHUTTLE};
pub use words::{Place, PomdpError};
pub use world::{PomdpWorld, shuttle};

#[cfg(test)]
#[path = "pomdp_tests.rs"]
mod tests;
