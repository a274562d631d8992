//! The Microworld experiment (book, chapter 5): what is run, what is claimed.

pub mod catalogue;
pub mod goals;
pub mod level1;
pub mod level2;
