//! Damage: what happens to a robot in mid-life, wrapped around any world (book, 6.3).
//!
//! A [`Damage`] is one line of text; a [`Damaged`] world shows it.
//! Neither robot nor brain knows: there is no `if` for damage anywhere else.

mod damaged;
mod kinds;

pub use damaged::Damaged;
pub use kinds::{Damage, DamageError, Part};
