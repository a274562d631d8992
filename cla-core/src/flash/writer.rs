//! Into a slot and out of it again: pieces are erased for, written, read back and compared.

use super::fault::{Fault, Unread};
use super::record::{Kind, RECORD, Record, SUM};
use super::slot::{PIECE, PLACES, SaveCost, Shape};
use crate::snapshot::{Sink, Source};
use crc::Digest;
use embedded_storage::nor_flash::NorFlash;

/// Writes one slot from its beginning to the end of an image.
pub(super) struct SlotWriter<'a, F> {
    flash: &'a mut F,
    at: u32,
    end: u32,
    /// Up to here pages are erased.
    erased: u32,
    piece: [u8; PIECE],
    used: usize,
    sum: Digest<'static, u32>,
    pub(super) cost: SaveCost,
}

impl<'a, F: NorFlash> SlotWriter<'a, F> {
    /// Writes from `start` to `end`; up to `erased` the pages are erased already.
    pub(super) fn new(flash: &'a mut F, start: u32, end: u32, erased: u32) -> Self {
        Self {
            flash,
            at: start,
            end,
            erased: erased.max(start),
            piece: [0xff; PIECE],
            used: 0,
            sum: SUM.digest(),
            cost: SaveCost::default(),
        }
    }

    /// Erases for the records, writes the header and goes to where the image begins.
    pub(super) fn begin(&mut self, header: &Record) -> Result<(), Fault<F::Error>> {
        let body = self.at.saturating_add(Shape::<F>::BODY);
        self.erase_to(body)?;
        let cost = write_record(self.flash, self.at, Kind::Header, header)?;
        self.cost.written += cost.written;
        self.cost.read += cost.read;
        self.at = body;
        Ok(())
    }

    fn erase_to(&mut self, end: u32) -> Result<(), Fault<F::Error>> {
        if end > self.end {
            return Err(Fault::Full);
        }
        while self.erased < end {
            let next = self.erased.saturating_add(Shape::<F>::PAGE);
            self.flash.erase(self.erased, next).map_err(Fault::Erase)?;
            self.erased = next;
            self.cost.erased += 1;
        }
        Ok(())
    }

    /// Writes what is left; answers the checksum of the image.
    pub(super) fn finish(mut self) -> Result<(u32, SaveCost), Fault<F::Error>> {
        self.flush()?;
        Ok((self.sum.finalize(), self.cost))
    }

    /// Writes the piece; what is behind its end in the last word stays erased.
    fn flush(&mut self) -> Result<(), Fault<F::Error>> {
        if self.used == 0 {
            return Ok(());
        }
        let said = self.piece.get(..self.used).unwrap_or_default();
        self.sum.update(said);
        let length = self.used.next_multiple_of(F::WRITE_SIZE).min(PIECE);
        let padding = self.piece.get_mut(self.used..).unwrap_or_default();
        padding.fill(0xff);
        self.used = 0;
        self.erase_to(self.at.saturating_add(length as u32))?;
        let piece = self.piece.get(..length).unwrap_or_default();
        self.cost.read += write_and_compare(self.flash, self.at, piece)?;
        self.at += length as u32;
        self.cost.written += length as u32;
        Ok(())
    }
}

impl<F: NorFlash> Sink for SlotWriter<'_, F> {
    type Error = Fault<F::Error>;

    fn write(&mut self, piece: &[u8]) -> Result<(), Self::Error> {
        for &byte in piece {
            if let Some(place) = self.piece.get_mut(self.used) {
                *place = byte;
                self.used += 1;
            }
            if self.used >= PIECE {
                self.flush()?;
            }
        }
        Ok(())
    }
}

/// Writes whole words and reads them back; how many bytes were read.
fn write_and_compare<F: NorFlash>(
    flash: &mut F,
    at: u32,
    bytes: &[u8],
) -> Result<u32, Fault<F::Error>> {
    flash.write(at, bytes).map_err(Fault::Write)?;
    let mut back = [0; PIECE];
    let length = bytes.len().next_multiple_of(F::READ_SIZE);
    let back = back.get_mut(..length).unwrap_or_default();
    flash.read(at, back).map_err(Fault::Read)?;
    if back
        .iter()
        .zip(bytes)
        .all(|(read, written)| read == written)
    {
        Ok(back.len() as u32)
    } else {
        Err(Fault::Mismatch)
    }
}

