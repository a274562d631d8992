//! All settings of a run as the file that is written beside its results, and read as settings again.

use serde_json::{Value, json};

use crate::failure::Impossible;
use crate::settings::{text, tree_of};
use crate::world::setting::WorldOptions;

/// The file's name.
pub const SETTINGS: &str = "settings.toml";

/// Settings as the text of a file, with the seeds, which follow each other.
///
/// # Errors
/// [`Impossible`] for a value that TOML cannot say.
pub(super) fn file(seeds: &[u64], mut all: Value) -> Result<String, Impossible> {
    if let (Some(first), Some(last)) = (seeds.first(), seeds.last()) {
        all["seeds"] = format!("{first}..{}", last + 1).into();
    }
    text(&all)
}

/// The Pioneer's room as settings.
///
/// # Errors
/// [`Impossible`] for what has no form in JSON.
pub(super) fn room(world: &WorldOptions) -> Result<Value, Impossible> {
    let mut all = tree_of(&world.config)?;
    // Who asks for the other one when the file is read again gets all of that.
    let it = &world.config;
    let is_quiet = [it.drop_out, it.step_noise, it.turn_noise]
        .iter()
        .all(|it| *it == 0.0);
    all["name"] = if is_quiet { "noise-free" } else { "pioneer" }.into();
    if let Some(path) = &world.path {
        all["layout"] = json!(path.display().to_string());
    }
    Ok(all)
}
