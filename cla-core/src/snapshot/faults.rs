//! Faults for tests: a bit of a living brain turns, as in a memory that is hit.
//!
//! Compiled with the feature `faults` alone.
//! Any bit of a number, an id, a link or a bit set can turn, in tables and in what is computed from
//! them; of a tag or a length those bits that leave a value of its type: no other can be held without
//! `unsafe`.

use super::{Flip, Snapshot};

/// The bits of a brain that are held in memory.
///
/// ```
/// use cla_core::forager::{pioneer, small};
/// use cla_core::snapshot::faults;
/// let few = faults::bits(&mut *Box::new(small::brain()));
/// assert!(few < faults::bits(&mut *Box::new(pioneer::brain())));
/// ```
pub fn bits<B: Snapshot>(brain: &mut B) -> u32 {
    let mut count = Flip::of_memory(u32::MAX);
    for number in 0..B::SECTIONS.len() {
        brain.flip_section(number, &mut count);
    }
    count.bits()
}

/// Turns one of them, below [`bits`]; answers the section in which it lies.
///
/// A brain of fewer bits, and a bit that its place cannot hold, stay as they are.
///
/// ```
/// use cla_core::AgentConfig;
/// use cla_core::forager::small;
/// use cla_core::snapshot::{Audit, faults};
/// let mut brain = Box::new(small::brain());
/// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// let mut bit = 0;
/// while brain.audit() == Audit::Sound {
///     faults::flip(&mut *brain, bit);
///     bit += 1;
/// }
/// # Ok::<(), cla_core::ConfigError>(())
/// ```
pub fn flip<B: Snapshot>(brain: &mut B, bit: u32) -> Option<&'static str> {
    let mut by = Flip::of_memory(bit);
    for (number, name) in B::SECTIONS.iter().enumerate() {
        brain.flip_section(number, &mut by);
        if by.found() {
            return Some(name);
        }
    }
    None
}
