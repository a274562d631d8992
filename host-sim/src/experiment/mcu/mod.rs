//! The brain on microcontrollers: what it costs there, and that it is the same brain.
//!
//! `board` builds and runs the firmware in QEMU.

pub mod board;
