//! One number for a long sequence of bits: equal numbers, equal sequences.

use core::fmt;

/// A running 64-bit FNV-1a hash; floats enter as their bits.
///
/// ```
/// use firmware_example::fingerprint::Fingerprint;
/// let mut it = Fingerprint::new();
/// it.bytes(b"foobar");
/// assert_eq!(it.to_string(), "85944171f73967e8"); // the published test vector
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fingerprint(u64);

impl Fingerprint {
    /// The hash of nothing.
    #[must_use]
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// The number.
    #[must_use]
    pub const fn value(&self) -> u64 {
        self.0
    }

    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Adds the bits of a float, so that 0 and −0 differ.
    pub fn float(&mut self, value: f32) {
        self.bytes(&value.to_bits().to_le_bytes());
    }

    /// Adds a whole number.
    pub fn number(&mut self, value: u32) {
        self.bytes(&value.to_le_bytes());
    }
}

impl Default for Fingerprint {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Two halves: formatting a 64-bit number would bring 64-bit division into the firmware.
        write!(f, "{:08x}{:08x}", (self.0 >> 32) as u32, self.0 as u32)
    }
}
