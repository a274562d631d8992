//! What a brain finds when it looks itself through, and the part of it that is the same for all.

use core::ops::Range;

use super::limits::Limits;
use super::mender::Mender;
use super::{Snapshot, Writer};

/// What a brain found when it looked itself through.
///
/// ```
/// use cla_core::snapshot::Audit;
/// assert_eq!(Audit::Sound.to_string(), "all is sound");
/// assert_eq!(Audit::Mended(2).and(Audit::Sound), Audit::Mended(2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Audit {
    /// Nothing that cannot be so.
    Sound,
    /// So many rows, values and nodes were dropped or forgotten; it can live on.
    Mended(u32),
    /// The part of that name is lost and cannot be found again from the rest: load the last image, or
    /// let it be born again.
    Lost(&'static str),
}

impl Audit {
    pub(crate) const fn of(mended: u32) -> Self {
        match mended {
            0 => Self::Sound,
            many => Self::Mended(many),
        }
    }

    /// What was found in two parts of a brain.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Lost(part), _) | (_, Self::Lost(part)) => Self::Lost(part),
            (Self::Mended(some), Self::Mended(more)) => Self::Mended(some.saturating_add(more)),
            (found, Self::Sound) | (Self::Sound, found) => found,
        }
    }
}

impl core::fmt::Display for Audit {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Sound => f.write_str("all is sound"),
            Self::Mended(many) => write!(f, "{many} entries were mended or dropped"),
            Self::Lost(part) => write!(f, "{part} cannot be mended: load the last image"),
        }
    }
}

/// Makes blank what no image would take of some sections, and asks them again.
pub(crate) fn mend_sections<B: Snapshot>(
    brain: &mut B,
    sections: Range<usize>,
    limits: Limits,
) -> Audit {
    let mut by = Mender::of(limits);
    for number in sections.clone() {
        by.limits.begin_section();
        brain.mend_section(number, &mut by);
    }
    let mut look = Writer::counting(limits);
    for (number, name) in B::SECTIONS.iter().enumerate() {
        if sections.contains(&number) {
            look.limits.begin_section();
            brain.store_section(number, &mut look);
            if look.is_unsound() {
                return Audit::Lost(name);
            }
        }
    }
    Audit::of(by.mended())
}
