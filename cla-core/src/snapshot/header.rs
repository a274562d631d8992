//! For which brain an image was made.

use super::limits::VERSION;
use super::refusal::LoadError;
use super::writer::OF_SECTIONS;
use super::{Reader, Writer};

/// What an image begins with.
const MAGIC: [u8; 8] = *b"CLABRAIN";
/// Bytes of the header of this version, with its checksum.
pub(super) const HEADER: u16 = 80;
/// Which arithmetic a life was lived with: another one goes on with other bits.
pub(super) const NUMERICS: u16 = if cfg!(feature = "micromath") { 2 } else { 1 };
/// Capacities at most.
const CAPACITIES: usize = 12;

/// For which brain an image is: its kind and capacities.
///
/// ```
/// use cla_core::forager::{pioneer, small};
/// use cla_core::snapshot::Snapshot;
/// assert_ne!(pioneer::Brain::PROFILE, small::Brain::PROFILE);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Profile {
    /// 1 for an agent, 2 for a mind.
    pub(crate) kind: u8,
    /// What a weight of a map is stored in: 1 for `f32`, 2 for a byte, 0 without maps.
    pub(crate) weights: u8,
    /// Each capacity with its name, in the order of the type's parameters.
    pub(crate) capacities: &'static [(&'static str, u32)],
}

/// The names of items and actions, as checksums: a robot whose third item means something else is
/// another robot.
///
/// ```
/// use cla_core::forager::{pioneer, small};
/// use cla_core::snapshot::Names;
/// assert_eq!(pioneer::VOCABULARY.names(), small::VOCABULARY.names());
/// assert_ne!(pioneer::VOCABULARY.names(), Names::UNKNOWN);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Names {
    items: u32,
    actions: u32,
}

impl Names {
    /// Nobody knows them: they are not compared.
    pub const UNKNOWN: Self = Self {
        items: 0,
        actions: 0,
    };

    /// The names in the order of their ids.
    #[must_use]
    pub fn of(items: &[&str], actions: &[&str]) -> Self {
        Self {
            items: sum(items),
            actions: sum(actions),
        }
    }
}

/// A checksum of names; never 0, which stands for none.
fn sum(names: &[&str]) -> u32 {
    let mut digest = OF_SECTIONS.digest();
    for name in names {
        digest.update(name.as_bytes());
        digest.update(&[0]);
    }
    digest.finalize().max(1)
}

pub(super) fn write(profile: &Profile, names: Names, length: u32, to: &mut Writer<'_>) {
    to.bytes(&MAGIC);
    for number in [VERSION, HEADER, NUMERICS] {
        to.bytes(&number.to_le_bytes());
    }
    to.bytes(&[profile.kind, profile.weights]);
    let capacities = profile.capacities.iter().map(|(_, capacity)| *capacity);
    for capacity in capacities.chain([0; CAPACITIES]).take(CAPACITIES) {
        to.bytes(&capacity.to_le_bytes());
    }
    for number in [names.items, names.actions, length] {
        to.bytes(&number.to_le_bytes());
    }
    to.end_section();
}

/// Reads the header; how long the image is.
pub(super) fn read<E>(
    profile: &Profile,
    names: Names,
    there: u32,
    from: &mut Reader<'_>,
) -> Result<u32, LoadError<E>> {
    if there < u32::from(HEADER) {
        return Err(LoadError::Truncated);
    }
    from.allow(u32::from(HEADER) - 4);
    let magic: [u8; 8] = from.bytes();
    let [version, _, numerics] = [(); 3].map(|()| u16::from_le_bytes(from.bytes()));
    let [kind, weights] = from.bytes();
    let capacities = [(); CAPACITIES].map(|()| u32::from_le_bytes(from.bytes()));
    let [items, actions, length] = [(); 3].map(|()| u32::from_le_bytes(from.bytes()));
    if from.is_wrong() {
        return Err(LoadError::Damaged("header"));
    }
    if magic != MAGIC {
        return Err(LoadError::NotAnImage);
    }
    // The header of another version may be longer, and then its checksum lies elsewhere.
    from.end_section();
    if from.is_wrong() {
        return Err(if version == VERSION {
            LoadError::Damaged("header")
        } else {
            LoadError::Version { image: version }
        });
    }
    if version != VERSION {
        return Err(LoadError::Version { image: version });
    }
    if numerics != NUMERICS {
        return Err(LoadError::Numerics);
    }
    if kind != profile.kind {
        return Err(LoadError::Kind);
    }
    if weights != profile.weights {
        return Err(LoadError::Weights);
    }
    let own = profile.capacities.iter().copied();
    let own = own.chain([("capacities", 0); CAPACITIES]);
    for (image, (name, here)) in capacities.into_iter().zip(own) {
        if image != here {
            return Err(LoadError::Capacity { name, image, here });
        }
    }
    let differ = |one, other| one != 0 && other != 0 && one != other;
    if differ(items, names.items) {
        return Err(LoadError::Items);
    }
    if differ(actions, names.actions) {
        return Err(LoadError::Actions);
    }
    if length > there {
        return Err(LoadError::Truncated);
    }
    Ok(length)
}
