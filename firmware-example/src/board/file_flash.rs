//! A NOR flash in a file of the host, with the pages and words of an nRF52840.
//!
//! The emulated Arm boards have no flash that outlives them, and the one of the RISC-V machine has
//! pages of 256 KiB. This one has pages of 4 KiB and words of 4 bytes; a word is written once after an
//! erase, and each word and each piece of a page is a call of its own to the host, so that an emulator
//! that is killed leaves half a write behind.

use embedded_storage::nor_flash::{
    ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash, check_erase, check_read, check_write,
};
use semihosting::fs::File;
use semihosting::io::{Read, Seek, SeekFrom, Write};

const PAGE: usize = 4096;
const WORD: usize = 4;
/// What is erased with one call.
const PIECE: usize = 128;

/// The file; it is made, erased, when it is not there.
#[derive(Debug)]
pub struct FileFlash {
    file: File,
    bytes: usize,
}

impl FileFlash {
    /// Opens `flash.bin` in the emulator's folder; `None` when it can neither be opened nor made.
    #[must_use]
    pub fn open(bytes: usize) -> Option<Self> {
        let mut options = File::options();
        options.read(true).write(true);
        if let Ok(file) = options.open(c"flash.bin") {
            return Some(Self { file, bytes });
        }
        let file = options
            .create(true)
            .truncate(true)
            .open(c"flash.bin")
            .ok()?;
        let mut it = Self { file, bytes };
        it.erase(0, bytes as u32).ok()?;
        Some(it)
    }

    fn go_to(&mut self, offset: u32) -> Result<(), NorFlashErrorKind> {
        let place = SeekFrom::Start(offset.into());
        let moved = self.file.seek(place);
        moved.map(drop).map_err(|_| NorFlashErrorKind::Other)
    }
}

impl ErrorType for FileFlash {
    type Error = NorFlashErrorKind;
}

impl ReadNorFlash for FileFlash {
    const READ_SIZE: usize = 1;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), NorFlashErrorKind> {
        check_read(self, offset, bytes.len())?;
        self.go_to(offset)?;
        let read = self.file.read_exact(bytes);
        read.map_err(|_| NorFlashErrorKind::Other)
    }

    fn capacity(&self) -> usize {
        self.bytes
    }
}

impl NorFlash for FileFlash {
    const WRITE_SIZE: usize = WORD;
    const ERASE_SIZE: usize = PAGE;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), NorFlashErrorKind> {
        check_erase(self, from, to)?;
        self.go_to(from)?;
        for _ in 0..to.saturating_sub(from) as usize / PIECE {
            let written = self.file.write_all(&[0xff; PIECE]);
            written.map_err(|_| NorFlashErrorKind::Other)?;
        }
        Ok(())
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), NorFlashErrorKind> {
        check_write(self, offset, bytes.len())?;
        for (index, piece) in bytes.chunks(PIECE).enumerate() {
            let mut there = [0; PIECE];
            let there = there.get_mut(..piece.len()).unwrap_or_default();
            self.read(offset + (index * PIECE) as u32, there)?;
            if there.iter().any(|&byte| byte != 0xff) {
                return Err(NorFlashErrorKind::Other);
            }
        }
        self.go_to(offset)?;
        for word in bytes.chunks(WORD) {
            let written = self.file.write_all(word);
            written.map_err(|_| NorFlashErrorKind::Other)?;
        }
        Ok(())
    }
}
