//! Images in NOR flash: a brain survives a reset, and a power cut at any moment of a save.
//!
//! [`FlashStore`] keeps generations of a whole image in slots of a region of flash, over the traits of
//! `embedded-storage`; a save goes into the slot that is not needed, and the newest generation stays
//! until another one is whole. A slot is
//!
//! | records | what |
//! |---|---|
//! | 1 | header: written after the erase, before the image |
//! | 6 | commits and seals: written after the image was read back |
//! | – | the image, from the next multiple of 256 bytes on |
//!
//! and a record, little-endian, padded to the flash's word,
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `CLASLOT` and `h`, `c` or `s`: header, commit, seal |
//! | 4, 4 | generation, how often the slot was erased |
//! | 4, 4, 4 | tick, bytes of the image, its checksum; the header's is 0 |
//! | 4 | checksum of the record |
//!
//! A word that was being written when the power went may read as written today and not tomorrow. So a
//! commit is followed by a seal, which is begun only when the commit was written and read back: a seal
//! that can be read says that its commit always will be. A slot with a commit and no seal is sealed
//! anew when the store is opened, before anything else is erased.
//! Needs the feature `flash`. Why it is not `sequential-storage`: `docs/decisions/flash-store.md`.

mod fault;
mod ram;
mod record;
mod slot;
mod store;
mod writer;

pub use fault::{Fault, FlashCounts, LayoutError, ResumeError, StoreError, Unread};
pub use ram::RamFlash;
pub use slot::{FlashTiming, SaveCost};
pub use store::{FlashStore, Resumed, Saved};
