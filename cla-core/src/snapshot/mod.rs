//! Snapshots: what a brain has learned and where its life stands, as bytes that outlive a reset.
//!
//! [`save`] streams a brain into a [`Sink`], [`load`] reads it back from a [`Source`], and the life
//! goes on to the bit; the bytes are the same on every target.
//!
//! An image is a header, sections and a checksum, little-endian throughout:
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `CLABRAIN` |
//! | 2, 2, 2 | version of the format, bytes of the header, numerics |
//! | 1, 1 | kind of brain, what a map's weight is stored in |
//! | 4 · 12 | capacities, 0 where there are fewer |
//! | 4, 4 | checksums of the names of items and of actions, 0 where they are not known |
//! | 4, 4 | bytes of the whole image, CRC-32C of the header so far |
//! | 2, 4, …, 4 | for each section: its number, its bytes, the fields, CRC-32C of all that |
//! | 4 | CRC-32 of the whole image so far |
//!
//! Version 2 has a byte more than version 1, the kind of traces, behind the rates of habits; both are
//! read.
//! Two polynomials, because what one of them cannot see it cannot see twice.
//! Loading is all or nothing: the image is read once to be believed and a second time to be taken.
//! A configuration in an image has to work like any other.
//! Why it is not serde is told in `docs/decisions/snapshots.md`.

mod audit;
#[cfg(any(test, feature = "faults"))]
pub mod faults;
mod header;
mod image;
mod knowledge;
mod limits;
mod mender;
mod port;
mod reader;
mod refusal;
mod scrub;
mod seal;
mod section;
mod stored;
mod writer;

pub use audit::Audit;
pub(crate) use audit::mend_sections;
pub use header::{Names, Origin, Profile};
pub use image::{Snapshot, check, length, load, save};
pub use knowledge::{Knowing, load_knowledge, save_knowledge};
pub use limits::Limits;
pub(crate) use limits::{LARGEST, LARGEST_COUNT, LARGEST_VALUE, MOST_CHANGE, bounded, clipped};
pub use mender::{Flip, Mender};
pub use port::{Sink, SinkFull, SliceSink, Source, SourceEnd};
pub use reader::Reader;
pub use refusal::{LoadError, SaveError};
pub use scrub::{Scrub, TooManyChunks};
pub(crate) use section::{check_fields, flip_fields, mend_fields, restore_fields, store_fields};
pub use stored::Stored;
pub(crate) use stored::{Codes, check_field, check_that, refuses, stored, stored_as, stored_codes};
pub use writer::Writer;

#[cfg(test)]
#[path = "snapshot_tests.rs"]
mod tests;
