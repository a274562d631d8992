//! Worlds, experiments and reports around `cla-core`.

pub mod experiment;
pub mod world;
