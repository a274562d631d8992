//! The parts, in the order in which they are run and reported.

mod bit_flip;
mod resume;

use super::part::Part;

/// All of them.
pub(super) const ALL: &[Part] = &[bit_flip::PART, resume::PART];
