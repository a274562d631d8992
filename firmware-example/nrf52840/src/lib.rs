//! A cart with two wheels that looks for its charger: what it is, how its sensors become items, and who
//! moves it when the brain is late. Nothing here knows the part; `main.rs` does.
#![no_std]

pub mod pace;
pub mod robot;
