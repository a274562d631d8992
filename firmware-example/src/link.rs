//! The wire between a brain and a body: what is said, and how it is framed.
//!
//! A frame is a postcard message with its number and a CRC-32, in COBS, which leaves no zero in it,
//! and a zero at its end: whatever happened before a zero, the next frame begins after it.
//! Frames that are broken, too long or out of turn are counted and dropped; nothing here panics.

use crc::{CRC_32_ISCSI, Crc};
use serde::{Deserialize, Serialize};

/// The longest frame, in bytes, with its zero.
pub const FRAME: usize = 128;

const CRC: Crc<u32> = Crc::<u32>::new(&CRC_32_ISCSI);

/// What the body's side asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Order {
    /// Be born.
    Begin {
        /// Decides the whole life.
        seed: u64,
    },
    /// Choose an action for this percept (one bit an item).
    Choose {
        /// What the sensors say.
        now: u8,
    },
    /// Learn what the chosen action led to.
    Learn {
        /// What the sensors say.
        now: u8,
    },
    /// Learn from a reflex.
    Observe {
        /// What the sensors said before it.
        before: u8,
        /// The action that it ends with.
        action: u8,
        /// What they say after it.
        after: u8,
    },
    /// Begin the second level.
    SecondLevel,
    /// Training is over: choose by value, and let reliabilities adapt.
    Act,
    /// Say what you counted and what you know.
    Report,
    /// Stop the robot and end the program.
    Stop,
}

/// What the brain's side answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Answer {
    /// It is done.
    Done,
    /// Do this.
    Chosen {
        /// Id of the action.
        action: u8,
        /// The bits of the value that decided.
        value: u32,
    },
    /// The brain cannot do that now: not born, nothing chosen, or no such action.
    Refused,
    /// What was asked for with [`Order::Report`].
    Report {
        /// Frames that were dropped.
        dropped: Dropped,
        /// Schemas known.
        schemas: u16,
        /// A hash of all schemas with their counts and of all beliefs.
        knowledge: u64,
    },
}

/// Frames that were not followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Dropped {
    /// Cut short, damaged, or no message.
    pub broken: u32,
    /// Longer than [`FRAME`].
    pub oversized: u32,
    /// Old numbers, or numbers from the future.
    pub out_of_turn: u32,
    /// The last frame once more: answered as before, but not done again.
    pub repeated: u32,
}

/// A message with its number; an answer has the number of its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Numbered<T> {
    /// One more than that of the frame before; the first is 1.
    pub number: u32,
    /// What is said.
    pub message: T,
}

/// Writes a frame with its zero; `None` for a message that does not fit.
pub fn encode<'a, T: Serialize>(it: &Numbered<T>, frame: &'a mut [u8; FRAME]) -> Option<&'a [u8]> {
    let mut plain = [0; FRAME];
    let plain = postcard::to_slice_crc32(it, &mut plain, CRC.digest()).ok()?;
    let body = frame.get_mut(..FRAME - 1)?;
    let length = cobs::try_encode(plain, body).ok()?;
    *frame.get_mut(length)? = 0;
    frame.get(..=length)
}

/// A frame that came to its end but cannot be followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Cut short, damaged, or no message.
    Broken,
    /// Longer than [`FRAME`].
    Oversized,
}

/// Puts frames together from bytes as they come.
#[derive(Clone, Debug)]
pub struct Receiver {
    frame: [u8; FRAME],
    filled: usize,
}

impl Receiver {
    /// Nothing received yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            frame: [0; FRAME],
            filled: 0,
        }
    }

    /// Takes one byte; answers when it ends a frame. Zeros without a frame are skipped.
    pub fn take<T: for<'a> Deserialize<'a>>(
        &mut self,
        byte: u8,
    ) -> Option<Result<Numbered<T>, Fault>> {
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
        let Some(body) = self.frame.get_mut(..filled) else {
            return Some(Err(Fault::Oversized));
        };
        Some(decode(body).ok_or(Fault::Broken))
    }
}

impl Default for Receiver {
    fn default() -> Self {
        Self::new()
    }
}

fn decode<T: for<'a> Deserialize<'a>>(body: &mut [u8]) -> Option<Numbered<T>> {
    let length = cobs::decode_in_place(body).ok()?;
    postcard::from_bytes_crc32(body.get(..length)?, CRC.digest()).ok()
}
