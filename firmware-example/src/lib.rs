#![no_std]
//! What the firmware does, apart from the board it does it on.
//!
//! The host runs the same [`relive`](replay::relive) on the same recorded [`trace`], and a test
//! compares the two to the bit.

#[cfg(target_os = "none")]
pub mod board;
pub mod controller;
pub mod fingerprint;
pub mod link;
pub mod replay;
pub mod trace;

/// The brain of this build: the forager's, or with the feature `small` the one for small parts.
pub mod profile {
    #[cfg(not(feature = "small"))]
    pub use cla_core::forager::pioneer::*;
    #[cfg(feature = "small")]
    pub use cla_core::forager::small::*;
}
