//! The way out: fields become bytes, bytes become pieces with their checksums.

use super::limits::Limits;
use super::seal::Seal;
use crc::{CRC_32_ISCSI, CRC_32_ISO_HDLC, Crc, Digest};

/// Bytes of a piece; it lies on the stack.
pub(super) const PIECE: usize = 64;

/// Of a header or a section: CRC-32C (Castagnoli).
pub(super) static OF_SECTIONS: Crc<u32> = Crc::<u32>::new(&CRC_32_ISCSI);
/// Of a whole image: another polynomial, so that a damage which one of them cannot see is seen by the
/// other.
pub(super) static OF_IMAGES: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// Both checksums of what has gone by.
pub(super) struct Sums {
    section: Digest<'static, u32>,
    image: Digest<'static, u32>,
}

impl Sums {
    pub(super) fn new() -> Self {
        Self {
            section: OF_SECTIONS.digest(),
            image: OF_IMAGES.digest(),
        }
    }

    pub(super) fn add(&mut self, bytes: &[u8]) {
        self.section.update(bytes);
        self.image.update(bytes);
    }

    /// The section's checksum so far; the next section begins with it.
    pub(super) fn end_section(&mut self) -> u32 {
        core::mem::replace(&mut self.section, OF_SECTIONS.digest()).finalize()
    }

    pub(super) fn image(&self) -> u32 {
        self.image.clone().finalize()
    }
}

/// Takes one piece; whether it could.
pub(super) type Out<'a> = &'a mut dyn FnMut(&[u8]) -> bool;

/// Takes the fields of a brain in their order; without a sink it counts and checks alone.
///
/// It is sticky: once something was refused, nothing more is written.
pub struct Writer<'a> {
    out: Option<Out<'a>>,
    seal: Option<Seal<'a>>,
    piece: [u8; PIECE],
    used: usize,
    sums: Sums,
    length: u32,
    /// How many there are of what links point at.
    pub(crate) limits: Limits,
    unsound: bool,
    failed: bool,
}

impl<'a> Writer<'a> {
    /// Counts and checks, and keeps nothing.
    pub(super) fn counting(limits: Limits) -> Self {
        Self::of(None, limits)
    }

    pub(super) fn into(out: Out<'a>, limits: Limits) -> Self {
        Self::of(Some(out), limits)
    }

    /// Adds all fields up, chunk by chunk.
    pub(super) fn sealing(each: &'a mut dyn FnMut(u32), limits: Limits) -> Self {
        let mut it = Self::of(None, limits);
        it.seal = Some(Seal::of(each));
        it
    }

    /// Ends the last chunk; answers how many fields there were.
    pub(super) fn end_seal(&mut self) -> u32 {
        self.seal.as_mut().map_or(0, Seal::end)
    }

    fn of(out: Option<Out<'a>>, limits: Limits) -> Self {
        Self {
            out,
            seal: None,
            piece: [0; PIECE],
            used: 0,
            sums: Sums::new(),
            length: 0,
            limits,
            unsound: false,
            failed: false,
        }
    }

    /// Notes that what is being written cannot be so in a sound brain.
    pub(crate) const fn refuse(&mut self) {
        self.unsound = true;
    }

    /// Notes that it cannot be so unless `sound`.
    pub(crate) const fn require(&mut self, sound: bool) {
        if !sound {
            self.refuse();
        }
    }

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        self.length = self.length.wrapping_add(bytes.len() as u32);
        if self.out.is_none() {
            if let Some(seal) = &mut self.seal {
                seal.add(bytes);
            }
            return;
        }
        for &byte in bytes {
            if self.used >= PIECE {
                self.flush();
            }
            if let Some(place) = self.piece.get_mut(self.used) {
                *place = byte;
                self.used += 1;
            }
        }
    }

    fn flush(&mut self) {
        let piece = self.piece.get(..self.used).unwrap_or_default();
        self.used = 0;
        if let Some(out) = &mut self.out
            && !self.failed
            && !piece.is_empty()
        {
            self.sums.add(piece);
            self.failed = !out(piece);
        }
    }

    /// Ends a header or section with its checksum.
    pub(super) fn end_section(&mut self) {
        self.flush();
        let sum = self.sums.end_section();
        self.bytes(&sum.to_le_bytes());
        self.flush();
        // The checksum itself belongs to the image alone.
        self.sums.end_section();
        self.limits.begin_section();
    }

    /// Ends the image with its checksum.
    pub(super) fn end_image(&mut self) {
        self.flush();
        let sum = self.sums.image();
        self.bytes(&sum.to_le_bytes());
        self.flush();
    }

    /// Bytes so far.
    pub(super) const fn length(&self) -> u32 {
        self.length
    }

    pub(super) const fn is_unsound(&self) -> bool {
        self.unsound
    }

    pub(super) const fn has_failed(&self) -> bool {
        self.failed
    }
}
