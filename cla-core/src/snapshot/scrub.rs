//! A seal on a brain between two ticks, by which a bit that turned meanwhile is found and turned back.
//!
//! Nothing but a fault changes a brain while nobody calls it, and that is most of a robot's time.

use super::audit::Audit;
use super::mender::Flip;
use super::seal::{CHUNK, step};
use super::{Snapshot, Writer};

/// Sums over the fields of a living brain, in chunks of 512 fields.
///
/// [`seal`](Self::seal) after the last call of a tick, [`check`](Self::check) before the first of the
/// next.
/// One turned bit in a chunk is turned back; where more turned, or the length of a table did, the part
/// is named, and the last image is to be loaded.
/// What is computed from the rest (links, discounted values) is computed again.
/// It takes four bytes a chunk and one more for each section; both calls go through the whole brain
/// once, or through those sections that it was made for, so that one `Scrub` a section divides the
/// work.
///
/// ```
/// use cla_core::AgentConfig;
/// use cla_core::forager::small;
/// use cla_core::snapshot::{Audit, Scrub};
/// let mut brain = Box::new(small::brain());
/// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// let mut scrub = Scrub::<256>::new();
/// scrub.seal(&*brain)?;
/// // … the robot moves …
/// assert_eq!(scrub.check(&mut *brain), Some(Audit::Sound));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Scrub<const SUMS: usize> {
    sums: [u32; SUMS],
    first: usize,
    last: usize,
    sealed: bool,
}

/// There is no room for the sums of so large a brain: the seal is not made.
///
/// ```
/// let error = cla_core::snapshot::TooManyChunks { needed: 300 };
/// assert_eq!(error.to_string(), "a seal of this brain takes 300 sums");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooManyChunks {
    /// Sums that it takes.
    pub needed: u32,
}

impl core::fmt::Display for TooManyChunks {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "a seal of this brain takes {} sums", self.needed)
    }
}

impl core::error::Error for TooManyChunks {}

impl<const SUMS: usize> Scrub<SUMS> {
    /// For a whole brain; nothing is sealed.
    #[must_use]
    pub const fn new() -> Self {
        Self::of(0, usize::MAX)
    }

    /// For some sections of an image, from `first` to the one before `last`.
    #[must_use]
    pub const fn of(first: usize, last: usize) -> Self {
        Self {
            sums: [0; SUMS],
            first,
            last,
            sealed: false,
        }
    }

    fn sections<B: Snapshot>(&self) -> core::ops::Range<usize> {
        self.first..self.last.min(B::SECTIONS.len())
    }

    /// Seals a brain as it is now; it goes through it once.
    ///
    /// # Errors
    /// [`TooManyChunks`] when there are not enough sums; nothing is sealed then.
    pub fn seal<B: Snapshot>(&mut self, brain: &B) -> Result<(), TooManyChunks> {
        let mut used = 0;
        self.sealed = false;
        let sums = &mut self.sums;
        for number in self.first..self.last.min(B::SECTIONS.len()) {
            let head = used;
            used += 1;
            let fields = walk(brain, number, &mut |sum| {
                if let Some(place) = sums.get_mut(used) {
                    *place = sum;
                }
                used += 1;
            });
            if let Some(place) = sums.get_mut(head) {
                *place = fields;
            }
        }
        self.sealed = used <= SUMS;
        if self.sealed {
            Ok(())
        } else {
            Err(TooManyChunks {
                needed: used as u32,
            })
        }
    }

    /// Goes through a brain that was sealed, and turns back what turned meanwhile; `None` when nothing
    /// was sealed.
    ///
    /// [`Audit::Mended`] counts bits; what is [`Audit::Lost`] is as it was found.
    pub fn check<B: Snapshot>(&self, brain: &mut B) -> Option<Audit> {
        if !self.sealed {
            return None;
        }
        let mut found = Audit::Sound;
        let mut at = 0;
        for number in self.sections::<B>() {
            let (&fields, sums) = self.sums.get(at..)?.split_first()?;
            let sums = sums.get(..fields.div_ceil(CHUNK) as usize)?;
            at += 1 + sums.len();
            found = found.and(check(brain, number, fields, sums));
        }
        brain.rebuild();
        Some(found)
    }
}

impl<const SUMS: usize> Default for Scrub<SUMS> {
    fn default() -> Self {
        Self::new()
    }
}

/// Checks a section against its sums.
fn check<B: Snapshot>(brain: &mut B, number: usize, fields: u32, sums: &[u32]) -> Audit {
    let lost = Audit::Lost(B::SECTIONS.get(number).copied().unwrap_or("nothing"));
    // Each round turns one bit of another chunk back, or is the last.
    for mended in 0..=sums.len() as u32 {
        let Some((chunk, syndrome)) = (match differing(brain, number, fields, sums) {
            Some(differing) => differing,
            None => return lost,
        }) else {
            return Audit::of(mended);
        };
        let length = CHUNK.min(fields - chunk * CHUNK);
        let Some((field, bit)) = locate(syndrome, length) else {
            return lost;
        };
        turn(brain, number, chunk * CHUNK + field, bit);
        let again = differing(brain, number, fields, sums);
        if again.is_none_or(|next| next.is_some_and(|(next, _)| next <= chunk)) {
            turn(brain, number, chunk * CHUNK + field, bit);
            return lost;
        }
    }
    lost
}

/// The first chunk whose sum differs, and by what; `None` when there are not as many fields.
fn differing<B: Snapshot>(
    brain: &B,
    number: usize,
    fields: u32,
    sums: &[u32],
) -> Option<Option<(u32, u32)>> {
    let (mut first, mut chunk) = (None, 0);
    let found = walk(brain, number, &mut |sum| {
        let differs = sum ^ sums.get(chunk).copied().unwrap_or(sum);
        if differs != 0 && first.is_none() {
            first = Some((chunk as u32, differs));
        }
        chunk += 1;
    });
    (found == fields).then_some(first)
}

fn turn<B: Snapshot>(brain: &mut B, number: usize, field: u32, bit: u32) {
    brain.flip_section(number, &mut Flip::of_field(field, bit));
}

/// Gives the sum of each chunk of a section; answers how many fields there are.
#[inline(never)]
fn walk<B: Snapshot>(brain: &B, number: usize, each: &mut dyn FnMut(u32)) -> u32 {
    let mut to = Writer::sealing(each, B::limits());
    brain.store_section(number, &mut to);
    to.end_seal()
}

/// The field and the bit that change a sum so, in a chunk of so many fields.
fn locate(syndrome: u32, fields: u32) -> Option<(u32, u32)> {
    for bit in 0..u32::BITS {
        let mut change = 1 << bit;
        for back in 1..=fields {
            if change == syndrome {
                return Some((fields - back, bit));
            }
            change = step(change);
        }
    }
    None
}

#[cfg(test)]
#[path = "scrub_tests.rs"]
mod tests;
