//! A whole image: header, sections, checksum; written in one pass, read in two.

use core::convert::Infallible;

use super::header::{self, HEADER, Names, Profile};
use super::limits::Limits;
use super::port::{Sink, Source};
use super::refusal::{LoadError, SaveError};
use super::{Flip, Mender, Reader, Writer};

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

    /// Makes what cannot be so in the section of that number blank, in place.
    #[doc(hidden)]
    fn mend_section(&mut self, number: usize, by: &mut Mender);

    /// Turns a bit of the section of that number, if it is one of its bits.
    #[doc(hidden)]
    fn flip_section(&mut self, number: usize, by: &mut Flip);

    /// Makes what is not stored, after all sections were read.
    #[doc(hidden)]
    fn rebuild(&mut self);

    /// What was read is not to be trusted: the brain must not act.
    #[doc(hidden)]
    fn forsake(&mut self);
}

/// The bytes that the image of a brain would have now; nothing is written.
///
/// ```
/// use cla_core::forager::small;
/// use cla_core::{AgentConfig, snapshot};
/// let mut brain = Box::new(small::brain());
/// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// let mut saved = 0_u32;
/// snapshot::save(&*brain, small::VOCABULARY.names(), &mut saved)?;
/// assert_eq!(snapshot::length(&*brain), Ok(saved));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`save`], but for those of a sink.
pub fn length<B: Snapshot>(brain: &B) -> Result<u32, SaveError<Infallible>> {
    if !brain.is_born() {
        return Err(SaveError::NotBorn);
    }
    let length = whole::<B>(Names::UNKNOWN).length(brain);
    length.map_err(SaveError::Unsound)
}

/// Saves a brain: `names` say what its items and actions mean.
///
/// The brain is gone through three times: to be checked and measured, as a whole and by sections, and
/// to be written; the sink gets pieces of at most 64 bytes, in order.
/// Answers the bytes of the image.
///
/// A brain whose memory may have lost a bit is looked through first (`audit`): what is damaged is
/// refused here, and what is sound is saved.
///
/// A brain that is too large for the stack is copied in this way, too: saved, and loaded into another,
/// which `Box::new(const { robot::brain() })` makes on a heap, in place where the compiler optimizes and
/// over the stack where it does not; `clone` goes over the stack.
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
    whole::<B>(names).save(brain, sink)
}

/// The parts of an image of a whole brain.
fn whole<B: Snapshot>(names: Names) -> Parts<B> {
    Parts {
        profile: B::PROFILE,
        names,
        sections: B::SECTIONS,
        limits: B::limits(),
        store: B::store_section,
    }
}

/// What an image is made of.
pub(super) struct Parts<B> {
    pub(super) profile: Profile,
    pub(super) names: Names,
    pub(super) sections: &'static [&'static str],
    pub(super) limits: Limits,
    pub(super) store: fn(&B, usize, &mut Writer<'_>),
}

impl<B> Parts<B> {
    pub(super) fn save<S: Sink>(
        &self,
        brain: &B,
        sink: &mut S,
    ) -> Result<u32, SaveError<S::Error>> {
        let length = self.length(brain).map_err(SaveError::Unsound)?;
        let mut error = None;
        let mut out = |piece: &[u8]| match sink.write(piece) {
            Ok(()) => true,
            Err(it) => {
                error = Some(it);
                false
            }
        };
        self.write(brain, length, &mut out);
        match error {
            None => Ok(length),
            Some(error) => Err(SaveError::Sink(error)),
        }
    }

    /// The bytes of the image, or the part of the brain that is damaged.
    #[inline(never)]
    fn length(&self, brain: &B) -> Result<u32, &'static str> {
        let mut length = u32::from(HEADER) + 4;
        let mut measured = Writer::counting(self.limits);
        for (number, &name) in self.sections.iter().enumerate() {
            (self.store)(brain, number, &mut measured);
            measured.limits.begin_section();
            if measured.is_unsound() {
                return Err(name);
            }
            length = length.wrapping_add(FRAME);
        }
        Ok(length.wrapping_add(measured.length()))
    }

    #[inline(never)]
    fn write(&self, brain: &B, length: u32, out: &mut dyn FnMut(&[u8]) -> bool) {
        let mut to = Writer::into(out, self.limits);
        header::write(&self.profile, self.names, length, &mut to);
        for number in 0..self.sections.len() {
            let mut section = Writer::counting(to.limits);
            (self.store)(brain, number, &mut section);
            to.bytes(&(number as u16).to_le_bytes());
            to.bytes(&section.length().to_le_bytes());
            (self.store)(brain, number, &mut to);
            to.end_section();
            if to.has_failed() {
                return;
            }
        }
        to.end_image();
    }
}

/// Loads a brain from its image; answers the bytes of the image.
///
/// The source is read twice: the first pass checks every checksum, number, range and link, and only
/// the second one writes into the brain, in place.
///
/// What checksums cannot see, an image that was written to deceive, is refused or lives on with finite
/// numbers; an audit mends it, which is worth its time where others can write the medium.
///
/// See [`save`] for an example.
///
/// # Errors
/// [`LoadError`]; the brain is as it was, but for [`LoadError::Changed`] and
/// [`LoadError::Interrupted`], after which it is unborn.
#[inline(never)]
pub fn load<B: Snapshot, S: Source>(
    brain: &mut B,
    names: Names,
    source: &mut S,
) -> Result<u32, LoadError<S::Error>> {
    let there = source.length();
    let length = check::<B, S>(names, source)?;
    let taken = pass(source, B::limits(), |from| {
        walk::<B, S::Error>(names, there, from, |number, from| {
            brain.restore_section(number, from);
        })
    });
    match taken {
        Ok(taken) if taken == length => {
            brain.rebuild();
            Ok(length)
        }
        Err(LoadError::Source(error)) => {
            brain.forsake();
            Err(LoadError::Interrupted(error))
        }
        _ => {
            brain.forsake();
            Err(LoadError::Changed)
        }
    }
}

/// Checks an image as [`load`] does, and takes nothing; answers the bytes of the image.
///
/// ```
/// use cla_core::forager::small;
/// use cla_core::snapshot::{LoadError, Names, check};
/// let refused = check::<small::Brain, _>(Names::UNKNOWN, &mut &[7; 100][..]);
/// assert_eq!(refused, Err(LoadError::NotAnImage));
/// ```
///
/// # Errors
/// [`LoadError`], without those of taking it.
#[inline(never)]
pub fn check<B: Snapshot, S: Source>(
    names: Names,
    source: &mut S,
) -> Result<u32, LoadError<S::Error>> {
    let there = source.length();
    pass(source, B::limits(), |from| {
        walk::<B, S::Error>(names, there, from, B::check_section)
    })
}

/// Reads the source once.
pub(super) fn pass<S: Source>(
    source: &mut S,
    limits: Limits,
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
    let walked = walk(&mut Reader::of(&mut input, limits));
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
    each: impl FnMut(usize, &mut Reader<'_>),
) -> Result<u32, LoadError<E>> {
    let length = header::read(&B::PROFILE, names, there, from)?;
    sections(length, B::SECTIONS, from, each)
}

/// Goes through the sections behind a header; how long the image is.
pub(super) fn sections<E>(
    length: u32,
    names: &[&'static str],
    from: &mut Reader<'_>,
    mut each: impl FnMut(usize, &mut Reader<'_>),
) -> Result<u32, LoadError<E>> {
    for (number, name) in names.iter().enumerate() {
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
