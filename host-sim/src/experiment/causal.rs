//! Causal perception: a hierarchy learns what a launching is, in stages, and falls back (book, 4).

pub mod network;
