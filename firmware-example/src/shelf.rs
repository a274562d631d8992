//! Generations of a brain in flash; one that this program cannot take is never written over.

use core::fmt;

use cla_core::flash::{FlashCounts, FlashStore, ResumeError, Resumed, Saved, StoreError};
use cla_core::snapshot::Snapshot;
use embedded_storage::nor_flash::NorFlash;

use crate::controller::Keep;
use crate::link::Life;
use crate::resume::names;

/// A store, and whether it may be saved into.
#[derive(Debug)]
pub struct Shelf<F, const SLOTS: usize> {
    store: FlashStore<F, SLOTS>,
    /// Whether it was looked what lies there, and all of it may be written over in its turn.
    free: bool,
}

/// Why a brain was not saved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotSaved<E> {
    /// A brain lies there that this program could not take, or nobody has looked: it is kept. To give
    /// it up, erase the flash.
    Foreign,
    /// The store could not.
    Store(StoreError<E>),
}

impl<E> fmt::Display for NotSaved<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Foreign => {
                f.write_str("the brain in the flash is of another program, and is kept")
            }
            Self::Store(error) => error.fmt(f),
        }
    }
}

impl<F: NorFlash, const SLOTS: usize> Shelf<F, SLOTS> {
    /// Nobody has looked yet what lies there.
    #[must_use]
    pub const fn new(store: FlashStore<F, SLOTS>) -> Self {
        Self { store, free: false }
    }

    /// Brings the newest life back that the brain takes.
    ///
    /// # Errors
    /// [`ResumeError::Nothing`] where nothing is lost by a new life; after any other, and where a newer
    /// life was refused than the one that is brought back, nothing is saved here.
    pub fn resume<B: Snapshot>(&mut self, brain: &mut B) -> Result<Resumed, ResumeError> {
        let resumed = self.store.resume(brain, names());
        self.free = match &resumed {
            // A newer one that is whole and was not taken would be the next to be erased.
            Ok(resumed) => resumed.refused == 0,
            Err(error) => *error == ResumeError::Nothing,
        };
        resumed
    }

    /// Saves a brain, with a number that [`resume`](Self::resume) gives back.
    ///
    /// # Errors
    /// [`NotSaved`]; what was there is still there.
    pub fn save<B: Snapshot>(&mut self, brain: &B, tick: u32) -> Result<Saved, NotSaved<F::Error>> {
        if !self.free {
            return Err(NotSaved::Foreign);
        }
        let saved = self.store.save(brain, names(), tick);
        saved.map_err(NotSaved::Store)
    }

    /// What has gone wrong since the store was opened.
    #[must_use]
    pub const fn counts(&self) -> FlashCounts {
        self.store.counts()
    }

    /// Gives the flash back.
    pub fn release(self) -> F {
        self.store.release()
    }
}

/// The number of a generation is the name of its life.
impl<F: NorFlash, const SLOTS: usize, B: Snapshot> Keep<B> for Shelf<F, SLOTS> {
    fn keep(&mut self, brain: &B, life: Life) -> Option<u32> {
        let saved = self.save(brain, life.0).ok()?;
        Some(saved.generation)
    }
}
