#![no_std]
//! What the firmware does, apart from the board it does it on.
//!
//! The host runs the same [`relive`](replay::relive) on the same recorded [`trace`], and a test
//! compares the two to the bit.

#[cfg(target_os = "none")]
pub mod board;
pub mod fingerprint;
pub mod replay;
pub mod trace;
