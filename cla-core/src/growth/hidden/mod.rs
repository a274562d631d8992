//! What cannot be seen: synthetic items with three values, and samples labelled in hindsight (5.1.1).

mod hindsight;
mod synthetic;

pub use hindsight::HindsightSample;
pub use synthetic::{NoRoomForItem, SyntheticItem, SyntheticItems};
