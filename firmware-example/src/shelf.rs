//! Generations of a brain in flash: it is looked through before each save, and a brain that this program
//! cannot take is never written over.

use core::fmt;

use cla_core::flash::{FlashCounts, FlashStore, ResumeError, Resumed, Saved, StoreError};
use cla_core::snapshot::{Audit, Snapshot, Stored};
use cla_core::som::Prototypes;
use embedded_storage::nor_flash::NorFlash;

use crate::controller::Keep;
use crate::link::Life;
use crate::replay::Forager;
use crate::resume::names;

/// A brain that looks itself through before it is saved.
pub trait Audited: Snapshot {
    /// Looks everything through once, and mends what a memory that lost a bit may have done.
    fn audit(&mut self) -> Audit;
}

impl<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored,
> Audited for Forager<W, H, P, S, Y, B, M>
{
    fn audit(&mut self) -> Audit {
        // The brain's own, which comes before that of this trait.
        Self::audit(self)
    }
}

/// A store, and whether it may be saved into.
#[derive(Debug)]
pub struct Shelf<F, const SLOTS: usize> {
    store: FlashStore<F, SLOTS>,
    /// Whether it was looked what lies there, and all of it may be written over in its turn.
    free: bool,
    /// The number that the newest life here was saved with, as far as is known.
    newest: Option<u32>,
}

/// What was saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kept {
    /// Entries that the audit before it mended or dropped; 0 in a sound brain.
    pub mended: u32,
    /// The generation.
    pub saved: Saved,
}

/// Why a brain was not saved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotSaved<E> {
    /// A brain lies there that this program could not take, or nobody has looked: it is kept. To give
    /// it up, erase the flash.
    Foreign,
    /// The part of that name is lost in RAM and cannot be mended: what lies in the flash is better.
    Lost(&'static str),
    /// The store could not.
    Store(StoreError<E>),
}

impl<E> fmt::Display for NotSaved<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Foreign => {
                f.write_str("the brain in the flash is of another program, and is kept")
            }
            Self::Lost(part) => write!(f, "{part} cannot be mended, and nothing was written"),
            Self::Store(error) => error.fmt(f),
        }
    }
}

impl<F: NorFlash, const SLOTS: usize> Shelf<F, SLOTS> {
    /// Nobody has looked yet what lies there.
    #[must_use]
    pub const fn new(store: FlashStore<F, SLOTS>) -> Self {
        Self {
            store,
            free: false,
            newest: None,
        }
    }

    /// Brings the newest life back that the brain takes.
    ///
    /// # Errors
    /// [`ResumeError::Nothing`] where nothing is lost by a new life; after any other, and where a newer
    /// life was refused than the one that is brought back, nothing is saved here.
    pub fn resume<B: Snapshot>(&mut self, brain: &mut B) -> Result<Resumed, ResumeError> {
        let resumed = self.store.resume(brain, names());
        self.newest = resumed.as_ref().ok().map(|it| it.tick);
        self.free = match &resumed {
            // A newer one that is whole and was not taken would be the next to be erased.
            Ok(resumed) => resumed.foreign == 0,
            Err(error) => *error == ResumeError::Nothing,
        };
        resumed
    }

    /// Looks a brain through and saves it, with a number that [`resume`](Self::resume) gives back.
    ///
    /// # Errors
    /// [`NotSaved`]; what was there is still there. After [`NotSaved::Lost`] the brain is as it was: bring
    /// the last life back, or let another one begin.
    pub fn save<B: Audited>(
        &mut self,
        brain: &mut B,
        tick: u32,
    ) -> Result<Kept, NotSaved<F::Error>> {
        if !self.free {
            return Err(NotSaved::Foreign);
        }
        let mended = match brain.audit() {
            Audit::Sound => 0,
            Audit::Mended(many) => many,
            Audit::Lost(part) => return Err(NotSaved::Lost(part)),
        };
        let saved = self.store.save(brain, names(), tick);
        let saved = saved.map_err(NotSaved::Store)?;
        self.newest = Some(tick);
        Ok(Kept { mended, saved })
    }

    /// Whether the next save is not refused for what lies here.
    #[must_use]
    pub const fn is_free(&self) -> bool {
        self.free
    }

    /// Brings back what was last saved of a life in whose brain something is lost.
    ///
    /// # Errors
    /// As [`resume`](Self::resume), and [`ResumeError::Nothing`] where no more than another life lies
    /// here. The brain is as it was, or unborn where it was another's for a moment.
    pub fn bring_back<B: Snapshot>(
        &mut self,
        brain: &mut B,
        life: Life,
    ) -> Result<Resumed, ResumeError> {
        if self.newest != Some(life.0) {
            return Err(ResumeError::Nothing);
        }
        let resumed = self.resume(brain)?;
        if resumed.tick != life.0 {
            // The newest generation has rotted, and the one before it is of another life.
            brain.forsake();
            return Err(ResumeError::Nothing);
        }
        Ok(resumed)
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
impl<F: NorFlash, const SLOTS: usize, B: Audited> Keep<B> for Shelf<F, SLOTS> {
    fn keep(&mut self, brain: &mut B, life: Life) -> Option<u32> {
        match self.save(brain, life.0) {
            Ok(kept) => Some(kept.saved.generation),
            Err(NotSaved::Lost(_)) => {
                // Brought back or not, what was learned since is not kept.
                let _ = self.bring_back(brain, life);
                None
            }
            Err(_) => None,
        }
    }
}
