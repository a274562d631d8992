//! Where slots lie, what is known of each, and what a save costs.

use super::record::{RECORD, Record};
use embedded_storage::nor_flash::NorFlash;

/// Bytes that are written and compared at once; they lie on the stack, twice.
pub(super) const PIECE: usize = 256;
/// Places for commits and seals; a save takes two, and so does the repair of one that was cut.
pub(super) const PLACES: usize = 6;

/// Sizes that follow from a flash's word.
pub(super) struct Shape<F>(core::marker::PhantomData<F>);

impl<F: NorFlash> Shape<F> {
    /// Bytes from one record to the next.
    pub(super) const UNIT: usize = {
        assert!(F::WRITE_SIZE > 0 && F::READ_SIZE > 0 && F::ERASE_SIZE > 0);
        assert!(
            PIECE.is_multiple_of(F::WRITE_SIZE) && PIECE.is_multiple_of(F::READ_SIZE),
            "the flash's words must divide 256 bytes"
        );
        assert!(
            F::ERASE_SIZE.is_multiple_of(F::WRITE_SIZE),
            "a page must have whole words"
        );
        let word = if F::WRITE_SIZE > F::READ_SIZE {
            F::WRITE_SIZE
        } else {
            F::READ_SIZE
        };
        assert!(word.is_multiple_of(F::READ_SIZE) && word.is_multiple_of(F::WRITE_SIZE));
        RECORD.next_multiple_of(word)
    };
    /// Where the image begins in a slot.
    pub(super) const BODY: u32 = ((1 + PLACES) * Self::UNIT).next_multiple_of(PIECE) as u32;
    pub(super) const PAGE: u32 = F::ERASE_SIZE as u32;
    pub(super) const WORD: u32 = F::WRITE_SIZE as u32;
}

/// What is known of a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Slot {
    /// The generation that can be read from it.
    pub(super) committed: Option<Record>,
    /// Whether its seal can be read, so that its commit always can.
    pub(super) sealed: bool,
    /// The largest generation of its records; 0 when nothing can be read.
    pub(super) seen: u32,
    /// How often its first page was erased; unknown after a cut between erase and header.
    pub(super) wear: Option<u32>,
    /// How often a save in it has failed since the store was opened.
    pub(super) failures: u16,
}

impl Slot {
    pub(super) const UNKNOWN: Self = Self {
        committed: None,
        sealed: false,
        seen: 0,
        wear: None,
        failures: 0,
    };
}

/// What a save does to the flash.
///
/// ```
/// use cla_core::flash::{FlashTiming, SaveCost};
/// let cost = SaveCost { erased: 2, written: 1000, read: 2000 };
/// let timing = FlashTiming { erase: 85_000, program: 41, bytes: 4 };
/// assert_eq!(cost.microseconds(&timing), 2 * 85_000 + 250 * 41);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SaveCost {
    /// Pages erased.
    pub erased: u32,
    /// Bytes written, padding among them.
    pub written: u32,
    /// Bytes read back.
    pub read: u32,
}

impl SaveCost {
    /// How long the flash is busy, in µs, reading not counted; on many parts the processor stands
    /// still meanwhile.
    #[must_use]
    pub fn microseconds(&self, timing: &FlashTiming) -> u64 {
        let programs = self.written.div_ceil(timing.bytes.max(1));
        u64::from(self.erased) * u64::from(timing.erase)
            + u64::from(programs) * u64::from(timing.program)
    }
}

/// How fast a flash is; its data sheet says so.
///
/// ```
/// let timing = cla_core::flash::FlashTiming { erase: 85_000, program: 41, bytes: 4 };
/// assert!(timing.erase > timing.program);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlashTiming {
    /// µs to erase a page.
    pub erase: u32,
    /// µs to program what is programmed at once.
    pub program: u32,
    /// Bytes that are programmed at once.
    pub bytes: u32,
}
