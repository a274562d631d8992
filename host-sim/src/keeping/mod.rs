//! Brains in files: trained a while and kept, gone on with, looked into.
//!
//! A file is whole or it is not there, and it is checked when it is read; see `cla_core::snapshot`.

mod file;
mod inspect;
mod train;

pub use file::{keep, recall};
pub use inspect::inspect;
pub use train::{Training, train};
