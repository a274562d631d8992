//! Why a brain was not saved or an image not taken, in a sentence.

use core::fmt;

use super::limits::{OLDEST, VERSION};

/// Why a brain was not saved.
///
/// ```
/// use cla_core::snapshot::{SaveError, SinkFull};
/// let error = SaveError::<SinkFull>::Unsound("knowledge");
/// assert_eq!(error.to_string(), "the brain is damaged in its knowledge; nothing was written");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SaveError<E> {
    /// There is no life to save.
    NotBorn,
    /// A number is not finite, or a link points at nothing, in the part of that name: a good image
    /// is not to be replaced by this one.
    Unsound(&'static str),
    /// The sink said so; what was written is no image.
    Sink(E),
}

/// Why an image was not taken; the brain is as it was, but for [`Changed`](Self::Changed) and
/// [`Interrupted`](Self::Interrupted).
///
/// ```
/// use cla_core::snapshot::{LoadError, SourceEnd};
/// let error = LoadError::<SourceEnd>::Capacity { name: "patterns", image: 64, here: 128 };
/// assert_eq!(error.to_string(), "the image is of a brain with 64 patterns, and this one has 128");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LoadError<E> {
    /// There is nobody who could take knowledge: the brain is not born.
    NotBorn,
    /// It does not begin as an image does.
    NotAnImage,
    /// It is of another version of the format.
    Version {
        /// The image's.
        image: u16,
    },
    /// It was made with another arithmetic.
    Numerics,
    /// It is of another kind of brain.
    Kind {
        /// What it is of: `"an agent"`, `"a mind"`, or what one of them knows.
        image: &'static str,
        /// What was asked for.
        here: &'static str,
    },
    /// Its maps' weights are stored otherwise.
    Weights,
    /// It is of a brain with another capacity.
    Capacity {
        /// Of what.
        name: &'static str,
        /// The image's.
        image: u32,
        /// This brain's.
        here: u32,
    },
    /// Its items have other names.
    Items,
    /// Its actions have other names.
    Actions,
    /// Its end is missing.
    Truncated,
    /// The part of that name is damaged.
    Damaged(&'static str),
    /// The source said so, before anything was taken.
    Source(E),
    /// The source said so while the image was taken: the brain is unborn now.
    Interrupted(E),
    /// It was whole when it was checked and was not when it was taken: the brain is unborn now.
    Changed,
}

impl<E> LoadError<E> {
    /// Whether it is the image of another robot, program or version, and not one that is damaged or
    /// could not be read.
    #[must_use]
    pub const fn is_foreign(&self) -> bool {
        matches!(
            self,
            Self::Version { .. }
                | Self::Numerics
                | Self::Kind { .. }
                | Self::Weights
                | Self::Capacity { .. }
                | Self::Items
                | Self::Actions
        )
    }
}

impl<E: fmt::Display> fmt::Display for SaveError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotBorn => f.write_str("the brain is not born: there is no life to save"),
            Self::Unsound(part) => {
                f.write_str("the brain is damaged in its ")?;
                f.write_str(part)?;
                f.write_str("; nothing was written")
            }
            Self::Sink(error) => {
                f.write_str("the image could not be written: ")?;
                error.fmt(f)
            }
        }
    }
}

impl<E: fmt::Display> fmt::Display for LoadError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotBorn => f.write_str("the brain is not born: nobody could take the knowledge"),
            Self::NotAnImage => f.write_str("this is no image of a brain"),
            Self::Version { image } => write!(
                f,
                "the image is of version {image} of the format, and this program reads {OLDEST} to {VERSION}"
            ),
            Self::Numerics => {
                f.write_str("the image is of a life with another arithmetic (feature micromath)")
            }
            Self::Kind { image, here } => {
                f.write_str("the image is of ")?;
                f.write_str(image)?;
                f.write_str(", and one of ")?;
                f.write_str(here)?;
                f.write_str(" is asked for")
            }
            Self::Weights => f.write_str("the image is of a brain whose maps store weights otherwise"),
            Self::Capacity { name, image, here } => write!(
                f,
                "the image is of a brain with {image} {name}, and this one has {here}"
            ),
            Self::Items => f.write_str("the image is of a robot whose items have other names"),
            Self::Actions => f.write_str("the image is of a robot whose actions have other names"),
            Self::Truncated => f.write_str("the end of the image is missing"),
            Self::Damaged(part) => {
                f.write_str("the image is damaged in its ")?;
                f.write_str(part)
            }
            Self::Source(error) => {
                f.write_str("the image could not be read: ")?;
                error.fmt(f)
            }
            Self::Interrupted(error) => {
                f.write_str("the brain is unborn, as the image could not be read to its end: ")?;
                error.fmt(f)
            }
            Self::Changed => f.write_str(
                "the image changed between two readings: the brain is unborn, load another or be_born",
            ),
        }
    }
}

impl<E: fmt::Display + fmt::Debug> core::error::Error for SaveError<E> {}
impl<E: fmt::Display + fmt::Debug> core::error::Error for LoadError<E> {}
