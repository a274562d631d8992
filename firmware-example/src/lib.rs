#![no_std]
//! What the firmware does, apart from the board it does it on.
//!
//! The host runs the same [`relive`](replay::relive) on the same recorded [`trace`], and a test
//! compares the two to the bit.

#[cfg(target_os = "none")]
pub mod board;
pub mod controller;
pub mod fingerprint;
#[cfg(target_os = "none")]
pub mod hal;
pub mod keeper;
pub mod link;
pub mod meter;
pub mod mind;
pub mod replay;
pub mod resume;
pub mod shelf;
pub mod trace;

// Where the log goes, and the critical section that it needs.
#[cfg(all(feature = "defmt", target_os = "none", target_arch = "arm"))]
use cortex_m as _;
#[cfg(all(feature = "defmt", target_os = "none"))]
use defmt_rtt as _;
#[cfg(all(feature = "defmt", target_os = "none", target_arch = "riscv32"))]
use riscv as _;

/// The brain of this build: the forager's, or with the feature `small` the one for small parts.
pub mod profile {
    #[cfg(not(feature = "small"))]
    pub use cla_core::forager::pioneer::*;
    #[cfg(feature = "small")]
    pub use cla_core::forager::small::*;
}
