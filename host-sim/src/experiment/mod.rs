//! The book's experiments, a folder each, on one plan: options, trial, claims, tables, figures.

pub mod angle;
pub mod calibrate;
pub mod causal;
pub mod forage;
pub mod hil;
pub mod mcu;
pub mod microworld;
pub mod noted;
pub mod plan;
pub mod record;
pub mod recover;
