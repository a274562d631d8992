//! The parts, in the order in which they are run and reported.

mod bit_flip;
mod kill;
mod long_life;
mod power_cut;
mod ram_flips;
mod resume;
mod wire;

use super::part::Part;

/// All whose claims are declared, and stand in the committed results.
pub(super) const ALL: &[Part] = &[
    bit_flip::PART,
    resume::PART,
    power_cut::PART,
    kill::PART,
    ram_flips::PART,
    wire::PART,
];

/// Those whose claims are not committed yet: they are run only when they are named.
pub(super) const UNCLAIMED: &[Part] = &[long_life::PART];
