//! Memory that behaves as NOR flash: for examples, tests and parts whose RAM has a battery.

use embedded_storage::nor_flash::{
    ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash, check_erase, check_read, check_write,
};

/// Bytes with the rules of NOR flash: a page is erased to ones, and a word is written once.
///
/// A write over what is not erased is refused (`NorFlashErrorKind::Other`).
///
/// ```
/// use cla_core::flash::RamFlash;
/// use embedded_storage::nor_flash::{NorFlash, ReadNorFlash};
/// let mut bytes = [0; 8];
/// let mut flash = RamFlash::<4, 8>::new(&mut bytes);
/// assert!(flash.write(0, &[1, 2, 3, 4]).is_err());
/// flash.erase(0, 8)?;
/// flash.write(0, &[1, 2, 3, 4])?;
/// let mut read = [0; 2];
/// flash.read(3, &mut read)?;
/// assert_eq!(read, [4, 0xff]);
/// # Ok::<(), embedded_storage::nor_flash::NorFlashErrorKind>(())
/// ```
#[derive(Debug)]
pub struct RamFlash<'a, const WORD: usize, const PAGE: usize> {
    bytes: &'a mut [u8],
}

impl<'a, const WORD: usize, const PAGE: usize> RamFlash<'a, WORD, PAGE> {
    /// A flash of these bytes, as they are.
    #[must_use]
    pub const fn new(bytes: &'a mut [u8]) -> Self {
        Self { bytes }
    }

    fn part(&mut self, from: u32, length: usize) -> Result<&mut [u8], NorFlashErrorKind> {
        let part = self.bytes.get_mut(from as usize..);
        let part = part.and_then(|it| it.get_mut(..length));
        part.ok_or(NorFlashErrorKind::OutOfBounds)
    }
}

impl<const WORD: usize, const PAGE: usize> ErrorType for RamFlash<'_, WORD, PAGE> {
    type Error = NorFlashErrorKind;
}

impl<const WORD: usize, const PAGE: usize> ReadNorFlash for RamFlash<'_, WORD, PAGE> {
    const READ_SIZE: usize = 1;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), NorFlashErrorKind> {
        check_read(self, offset, bytes.len())?;
        let from = self.part(offset, bytes.len())?;
        bytes.iter_mut().zip(from).for_each(|(to, it)| *to = *it);
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.bytes.len()
    }
}

impl<const WORD: usize, const PAGE: usize> NorFlash for RamFlash<'_, WORD, PAGE> {
    const WRITE_SIZE: usize = WORD;
    const ERASE_SIZE: usize = PAGE;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), NorFlashErrorKind> {
        check_erase(self, from, to)?;
        self.part(from, to.saturating_sub(from) as usize)?
            .fill(0xff);
        Ok(())
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), NorFlashErrorKind> {
        check_write(self, offset, bytes.len())?;
        let to = self.part(offset, bytes.len())?;
        if to.iter().any(|&byte| byte != 0xff) {
            return Err(NorFlashErrorKind::Other);
        }
        to.iter_mut().zip(bytes).for_each(|(to, it)| *to = *it);
        Ok(())
    }
}
