//! Brains in files: trained a while and kept, gone on with, looked into, compared, exported.
//!
//! A file is whole or it is not there, and it is checked when it is read; see `cla_core::snapshot`.
//! `known` finds whose brain it is, `of_agent` and `of_mind` make its portrait; what is told, drawn on
//! a page, compared and exported is made from the portrait alone.

mod compare;
mod file;
mod graph;
mod known;
mod of_agent;
mod of_mind;
mod page;
mod portrait;
mod sizing;
mod told;
mod train;

use std::path::Path;

pub use file::{keep, recall};
pub use known::look;
pub use portrait::{Belief, Count, Filling, Item, Portrait, Schema, Sign, Voice};
pub use sizing::{Wanted, size};
pub use train::{Raised, Training, train};

use crate::failure::Failure;
use crate::whole::write;

/// Says what the brain of a file knows: sizes, health, items, schemas by value and reliability, habits,
/// beliefs; of each table the first `most` rows. With `onto` it becomes a page there, too.
///
/// # Errors
/// When the file is no whole image of a brain that is known, or the page cannot be written.
pub fn inspect(path: &Path, most: usize, onto: Option<&Path>) -> Result<String, Failure> {
    let portrait = look(path)?;
    let mut text = told::told(&portrait, most);
    if let Some(onto) = onto {
        write(onto, page::page(&portrait).as_bytes())?;
        text.push_str(&format!("\n\nthe page is {}", onto.display()));
    }
    Ok(text)
}

/// Says what was learned, lost and revalued from the brain of one file to that of another.
///
/// # Errors
/// When a file is no whole image of a brain that is known, or they are of different robots.
pub fn diff(before: &Path, after: &Path, most: usize) -> Result<String, Failure> {
    compare::compared(&look(before)?, &look(after)?, most)
}

/// The portrait of a brain as JSON: written into `onto`, or answered.
///
/// # Errors
/// When the file is no whole image of a brain that is known, or cannot be written.
pub fn export(path: &Path, onto: Option<&Path>) -> Result<String, Failure> {
    let json = serde_json::to_string_pretty(&look(path)?)?;
    let Some(onto) = onto else {
        return Ok(json);
    };
    write(onto, format!("{json}\n").as_bytes())?;
    Ok(format!("exported to {}", onto.display()))
}
