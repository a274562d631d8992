//! A brain in flash survives power cuts at every operation, rot and wear: what a save has answered for
//! is there, and nothing else is taken for it.
//!
//! `CLA_CUTS` says how many moments of a power cut are tried at least (`tests/run cuts`), and
//! `CLA_CUTS_AGAIN` after one of how many of them the power goes again at every operation of the
//! recovery: 1 is after each.

use std::num::NonZeroU64;

use cla_core::flash::{FlashStore, FlashTiming, LayoutError};
use host_sim::device::flash::cuts::{Cuts, History, on_every_shape, pages_of_slot};
use host_sim::device::flash::decay::{rot, wear_out};
use host_sim::device::flash::fake::FakeFlash;
use host_sim::device::flash::toy::{Age, Brain, SmallMind, Toy, ages, image, names, robot};

fn some<B: Toy>() -> Vec<Age<B>> {
    let ages = ages::<B>(5, 3).expect("the toy lives");
    for (index, (_, image)) in ages.iter().enumerate() {
        assert!(image.len() > 1_500, "{}", image.len());
        assert!(ages[..index].iter().all(|(_, other)| other != image));
    }
    ages
}

/// All of them survived.
fn on_all_shapes<B: Toy>(ages: &[Age<B>], history: History) -> Cuts {
    let mut cuts = Cuts::default();
    let runs = on_every_shape(ages, history).expect("the slots are large enough");
    for (shape, run) in runs {
        assert!(run.points > 100, "{shape}: {run:?}");
        assert!(run.all_survived(), "{shape}, {history:?}: {run:?}");
        cuts.add(&run);
    }
    cuts
}

#[test]
fn no_committed_generation_is_lost_wherever_the_power_is_cut() {
    let least = std::env::var("CLA_CUTS").ok();
    let least: u64 = least.map_or(20_000, |it| it.parse().expect("CLA_CUTS is a number"));
    let again = std::env::var("CLA_CUTS_AGAIN").ok();
    let again: Option<NonZeroU64> =
        again.map(|it| it.parse().expect("CLA_CUTS_AGAIN is a number above 0"));
    let again_after = again.map_or(7, NonZeroU64::get);
    let (agents, minds) = (some::<Brain>(), some::<SmallMind>());
    let mut cuts = Cuts::default();
    let mut seed = 0;
    while cuts.points < least {
        let history = History {
            saves: if least > 20_000 { 12 } else { 3 },
            seed,
            corrects_errors: seed % 2 == 1,
            again_after,
        };
        cuts.add(&on_all_shapes(&agents, history));
        cuts.add(&on_all_shapes(&minds, history));
        seed += 1;
    }
    println!("{cuts:?}");
    assert!(cuts.all_survived() && cuts.again > 0 && cuts.sealed_anew > 0);
}

#[test]
fn rotten_bits_cost_generations_and_never_give_another_brain() {
    let ages = some::<Brain>();
    let two = rot::<4, 512, 2>(&ages, 2_000, 1).expect("it fits");
    let four = rot::<16, 256, 4>(&ages, 2_000, 2).expect("it fits");
    println!("{two:?} {four:?}");
    for it in [two, four] {
        assert_eq!(it.wrong, 0, "{it:?}");
        assert!(it.newest > 0 && it.older > 0, "{it:?}");
    }
    // More slots keep more of the past.
    assert!(four.none < two.none, "{two:?} {four:?}");
}

#[test]
fn a_flash_that_wears_out_is_used_evenly_and_keeps_its_last_generation() {
    let ages = some::<Brain>();
    let two = wear_out::<4, 512, 2>(&ages, 40, 1).expect("it fits");
    let four = wear_out::<8, 1024, 4>(&ages, 40, 1).expect("it fits");
    println!("{two:?} {four:?}");
    for (slots, it) in [(2, two), (4, four)] {
        assert_eq!((it.lost, it.wrong, it.refused), (0, 0, 10), "{it:?}");
        assert!(it.saved >= 40 * slots, "{it:?}");
        // Pages endure up to a quarter more than others.
        assert!(it.spread.1 - it.spread.0 <= 10, "{it:?}");
        assert!(it.counts != Default::default(), "{it:?}");
    }
}

