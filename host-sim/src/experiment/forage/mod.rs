//! Foraging (book, 6.2).

pub mod life;
pub mod measure;
