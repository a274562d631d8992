//! Words: what is perceived and done, and how it is written (book, 5.1.1).
//!
//! An item is on, off or unknown; a percept is what is known of all of them at one moment; a
//! conjunction of signed items is a context or a result; `+s3/forward/+s3+ingrip` writes it all.
//! Both learners speak these words: the agent with its maps and tables, and `growth`.
//! Here stands also what a control step touches and how a brain is doing, because everyone who works
//! adds to them.

mod action;
mod cost;
mod health;
mod item;
mod notation;
mod signed_items;
mod threshold;

pub use action::{ActionId, Vocabulary};
pub use cost::Cost;
pub(crate) use health::{BEARABLE, Gauge, State, Told, fullest};
pub use health::{Health, WINDOW};
pub use item::{ItemId, ItemOutOfRange, ItemSet, ItemStates, Items};
pub use notation::{Detail, NotationError, SchemaText, Written};
pub use signed_items::SignedItems;
pub use threshold::Threshold;
