//! Level 2: synthetic items made from the schemas of level 1, and beliefs about them (5.1.1, 6.2.6).
//!
//! A schema's synthetic item is the state in which it would succeed.
//! Whether it was on is known in hindsight; it is believed from the past alone, by which schema has
//! just succeeded.
//! [`SecondLevel`] counts beliefs in a table of its own; [`SomLevel`] is the book's form, harvested
//! from maps, and stands beside an agent whose own second level is off.

mod audit;
mod belief;
mod carried;
mod config;
mod maps;
mod rates;
mod second_level;

pub use belief::{Belief, BeliefLosses};
pub use config::{Fallback, Level2Config};
pub use maps::{Learning, Reading, SomLevel, SomLevelConfig, SomLevelLosses};
pub use second_level::SecondLevel;
