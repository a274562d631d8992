//! A whole image: header, sections, checksum; written in one pass, read in two.

use super::header::{self, HEADER, Names, Profile};
use super::limits::Limits;
use super::port::{Sink, Source};
use super::refusal::{LoadError, SaveError};
use super::{Reader, Writer};

/// Bytes around the fields of a section: number, length and checksum.
const FRAME: u32 = 2 + 4 + 4;

/// A brain whose life can be saved and go on elsewhere.
///
/// ```
/// use cla_core::forager::small;
/// use cla_core::snapshot::Snapshot;
/// assert_eq!(small::Brain::PROFILE, small::Brain::PROFILE);
/// ```
pub trait Snapshot {
    /// For which brains an image of this one is.
    const PROFILE: Profile;

    /// The names of the sections, in the order in which they are stored.
    #[doc(hidden)]
    const SECTIONS: &'static [&'static str];

    /// Whether there is a life to save.
    #[doc(hidden)]
    fn is_born(&self) -> bool;

    /// How many there are of what links point at, before any table is read.
    #[doc(hidden)]
    fn limits() -> Limits;

    /// Writes the section of that number.
    #[doc(hidden)]
    fn store_section(&self, number: usize, to: &mut Writer<'_>);

    /// Reads past the section of that number.
    #[doc(hidden)]
    fn check_section(number: usize, from: &mut Reader<'_>);

    /// Reads the section of that number over what is there.
    #[doc(hidden)]
    fn restore_section(&mut self, number: usize, from: &mut Reader<'_>);

    /// Makes what is not stored, after all sections were read.
    #[doc(hidden)]
    fn rebuild(&mut self);

    /// What was read is not to be trusted: the brain must not act.
    #[doc(hidden)]
    fn forsake(&mut self);
}

/// Saves a brain: `names` say what its items and actions mean.
///
/// The brain is gone through three times: to be checked and measured, as a whole and by sections, and
/// to be written; the sink gets pieces of at most 64 bytes, in order.
/// Answers the bytes of the image.
///
/// ```
/// use cla_core::forager::small;
/// use cla_core::{AgentConfig, snapshot};
/// let mut brain = Box::new(small::brain());
/// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// let mut image = vec![0; 65_536];
/// let names = small::VOCABULARY.names();
/// let length = snapshot::save(&*brain, names, &mut snapshot::SliceSink::new(&mut image))?;
/// let mut other = Box::new(small::brain());
/// snapshot::load(&mut *other, names, &mut &image[..length as usize])?;
/// let now = small::Percept::all_off(7);
/// assert_eq!(other.choose(&now)?, brain.choose(&now)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SaveError`]; unless the sink failed, nothing was written.
#[inline(never)]
pub fn save<B: Snapshot, S: Sink>(
    brain: &B,
    names: Names,
    sink: &mut S,
) -> Result<u32, SaveError<S::Error>> {
    if !brain.is_born() {
        return Err(SaveError::NotBorn);
    }
    let mut length = u32::from(HEADER) + 4;
    let mut measured = Writer::counting(B::limits());
    for (number, name) in B::SECTIONS.iter().enumerate() {
        measure(brain, number, &mut measured);
        if measured.is_unsound() {
            return Err(SaveError::Unsound(name));
        }
        length = length.wrapping_add(FRAME);
    }
    length = length.wrapping_add(measured.length());
    let mut error = None;
    let mut out = |piece: &[u8]| match sink.write(piece) {
        Ok(()) => true,
        Err(it) => {
            error = Some(it);
            false
        }
    };
    write(brain, names, length, &mut out);
    match error {
        None => Ok(length),
        Some(error) => Err(SaveError::Sink(error)),
    }
}

fn measure<B: Snapshot>(brain: &B, number: usize, measured: &mut Writer<'_>) {
    brain.store_section(number, measured);
    measured.limits.begin_section();
}

#[inline(never)]
fn write<B: Snapshot>(brain: &B, names: Names, length: u32, out: &mut dyn FnMut(&[u8]) -> bool) {
    let mut to = Writer::into(out, B::limits());
    header::write(&B::PROFILE, names, length, &mut to);
    for number in 0..B::SECTIONS.len() {
        let mut section = Writer::counting(to.limits);
        brain.store_section(number, &mut section);
        to.bytes(&(number as u16).to_le_bytes());
        to.bytes(&section.length().to_le_bytes());
        brain.store_section(number, &mut to);
        to.end_section();
        if to.has_failed() {
            return;
        }
    }
    to.end_image();
}

/// Loads a brain from its image; answers the bytes of the image.
///
/// The source is read twice: the first pass checks every checksum, number, range and link, and only
/// the second one writes into the brain, in place.
///
/// See [`save`] for an example.
///
/// # Errors
/// [`LoadError`]; the brain is as it was, but for [`LoadError::Changed`], after which it is unborn.
#[inline(never)]
pub fn load<B: Snapshot, S: Source>(
    brain: &mut B,
    names: Names,
    source: &mut S,
) -> Result<u32, LoadError<S::Error>> {
    let there = source.length();
    let length = pass::<B, S>(source, |from| {
        walk::<B, S::Error>(names, there, from, B::check_section)
    })?;
    let taken = pass::<B, S>(source, |from| {
        walk::<B, S::Error>(names, there, from, |number, from| {
            brain.restore_section(number, from);
        })
    });
    if taken.is_ok_and(|taken| taken == length) {
        brain.rebuild();
        return Ok(length);
    }
    brain.forsake();
    Err(LoadError::Changed)
}

/// Reads the source once.
fn pass<B: Snapshot, S: Source>(
    source: &mut S,
    walk: impl FnOnce(&mut Reader<'_>) -> Result<u32, LoadError<S::Error>>,
) -> Result<u32, LoadError<S::Error>> {
    let mut error = None;
    let mut input = |at: u32, piece: &mut [u8]| match source.read(at, piece) {
        Ok(()) => true,
        Err(it) => {
            error = Some(it);
            false
        }
    };
    let walked = walk(&mut Reader::of(&mut input, B::limits()));
    match error {
        Some(error) => Err(LoadError::Source(error)),
        None => walked,
    }
}

/// Goes through an image, section by section; how long it is.
#[inline(never)]
fn walk<B: Snapshot, E>(
    names: Names,
    there: u32,
    from: &mut Reader<'_>,
    mut each: impl FnMut(usize, &mut Reader<'_>),
) -> Result<u32, LoadError<E>> {
    let length = header::read(&B::PROFILE, names, there, from)?;
    for (number, name) in B::SECTIONS.iter().enumerate() {
        let damaged = LoadError::Damaged(name);
        from.allow(6);
        let found = u16::from_le_bytes(from.bytes());
        let bytes = u32::from_le_bytes(from.bytes());
        let left = length.saturating_sub(from.at());
        if from.is_wrong() || usize::from(found) != number || bytes > left {
            return Err(damaged);
        }
        from.allow(bytes);
        each(number, from);
        from.end_section();
        if from.is_wrong() {
            return Err(damaged);
        }
    }
    from.end_image();
    if from.is_wrong() || from.at() != length {
        return Err(LoadError::Damaged("end"));
    }
    Ok(length)
}
