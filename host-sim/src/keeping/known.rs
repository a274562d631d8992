//! The brains that this program knows by their images: the book's learner and the one learner of each
//! world of its own, of those in which places look alike, and of any other in which `live` lets them live.
//!
//! An image says what its items are called by a checksum alone: where no list of names fits it, items
//! and actions have their numbers for names.

use std::path::Path;
use std::thread;

use cla_core::forager::{pioneer, small};
use cla_core::forest::Mind;
use cla_core::snapshot::{LoadError, Names, Snapshot, SourceEnd, load};
use cla_core::word::Vocabulary;

use super::file::{read, whole};
use super::portrait::Portrait;
use super::{of_agent, of_mind};
use crate::experiment::aliased::{Book, Place};
use crate::experiment::live::Settler;
use crate::failure::Failure;
use crate::learner::mind::Brain;
use crate::world::WORLD_WORDS;
use crate::world::generated::dweller;
use crate::world::keys::seeker;
use crate::world::lake::skater;
use crate::world::names::kept;
use crate::world::pomdp::shuttle;
use crate::world::vacuum::cleaner;

/// What came of trying an image.
type Tried = Result<Portrait, LoadError<SourceEnd>>;

/// Bytes of stack: the largest brain passes over it on its way to the heap.
const STACK: usize = 64 << 20;

/// What is said of the world of a brain whose names are not known here: by the checksums of its names, so
/// that two of one world are known as such.
fn unnamed(image: &[u8]) -> String {
    let sums = image.get(64..72).unwrap_or_default().iter();
    let digits: String = sums.map(|byte| format!("{byte:02x}")).collect();
    format!("world {digits} whose names are not known here")
}

/// The portrait of the brain in a file.
///
/// # Errors
/// When the file cannot be read, is no whole image, or is of a brain that is none of those known.
pub fn look(path: &Path) -> Result<Portrait, Failure> {
    let image = read(path)?;
    let tried = thread::scope(|scope| -> Result<_, Failure> {
        let builder = thread::Builder::new().stack_size(STACK);
        let handle = builder.spawn_scoped(scope, || portrait(&image))?;
        match handle.join() {
            Ok(tried) => Ok(tried),
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })?;
    let portrait = tried.map_err(|why| format!("{}: {why}", path.display()))?;
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

/// What the items and actions of a world are called in which places look alike.
fn words_of(place: Place) -> Vocabulary {
    match place.model() {
        Ok(Some(model)) => Vocabulary {
            items: model.observations(),
            actions: model.actions(),
        },
        // The forager's room is of no file, and the project's own files can be read.
        _ => pioneer::VOCABULARY,
    }
}

/// The book's agent of a world in which places look alike.
fn alike_agent<const ITEMS: usize, const ACTIONS: usize>(
    robot: &str,
    place: Place,
    image: &[u8],
) -> Tried {
    let (mut brain, words) = (Box::new(Book::<ITEMS, ACTIONS>::new()), words_of(place));
    let bytes = read_into(&mut *brain, &words, image)?;
    let portrait = of_agent::portrait(&brain, &words);
    Ok(of(robot, bytes, portrait))
}

/// The one learner of such a world.
fn alike_mind<const ITEMS: usize, const ACTIONS: usize>(
    robot: &str,
    place: Place,
    image: &[u8],
) -> Tried {
    let words = words_of(place);
    let mut mind: Box<Brain<1, ITEMS, ACTIONS>> = Box::new(Mind::new());
    let bytes = read_into(&mut *mind, &words, image)?;
    let portrait = of_mind::portrait(&mind, &words);
    Ok(of(robot, bytes, portrait))
}

/// Items and actions by their numbers.
fn numbered(items: usize, actions: usize) -> Vocabulary {
    let names = |letter: char, many: usize| {
        let all = (0..many).map(|it| format!("{letter}{it}"));
        kept(&all.collect::<Vec<_>>())
    };
    Vocabulary {
        items: names('i', items),
        actions: names('a', actions),
    }
}

/// A mind of this size, whatever its items are called.
fn any_mind<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize>(
    mut image: &[u8],
) -> Tried {
    let mut mind: Box<Brain<WORDS, ITEMS, ACTIONS>> = Box::new(Mind::new());
    let robot = unnamed(image);
    let bytes = load(&mut *mind, Names::UNKNOWN, &mut image)?;
    let portrait = of_mind::portrait(&mind, &numbered(ITEMS, ACTIONS));
    Ok(of(&robot, bytes, portrait))
}

/// The agent with room for any world, whatever its items are called.
fn any_settler(mut image: &[u8]) -> Tried {
    let mut brain = Box::new(Settler::zeroed());
    let robot = unnamed(image);
    let bytes = load(&mut *brain, Names::UNKNOWN, &mut image)?;
    // No world has more items than these.
    let words = numbered(32 * WORLD_WORDS, brain.bank().maps().len());
    let portrait = of_agent::portrait(&brain, &words);
    Ok(of(&robot, bytes, portrait))
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

/// Those of `aliased`; the mind of its forager, and the mind and the agent of its shuttle, stand above.
const ALIKE: [fn(&[u8]) -> Tried; 7] = [
    |image| alike_agent::<7, 6>("forager among barriers", Place::Barriers, image),
    |image| alike_agent::<7, 4>("cheese maze", Place::Cheese, image),
    |image| alike_mind::<7, 4>("cheese maze", Place::Cheese, image),
    // Corridors of all lengths show the same.
    |image| alike_agent::<6, 3>("corridor", Place::TMaze2, image),
    |image| alike_mind::<6, 3>("corridor", Place::TMaze2, image),
    |image| alike_agent::<21, 5>("hallway", Place::Hallway, image),
    |image| alike_mind::<21, 5>("hallway", Place::Hallway, image),
];

/// The sizes that `live` has for other worlds, the widened ones and those of files among them.
const ANY: [fn(&[u8]) -> Tried; 17] = [
    any_settler,
    any_mind::<1, 7, 6>,
    any_mind::<1, 16, 4>,
    any_mind::<1, 5, 3>,
    any_mind::<1, 15, 5>,
    any_mind::<2, 48, 6>,
    any_mind::<2, 64, 3>,
    any_mind::<2, 64, 4>,
    any_mind::<2, 64, 5>,
    any_mind::<2, 64, 6>,
    any_mind::<2, 64, 7>,
    any_mind::<2, 64, 8>,
    any_mind::<2, 64, 9>,
    any_mind::<2, 64, 10>,
    any_mind::<2, 64, 11>,
    any_mind::<2, 64, 12>,
    any_mind::<4, 120, 12>,
];

/// The brain of an image, and where it is none of those known, why it is not.
fn portrait(image: &[u8]) -> Result<Portrait, String> {
    let mut stranger = None;
    for it in KNOWN.iter().chain(&ALIKE).chain(&ANY) {
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
