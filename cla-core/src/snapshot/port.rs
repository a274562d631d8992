//! Where an image goes and where it comes from: a file, a flash, a wire, a slice.

use core::convert::Infallible;
use core::fmt;

/// Takes an image piece by piece, in order.
///
/// A flash driver, a file or a wire implements it; pieces have at most 64 bytes.
///
/// ```
/// use cla_core::snapshot::Sink;
/// let mut image = heapless::Vec::<u8, 8>::new();
/// image.write(&[1, 2])?;
/// assert_eq!(image, [1, 2]);
/// # Ok::<(), cla_core::snapshot::SinkFull>(())
/// ```
pub trait Sink {
    /// Why a piece could not be taken.
    type Error;

    /// Takes the next piece.
    ///
    /// # Errors
    /// Whatever the medium says; the image that was begun is then worth nothing.
    fn write(&mut self, piece: &[u8]) -> Result<(), Self::Error>;
}

/// Gives any piece of an image; it is read twice, each time from the beginning to the end.
///
/// ```
/// use cla_core::snapshot::Source;
/// let mut image: &[u8] = &[1, 2, 3];
/// let mut piece = [0; 2];
/// image.read(1, &mut piece)?;
/// assert_eq!((image.length(), piece), (3, [2, 3]));
/// # Ok::<(), cla_core::snapshot::SourceEnd>(())
/// ```
pub trait Source {
    /// Why a piece could not be read.
    type Error;

    /// Bytes that there are; an image may be shorter.
    fn length(&self) -> u32;

    /// Reads the piece that begins `at` so many bytes from the beginning.
    ///
    /// # Errors
    /// Whatever the medium says.
    fn read(&mut self, at: u32, piece: &mut [u8]) -> Result<(), Self::Error>;
}

/// A slice or a buffer has no room for the whole image.
///
/// ```
/// assert_eq!(cla_core::snapshot::SinkFull.to_string(), "there is no room for the whole image");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SinkFull;

impl fmt::Display for SinkFull {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("there is no room for the whole image")
    }
}

impl core::error::Error for SinkFull {}

/// A piece was asked for that lies behind the end.
///
/// ```
/// assert_eq!(cla_core::snapshot::SourceEnd.to_string(), "there is nothing behind the end");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SourceEnd;

impl fmt::Display for SourceEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("there is nothing behind the end")
    }
}

impl core::error::Error for SourceEnd {}

/// Writes an image into bytes that are there already.
///
/// ```
/// use cla_core::snapshot::{Sink, SinkFull, SliceSink};
/// let mut bytes = [0; 3];
/// let mut sink = SliceSink::new(&mut bytes);
/// sink.write(&[1, 2])?;
/// assert_eq!(sink.write(&[3, 4]), Err(SinkFull));
/// assert_eq!(sink.written(), 2);
/// # Ok::<(), SinkFull>(())
/// ```
#[derive(Debug)]
pub struct SliceSink<'a> {
    bytes: &'a mut [u8],
    written: usize,
}

impl<'a> SliceSink<'a> {
    /// Writes from the beginning of `bytes`.
    #[must_use]
    pub const fn new(bytes: &'a mut [u8]) -> Self {
        Self { bytes, written: 0 }
    }

    /// Bytes written so far.
    #[must_use]
    pub const fn written(&self) -> usize {
        self.written
    }
}

impl Sink for SliceSink<'_> {
    type Error = SinkFull;

    fn write(&mut self, piece: &[u8]) -> Result<(), SinkFull> {
        let room = self.bytes.get_mut(self.written..).unwrap_or_default();
        let room = room.get_mut(..piece.len()).ok_or(SinkFull)?;
        for (place, byte) in room.iter_mut().zip(piece) {
            *place = *byte;
        }
        self.written += piece.len();
        Ok(())
    }
}

impl<const N: usize, L: heapless::LenType> Sink for heapless::Vec<u8, N, L> {
    type Error = SinkFull;

    fn write(&mut self, piece: &[u8]) -> Result<(), SinkFull> {
        self.extend_from_slice(piece).map_err(|_| SinkFull)
    }
}

/// Counts the bytes of an image, and keeps none.
impl Sink for u32 {
    type Error = Infallible;

    fn write(&mut self, piece: &[u8]) -> Result<(), Infallible> {
        *self = self.wrapping_add(piece.len() as u32);
        Ok(())
    }
}

impl Source for &[u8] {
    type Error = SourceEnd;

    fn length(&self) -> u32 {
        u32::try_from(self.len()).unwrap_or(u32::MAX)
    }

    fn read(&mut self, at: u32, piece: &mut [u8]) -> Result<(), SourceEnd> {
        let from = self.get(at as usize..).ok_or(SourceEnd)?;
        let from = from.get(..piece.len()).ok_or(SourceEnd)?;
        for (place, byte) in piece.iter_mut().zip(from) {
            *place = *byte;
        }
        Ok(())
    }
}
