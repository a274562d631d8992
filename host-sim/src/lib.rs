//! Worlds, experiments and reports around `cla-core`.

pub mod baseline;
pub mod experiment;
pub mod report;
pub mod world;
