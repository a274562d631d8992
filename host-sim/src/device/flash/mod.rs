//! A NOR flash that loses its power, and the lives of a brain that is kept in it.
//!
//! `fake` is the flash and its rules, `toy` the brain, `cuts` cuts the power everywhere, `decay` lets
//! bits rot and pages wear out, `kills` kills an emulated board.

pub mod cuts;
pub mod decay;
pub mod fake;
pub mod kills;
pub mod toy;
