//! The power goes at every operation of a history of saves, within it, and again during what comes
//! after.
//!
//! After each cut the flash is opened as after a reset. The generation that a save has answered for
//! must be there, or a newer one; what is resumed must be, to the byte, the brain that was saved at that
//! tick; and a second reset, at which hanging cells read otherwise, must find the same.

use cla_core::flash::{FlashStore, LayoutError};
use cla_core::num::Rng;

use super::fake::{Cut, FakeFlash, Torn};
use super::toy::{Age, Toy, image, names};

/// What is tried.
#[derive(Clone, Copy, Debug)]
pub struct History {
    /// Saves in a row.
    pub saves: usize,
    /// Decides which cells hang, and how they read.
    pub seed: u64,
    /// Whether words have an error-correcting code.
    pub corrects_errors: bool,
    /// The power goes again, at every operation of the recovery and at one of the save after it, after
    /// each cut whose number is a multiple of this; 1 is after each. Cuts of recoveries have numbers, too.
    pub again_after: u64,
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cuts {
    /// Moments at which the power went.
    pub points: u64,
    /// Those of them within a save of the history, no two of which are the same place and degree in
    /// writing the same image. A history that saves an age twice counts that once; two histories of the
    /// same images, one with and one without error correction, count each such place once each.
    pub distinct: u64,
    /// Those of them that fell into a recovery or the save after it.
    pub again: u64,
    /// Committed generations that were not there afterwards.
    pub lost: u64,
    /// Brains that were resumed and are not what was saved at that tick.
    pub wrong: u64,
    /// Generations that were resumed and were not there at the next reset.
    pub regressed: u64,
    /// Saves after a recovery that failed on a sound flash.
    pub refused: u64,
    /// Words that were written twice, and operations out of bounds.
    pub violations: u64,
    /// Commits that were found without their seal, and sealed.
    pub sealed_anew: u64,
}

impl Cuts {
    /// Adds those of another history.
    pub fn add(&mut self, other: &Self) {
        self.points += other.points;
        self.distinct += other.distinct;
        self.again += other.again;
        self.lost += other.lost;
        self.wrong += other.wrong;
        self.regressed += other.regressed;
        self.refused += other.refused;
        self.violations += other.violations;
        self.sealed_anew += other.sealed_anew;
    }

    /// Whether nothing went wrong.
    #[must_use]
    pub const fn all_survived(&self) -> bool {
        self.lost + self.wrong + self.regressed + self.refused + self.violations == 0
    }
}

/// One history on each shape of flash: words of 1 to 256 bytes, pages of 64 to 4096, 2 to 4 slots; each
/// with its shape in words.
///
/// # Errors
/// [`LayoutError`] when an image does not fit.
pub fn on_every_shape<B: Toy>(
    ages: &[Age<B>],
    history: History,
) -> Result<[(&'static str, Cuts); 6], LayoutError> {
    Ok([
        ("1, 64, 2", cut_everywhere::<B, 1, 64, 2>(ages, history)?),
        (
            "4, 4096, 2",
            cut_everywhere::<B, 4, 4096, 2>(ages, history)?,
        ),
        ("8, 512, 3", cut_everywhere::<B, 8, 512, 3>(ages, history)?),
        (
            "16, 256, 4",
            cut_everywhere::<B, 16, 256, 4>(ages, history)?,
        ),
        (
            "32, 1024, 2",
            cut_everywhere::<B, 32, 1024, 2>(ages, history)?,
        ),
        (
            "256, 4096, 2",
            cut_everywhere::<B, 256, 4096, 2>(ages, history)?,
        ),
    ])
}

type Store<const W: usize, const P: usize, const N: usize> = FlashStore<FakeFlash<W, P>, N>;

/// A flash with what is in it.
#[derive(Clone)]
struct State<const W: usize, const P: usize> {
    flash: FakeFlash<W, P>,
    /// The last generation that a save has answered for; 0 before the first.
    committed: u32,
    /// Which age was saved at which tick, answered for or not.
    saved: Vec<usize>,
}

struct Trial<'a, B, const W: usize, const P: usize, const N: usize> {
    ages: &'a [Age<B>],
    slot: u32,
    history: History,
    rng: Rng,
    scratch: Box<B>,
    cuts: Cuts,
}

/// Pages that a slot must have for the images of these ages.
#[must_use]
pub fn pages_of_slot<B>(word: usize, page: usize, ages: &[Age<B>]) -> usize {
    let longest = ages.iter().map(|(_, image)| image.len()).max().unwrap_or(0);
    let records = (7 * word.max(32)).next_multiple_of(256);
    (records + longest.next_multiple_of(word)).div_ceil(page)
}

/// Lives through a history on a flash with words of `W` bytes, pages of `P` and `N` slots.
///
/// # Errors
/// [`LayoutError`] when an image does not fit.
pub fn cut_everywhere<B: Toy, const W: usize, const P: usize, const N: usize>(
    ages: &[Age<B>],
    history: History,
) -> Result<Cuts, LayoutError> {
    let pages = pages_of_slot(W, P, ages);
    let mut flash = FakeFlash::<W, P>::new(N * pages, history.seed);
    if history.corrects_errors {
        flash = flash.with_error_correction();
    }
    let mut trial = Trial::<B, W, P, N> {
        ages,
        slot: (pages * P) as u32,
        history,
        rng: Rng::new(history.seed ^ 0x5EED),
        scratch: B::empty(),
        cuts: Cuts::default(),
    };
    let mut state = State {
        flash,
        committed: 0,
        saved: Vec::new(),
    };
    for save in 0..history.saves {
        let age = save % ages.len();
        let seed = trial.rng.next_seed();
        let (after, operations) = trial.saved(&state, age, seed, None)?;
        for (operation, parts) in operations.into_iter().enumerate() {
            for (part, torn) in moments(parts) {
                let cut = Cut {
                    operation: operation as u32,
                    part,
                    torn,
                };
                let (torn, _) = trial.saved(&state, age, seed, Some(cut))?;
                trial.cuts.points += 1;
                trial.cuts.distinct += u64::from(save < ages.len());
                trial.recovers(torn)?;
            }
        }
        state = after;
    }
    trial.cuts.violations += u64::from(state.flash.violations());
    Ok(trial.cuts)
}

/// Where in an operation of so many parts the power goes.
fn moments(parts: u32) -> Vec<(u32, Torn)> {
    let last = parts.saturating_sub(1);
    let mut places = vec![0, last / 2, last];
    places.dedup();
    let each = |part: u32| Torn::ALL.map(|torn| (part, torn));
    places.into_iter().flat_map(each).collect()
}

impl<B: Toy, const W: usize, const P: usize, const N: usize> Trial<'_, B, W, P, N> {
    fn open(&mut self, mut flash: FakeFlash<W, P>) -> Result<Store<W, P, N>, LayoutError> {
        flash.reboot(self.rng.next_seed());
        Store::open(flash, 0, self.slot)
    }

