//! A NOR flash as its data sheet describes it, and as it is when the power goes.
//!
//! Erasing sets whole pages to ones, a word is written once after that, and anything else is counted
//! as a violation. When the power goes during an operation, the words before are written and those
//! behind are not; the cells of the word or page in between are done, or not, or hang between both
//! and read as either at every reading. A word with an error-correcting code is then mostly no
//! longer readable at all.

use std::cmp::Ordering;

use cla_core::num::Rng;
use embedded_storage::nor_flash::{
    ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash, check_erase, check_read, check_write,
};

/// How far an operation had come with its cells when the power went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Torn {
    /// Hardly any cell has changed.
    Barely,
    /// Half of them.
    Half,
    /// All but a few that hang.
    Nearly,
}

impl Torn {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Barely, Self::Half, Self::Nearly];

    /// How likely a cell is done, and how likely it hangs.
    const fn shares(self) -> (f32, f32) {
        match self {
            Self::Barely => (0.02, 0.04),
            Self::Half => (0.4, 0.2),
            Self::Nearly => (0.95, 0.05),
        }
    }
}

/// When the power goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// In which erase or write from now on, 0 the next.
    pub operation: u32,
    /// In which of its words or pages.
    pub part: u32,
    /// How far with that.
    pub torn: Torn,
}

/// An erase or a write of the past.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operation {
    /// Words that were written or pages that were erased.
    pub parts: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Word {
    Erased,
    Written,
    /// The power went while it was written or erased.
    Torn,
}

/// How a page fails that was erased more often than it endures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Worn {
    /// It says so when it is erased.
    Erase,
    /// It says so when it is written.
    Write,
    /// It says nothing, and some cells stay zero.
    Silent,
}

/// A flash with words of `WORD` bytes in pages of `PAGE`.
///
/// ```
/// use embedded_storage::nor_flash::NorFlash;
/// use host_sim::device::flash::fake::FakeFlash;
/// let mut flash = FakeFlash::<4, 64>::new(2, 1);
/// flash.erase(0, 64).unwrap();
/// flash.write(0, &[1, 2, 3, 4]).unwrap();
/// flash.write(0, &[1, 2, 3, 4]).unwrap();
/// assert_eq!(flash.violations(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct FakeFlash<const WORD: usize, const PAGE: usize> {
    cells: Vec<u8>,
    /// Cells that read as either.
    hanging: Vec<u8>,
    words: Vec<Word>,
    erased: Vec<u32>,
    endurance: u32,
    corrects_errors: bool,
    rng: Rng,
    cut: Option<Cut>,
    dead: bool,
    operations: Vec<Operation>,
    violations: u32,
}

impl<const WORD: usize, const PAGE: usize> FakeFlash<WORD, PAGE> {
    /// A flash of so many pages with whatever was in them.
    #[must_use]
    pub fn new(pages: usize, seed: u64) -> Self {
        let mut rng = Rng::new(seed);
        let cells = (0..pages * PAGE).map(|_| rng.next_u32() as u8).collect();
        Self {
            cells,
            hanging: vec![0; pages * PAGE],
            words: vec![Word::Written; pages * PAGE / WORD],
            erased: vec![0; pages],
            endurance: u32::MAX,
            corrects_errors: false,
            rng,
            cut: None,
            dead: false,
            operations: Vec::new(),
            violations: 0,
        }
    }

    /// The same with an error-correcting code for each word: a torn one is mostly unreadable, and is
    /// not written a second time.
    #[must_use]
    pub fn with_error_correction(self) -> Self {
        Self {
            corrects_errors: true,
            ..self
        }
    }

    /// The same with pages that endure so many erases, each up to a quarter more.
    #[must_use]
    pub fn with_endurance(self, endurance: u32) -> Self {
        Self { endurance, ..self }
    }

    /// Sets when the power goes.
    pub fn cut(&mut self, cut: Cut) {
        self.cut = Some(cut);
        self.operations.clear();
    }

    /// The power is back; `seed` decides how hanging cells read from now on.
    pub fn reboot(&mut self, seed: u64) {
        self.cut = None;
        self.dead = false;
        self.operations.clear();
        self.rng = Rng::new(seed);
    }

    /// Erases and writes since the last cut was set or the power came back.
    #[must_use]
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// How often the rules were broken: a word written twice, an operation out of its bounds.
    #[must_use]
    pub const fn violations(&self) -> u32 {
        self.violations
    }

    /// How often each page was erased.
    #[must_use]
    pub fn erased(&self) -> &[u32] {
        &self.erased
    }

    /// Flips a bit, as age and radiation do.
    pub fn flip(&mut self, bit: usize) {
        self.cells[bit / 8] ^= 1 << (bit % 8);
    }

    /// Bits there are.
    #[must_use]
    pub const fn bits(&self) -> usize {
        self.cells.len() * 8
    }

    /// How a page fails, if it does by now.
    fn worn(&self, page: usize) -> Option<Worn> {
        let more = u64::from(self.endurance) * (page as u64 * 7 % 5) / 16;
        let endured = u64::from(self.endurance) + more;
        let kinds = [Worn::Erase, Worn::Write, Worn::Silent];
        (u64::from(self.erased[page]) > endured).then(|| kinds[page % 3])
    }

    /// Notes an operation; the part in which the power goes, if it goes now.
    fn begin(&mut self, parts: usize) -> Option<(usize, Torn)> {
        let number = self.operations.len() as u32;
        self.operations.push(Operation {
            parts: parts as u32,
        });
        let cut = self.cut.filter(|it| it.operation == number)?;
        self.dead = true;
        Some(((cut.part as usize).min(parts.saturating_sub(1)), cut.torn))
    }

