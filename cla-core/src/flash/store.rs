//! Generations of one brain's image in a region of flash: the newest whole one is always there.

use super::fault::{Fault, FlashCounts, LayoutError, ResumeError, StoreError};
use super::record::{Kind, Record};
use super::slot::{PLACES, SaveCost, Shape, Slot};
use super::writer::{Found, SlotReader, SlotWriter, read_record, seal};
use crate::snapshot::{self, Names, SaveError, Snapshot};
use embedded_storage::nor_flash::NorFlash;

/// Keeps generations of a brain's image in `SLOTS` slots of a NOR flash: two are enough to lose
/// nothing, more of them share the wear and keep older generations against bit rot.
///
/// A save writes over the least worn slot (the oldest where that is equal) other than that of the
/// newest generation, and a slot that fails is counted and the next one is taken.
/// The store holds 40 bytes a slot and no image, and a call takes about 2 KiB of stack
/// (`memory-budget.md`).
///
/// ```
/// use cla_core::flash::{FlashStore, RamFlash};
/// use cla_core::forager::small;
/// use cla_core::{AgentConfig, snapshot};
/// let mut memory = vec![0xff; 2 * 65_536];
/// let names = small::VOCABULARY.names();
/// let mut brain = Box::new(small::brain());
/// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
///
/// let mut store = FlashStore::<_, 2>::open(RamFlash::<4, 4096>::new(&mut memory), 0, 65_536)?;
/// let saved = store.save(&*brain, names, 100)?;
/// assert_eq!((saved.generation, saved.tick), (1, 100));
/// drop(store); // A reset.
///
/// let mut store = FlashStore::<_, 2>::open(RamFlash::<4, 4096>::new(&mut memory), 0, 65_536)?;
/// let resumed = store.resume(&mut *brain, names)?;
/// assert_eq!((resumed.generation, resumed.tick), (1, 100));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct FlashStore<F, const SLOTS: usize> {
    flash: F,
    start: u32,
    bytes: u32,
    slots: [Slot; SLOTS],
    /// The slot of the newest whole generation.
    newest: Option<usize>,
    /// The slot that is being erased ahead, and up to where.
    ahead: Option<(usize, u32)>,
    counts: FlashCounts,
}

/// What was saved.
///
/// ```
/// # use cla_core::flash::{Saved, SaveCost};
/// fn say(saved: &Saved) -> String {
///     format!("generation {} in slot {}, {} bytes", saved.generation, saved.slot, saved.image)
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Saved {
    /// The number of this save; larger than any before.
    pub generation: u32,
    /// What the caller said it was saved at.
    pub tick: u32,
    /// The slot that holds it.
    pub slot: u8,
    /// Bytes of the image.
    pub image: u32,
    /// What it did to the flash; slots that failed are not in it.
    pub cost: SaveCost,
}

/// What was resumed.
///
/// ```
/// # use cla_core::flash::Resumed;
/// fn say(resumed: &Resumed) -> String {
///     format!("generation {}, saved at tick {}", resumed.generation, resumed.tick)
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Resumed {
    /// The number of the save.
    pub generation: u32,
    /// What the caller said then.
    pub tick: u32,
    /// The slot that holds it.
    pub slot: u8,
    /// Bytes of the image.
    pub image: u32,
    /// Newer generations that the brain did not take.
    pub refused: u8,
    /// Those of them that are of another robot, program or version, and whole: the next saves would be
    /// written over them.
    pub foreign: u8,
}

impl<F: NorFlash, const SLOTS: usize> FlashStore<F, SLOTS> {
    /// Opens the store whose first slot begins `start` bytes into the flash, each slot with `bytes`
    /// bytes: whole pages both. Whatever stood there before is no generation and is written over.
    ///
    /// Every committed image is read once, the newest first, until one is whole. A commit that was cut
    /// off before its seal is sealed.
    ///
    /// # Errors
    /// [`LayoutError`]; the flash was not touched. What cannot be read is counted and not believed.
    pub fn open(flash: F, start: u32, bytes: u32) -> Result<Self, LayoutError> {
        const { assert!(SLOTS >= 2 && SLOTS <= 32, "a store has 2 to 32 slots") };
        let page = Shape::<F>::PAGE;
        if !start.is_multiple_of(page) || !bytes.is_multiple_of(page) {
            return Err(LayoutError::NotPages);
        }
        if bytes <= Shape::<F>::BODY {
            return Err(LayoutError::TooSmall);
        }
        let end = u64::from(start) + u64::from(bytes) * SLOTS as u64;
        if end > flash.capacity() as u64 || end > u64::from(u32::MAX) {
            return Err(LayoutError::BehindTheEnd);
        }
        let mut store = Self {
            flash,
            start,
            bytes,
            slots: [Slot::UNKNOWN; SLOTS],
            newest: None,
            ahead: None,
            counts: FlashCounts::default(),
        };
        for slot in 0..SLOTS {
            store.look_at(slot);
        }
        store.settle();
        Ok(store)
    }

