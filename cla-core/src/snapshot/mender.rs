//! A living brain gone through in place: what cannot be so is replaced, or one bit is turned.

use super::limits::Limits;

/// Goes through the fields of a brain in the order of its image and puts the blank value in the place
/// of what cannot be so.
pub struct Mender {
    /// How many there are of what links point at.
    pub(crate) limits: Limits,
    mended: u32,
}

impl Mender {
    pub(crate) const fn of(limits: Limits) -> Self {
        Self { limits, mended: 0 }
    }

    /// Counts one value that was replaced.
    pub(crate) const fn count(&mut self) {
        self.mended = self.mended.saturating_add(1);
    }

    /// Values that were replaced so far.
    pub(crate) const fn mended(&self) -> u32 {
        self.mended
    }
}

/// Which bit of a brain is turned: fields are counted in the order of its image, and what an image
/// does not keep is passed over unless it is asked for.
pub struct Flip {
    at: At,
    derived: bool,
    bits: u32,
    found: bool,
}

enum At {
    /// A bit of a field: fields before it that are left.
    Field { left: u32, bit: u32 },
    /// Bits before it that are left.
    #[cfg(any(test, feature = "faults"))]
    Bit { left: u32 },
}

impl Flip {
    /// A bit of a field that an image keeps.
    pub(super) const fn of_field(field: u32, bit: u32) -> Self {
        Self {
            at: At::Field { left: field, bit },
            derived: false,
            bits: 0,
            found: false,
        }
    }

    /// A bit of all that is in memory; `u32::MAX` counts them.
    #[cfg(any(test, feature = "faults"))]
    pub(super) const fn of_memory(bit: u32) -> Self {
        Self {
            at: At::Bit { left: bit },
            derived: true,
            bits: 0,
            found: false,
        }
    }

    /// Whether what an image does not keep is looked at, too.
    pub(crate) const fn sees_derived(&self) -> bool {
        self.derived
    }

    /// A field of so many bits comes: which of them is turned, if it is one of them.
    pub(crate) fn field(&mut self, bits: u32) -> Option<u32> {
        self.bits = self.bits.saturating_add(bits);
        if self.found {
            return None;
        }
        match &mut self.at {
            At::Field { left: 0, bit } => {
                self.found = true;
                Some(*bit).filter(|bit| *bit < bits)
            }
            At::Field { left, .. } => {
                *left -= 1;
                None
            }
            #[cfg(any(test, feature = "faults"))]
            At::Bit { left } if *left < bits => {
                self.found = true;
                Some(*left)
            }
            #[cfg(any(test, feature = "faults"))]
            At::Bit { left } => {
                *left -= bits;
                None
            }
        }
    }

    /// Whether the field was met.
    #[cfg(any(test, feature = "faults"))]
    pub(super) const fn found(&self) -> bool {
        self.found
    }

    /// Bits that were passed.
    #[cfg(any(test, feature = "faults"))]
    pub(super) const fn bits(&self) -> u32 {
        self.bits
    }
}
