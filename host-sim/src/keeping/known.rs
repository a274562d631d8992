//! The brains that this program knows by their images: the book's learner and the one learner of each
//! world of its own.

use std::path::Path;

use cla_core::forager::{pioneer, small};
use cla_core::forest::Mind;
use cla_core::snapshot::{LoadError, Snapshot, SourceEnd, load};
use cla_core::word::Vocabulary;

use super::file::{read, whole};
use super::portrait::Portrait;
use super::{of_agent, of_mind};
use crate::failure::Failure;
use crate::learner::mind::Brain;
use crate::world::generated::dweller;
use crate::world::keys::seeker;
use crate::world::lake::skater;
use crate::world::pomdp::shuttle;
use crate::world::vacuum::cleaner;

/// What came of trying an image.
type Tried = Result<Portrait, LoadError<SourceEnd>>;

/// The portrait of the brain in a file.
///
/// # Errors
/// When the file cannot be read, is no whole image, or is of a brain that is none of those known.
pub fn look(path: &Path) -> Result<Portrait, Failure> {
    let image = read(path)?;
    let portrait = portrait(&image).map_err(|why| format!("{}: {why}", path.display()))?;
    whole(portrait.bytes, &image, path)?;
    Ok(portrait)
}

macro_rules! agent {
    ($robot:literal, $name:ident, $image:expr) => {{
        let mut brain = Box::new($name::brain());
        let words = &$name::VOCABULARY;
        read_into(&mut *brain, words, $image)
            .map(|bytes| of($robot, bytes, of_agent::portrait(&brain, words)))
    }};
}

macro_rules! mind {
    ($robot:literal, $name:ident, $image:expr) => {{
        const ITEMS: usize = $name::ITEMS.len();
        const ACTIONS: usize = $name::ACTIONS.len();
        let mut mind = Box::new(Mind::new());
        let mind: &mut Brain<{ $name::WORDS }, ITEMS, ACTIONS> = &mut mind;
        let words = &$name::VOCABULARY;
        read_into(mind, words, $image)
            .map(|bytes| of($robot, bytes, of_mind::portrait(mind, words)))
    }};
}

fn of(robot: &str, bytes: u32, portrait: Portrait) -> Portrait {
    Portrait {
        robot: robot.to_owned(),
        bytes,
        ..portrait
    }
}

fn read_into<B: Snapshot>(
    brain: &mut B,
    words: &Vocabulary,
    mut image: &[u8],
) -> Result<u32, LoadError<SourceEnd>> {
    load(brain, words.names(), &mut image)
}

/// One after the other, until one fits.
const KNOWN: [fn(&[u8]) -> Tried; 13] = [
    |image| agent!("forager", pioneer, image),
    |image| agent!("forager, small", small, image),
    |image| mind!("forager", pioneer, image),
    |image| agent!("frozen lake", skater, image),
    |image| mind!("frozen lake", skater, image),
    |image| agent!("shuttle", shuttle, image),
    |image| mind!("shuttle", shuttle, image),
    |image| agent!("vacuum cleaner", cleaner, image),
    |image| mind!("vacuum cleaner", cleaner, image),
    |image| agent!("keys and doors", seeker, image),
    |image| mind!("keys and doors", seeker, image),
    |image| agent!("world by chance", dweller, image),
    |image| mind!("world by chance", dweller, image),
];

/// The brain of an image, and where it is none of those known, why it is not.
fn portrait(image: &[u8]) -> Result<Portrait, String> {
    let mut stranger = None;
    for it in KNOWN {
        match it(image) {
            Ok(portrait) => return Ok(portrait),
            Err(
                why @ (LoadError::Kind { .. }
                | LoadError::Weights
                | LoadError::Capacity { .. }
                | LoadError::Items
                | LoadError::Actions),
            ) => {
                stranger.get_or_insert(why);
            }
            // Another brain would be refused for the same.
            Err(why) => return Err(why.to_string()),
        }
    }
    let why = stranger.map_or_else(String::new, |why| format!(" (beside the forager's: {why})"));
    Err(format!(
        "this is the brain of no robot that this program knows{why}"
    ))
}