    /// Saves a brain as the next generation; `tick` is the caller's and comes back when it is resumed.
    ///
    /// The newest generation is left alone until this one is whole, and what was written is read back.
    /// The time it takes is [`cost`](Self::cost); the brain is gone through four times.
    /// Audit it first: a brain that lost a bit is refused, and with it what it learned since the last
    /// generation; one that was mended is saved.
    ///
    /// # Errors
    /// [`StoreError`]; the newest generation is still there.
    pub fn save<B: Snapshot>(
        &mut self,
        brain: &B,
        names: Names,
        tick: u32,
    ) -> Result<Saved, StoreError<F::Error>> {
        let image = snapshot::length(brain).map_err(|error| StoreError::of(&error))?;
        let room = self.capacity();
        if image > room {
            return Err(StoreError::TooLarge { image, slot: room });
        }
        let mut tried = 0_u32;
        let mut last = Fault::Full;
        while let Some(slot) = self.victim(tried) {
            tried |= 1 << slot;
            let seen = self.slots.iter().map(|it| it.seen).max().unwrap_or(0);
            let next = seen.checked_add(1).filter(|&it| it < u32::MAX);
            let generation = next.ok_or(StoreError::Exhausted)?;
            let record = Record {
                generation,
                wear: self.worn(slot).saturating_add(1),
                tick,
                length: image,
                sum: 0,
            };
            match self.write(slot, record, brain, names) {
                Ok(cost) => {
                    self.newest = Some(slot);
                    return Ok(Saved {
                        generation,
                        tick,
                        slot: slot as u8,
                        image,
                        cost,
                    });
                }
                Err(SaveError::Sink(fault)) => {
                    self.counts.note(&fault);
                    if let Some(it) = self.slots.get_mut(slot) {
                        it.failures = it.failures.saturating_add(1);
                    }
                    last = fault;
                }
                Err(SaveError::NotBorn) => return Err(StoreError::NotBorn),
                Err(SaveError::Unsound(part)) => return Err(StoreError::Unsound(part)),
            }
        }
        Err(StoreError::Worn(last))
    }

    /// Loads the newest generation that the brain takes; see [`snapshot::load`].
    ///
    /// An image of another robot, or one that rots while it is read, is refused, and an older
    /// generation is tried.
    ///
    /// # Errors
    /// [`ResumeError`]; the brain is as it was, or unborn when an image changed while it was taken.
    pub fn resume<B: Snapshot>(
        &mut self,
        brain: &mut B,
        names: Names,
    ) -> Result<Resumed, ResumeError> {
        let mut first = None;
        let mut below = u32::MAX;
        let (mut refused, mut foreign) = (0, 0);
        for _ in 0..SLOTS {
            let Some((slot, record)) = self.newest_below(below) else {
                break;
            };
            below = record.generation;
            // The newest one was looked at when the store was opened.
            if Some(slot) != self.newest && !self.is_whole(slot, &record) {
                self.counts.rotten = self.counts.rotten.saturating_add(1);
                self.drop_commit(slot);
                continue;
            }
            let mut source = self.reader(slot, record.length);
            let loaded = snapshot::load(brain, names, &mut source);
            let failed = source.failed;
            self.counts.reads_failed = self.counts.reads_failed.saturating_add(failed);
            match loaded {
                Ok(image) => {
                    self.is_sealed(slot, &record);
                    self.newest = Some(slot);
                    return Ok(Resumed {
                        generation: record.generation,
                        tick: record.tick,
                        slot: slot as u8,
                        image,
                        refused,
                        foreign,
                    });
                }
                Err(error) => {
                    self.counts.refused = self.counts.refused.saturating_add(1);
                    refused += 1;
                    foreign += u8::from(error.is_foreign());
                    first.get_or_insert(error);
                }
            }
        }
        Err(first.map_or(ResumeError::Nothing, ResumeError::Refused))
    }

