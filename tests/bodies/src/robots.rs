//! The robots of the fuzzers: tables that are full after a few steps, and those of a whole forager.

#![allow(
    missing_docs,
    reason = "the names of items and actions say what they are"
)]

use cla_core::forest::Mind;
use cla_core::reason::Reason;

macro_rules! speck {
    ($name:ident, $($maps:tt)+) => {
        cla_core::brain! {
            /// A robot whose tables are full at once.
            pub mod $name {
                items: [left, right, lamp],
                actions: [turn, go],
                values: [lamp = 10.0],
                maps: $($maps)+,
                patterns: 4,
                schemas: 5,
                synthetic: 3,
                beliefs: 4,
                ram: 8_000,
            }
        }
    };
}

speck!(floats, 2 x 2);
speck!(bytes, 3 x 2 of bytes);

/// The one learner, as small: 3 items, 2 actions, 64 samples, 4 leaves, 4 rows, 6 states, 8 links.
pub(crate) type Mite = Mind<1, 3, 2, 4, 4, 4, 6, 8>;

/// The same with a reason: 4 remembered samples of an action, 5 schemas, 6 imagined states.
pub(crate) type Muse = Mind<1, 3, 2, 4, 4, 4, 6, 8, Reason<1, 3, 2, 4, 5, 6>>;

cla_core::brain! {
    /// The one learner with a reason.
    pub mod moth {
        items: [left, right, lamp, singed],
        actions: [turn, go, stay],
        values: [lamp = 10.0, singed = -5.0],
        samples: 64,
        imagines: 4,
        ram: 40_000,
    }
}
