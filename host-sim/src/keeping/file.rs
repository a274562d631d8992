//! One brain, one file.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

use cla_core::snapshot::{LoadError, Names, Sink, Snapshot, SourceEnd, load, save};

use crate::failure::Failure;

/// Most bytes of an image: a brain is smaller by far.
const MOST_BYTES: u64 = 1 << 28;

/// An image in memory.
struct Memory(Vec<u8>);

impl Sink for Memory {
    type Error = std::convert::Infallible;

    fn write(&mut self, piece: &[u8]) -> Result<(), Self::Error> {
        self.0.extend_from_slice(piece);
        Ok(())
    }
}

/// Keeps a brain in a file, in place of what the file held; answers its bytes.
///
/// It is written beside its place, flushed to the disk and renamed, so whoever reads finds the old
/// brain or the new one.
///
/// # Errors
/// When the brain is not born or is damaged, or the file cannot be written; the old file stays.
pub fn keep<B: Snapshot>(brain: &B, names: Names, path: &Path) -> Result<u32, Failure> {
    let mut image = Memory(Vec::new());
    let length = save(brain, names, &mut image)?;
    let failed = |error| format!("cannot write {}: {error}", path.display());
    let name = path.file_name().ok_or("a brain needs the name of a file")?;
    let mut beside = name.to_owned();
    beside.push(format!(".unfinished.{}", std::process::id()));
    let beside = path.with_file_name(beside);
    let write = || {
        let mut file = File::create(&beside)?;
        file.write_all(&image.0)?;
        file.sync_all()?;
        fs::rename(&beside, path)
    };
    write().map_err(|error| {
        // What was begun is of no use to anybody.
        let _ = fs::remove_file(&beside);
        failed(error)
    })?;
    Ok(length)
}

/// Reads a brain from a file.
///
/// # Errors
/// When there is no such file, or it is no whole image of such a brain; the brain is as it was. Where
/// bytes stand behind the image it was taken all the same.
pub fn recall<B: Snapshot>(brain: &mut B, names: Names, path: &Path) -> Result<u32, Failure> {
    let image = read(path)?;
    let refused = |it: LoadError<SourceEnd>| format!("{}: {it}", path.display());
    let length = load(brain, names, &mut &*image).map_err(refused)?;
    if length as usize != image.len() {
        // It was taken, and is right; but a file is not a slot of flash.
        return Err(format!("{}: there are bytes behind the image", path.display()).into());
    }
    Ok(length)
}

/// All bytes of a file.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let failed = |error| format!("cannot read {}: {error}", path.display());
    let length = fs::metadata(path).map_err(failed)?.len();
    if length > MOST_BYTES {
        return Err(format!("{}: this is no image of a brain", path.display()).into());
    }
    Ok(fs::read(path).map_err(failed)?)
}
