//! The brain on microcontrollers: what it costs there, and that it is the same brain.
//!
//! `board` builds and runs the firmware in QEMU, `distant` is the wire to a brain in it, `hil` lets
//! that brain live.

pub mod board;
pub mod distant;
pub mod hil;
