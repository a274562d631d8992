//! Knowledge alone: what was learned, without maps and without what only the same life could go on
//! with; for the same robot or a larger one.
//!
//! The image has the header and the frame of every other; what its sections hold says itself how much
//! there is of it, so that a brain with more room, more items or more actions takes it.

use super::header::{self, Kept, Names, Origin, Robot};
use super::image::{self, Snapshot};
use super::port::{Sink, Source};
use super::reader::Unfit;
use super::refusal::{LoadError, SaveError};
use super::{Reader, Writer};

/// A brain whose knowledge can be kept alone, and be taken by another.
///
/// ```
/// use cla_core::forager::small;
/// use cla_core::snapshot::Knowing;
/// fn is_knowing<B: Knowing>() {}
/// is_knowing::<small::Brain>();
/// ```
pub trait Knowing: Snapshot {
    /// The names of the sections of knowledge, in the order in which they are stored.
    #[doc(hidden)]
    const KNOWLEDGE: &'static [&'static str];

    /// Which capacities are those of items and actions: a robot may have more, and not less.
    #[doc(hidden)]
    const ROBOT: [usize; 2];

    /// Writes the section of that number.
    #[doc(hidden)]
    fn store_knowledge(&self, number: usize, to: &mut Writer<'_>);

    /// Reads the section of that number, over what is there if there is anybody.
    #[doc(hidden)]
    fn take_knowledge(
        into: Option<&mut Self>,
        number: usize,
        origin: &Origin,
        from: &mut Reader<'_>,
    );

    /// Makes what was not read, after all sections were.
    #[doc(hidden)]
    fn settle_knowledge(&mut self);
}

/// Saves what a brain knows, without its maps and where its life stands; see [`Knowing`].
///
/// Answers the bytes of the image.
///
/// ```
/// use cla_core::AgentConfig;
/// use cla_core::forager::small;
/// use cla_core::snapshot::{SliceSink, load_knowledge, save_knowledge};
/// let words = small::VOCABULARY;
/// let mut brain = Box::new(small::brain());
/// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// let mut image = vec![0; 65_536];
/// let length = save_knowledge(&*brain, words.names(), &mut SliceSink::new(&mut image))?;
/// let mut other = Box::new(small::brain());
/// small::be_born(&mut other, AgentConfig::FORAGER, 2)?;
/// load_knowledge(&mut *other, words.items, words.actions, &mut &image[..length as usize])?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SaveError`]; unless the sink failed, nothing was written.
pub fn save_knowledge<B: Knowing, S: Sink>(
    brain: &B,
    names: Names,
    sink: &mut S,
) -> Result<u32, SaveError<S::Error>> {
    if !brain.is_born() {
        return Err(SaveError::NotBorn);
    }
    let parts = image::Parts {
        profile: header::of_knowledge(&B::PROFILE),
        names,
        sections: B::KNOWLEDGE,
        limits: B::limits(),
        store: B::store_knowledge,
    };
    parts.save(brain, sink)
}

/// Takes what another brain of the same robot knew, or of one with fewer items and actions; answers
/// the bytes of the image.
///
/// The brain must be born: it keeps its configuration, its generator, what is worth having, and the
/// stage of its life; what it knew before is gone.
/// `items` and `actions` are its own names; the first of them must be those of the image.
/// Items that are added at the end stand in no context yet, actions that are added were never tried.
///
/// See [`save_knowledge`] for an example.
///
/// # Errors
/// [`LoadError`]; the brain is as it was, but for [`LoadError::Changed`] and
/// [`LoadError::Interrupted`], after which it is unborn.
pub fn load_knowledge<B: Knowing, S: Source>(
    brain: &mut B,
    items: &[&str],
    actions: &[&str],
    source: &mut S,
) -> Result<u32, LoadError<S::Error>> {
    if !brain.is_born() {
        return Err(LoadError::NotBorn);
    }
    let there = source.length();
    let robot = Robot {
        places: B::ROBOT,
        names: [items, actions],
    };
    let mut walk = |mut into: Option<&mut B>| {
        image::pass(source, B::limits(), |from| {
            let Kept { length, origin } = header::read_knowledge(&B::PROFILE, &robot, there, from)?;
            let walked = image::sections(length, B::KNOWLEDGE, from, |number, from| {
                B::take_knowledge(into.as_deref_mut(), number, &origin, from);
            });
            walked.map_err(|error| match from.unfit() {
                Some(Unfit { name, image, here }) => LoadError::Capacity { name, image, here },
                None => error,
            })
        })
    };
    let length = walk(None)?;
    let taken = walk(Some(brain));
    match taken {
        Ok(taken) if taken == length => {
            brain.settle_knowledge();
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
