//! Worlds, experiments and reports around `cla-core`.

pub mod baseline;
pub mod budget;
pub mod cli;
pub mod experiment;
pub mod learner;
pub mod meter;
pub mod options;
pub mod progress;
pub mod report;
pub mod world;
