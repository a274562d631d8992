//! What a brain costs on a microcontroller: counted on emulated boards, estimated on the host, held
//! against a budget.
//!
//! `target` names the processors, `board` builds and runs firmware for them, `meter` weighs what a
//! step has touched, `budget` is what a user allows; `flash` is a NOR flash that loses its power.

pub mod board;
pub mod budget;
pub mod flash;
pub mod meter;
pub mod target;
