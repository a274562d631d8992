//! For which brain an image was made.

use super::limits::{OLDEST, VERSION};
use super::refusal::LoadError;
use super::writer::OF_SECTIONS;
use super::{Reader, Writer};

/// What an image begins with.
const MAGIC: [u8; 8] = *b"CLABRAIN";
/// Bytes of the header of this version, with its checksum.
pub(super) const HEADER: u16 = 80;
/// Which arithmetic a life was lived with: another one goes on with other bits.
pub(super) const NUMERICS: u16 = if cfg!(feature = "micromath") { 2 } else { 1 };
/// The bit of a kind that says: knowledge alone.
const KNOWLEDGE: u8 = 128;
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
    /// 1 for an agent, 2 for a mind; 128 more for what it knows alone.
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

/// What a header says that has the right checksum and the right arithmetic.
struct Found {
    kind: u8,
    weights: u8,
    capacities: [u32; CAPACITIES],
    names: Names,
    length: u32,
}

/// The profile of an image of knowledge alone: of another kind, and without maps.
pub(super) const fn of_knowledge(profile: &Profile) -> Profile {
    Profile {
        kind: profile.kind | KNOWLEDGE,
        weights: 0,
        capacities: profile.capacities,
    }
}

/// How large the brain was whose knowledge is read, in the order of its profile.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    capacities: [u32; CAPACITIES],
}

impl Origin {
    /// The capacity of that number, at most `most`: a loop over it is bounded by it.
    pub(crate) fn capacity(&self, number: usize, most: usize) -> usize {
        let found = self.capacities.get(number).copied().unwrap_or(0);
        (found as usize).min(most)
    }
}

/// How long an image of knowledge is, and how large the brain was.
pub(super) struct Kept {
    pub(super) length: u32,
    pub(super) origin: Origin,
}

/// A robot that is to take knowledge: which capacities are those of its items and actions, and what
/// they are called.
pub(super) struct Robot<'a> {
    pub(super) places: [usize; 2],
    pub(super) names: [&'a [&'a str]; 2],
}

/// Reads the header of an image of knowledge for a brain of this profile.
pub(super) fn read_knowledge<E>(
    profile: &Profile,
    robot: &Robot<'_>,
    there: u32,
    from: &mut Reader<'_>,
) -> Result<Kept, LoadError<E>> {
    let found = found(there, from)?;
    is_kind(found.kind, profile.kind | KNOWLEDGE)?;
    let own = profile.capacities.iter().copied();
    let all = found.capacities.into_iter().zip(own);
    for (number, (image, (name, here))) in all.enumerate() {
        if robot.places.contains(&number) && image > here {
            return Err(LoadError::Capacity { name, image, here });
        }
    }
    let [items, actions] = robot.names;
    let [item_count, action_count] = robot.places.map(|at| {
        let many = found.capacities.get(at).copied();
        many.unwrap_or(0) as usize
    });
    let differ = |image, names: &[&str], many| {
        image != 0 && image != sum(names.get(..many).unwrap_or(names))
    };
    if differ(found.names.items, items, item_count) {
        return Err(LoadError::Items);
    }
    if differ(found.names.actions, actions, action_count) {
        return Err(LoadError::Actions);
    }
    Ok(Kept {
        length: found.length,
        origin: Origin {
            capacities: found.capacities,
        },
    })
}

/// Refuses an image of another kind, by the names of both.
fn is_kind<E>(image: u8, here: u8) -> Result<(), LoadError<E>> {
    if image == here {
        return Ok(());
    }
    let [image, here] = [image, here].map(|kind| match kind {
        1 => "an agent",
        2 => "a mind",
        129 => "an agent's knowledge",
        130 => "a mind's knowledge",
        _ => "a brain that this program does not know",
    });
    Err(LoadError::Kind { image, here })
}

/// Reads the header; how long the image is.
pub(super) fn read<E>(
    profile: &Profile,
    names: Names,
    there: u32,
    from: &mut Reader<'_>,
) -> Result<u32, LoadError<E>> {
    let found = found(there, from)?;
    is_kind(found.kind, profile.kind)?;
    if found.weights != profile.weights {
        return Err(LoadError::Weights);
    }
    let own = profile.capacities.iter().copied();
    let own = own.chain([("capacities", 0); CAPACITIES]);
    for (image, (name, here)) in found.capacities.into_iter().zip(own) {
        if image != here {
            return Err(LoadError::Capacity { name, image, here });
        }
    }
    let differ = |one, other| one != 0 && other != 0 && one != other;
    if differ(found.names.items, names.items) {
        return Err(LoadError::Items);
    }
    if differ(found.names.actions, names.actions) {
        return Err(LoadError::Actions);
    }
    Ok(found.length)
}

fn found<E>(there: u32, from: &mut Reader<'_>) -> Result<Found, LoadError<E>> {
    if there < u32::from(HEADER) {
        return Err(LoadError::Truncated);
    }
    from.allow(u32::from(HEADER) - 4);
    let magic: [u8; 8] = from.bytes();
    let [version, header, numerics] = [(); 3].map(|()| u16::from_le_bytes(from.bytes()));
    let [kind, weights] = from.bytes();
    let capacities = [(); CAPACITIES].map(|()| u32::from_le_bytes(from.bytes()));
    let [items, actions, length] = [(); 3].map(|()| u32::from_le_bytes(from.bytes()));
    if from.is_wrong() {
        return Err(LoadError::Damaged("header"));
    }
    if magic != MAGIC {
        return Err(LoadError::NotAnImage);
    }
    let is_read = (OLDEST..=VERSION).contains(&version);
    // The header of a later version may be longer, and then its checksum lies elsewhere.
    from.end_section();
    if from.is_wrong() {
        return Err(if is_read {
            LoadError::Damaged("header")
        } else {
            LoadError::Version { image: version }
        });
    }
    if !is_read {
        return Err(LoadError::Version { image: version });
    }
    if header != HEADER || length < u32::from(HEADER) {
        return Err(LoadError::Damaged("header"));
    }
    if numerics != NUMERICS {
        return Err(LoadError::Numerics);
    }
    if length > there {
        return Err(LoadError::Truncated);
    }
    from.set_version(version);
    Ok(Found {
        kind,
        weights,
        capacities,
        names: Names { items, actions },
        length,
    })
}
