//! Self-organizing maps (book, 2.2): prototypes on a grid, best matching unit, training, quality.
//!
//! [`DenseSom`] is the textbook map for real-valued stimuli, and the oracle for the others.
//! [`BinarySom`] is the map of schemas: binary stimuli, work proportional to what is on.
//! [`ByteSom`] is the same in a quarter of the memory; [`Prototypes`] is what both can do.
//! The maps know nothing of layers or schemas; both are built on them.

mod audit;
mod binary;
mod byte;
mod column;
mod dense;
mod grid;
mod prototypes;
mod quality;
mod stimulus;

pub use binary::BinarySom;
pub use byte::{ByteSom, Norms};
pub use dense::{DenseSom, StimulusError};
pub use grid::{BestMatch, Grid, NodeId, best_match};
pub use prototypes::Prototypes;
pub use quality::{quantization_error, topographic_error};
pub use stimulus::SparseStimulus;