#[test]
fn what_a_save_costs_is_known_before_it() {
    let ages = some::<Brain>();
    let mut flash = FakeFlash::<4, 1024>::new(12, 1);
    flash.reboot(1);
    let mut store = FlashStore::<_, 3>::open(flash, 0, 4096).expect("whole pages");
    for (tick, (brain, image)) in ages.iter().enumerate() {
        let saved = store.save(&**brain, names(), tick as u32).expect("a save");
        assert_eq!(saved.cost, store.cost(image.len() as u32));
        assert_eq!(saved.image as usize, image.len());
    }
    let timing = FlashTiming {
        erase: 85_000,
        program: 41,
        bytes: 4,
    };
    let cost = store.cost(3_000);
    assert_eq!((cost.erased, cost.written), (4, 3_096));
    assert_eq!(cost.microseconds(&timing), 4 * 85_000 + 774 * 41);
    let flash = store.release();
    let erased: u32 = flash.operations().len() as u32;
    assert!(erased > 0 && flash.violations() == 0);
}

#[test]
fn pages_that_were_erased_ahead_are_not_erased_again() {
    let ages = some::<Brain>();
    let flash = FakeFlash::<4, 1024>::new(8, 1);
    let mut store = FlashStore::<_, 2>::open(flash, 0, 4096).expect("whole pages");
    let (brain, _) = &ages[0];
    store.save(&**brain, names(), 1).expect("a save");
    let left: Vec<u32> = (0..5)
        .map(|_| store.erase_ahead().expect("it erases"))
        .collect();
    assert_eq!(left, [3, 2, 1, 0, 0]);
    let saved = store.save(&**brain, names(), 2).expect("a save");
    assert_eq!((saved.cost.erased, saved.slot), (0, 1));
    let flash = store.release();
    assert_eq!(&flash.erased()[4..], [1; 4]);
    assert_eq!(flash.violations(), 0);
    let mut store = FlashStore::<_, 2>::open(flash, 0, 4096).expect("whole pages");
    let mut other = Box::new(robot::brain());
    let resumed = store.resume(&mut *other, names()).expect("it is whole");
    assert_eq!((resumed.generation, resumed.tick), (2, 2));
    // Nobody knew how worn the second slot was, so it was taken for as worn as the first.
    assert_eq!((store.wear(0), store.wear(1)), (1, 2));
}

#[test]
fn what_does_not_fit_is_refused_before_anything_is_erased() {
    use cla_core::flash::{ResumeError, StoreError};
    let ages = some::<Brain>();
    let open = |start, bytes| {
        let flash = FakeFlash::<4, 512>::new(8, 1);
        FlashStore::<_, 2>::open(flash, start, bytes).map(FlashStore::release)
    };
    assert_eq!(open(1, 1024).err(), Some(LayoutError::NotPages));
    assert_eq!(open(0, 1000).err(), Some(LayoutError::NotPages));
    assert_eq!(open(0, 0).err(), Some(LayoutError::TooSmall));
    assert_eq!(open(1024, 2048).err(), Some(LayoutError::BehindTheEnd));
    assert!(open(0, 2048).is_ok());

    let flash = FakeFlash::<4, 512>::new(8, 1);
    let mut store = FlashStore::<_, 2>::open(flash, 1024, 1024).expect("it fits");
    let (brain, image) = &ages[0];
    assert_eq!(
        store.save(&**brain, names(), 0),
        Err(StoreError::TooLarge {
            image: image.len() as u32,
            slot: 768
        })
    );
    let unborn = robot::brain();
    assert_eq!(store.save(&unborn, names(), 0), Err(StoreError::NotBorn));
    let mut brain = brain.clone();
    assert_eq!(
        store.resume(&mut *brain, names()).err(),
        Some(ResumeError::Nothing)
    );
    assert_eq!(self::image(&*brain), *image);
    assert_eq!(store.release().erased(), [0; 8]);
    assert_eq!(
        pages_of_slot(4, 512, &ages[..1]),
        (256 + image.len()).div_ceil(512)
    );
}

#[test]
fn a_rotten_generation_is_written_over_before_a_whole_one() {
    let ages = some::<Brain>();
    let mut flash = FakeFlash::<4, 1024>::new(8, 1);
    for (tick, (brain, _)) in ages.iter().enumerate().take(2) {
        let mut store = FlashStore::<_, 2>::open(flash, 0, 4096).expect("whole pages");
        store.save(&**brain, names(), tick as u32).expect("a save");
        flash = store.release();
    }
    // In the image of the newest generation, which lies in the second slot.
    flash.flip((4096 + 256 + 1000) * 8);
    let mut store = FlashStore::<_, 2>::open(flash, 0, 4096).expect("whole pages");
    assert_eq!((store.generation(), store.counts().rotten), (Some(1), 1));
    let saved = store.save(&*ages[2].0, names(), 2).expect("a save");
    assert_eq!((saved.generation, saved.slot), (3, 1));
    let mut brain = Box::new(robot::brain());
    let resumed = store.resume(&mut *brain, names()).expect("it is whole");
    assert_eq!((resumed.generation, resumed.tick), (3, 2));
    assert_eq!(image(&*brain), ages[2].1);
}
