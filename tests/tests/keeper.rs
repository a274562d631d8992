//! When a brain is saved, and what becomes of the brain that lies in the flash already.

use cla_core::AgentConfig;
use cla_core::flash::{FlashStore, RamFlash, ResumeError};
use embedded_storage::nor_flash::NorFlashErrorKind;
use firmware_example::keeper::{Cause, Event, Keeper, Policy, live};
use firmware_example::profile::{self, Brain};
use firmware_example::shelf::{NotSaved, Shelf};
use host_sim::device::flash::toy::{self, robot};

#[test]
fn a_brain_is_due_by_policy_and_before_the_supply_fails() {
    use Cause::{Captures, PowerFailing, Ticks};
    // Limits of captures and actions; captures and actions since the last save; what is due, and what
    // is due where the supply fails.
    for (limits, lived, due, failing) in [
        ((20, 100), (0, 0), None, None),
        ((20, 100), (0, 99), None, Some(PowerFailing)),
        ((20, 100), (0, 100), Some(Ticks), Some(PowerFailing)),
        ((20, 100), (19, 99), None, Some(PowerFailing)),
        ((20, 100), (20, 99), Some(Captures), Some(PowerFailing)),
        ((20, 100), (20, 100), Some(Captures), Some(PowerFailing)),
        ((0, 100), (1000, 1), None, Some(PowerFailing)),
        ((20, 0), (0, 1000), None, Some(PowerFailing)),
        ((0, 0), (1000, 1000), None, Some(PowerFailing)),
    ] {
        let (captures, ticks) = limits;
        let mut keeper = Keeper::new(Policy { captures, ticks });
        (0..lived.0).for_each(|_| keeper.captured());
        (0..lived.1).for_each(|_| keeper.acted());
        let both = (keeper.due(false), keeper.due(true));
        assert_eq!(both, (due, failing), "{limits:?} {lived:?}");
        keeper.saved();
        assert_eq!((keeper.due(false), keeper.due(true)), (None, None));
    }
}

const SLOT: u32 = 256 * 1024;
type Flash<'a> = RamFlash<'a, 4, 4096>;

fn open(bytes: &mut [u8]) -> FlashStore<Flash<'_>, 2> {
    FlashStore::open(RamFlash::new(bytes), 0, SLOT).expect("whole pages")
}

/// Lives until so many actions; what was said.
fn lived(bytes: &mut [u8], end: u32) -> Vec<Event<NorFlashErrorKind>> {
    let mut brain: Box<Brain> = Box::new(profile::brain());
    let mut keeper = Keeper::new(Policy {
        captures: 0,
        ticks: 50,
    });
    let mut said = Vec::new();
    let mut shelf = Shelf::new(open(bytes));
    let lived = live(
        &mut brain,
        &mut shelf,
        &mut keeper,
        end,
        || false,
        |it| said.push(it),
    );
    assert_eq!(lived, Ok(()));
    said
}

#[test]
fn a_life_is_saved_and_goes_on() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let said = lived(&mut bytes, 100);
    assert_eq!(said[0], Event::Born(ResumeError::Nothing));
    let saved = said.iter().filter(|it| matches!(it, Event::Saved(_)));
    assert_eq!(saved.count(), 2, "{said:?}");
    let said = lived(&mut bytes, 150);
    let Event::Resumed(resumed) = said[0] else {
        panic!("{said:?}");
    };
    assert_eq!((resumed.generation, resumed.tick), (2, 100));
}

#[test]
fn a_brain_of_another_program_is_never_written_over() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let ages = toy::ages::<toy::Brain>(1, 3).expect("the toy lives");
    let (brain, image) = &ages[0];
    let mut store = open(&mut bytes);
    store.save(&**brain, toy::names(), 77).expect("a save");
    let before = bytes.clone();
    let said = lived(&mut bytes, 120);
    let Event::Born(ResumeError::Refused(_)) = said[0] else {
        panic!("{said:?}");
    };
    let refusals = said
        .iter()
        .filter(|it| **it == Event::Refused(NotSaved::Foreign));
    assert_eq!(refusals.count(), 2, "{said:?}");
    assert!(bytes == before);
    let mut other = Box::new(robot::brain());
    let resumed = open(&mut bytes).resume(&mut *other, toy::names());
    assert_eq!(resumed.expect("it is there").tick, 77);
    assert_eq!(toy::image(&*other), *image);
}

#[test]
fn a_newer_brain_of_another_program_is_kept_where_an_older_one_is_taken() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let said = lived(&mut bytes, 50);
    let saved = said.iter().filter(|it| matches!(it, Event::Saved(_)));
    assert_eq!(saved.count(), 1, "{said:?}");
    let ages = toy::ages::<toy::Brain>(1, 3).expect("the toy lives");
    let (brain, image) = &ages[0];
    open(&mut bytes)
        .save(&**brain, toy::names(), 77)
        .expect("a save");
    let before = bytes.clone();
    let said = lived(&mut bytes, 200);
    let Event::Resumed(resumed) = said[0] else {
        panic!("{said:?}");
    };
    assert_eq!(
        (resumed.generation, resumed.tick, resumed.refused),
        (1, 50, 1)
    );
    assert!(
        said.contains(&Event::Refused(NotSaved::Foreign)),
        "{said:?}"
    );
    assert!(bytes == before);
    let mut other = Box::new(robot::brain());
    let resumed = open(&mut bytes).resume(&mut *other, toy::names());
    assert_eq!(resumed.expect("it is there").tick, 77);
    assert_eq!(toy::image(&*other), *image);
}

#[test]
fn nothing_is_saved_before_it_was_looked_what_lies_there() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let mut brain = Box::new(profile::brain());
    profile::be_born(&mut brain, AgentConfig::FORAGER, 1).expect("it works");
    let mut shelf = Shelf::new(open(&mut bytes));
    assert_eq!(shelf.save(&*brain, 1).err(), Some(NotSaved::Foreign));
    let mut other = Box::new(profile::brain());
    assert_eq!(shelf.resume(&mut *other).err(), Some(ResumeError::Nothing));
    assert_eq!(shelf.save(&*brain, 1).expect("a save").generation, 1);
}
