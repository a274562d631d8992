//! The way in: pieces become bytes, bytes become fields, and nothing is believed before its checksum.

use super::limits::{Limits, VERSION};
use super::writer::{PIECE, Sums};

/// Reads one piece from a place; whether it could.
pub(super) type In<'a> = &'a mut dyn FnMut(u32, &mut [u8]) -> bool;

/// Gives the fields of a brain in their order.
///
/// It is sticky: once something was wrong it gives zeros, which every field can be read from, and
/// loops stay bounded by the tables they fill.
pub struct Reader<'a> {
    source: In<'a>,
    piece: [u8; PIECE],
    used: usize,
    filled: usize,
    /// Where the next piece begins, and where the section ends.
    at: u32,
    end: u32,
    sums: Sums,
    /// How many there are of what links point at.
    pub(crate) limits: Limits,
    version: u16,
    wrong: bool,
    failed: bool,
    unfit: Option<Unfit>,
}

/// What there is more of than fits.
#[derive(Clone, Copy)]
pub(super) struct Unfit {
    pub(super) name: &'static str,
    pub(super) image: u32,
    pub(super) here: u32,
}

impl<'a> Reader<'a> {
    pub(super) fn of(source: In<'a>, limits: Limits) -> Self {
        Self {
            source,
            piece: [0; PIECE],
            used: 0,
            filled: 0,
            at: 0,
            end: 0,
            sums: Sums::new(),
            limits,
            version: VERSION,
            wrong: false,
            failed: false,
            unfit: None,
        }
    }

    /// Lets the next `length` bytes be read.
    pub(super) const fn allow(&mut self, length: u32) {
        self.end = self.at.saturating_add(length);
    }

    /// What follows was written in this version of the format.
    pub(super) const fn set_version(&mut self, version: u16) {
        self.version = version;
    }

    /// Whether the image was written before that version, so that what came with it is missing.
    pub(crate) const fn is_before(&self, version: u16) -> bool {
        self.version < version
    }

    /// Notes that what was read cannot be so in a sound brain.
    pub(crate) const fn refuse(&mut self) {
        self.wrong = true;
    }

    /// Notes that it cannot be so unless `sound`.
    pub(crate) const fn require(&mut self, sound: bool) {
        if !sound {
            self.refuse();
        }
    }

    /// Reads how many there are of something of which `most` fit; 0 where there are more.
    pub(crate) fn count(&mut self, name: &'static str, most: usize) -> usize {
        let many = u16::from_le_bytes(self.bytes());
        if self.fit(name, many.into(), most) {
            many.into()
        } else {
            0
        }
    }

    /// Whether so many of something fit where there is room for `most`; notes what did not.
    pub(crate) fn fit(&mut self, name: &'static str, image: u32, most: usize) -> bool {
        let here = most as u32;
        let fits = image <= here;
        if !fits {
            self.refuse();
            self.unfit = self.unfit.or(Some(Unfit { name, image, here }));
        }
        fits
    }

    /// What did not fit.
    pub(super) const fn unfit(&self) -> Option<Unfit> {
        self.unfit
    }

    /// Whether something was wrong so far: reading may stop.
    pub(crate) const fn is_wrong(&self) -> bool {
        self.wrong || self.failed
    }

    pub(crate) fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let mut bytes = [0; N];
        for byte in &mut bytes {
            *byte = self.byte();
        }
        bytes
    }

    fn byte(&mut self) -> u8 {
        if self.used >= self.filled {
            self.fill();
        }
        match self.piece.get(self.used) {
            Some(&byte) if self.used < self.filled => {
                self.used += 1;
                byte
            }
            // Behind the end of the section.
            _ => {
                self.refuse();
                0
            }
        }
    }

    fn fill(&mut self) {
        (self.used, self.filled) = (0, 0);
        let left = self.end.saturating_sub(self.at);
        let many = (PIECE as u32).min(left) as usize;
        let piece = self.piece.get_mut(..many).unwrap_or_default();
        if piece.is_empty() || self.failed {
            return;
        }
        if (self.source)(self.at, piece) {
            self.sums.add(piece);
            self.at += many as u32;
            self.filled = many;
        } else {
            self.failed = true;
        }
    }

    /// Ends a header or section: it must have been read whole, and its checksum must be right.
    pub(super) fn end_section(&mut self) {
        if self.used < self.filled || self.at < self.end {
            self.refuse();
            return;
        }
        let sum = self.sums.end_section();
        self.allow(4);
        let stored = u32::from_le_bytes(self.bytes());
        self.sums.end_section();
        self.require(sum == stored);
        self.limits.begin_section();
    }

    /// Ends the image with its checksum.
    pub(super) fn end_image(&mut self) {
        let sum = self.sums.image();
        self.allow(4);
        let stored = u32::from_le_bytes(self.bytes());
        self.require(sum == stored);
    }

    /// Where the next section begins.
    pub(super) const fn at(&self) -> u32 {
        self.at
    }
}
