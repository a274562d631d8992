//! Self-organizing maps (book, 2.2): prototypes on a grid, best matching unit, training, quality.
//!
//! [`DenseSom`] is the textbook map for real-valued stimuli, and the oracle for the others.
//! The maps know nothing of layers or schemas; both are built on them.

mod dense;
mod grid;
mod quality;

pub use dense::{DenseSom, StimulusError};
pub use grid::{BestMatch, Grid, NodeId, best_match};
pub use quality::{quantization_error, topographic_error};