    /// Opens the store and saves an age, with the power cut or not; the flash afterwards, and the
    /// parts of each operation. With the same seed hanging cells read the same.
    fn saved(
        &self,
        before: &State<W, P>,
        age: usize,
        seed: u64,
        cut: Option<Cut>,
    ) -> Result<(State<W, P>, Vec<u32>), LayoutError> {
        let mut state = before.clone();
        state.flash.reboot(seed);
        if let Some(cut) = cut {
            state.flash.cut(cut);
        }
        let tick = state.saved.len() as u32;
        state.saved.push(age);
        let mut store = Store::<W, P, N>::open(state.flash, 0, self.slot)?;
        if let Ok(saved) = store.save(&*self.ages[age].0, names(), tick) {
            state.committed = saved.generation;
        }
        state.flash = store.release();
        let parts = state.flash.operations().iter().map(|it| it.parts).collect();
        Ok((state, parts))
    }

    /// Opens a flash after a cut and asks everything of it, with more cuts as often as the history says.
    fn recovers(&mut self, state: State<W, P>) -> Result<(), LayoutError> {
        self.resumes(&state)?;
        if !self.cuts.points.is_multiple_of(self.history.again_after) {
            return Ok(());
        }
        // What the recovery does; the hanging cells read the same each time.
        let seed = self.rng.next_seed();
        let recover = |cut: Option<Cut>| {
            let mut flash = state.flash.clone();
            flash.reboot(seed);
            if let Some(cut) = cut {
                flash.cut(cut);
            }
            Store::<W, P, N>::open(flash, 0, self.slot).map(FlashStore::release)
        };
        let whole = recover(None)?;
        let mut torn = Vec::new();
        for (operation, it) in whole.operations().iter().enumerate() {
            for (part, how) in moments(it.parts) {
                torn.push(recover(Some(Cut {
                    operation: operation as u32,
                    part,
                    torn: how,
                }))?);
            }
        }
        for flash in torn {
            self.cuts.points += 1;
            self.cuts.again += 1;
            self.resumes(&State {
                flash,
                ..state.clone()
            })?;
        }
        self.goes_on(&State {
            flash: whole,
            ..state.clone()
        })
    }

    /// The save after a recovery, whole and cut at one operation.
    fn goes_on(&mut self, state: &State<W, P>) -> Result<(), LayoutError> {
        let age = self.rng.below(self.ages.len() as u32) as usize;
        let seed = self.rng.next_seed();
        let (after, operations) = self.saved(state, age, seed, None)?;
        self.cuts.refused += u64::from(after.committed <= state.committed);
        self.resumes(&after)?;
        let operation = self.rng.below(operations.len().max(1) as u32);
        let parts = operations.get(operation as usize).copied().unwrap_or(1);
        let cut = Cut {
            operation,
            part: self.rng.below(parts.max(1)),
            torn: Torn::ALL[self.rng.below(3) as usize],
        };
        let (torn, _) = self.saved(state, age, seed, Some(cut))?;
        self.cuts.points += 1;
        self.cuts.again += 1;
        self.resumes(&torn)
    }

    /// Resets twice and compares what is resumed with what was saved.
    fn resumes(&mut self, state: &State<W, P>) -> Result<(), LayoutError> {
        let mut store = self.open(state.flash.clone())?;
        let first = store.resume(&mut *self.scratch, names()).ok();
        self.cuts.sealed_anew += u64::from(store.counts().sealed_anew);
        let generation = first.map_or(0, |it| it.generation);
        if generation < state.committed {
            self.cuts.lost += 1;
        }
        if let Some(resumed) = first {
            let age = state.saved.get(resumed.tick as usize);
            let same = age.is_some_and(|&age| image(&*self.scratch) == self.ages[age].1);
            self.cuts.wrong += u64::from(!same);
        }
        let flash = store.release();
        self.cuts.violations += u64::from(flash.violations() - state.flash.violations());
        let mut store = self.open(flash)?;
        let second = store.resume(&mut *self.scratch, names()).ok();
        let again = second.map_or(0, |it| it.generation);
        self.cuts.regressed += u64::from(again < generation);
        Ok(())
    }
}
