//! The book's experiments, one module each: what is run, what is claimed.

pub mod angle;
pub mod calibrate;
pub mod causal;
pub mod forage;
pub mod mcu;
pub mod microworld;
pub mod recover;
