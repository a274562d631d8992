//! One brain, one file.

use std::path::Path;

use cla_core::snapshot::{LoadError, Names, Snapshot, SourceEnd, check};

use crate::failure::Failure;
use crate::learner::image::{image_of, take};
use crate::whole::{read as read_file, write};

/// Most bytes of an image: a brain is smaller by far.
const MOST_BYTES: u64 = 1 << 28;

/// Keeps a brain in a file, in place of what the file held; answers its bytes.
///
/// # Errors
/// When the brain is not born or is damaged, or the file cannot be written; the old file stays.
pub fn keep<B: Snapshot>(brain: &B, names: Names, path: &Path) -> Result<u32, Failure> {
    let image = image_of(brain, names)?;
    write(path, &image)?;
    Ok(image.len() as u32)
}

/// Reads a brain from a file, which holds its image and nothing else.
///
/// # Errors
/// When there is no such file, or it is no whole image of such a brain; the brain is as it was.
pub fn recall<B: Snapshot>(brain: &mut B, names: Names, path: &Path) -> Result<u32, Failure> {
    let image = read(path)?;
    let refused = |it: LoadError<SourceEnd>| format!("{}: {it}", path.display());
    // What is taken cannot be given back: it is looked at first.
    let length = check::<B, _>(names, &mut &*image).map_err(refused)?;
    whole(length, &image, path)?;
    Ok(take(brain, names, &image).map_err(|it| format!("{}: {it}", path.display()))?)
}

/// Refuses bytes behind an image of this length: a file is not a slot of flash.
pub(super) fn whole(length: u32, image: &[u8], path: &Path) -> Result<u32, Failure> {
    if length as usize == image.len() {
        Ok(length)
    } else {
        Err(format!("{}: there are bytes behind the image", path.display()).into())
    }
}

/// All bytes of a file.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let failed = |why| format!("cannot read {}: {why}", path.display());
    Ok(read_file(path, MOST_BYTES).map_err(failed)?)
}
