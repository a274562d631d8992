//! Worlds, experiments and reports around `cla-core`.

pub mod world;
