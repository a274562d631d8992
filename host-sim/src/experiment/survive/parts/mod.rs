//! The parts, in the order in which they are run and reported.

mod bit_flip;
mod kill;
mod long_life;
mod power_cut;
mod ram_flips;
mod resume;
mod wire;

use super::part::Part;

/// All; their claims are declared, and stand in the committed results.
pub(super) const ALL: &[Part] = &[
    bit_flip::PART,
    resume::PART,
    power_cut::PART,
    kill::PART,
    ram_flips::PART,
    wire::PART,
    long_life::LONG,
    long_life::LASTING,
    long_life::LONGEST,
];
