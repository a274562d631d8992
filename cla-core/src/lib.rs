#![no_std]
//! The Constructivist Learning Architecture (Chaput 2004) for robots, in fixed memory.

#[cfg(test)]
extern crate std;

pub mod clasm;
pub mod num;
pub mod som;
