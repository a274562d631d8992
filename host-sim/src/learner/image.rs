//! A learner's brain as the bytes of its image, in memory.

use std::convert::Infallible;

use cla_core::snapshot::{self, Names, Sink, Snapshot};

use crate::failure::Failure;

/// Takes all pieces.
struct Memory(Vec<u8>);

impl Sink for Memory {
    type Error = Infallible;

    fn write(&mut self, piece: &[u8]) -> Result<(), Infallible> {
        self.0.extend_from_slice(piece);
        Ok(())
    }
}

/// The image of a brain; `names` are those of its world's items and actions.
///
/// # Errors
/// When it is not born or is damaged.
pub fn image_of<B: Snapshot>(brain: &B, names: Names) -> Result<Vec<u8>, Failure> {
    let mut image = Memory(Vec::new());
    snapshot::save(brain, names, &mut image)?;
    Ok(image.0)
}

/// Takes the image of a brain that was another's until now, and the bytes behind it are left.
///
/// # Errors
/// When it is no whole image of such a brain; the brain is as it was.
pub fn take<B: Snapshot>(brain: &mut B, names: Names, image: &[u8]) -> Result<u32, Failure> {
    Ok(snapshot::load(brain, names, &mut &*image)?)
}