    /// Erases one more page of the slot that the next save will take, so that it need not wait for it;
    /// how many pages are left. The older generation in that slot is given up.
    ///
    /// # Errors
    /// [`Fault::Erase`]; the next save tries that page again.
    pub fn erase_ahead(&mut self) -> Result<u32, Fault<F::Error>> {
        let Some(slot) = self.victim(0) else {
            return Ok(0);
        };
        let (start, end) = self.bounds(slot);
        let from = match self.ahead {
            Some((it, to)) if it == slot => to,
            _ => start,
        };
        if from >= end {
            return Ok(0);
        }
        if from == start {
            self.forget(slot);
        }
        let to = from.saturating_add(Shape::<F>::PAGE);
        if let Err(error) = self.flash.erase(from, to) {
            let fault = Fault::Erase(error);
            self.counts.note(&fault);
            return Err(fault);
        }
        self.ahead = Some((slot, to));
        Ok((end - to) / Shape::<F>::PAGE)
    }

    /// What saving an image of so many bytes does to the flash when no slot fails and nothing is
    /// erased ahead.
    #[must_use]
    pub fn cost(&self, image: u32) -> SaveCost {
        let body = Shape::<F>::BODY;
        let unit = Shape::<F>::UNIT as u32;
        let written = image.next_multiple_of(Shape::<F>::WORD);
        let back = image.next_multiple_of(Shape::<F>::WORD.max(F::READ_SIZE as u32));
        SaveCost {
            erased: body.saturating_add(written).div_ceil(Shape::<F>::PAGE),
            written: written.saturating_add(3 * unit),
            read: back.saturating_add(image).saturating_add(5 * unit),
        }
    }

    /// Bytes that a slot has for an image.
    #[must_use]
    pub fn capacity(&self) -> u32 {
        self.bytes.saturating_sub(Shape::<F>::BODY)
    }

    /// The newest whole generation, if there is one.
    #[must_use]
    pub fn generation(&self) -> Option<u32> {
        let slot = self.slots.get(self.newest?)?;
        slot.committed.map(|it| it.generation)
    }

    /// How often the first page of a slot was erased, no page of it more often; where the number cannot
    /// be read, because a power cut took it or nothing was there, that of the most worn slot. 0 for a
    /// slot that is not there.
    #[must_use]
    pub fn wear(&self, slot: usize) -> u32 {
        if slot < SLOTS { self.worn(slot) } else { 0 }
    }

    /// What has gone wrong since the store was opened.
    #[must_use]
    pub const fn counts(&self) -> FlashCounts {
        self.counts
    }

    /// Gives the flash back.
    #[must_use]
    pub fn release(self) -> F {
        self.flash
    }

    fn bounds(&self, slot: usize) -> (u32, u32) {
        let start = self.start + self.bytes * slot as u32;
        (start, start + self.bytes)
    }

