//! Files that are whole or not there.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

use crate::failure::Failure;

/// Writes a whole file in place of what was there.
///
/// It is written beside its place, flushed to the disk and renamed, so whoever reads finds the old
/// bytes or the new ones.
///
/// # Errors
/// When it cannot be written; the old file stays.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |error| format!("cannot write {}: {error}", path.display());
    let name = path.file_name().ok_or("a file needs a name")?;
    let mut beside = name.to_owned();
    beside.push(format!(".unfinished.{}", std::process::id()));
    let beside = path.with_file_name(beside);
    let write = || {
        let mut file = File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&beside, path)
    };
    write().map_err(|error| {
        // What was begun is of no use to anybody.
        let _ = fs::remove_file(&beside);
        failed(error)
    })?;
    Ok(())
}
