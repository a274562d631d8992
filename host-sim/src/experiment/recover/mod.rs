//! Damage and recovery: a robot whose camera was knocked, and what it makes of it (book, 6.3, 7.1.1).

pub mod life;
