//! The brain on microcontrollers: what it costs there, and that it is the same brain.
//!
//! `board` builds and runs the firmware in QEMU, `distant` is the wire to a brain in it, `hil` lets
//! that brain live, `peers` are others that do the same; here it becomes claims.

mod claims;
pub mod distant;
pub mod hil;
pub mod peers;

pub use claims::{run, run_hil};
