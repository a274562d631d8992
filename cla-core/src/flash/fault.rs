//! What goes wrong with a flash: counted, said, and never the end of the newest generation.

use core::fmt;

use crate::snapshot::{LoadError, SaveError};

/// Why a slot could not be written.
///
/// ```
/// assert_eq!(cla_core::flash::Fault::<u8>::Mismatch.to_string(), "the flash does not hold what was written");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Fault<E> {
    /// The flash could not erase a page.
    Erase(E),
    /// The flash could not write.
    Write(E),
    /// The flash could not read.
    Read(E),
    /// What was read back is not what was written: the page is worn out.
    Mismatch,
    /// The slot ended before the image.
    Full,
}

impl<E> fmt::Display for Fault<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Erase(_) => "the flash could not erase a page",
            Self::Write(_) => "the flash could not write",
            Self::Read(_) => "the flash could not read",
            Self::Mismatch => "the flash does not hold what was written",
            Self::Full => "the slot ended before the image",
        })
    }
}

/// Why a region of flash cannot be a store.
///
/// ```
/// assert_eq!(cla_core::flash::LayoutError::NotPages.to_string(), "slots must begin and end with a page");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LayoutError {
    /// A slot does not begin and end with a page.
    NotPages,
    /// A slot has no room for an image beside its records.
    TooSmall,
    /// The slots end behind the flash.
    BehindTheEnd,
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotPages => "slots must begin and end with a page",
            Self::TooSmall => "a slot has no room for an image beside its records",
            Self::BehindTheEnd => "the slots end behind the flash",
        })
    }
}

impl core::error::Error for LayoutError {}

/// Why a brain was not saved; the newest generation in flash is still there.
///
/// ```
/// use cla_core::flash::StoreError;
/// let error = StoreError::<u8>::TooLarge { image: 5000, slot: 3840 };
/// assert_eq!(error.to_string(), "the image has 5000 bytes, and a slot has room for 3840");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StoreError<E> {
    /// The part of that name is damaged in RAM: a good image is not to be replaced by this one.
    Unsound(&'static str),
    /// There is no life to save.
    NotBorn,
    /// The image is larger than a slot; nothing was erased.
    TooLarge {
        /// Bytes of the image.
        image: u32,
        /// Bytes that a slot has for one.
        slot: u32,
    },
    /// Every slot that may be written failed; the last one for this reason.
    Worn(Fault<E>),
    /// There is no larger generation.
    Exhausted,
}

impl<E> StoreError<E> {
    /// Without a sink there is no other reason.
    pub(super) fn of(error: &SaveError<core::convert::Infallible>) -> Self {
        match *error {
            SaveError::NotBorn => Self::NotBorn,
            SaveError::Unsound(part) => Self::Unsound(part),
            SaveError::Sink(never) => match never {},
        }
    }
}

impl<E> fmt::Display for StoreError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unsound(part) => {
                f.write_str("the brain is damaged in its ")?;
                f.write_str(part)?;
                f.write_str("; nothing was written")
            }
            Self::NotBorn => f.write_str("the brain is not born: there is no life to save"),
            Self::TooLarge { image, slot } => {
                write!(
                    f,
                    "the image has {image} bytes, and a slot has room for {slot}"
                )
            }
            Self::Worn(fault) => {
                f.write_str("no slot could be written: ")?;
                fault.fmt(f)
            }
            Self::Exhausted => f.write_str("there is no larger generation"),
        }
    }
}

impl<E: fmt::Debug> core::error::Error for StoreError<E> {}

/// The flash could not be read.
///
/// ```
/// assert_eq!(cla_core::flash::Unread.to_string(), "the flash could not be read");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Unread;

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the flash could not be read")
    }
}

impl core::error::Error for Unread {}

/// Why no brain was resumed.
///
/// ```
/// use cla_core::flash::ResumeError;
/// assert_eq!(ResumeError::Nothing.to_string(), "there is no whole image in the flash");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ResumeError {
    /// No generation is whole.
    Nothing,
    /// No generation was taken; the newest one for this reason.
    Refused(LoadError<Unread>),
}

impl fmt::Display for ResumeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => f.write_str("there is no whole image in the flash"),
            Self::Refused(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ResumeError {}

/// What has gone wrong since the store was opened; the numbers stop at their largest value.
///
/// ```
/// assert_eq!(cla_core::flash::FlashCounts::default().mismatches, 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlashCounts {
    /// Pages that could not be erased.
    pub erases_failed: u16,
    /// Words that could not be written.
    pub writes_failed: u16,
    /// Reads that failed; a record or an image was not believed then.
    pub reads_failed: u16,
    /// Pieces that did not hold what was written.
    pub mismatches: u16,
    /// Committed images that were no longer whole.
    pub rotten: u16,
    /// Whole images that the brain did not take.
    pub refused: u16,
    /// Generations that were sealed anew after a cut.
    pub sealed_anew: u16,
}

impl FlashCounts {
    pub(super) fn note<E>(&mut self, fault: &Fault<E>) {
        let count = match fault {
            Fault::Erase(_) => &mut self.erases_failed,
            Fault::Write(_) => &mut self.writes_failed,
            Fault::Read(_) => &mut self.reads_failed,
            Fault::Mismatch | Fault::Full => &mut self.mismatches,
        };
        *count = count.saturating_add(1);
    }
}
