//! What stands at the head of a slot: small records, each with its checksum.

use crc::{CRC_32_AUTOSAR, Crc};

/// A third polynomial: a whole image has the same CRC-32 as any other of its length, and the same
/// CRC-32C as any other with sections of the same lengths.
pub(super) static SUM: Crc<u32> = Crc::<u32>::new(&CRC_32_AUTOSAR);

/// Bytes of a record.
pub(super) const RECORD: usize = 32;
const NAME: [u8; 7] = *b"CLASLOT";

/// What a record is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Somebody began to write a generation.
    Header,
    /// The generation is whole.
    Commit,
    /// The commit before was written to its end.
    Seal,
}

impl Kind {
    const fn letter(self) -> u8 {
        match self {
            Self::Header => b'h',
            Self::Commit => b'c',
            Self::Seal => b's',
        }
    }
}

/// A generation and its image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Record {
    pub(super) generation: u32,
    pub(super) wear: u32,
    pub(super) tick: u32,
    pub(super) length: u32,
    pub(super) sum: u32,
}

impl Record {
    /// The bytes, without padding.
    pub(super) fn bytes(&self, kind: Kind) -> [u8; RECORD] {
        let mut bytes = [0; RECORD];
        let mut put = |from: &[u8], at: usize| {
            let places = bytes.iter_mut().skip(at);
            places.zip(from).for_each(|(place, byte)| *place = *byte);
        };
        put(&NAME, 0);
        put(&[kind.letter()], 7);
        let numbers = [self.generation, self.wear, self.tick, self.length, self.sum];
        for (index, number) in numbers.into_iter().enumerate() {
            put(&number.to_le_bytes(), 8 + 4 * index);
        }
        let (said, place) = bytes.split_at_mut(RECORD - 4);
        let sum = SUM.checksum(said).to_le_bytes();
        place.iter_mut().zip(sum).for_each(|(to, it)| *to = it);
        bytes
    }

    /// The record that stands there, if one does.
    pub(super) fn of(bytes: &[u8]) -> Option<(Kind, Self)> {
        let (said, rest) = bytes.split_at_checked(RECORD - 4)?;
        let word = |from: &[u8], at: usize| {
            let word = from.get(at..)?.first_chunk()?;
            Some(u32::from_le_bytes(*word))
        };
        if said.get(..7)? != NAME || word(rest, 0)? != SUM.checksum(said) {
            return None;
        }
        let kind = [Kind::Header, Kind::Commit, Kind::Seal]
            .into_iter()
            .find(|kind| said.get(7) == Some(&kind.letter()))?;
        let it = Self {
            generation: word(said, 8)?,
            wear: word(said, 12)?,
            tick: word(said, 16)?,
            length: word(said, 20)?,
            sum: word(said, 24)?,
        };
        Some((kind, it))
    }
}
