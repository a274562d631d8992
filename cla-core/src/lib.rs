#![doc = include_str!("../README.md")]
//!
//! The storeys, in the book's order; each knows only those before it:
//! [`num`] (arithmetic with the same bits everywhere) → [`som`] (self-organizing maps) →
//! [`layer`] (maps joined into hierarchies, overload, fallback) and, beside it,
//! [`clasm`] (items, Action SOMs, schemas, values, choice, the agent).
//! [`forager`] describes the book's robot.

#![no_std]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::todo,
        clippy::unimplemented,
        clippy::unreachable,
        clippy::panic_in_result_fn
    )
)]

#[cfg(test)]
extern crate std;

pub mod clasm;
pub mod forager;
pub mod layer;
pub mod num;
pub mod som;