    fn violated(&mut self, kind: NorFlashErrorKind) -> NorFlashErrorKind {
        self.violations += 1;
        kind
    }

    /// Writes a word, or what becomes of it.
    fn program(&mut self, word: usize, bytes: &[u8], torn: Option<Torn>) {
        let from = word * WORD;
        for (index, &byte) in bytes.iter().enumerate() {
            let at = from + index;
            let worn = self.worn(at / PAGE) == Some(Worn::Silent) && index == 0;
            // A worn page forgets one cell of each word.
            let byte = if worn { byte & 0xfe } else { byte };
            let to_zero = !byte & (self.cells[at] | self.hanging[at]);
            let (done, hangs) = match torn {
                None => (to_zero, 0),
                Some(torn) => self.parts_of(to_zero, torn),
            };
            self.cells[at] &= !done;
            self.hanging[at] = self.hanging[at] & !done | hangs;
        }
        self.words[word] = match (torn, self.words[word]) {
            (None, Word::Erased) => Word::Written,
            _ => Word::Torn,
        };
    }

    /// Of some cells those that are done and those that hang.
    fn parts_of(&mut self, cells: u8, torn: Torn) -> (u8, u8) {
        let (share, hanging) = torn.shares();
        let (mut done, mut hangs) = (0, 0);
        for bit in (0..8).map(|it| 1 << it).filter(|it| cells & it != 0) {
            let chance = self.rng.unit();
            if chance < share {
                done |= bit;
            } else if chance < share + hanging {
                hangs |= bit;
            }
        }
        (done, hangs)
    }

    fn wipe(&mut self, page: usize, torn: Option<Torn>) {
        let cells = page * PAGE..(page + 1) * PAGE;
        match torn {
            None => {
                self.cells[cells.clone()].fill(0xff);
                self.hanging[cells].fill(0);
            }
            Some(torn) => {
                // Many parts program a page before they erase it.
                let programmed = self.rng.chance(0.5);
                for at in cells {
                    let old = if programmed && torn != Torn::Barely {
                        0
                    } else {
                        self.cells[at]
                    };
                    let (done, hangs) = self.parts_of(!old, torn);
                    self.cells[at] = old | done;
                    self.hanging[at] |= hangs;
                }
            }
        }
        let state = if torn.is_some() {
            Word::Torn
        } else {
            Word::Erased
        };
        self.words[page * PAGE / WORD..(page + 1) * PAGE / WORD].fill(state);
        self.erased[page] += 1;
    }
}

impl<const WORD: usize, const PAGE: usize> ErrorType for FakeFlash<WORD, PAGE> {
    type Error = NorFlashErrorKind;
}

impl<const WORD: usize, const PAGE: usize> ReadNorFlash for FakeFlash<WORD, PAGE> {
    const READ_SIZE: usize = WORD;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), NorFlashErrorKind> {
        if self.dead {
            return Err(NorFlashErrorKind::Other);
        }
        check_read(self, offset, bytes.len()).map_err(|it| self.violated(it))?;
        let from = offset as usize;
        let words = from / WORD..(from + bytes.len()) / WORD;
        if self.corrects_errors {
            let torn = self.words[words].contains(&Word::Torn);
            if torn && self.rng.chance(0.75) {
                return Err(NorFlashErrorKind::Other);
            }
        }
        for (index, byte) in bytes.iter_mut().enumerate() {
            let hanging = self.hanging[from + index];
            let chance = if hanging == 0 {
                0
            } else {
                self.rng.next_u32() as u8
            };
            *byte = self.cells[from + index] & !hanging | hanging & chance;
        }
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.cells.len()
    }
}

impl<const WORD: usize, const PAGE: usize> NorFlash for FakeFlash<WORD, PAGE> {
    const WRITE_SIZE: usize = WORD;
    const ERASE_SIZE: usize = PAGE;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), NorFlashErrorKind> {
        if self.dead {
            return Err(NorFlashErrorKind::Other);
        }
        check_erase(self, from, to).map_err(|it| self.violated(it))?;
        let pages = from as usize / PAGE..to as usize / PAGE;
        let cut = self.begin(pages.len());
        for (part, page) in pages.enumerate() {
            if self.worn(page) == Some(Worn::Erase) {
                return Err(NorFlashErrorKind::Other);
            }
            match cut.map(|(at, torn)| (part.cmp(&at), torn)) {
                Some((Ordering::Greater, _)) => break,
                Some((Ordering::Equal, torn)) => self.wipe(page, Some(torn)),
                _ => self.wipe(page, None),
            }
        }
        if self.dead {
            return Err(NorFlashErrorKind::Other);
        }
        Ok(())
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), NorFlashErrorKind> {
        if self.dead {
            return Err(NorFlashErrorKind::Other);
        }
        check_write(self, offset, bytes.len()).map_err(|it| self.violated(it))?;
        let first = offset as usize / WORD;
        let cut = self.begin(bytes.len() / WORD);
        for (part, word) in bytes.chunks(WORD).enumerate() {
            let at = first + part;
            if self.words[at] == Word::Written {
                self.violations += 1;
            }
            let refused = self.corrects_errors && self.words[at] == Word::Torn;
            if refused || self.worn(at * WORD / PAGE) == Some(Worn::Write) {
                return Err(NorFlashErrorKind::Other);
            }
            match cut.map(|(at, torn)| (part.cmp(&at), torn)) {
                Some((Ordering::Greater, _)) => break,
                Some((Ordering::Equal, torn)) => self.program(at, word, Some(torn)),
                _ => self.program(at, word, None),
            }
        }
        if self.dead {
            return Err(NorFlashErrorKind::Other);
        }
        Ok(())
    }
}