    fn reader(&mut self, slot: usize, length: u32) -> SlotReader<'_, F> {
        let (start, _) = self.bounds(slot);
        SlotReader {
            flash: &mut self.flash,
            body: start + Shape::<F>::BODY,
            length,
            failed: 0,
        }
    }

    /// Reads the records of a slot.
    fn look_at(&mut self, slot: usize) {
        let (start, _) = self.bounds(slot);
        let room = self.capacity();
        let mut it = Slot::UNKNOWN;
        for place in 0..=PLACES {
            let (kind, record) = match read_record(&mut self.flash, start, place) {
                Ok(Found::Record(kind, record)) if record.length <= room => (kind, record),
                Ok(_) => continue,
                Err(fault) => {
                    self.counts.note(&fault);
                    continue;
                }
            };
            it.seen = it.seen.max(record.generation);
            it.wear = it.wear.max(Some(record.wear));
            if kind != Kind::Header {
                it.committed = Some(record);
                it.sealed |= kind == Kind::Seal;
            }
        }
        if let Some(place) = self.slots.get_mut(slot) {
            *place = it;
        }
    }

    /// Finds the newest whole generation and seals it where that was cut off; one that cannot be
    /// sealed is the last choice.
    fn settle(&mut self) {
        let mut unsealed = None;
        let mut below = u32::MAX;
        for _ in 0..SLOTS {
            let Some((slot, record)) = self.newest_below(below) else {
                break;
            };
            below = record.generation;
            if !self.is_whole(slot, &record) {
                self.counts.rotten = self.counts.rotten.saturating_add(1);
                self.drop_commit(slot);
                continue;
            }
            if self.is_sealed(slot, &record) {
                // What may not be there tomorrow is no generation beside one that will.
                for newer in 0..SLOTS {
                    let it = self.slots.get(newer).and_then(|it| it.committed);
                    if it.is_some_and(|it| it.generation > below) {
                        self.drop_commit(newer);
                    }
                }
                self.newest = Some(slot);
                return;
            }
            unsealed = unsealed.or(Some(slot));
        }
        self.newest = unsealed;
    }

    fn is_whole(&mut self, slot: usize, record: &Record) -> bool {
        // What could not be read once may be read the second time.
        for _ in 0..2 {
            let mut reader = self.reader(slot, record.length);
            let sum = reader.checksum();
            let failed = reader.failed;
            self.counts.reads_failed = self.counts.reads_failed.saturating_add(failed);
            if sum == Some(record.sum) {
                return true;
            }
        }
        false
    }

    /// Whether the commit of a slot is sealed, if need be by now.
    fn is_sealed(&mut self, slot: usize, record: &Record) -> bool {
        if self.slots.get(slot).is_some_and(|it| it.sealed) {
            return true;
        }
        let (start, _) = self.bounds(slot);
        let counts = &mut self.counts;
        let sealed = seal(&mut self.flash, start, record, |fault| counts.note(fault)).is_ok();
        if sealed {
            counts.sealed_anew = counts.sealed_anew.saturating_add(1);
            if let Some(it) = self.slots.get_mut(slot) {
                it.sealed = true;
            }
        }
        sealed
    }

    /// The slot of the newest generation below one.
    fn newest_below(&self, below: u32) -> Option<(usize, Record)> {
        let of = |(slot, it): (usize, &Slot)| it.committed.map(|record| (slot, record));
        let committed = self.slots.iter().enumerate().filter_map(of);
        let older = committed.filter(|(_, record)| record.generation < below);
        older.max_by_key(|(_, record)| record.generation)
    }

    /// The slot that the next save takes, among those that it has not tried.
    fn victim(&self, tried: u32) -> Option<usize> {
        let free = |slot: usize| Some(slot) != self.newest && tried & (1 << slot) == 0;
        if let Some((slot, _)) = self.ahead.filter(|(slot, _)| free(*slot)) {
            return Some(slot);
        }
        let key = |slot: usize| {
            let it = self.slots.get(slot).copied().unwrap_or(Slot::UNKNOWN);
            let generation = it.committed.map_or(0, |record| record.generation);
            (it.failures, self.worn(slot), generation)
        };
        (0..SLOTS)
            .filter(|&slot| free(slot))
            .min_by_key(|&it| key(it))
    }

    fn worn(&self, slot: usize) -> u32 {
        let known = self.slots.get(slot).and_then(|it| it.wear);
        let most = || self.slots.iter().filter_map(|it| it.wear).max();
        known.or_else(most).unwrap_or(0)
    }

    fn drop_commit(&mut self, slot: usize) {
        if let Some(it) = self.slots.get_mut(slot) {
            it.committed = None;
            it.sealed = false;
        }
    }

    /// Forgets what stands in a slot that is about to be erased, but for how worn it is.
    fn forget(&mut self, slot: usize) {
        self.drop_commit(slot);
        let wear = self.worn(slot);
        if let Some(it) = self.slots.get_mut(slot) {
            it.wear = Some(wear);
        }
    }

    /// Writes a generation into a slot: header, image, commit, seal.
    fn write<B: Snapshot>(
        &mut self,
        slot: usize,
        mut record: Record,
        brain: &B,
        names: Names,
    ) -> Result<SaveCost, SaveError<Fault<F::Error>>> {
        let (start, end) = self.bounds(slot);
        let ahead = self.ahead.take().filter(|(it, _)| *it == slot);
        let erased = ahead.map_or(start, |(_, to)| to);
        self.forget(slot);
        if let Some(it) = self.slots.get_mut(slot) {
            it.seen = record.generation;
            it.wear = Some(record.wear);
        }
        let mut writer = SlotWriter::new(&mut self.flash, start, end, erased);
        writer.begin(&record).map_err(SaveError::Sink)?;
        let image = snapshot::save(brain, names, &mut writer)?;
        let (sum, mut cost) = writer.finish().map_err(SaveError::Sink)?;
        record.sum = sum;
        let read = self.reader(slot, image).checksum();
        if read != Some(sum) || image != record.length {
            return Err(SaveError::Sink(Fault::Mismatch));
        }
        cost.read += image;
        let counts = &mut self.counts;
        let sealed = seal(&mut self.flash, start, &record, |fault| counts.note(fault));
        let sealed = sealed.map_err(SaveError::Sink)?;
        cost.written += sealed.written;
        cost.read += sealed.read;
        if let Some(it) = self.slots.get_mut(slot) {
            it.committed = Some(record);
            it.sealed = true;
        }
        Ok(cost)
    }
}
