//! How messages go over a wire: sealed, in frames that begin and end with a zero and have none inside.
//!
//! A frame is a postcard message with its seal, in COBS, between two zeros: whatever happened before
//! a zero, the next frame begins after it.
//! There is one frame for a message and one message for a frame: what is not, to the last byte, what
//! the sender would have written is broken.

use crc::{CRC_32_ISCSI, Crc};
use serde::{Deserialize, Serialize};

/// The longest frame, in bytes, with both zeros.
pub const FRAME: usize = 128;

const CRC: Crc<u32> = Crc::<u32>::new(&CRC_32_ISCSI);

/// What is said in one direction.
pub trait Said: Serialize + for<'a> Deserialize<'a> {
    /// Goes into the seal, so that a wire that echoes is not taken for the other side.
    const WAY: u8;
}

/// A key that both sides know and nobody else.
#[cfg(feature = "authentic")]
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Key(pub [u8; 16]);

#[cfg(feature = "authentic")]
impl Key {
    /// One that everybody knows, for emulated boards and tests: it protects nobody.
    pub const PUBLISHED: Self = Self(*b"a published key.");
}

#[cfg(feature = "authentic")]
impl core::fmt::Debug for Key {
    /// Does not show it.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Key")
    }
}

/// How a message is sealed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seal {
    /// CRC-32C, 4 bytes: against accidents. Who can write to the wire can order.
    Checksum,
    /// SipHash-2-4 with a key, 8 bytes: against others, too. Nothing is secret.
    #[cfg(feature = "authentic")]
    Keyed(Key),
}

impl Seal {
    /// Bytes of a seal.
    const fn bytes(&self) -> usize {
        match self {
            Self::Checksum => 4,
            #[cfg(feature = "authentic")]
            Self::Keyed(_) => 8,
        }
    }

    /// The seal of a message; the first [`bytes`](Self::bytes) count.
    fn of(&self, way: u8, message: &[u8]) -> [u8; 8] {
        let seal = match self {
            Self::Checksum => {
                let mut digest = CRC.digest();
                digest.update(&[way]);
                digest.update(message);
                u64::from(digest.finalize())
            }
            #[cfg(feature = "authentic")]
            Self::Keyed(Key(key)) => {
                use core::hash::Hasher;
                let mut hash = siphasher::sip::SipHasher24::new_with_key(key);
                hash.write(&[way]);
                hash.write(message);
                hash.finish()
            }
        };
        seal.to_le_bytes()
    }
}

/// Writes a frame with its zeros; `None` for a message that does not fit.
#[must_use]
pub fn encode<'a, T: Said>(it: &T, seal: &Seal, frame: &'a mut [u8; FRAME]) -> Option<&'a [u8]> {
    let mut plain = [0; FRAME];
    let length = postcard::to_slice(it, &mut plain).ok()?.len();
    let sealed = length + seal.bytes();
    let (message, rest) = plain.split_at_mut_checked(length)?;
    let sum = seal.of(T::WAY, message);
    rest.get_mut(..seal.bytes())?
        .copy_from_slice(sum.get(..seal.bytes())?);
    *frame.first_mut()? = 0;
    let body = frame.get_mut(1..FRAME - 1)?;
    let length = cobs::try_encode(plain.get(..sealed)?, body).ok()?;
    *frame.get_mut(length + 1)? = 0;
    frame.get(..length + 2)
}

/// A frame that came to its end but cannot be followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Cut short, damaged, not sealed as agreed, or no message to its last byte.
    Broken,
    /// Longer than [`FRAME`].
    Oversized,
}

/// Puts frames together from bytes as they come.
#[derive(Clone, Debug)]
pub struct Receiver {
    seal: Seal,
    frame: [u8; FRAME],
    filled: usize,
}

impl Receiver {
    /// Nothing received yet.
    #[must_use]
    pub const fn new(seal: Seal) -> Self {
        Self {
            seal,
            frame: [0; FRAME],
            filled: 0,
        }
    }

    /// How frames are sealed.
    #[must_use]
    pub const fn seal(&self) -> &Seal {
        &self.seal
    }

    /// A pause that no frame has inside: what came of one is dropped, and is a fault.
    pub fn pause(&mut self) -> Option<Fault> {
        match core::mem::take(&mut self.filled) {
            0 => None,
            _ => Some(Fault::Broken),
        }
    }

    /// Takes one byte; answers when it ends a frame. Zeros without a frame are skipped.
    pub fn take<T: Said>(&mut self, byte: u8) -> Option<Result<T, Fault>> {
        if byte != 0 {
            if let Some(place) = self.frame.get_mut(self.filled) {
                *place = byte;
            }
            self.filled = self.filled.saturating_add(1);
            return None;
        }
        let filled = core::mem::take(&mut self.filled);
        if filled == 0 {
            return None;
        }
        let Some(body) = self.frame.get(..filled) else {
            return Some(Err(Fault::Oversized));
        };
        Some(decode(body, &self.seal).ok_or(Fault::Broken))
    }
}

/// The message of a frame without its zeros.
fn decode<T: Said>(body: &[u8], seal: &Seal) -> Option<T> {
    let mut plain = [0; FRAME];
    let length = cobs::decode(body, &mut plain).ok()?.frame_size();
    let length = length.checked_sub(seal.bytes())?;
    let (message, _) = plain.split_at_checked(length)?;
    let (it, _) = postcard::take_from_bytes::<T>(message).ok()?;
    // A number may be written in more than one way, and bytes may follow: only the one frame that
    // the sender of this message writes, with its seal, is taken.
    let mut frame = [0; FRAME];
    let again = encode(&it, seal, &mut frame)?;
    (again.get(1..again.len() - 1)? == body).then_some(it)
}