/// Writes a record that is padded to the flash's words.
pub(super) fn write_record<F: NorFlash>(
    flash: &mut F,
    at: u32,
    kind: Kind,
    record: &Record,
) -> Result<SaveCost, Fault<F::Error>> {
    let mut unit = [0xff; PIECE];
    let places = unit.iter_mut().zip(record.bytes(kind));
    places.for_each(|(place, byte)| *place = byte);
    let unit = unit.get(..Shape::<F>::UNIT).unwrap_or_default();
    Ok(SaveCost {
        erased: 0,
        read: write_and_compare(flash, at, unit)?,
        written: unit.len() as u32,
    })
}

/// What stands where a record may stand.
pub(super) enum Found {
    /// Nothing was written there, as far as can be seen.
    Blank,
    /// Something that is no record.
    Nothing,
    /// A record.
    Record(Kind, Record),
}

/// Reads the record at a place; 0 is the header's.
pub(super) fn read_record<F: NorFlash>(
    flash: &mut F,
    start: u32,
    place: usize,
) -> Result<Found, Fault<F::Error>> {
    let mut unit = [0; PIECE];
    let unit = unit.get_mut(..Shape::<F>::UNIT).unwrap_or_default();
    let at = start.saturating_add((place * Shape::<F>::UNIT) as u32);
    flash.read(at, unit).map_err(Fault::Read)?;
    if unit.iter().all(|&byte| byte == 0xff) {
        return Ok(Found::Blank);
    }
    let said = unit.get(..RECORD).unwrap_or_default();
    Ok(match Record::of(said) {
        Some((kind, record)) => Found::Record(kind, record),
        None => Found::Nothing,
    })
}

/// Writes a commit and, when it was read back, its seal, each into the first blank place that takes it.
pub(super) fn seal<F: NorFlash>(
    flash: &mut F,
    start: u32,
    record: &Record,
    mut note: impl FnMut(&Fault<F::Error>),
) -> Result<SaveCost, Fault<F::Error>> {
    let mut cost = SaveCost::default();
    let mut next = Kind::Commit;
    let mut last = Fault::Full;
    for place in 1..=PLACES {
        match read_record(flash, start, place) {
            Ok(Found::Blank) => {}
            Ok(_) => continue,
            Err(fault) => {
                note(&fault);
                continue;
            }
        }
        let at = start.saturating_add((place * Shape::<F>::UNIT) as u32);
        match write_record(flash, at, next, record) {
            Ok(more) => {
                cost.written += more.written;
                cost.read += more.read + Shape::<F>::UNIT as u32;
                if next == Kind::Seal {
                    return Ok(cost);
                }
                next = Kind::Seal;
            }
            Err(fault) => {
                note(&fault);
                last = fault;
            }
        }
    }
    Err(last)
}

/// The image of a slot, read in words.
pub(super) struct SlotReader<'a, F> {
    pub(super) flash: &'a mut F,
    /// Where the image begins.
    pub(super) body: u32,
    pub(super) length: u32,
    pub(super) failed: u16,
}

impl<F: NorFlash> SlotReader<'_, F> {
    /// The checksum of the whole image; `None` when it cannot be read.
    pub(super) fn checksum(&mut self) -> Option<u32> {
        let mut sum = SUM.digest();
        let mut at = 0;
        while at < self.length {
            let mut piece = [0; PIECE];
            let many = (self.length - at).min(PIECE as u32);
            let piece = piece.get_mut(..many as usize).unwrap_or_default();
            self.read(at, piece).ok()?;
            sum.update(piece);
            at += many;
        }
        Some(sum.finalize())
    }
}

impl<F: NorFlash> Source for SlotReader<'_, F> {
    type Error = Unread;

    fn length(&self) -> u32 {
        self.length
    }

    fn read(&mut self, at: u32, piece: &mut [u8]) -> Result<(), Unread> {
        let from = self.body.saturating_add(at);
        let word = F::READ_SIZE as u32;
        // The words that hold the piece; a piece has at most 256 bytes, and one or two words more.
        let first = from - from % word;
        let before = (from - first) as usize;
        let many = (before + piece.len()).next_multiple_of(F::READ_SIZE);
        let mut words = [0; 2 * PIECE];
        let read = words.get_mut(..many).ok_or(Unread)?;
        if self.flash.read(first, read).is_err() {
            self.failed = self.failed.saturating_add(1);
            return Err(Unread);
        }
        let from = words.get(before..).unwrap_or_default();
        piece.iter_mut().zip(from).for_each(|(to, it)| *to = *it);
        Ok(())
    }
}
