//! Bits rot and pages wear out: what is no longer whole is refused, and saving goes on where it can.

use cla_core::flash::{FlashCounts, FlashStore, LayoutError};
use cla_core::num::Rng;

use super::cuts::pages_of_slot;
use super::fake::FakeFlash;
use super::toy::{Age, image, names, robot};

/// What came of a flash that decays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Decay {
    /// Bits that were flipped, one to four at a time.
    pub flips: u64,
    /// Resets after flips at which the newest generation was there.
    pub newest: u64,
    /// At which an older one was.
    pub older: u64,
    /// At which none was.
    pub none: u64,
    /// Brains that were resumed and are not what was saved at that tick.
    pub wrong: u64,
}

/// Flips bits of two or more whole generations, again and again from the same flash.
///
/// # Errors
/// [`LayoutError`] when an image does not fit.
pub fn rot<const W: usize, const P: usize, const N: usize>(
    ages: &[Age],
    times: u32,
    seed: u64,
) -> Result<Decay, LayoutError> {
    let pages = pages_of_slot(W, P, ages);
    let slot = (pages * P) as u32;
    let mut flash = FakeFlash::<W, P>::new(N * pages, seed);
    let mut newest = 0;
    for tick in 0..N {
        let mut store = FlashStore::<_, N>::open(flash, 0, slot)?;
        let saved = store.save(&*ages[tick % ages.len()].0, names(), tick as u32);
        newest = saved.map_or(newest, |it| it.generation);
        flash = store.release();
    }
    let (mut rng, mut brain) = (Rng::new(seed), Box::new(robot::brain()));
    let mut decay = Decay::default();
    for _ in 0..times {
        let mut flash = flash.clone();
        let flips = 1 + rng.below(4);
        for _ in 0..flips {
            flash.flip(rng.below(flash.bits() as u32) as usize);
        }
        decay.flips += u64::from(flips);
        let mut store = FlashStore::<_, N>::open(flash, 0, slot)?;
        match store.resume(&mut *brain, names()) {
            Ok(it) => {
                let age = &ages[it.tick as usize % ages.len()];
                decay.wrong += u64::from(image(&*brain) != age.1);
                *(if it.generation == newest {
                    &mut decay.newest
                } else {
                    &mut decay.older
                }) += 1;
            }
            Err(_) => decay.none += 1,
        }
    }
    Ok(decay)
}

/// What came of a flash that is saved into until it is worn out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wear {
    /// Saves that succeeded.
    pub saved: u32,
    /// Saves that were refused.
    pub refused: u32,
    /// Resets at which the last generation that was answered for was not there.
    pub lost: u32,
    /// Brains that were resumed and are not what was saved.
    pub wrong: u32,
    /// Erases of the least and of the most worn first page of a slot before the first refusal.
    pub spread: (u32, u32),
    /// What the store has counted.
    pub counts: FlashCounts,
}

/// Saves until so many saves in a row were refused, with a reset after each.
///
/// # Errors
/// [`LayoutError`] when an image does not fit.
pub fn wear_out<const W: usize, const P: usize, const N: usize>(
    ages: &[Age],
    endurance: u32,
    seed: u64,
) -> Result<Wear, LayoutError> {
    let pages = pages_of_slot(W, P, ages);
    let slot = (pages * P) as u32;
    let mut flash = FakeFlash::<W, P>::new(N * pages, seed).with_endurance(endurance);
    let mut wear = Wear::default();
    let (mut brain, mut last, mut tick) = (Box::new(robot::brain()), None, 0_u32);
    while wear.refused < 10 {
        let age = &ages[tick as usize % ages.len()];
        let mut store = FlashStore::<_, N>::open(flash, 0, slot)?;
        match store.save(&*age.0, names(), tick) {
            Ok(saved) => {
                wear.saved += 1;
                last = Some(saved.generation);
            }
            Err(_) => wear.refused += 1,
        }
        add(&mut wear.counts, store.counts());
        let worn = |slot| store.wear(slot);
        if wear.refused == 0 {
            let least = (0..N).map(worn).min().unwrap_or(0);
            wear.spread = (least, (0..N).map(worn).max().unwrap_or(0));
        }
        flash = store.release();
        flash.reboot(seed ^ u64::from(tick));
        let mut store = FlashStore::<_, N>::open(flash, 0, slot)?;
        match store.resume(&mut *brain, names()) {
            Ok(it) => {
                wear.lost += u32::from(Some(it.generation) < last);
                let age = &ages[it.tick as usize % ages.len()];
                wear.wrong += u32::from(image(&*brain) != age.1);
            }
            Err(_) => wear.lost += u32::from(last.is_some()),
        }
        flash = store.release();
        tick += 1;
    }
    Ok(wear)
}

fn add(sum: &mut FlashCounts, more: FlashCounts) {
    sum.erases_failed = sum.erases_failed.saturating_add(more.erases_failed);
    sum.writes_failed = sum.writes_failed.saturating_add(more.writes_failed);
    sum.reads_failed = sum.reads_failed.saturating_add(more.reads_failed);
    sum.mismatches = sum.mismatches.saturating_add(more.mismatches);
    sum.rotten = sum.rotten.saturating_add(more.rotten);
}
