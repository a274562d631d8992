//! Worlds, experiments and reports around `cla-core`.

pub mod baseline;
pub mod cli;
pub mod device;
pub mod experiment;
pub mod failure;
pub mod keeping;
pub mod learner;
pub mod logs;
pub mod options;
pub mod progress;
pub mod report;
pub mod settings;
pub mod whole;
pub mod world;
