//! CLASM: sensorimotor schemas grown from maps, and a controller that uses them (book, 5.3, 6.1–6.2).

mod item;

pub use item::{ItemId, ItemOutOfRange, ItemSet, ItemStates, Items};
