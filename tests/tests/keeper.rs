//! When a brain is saved, that it was looked through before, and what becomes of the brain that lies in
//! the flash already.

use std::cell::{Cell, RefCell};

use cla_core::AgentConfig;
use cla_core::flash::{FlashStore, RamFlash, ResumeError};
use cla_core::snapshot::{self, Audit, SaveError, faults};
use embedded_storage::nor_flash::NorFlashErrorKind;
use firmware_example::controller::Keep;
use firmware_example::keeper::{
    ByPolicy, Cause, Event, Keeper, Policy, along, be_born, begin, go_on, live,
};
use firmware_example::link::Life;
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

#[test]
fn a_policy_is_said_in_minutes_and_never_waits_longer() {
    for ((captures, minutes, tick_ms), ticks) in [
        ((20, 10, 200), 3_000),
        ((0, 1, 7), 8_571),
        ((5, 0, 200), 0),
        // Actions that are longer than the minute, and that take no time.
        ((5, 1, 120_000), 1),
        ((5, 1, 0), 60_000),
        ((5, u32::MAX, 1), u32::MAX),
    ] {
        let policy = Policy::every(captures, minutes, tick_ms);
        assert_eq!(policy, Policy { captures, ticks }, "{minutes} {tick_ms}");
    }
}

const SLOT: u32 = 256 * 1024;
type Flash<'a> = RamFlash<'a, 4, 4096>;

fn open(bytes: &mut [u8]) -> FlashStore<Flash<'_>, 2> {
    FlashStore::open(RamFlash::new(bytes), 0, SLOT).expect("whole pages")
}

const EVERY_50: Policy = Policy {
    captures: 0,
    ticks: 50,
};

/// Lives until so many actions; what was said.
fn lived(bytes: &mut [u8], end: u32) -> Vec<Event<NorFlashErrorKind>> {
    let mut brain: Box<Brain> = Box::new(profile::brain());
    let mut keeper = Keeper::new(EVERY_50);
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
fn a_life_is_saved_before_the_supply_fails_and_goes_on_there() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let mut brain: Box<Brain> = Box::new(profile::brain());
    let mut keeper = Keeper::new(Policy::every(0, 10, 200));
    let mut shelf = Shelf::new(open(&mut bytes));
    let (mut actions, mut said) = (0, Vec::new());
    let failing = || {
        actions += 1;
        actions >= 70
    };
    let came = live(&mut brain, &mut shelf, &mut keeper, 71, failing, |it| {
        said.push(it);
    });
    assert_eq!(came, Ok(()));
    // Nothing was due before, and what was lived since is saved as long as there is power.
    assert_eq!(said[1], Event::Saving(Cause::PowerFailing, 70), "{said:?}");
    let ticks: Vec<u32> = said.iter().filter_map(saved_at).collect();
    assert_eq!(ticks, [70, 71]);
    let said = lived(&mut bytes, 72);
    let Event::Resumed(resumed) = said[0] else {
        panic!("{said:?}");
    };
    assert_eq!((resumed.generation, resumed.tick), (2, 71));
}

fn saved_at(event: &Event<NorFlashErrorKind>) -> Option<u32> {
    match event {
        Event::Saved(saved) => Some(saved.tick),
        _ => None,
    }
}

/// The sign of what a specimen is worth, item 5, in a brain that has neither patterns nor schemas yet:
/// its image begins with their numbers, 16 bits each.
const WORTH: [u32; 1] = [2 * 16 + 5 * 32 + 31];

/// The sign and a bit of what is deferred to item 31, which this robot does not have; 32 inherent values
/// and a word of marks lie before.
const DEFERRED: [u32; 2] = {
    let value = 2 * 16 + 32 * 32 + 32 + 31 * 32;
    [value + 31, value + 23]
};

/// Turns bits of a brain before its first harvest, so that it cannot be saved as it is.
fn strike(brain: &mut Brain, bits: &[u32]) {
    assert!(brain.knowledge().schemas().is_empty());
    for &bit in bits {
        assert_eq!(faults::flip(brain, bit), Some("knowledge"));
    }
    let refused = snapshot::length(brain);
    assert_eq!(refused, Err(SaveError::Unsound("knowledge")));
}

/// Lives to action 50, at which the brain is saved, is struck, and lives to action 150; what was said
/// since, and the image in the end.
fn struck(bits: &[u32]) -> (Vec<Event<NorFlashErrorKind>>, Vec<u8>) {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let mut brain: Box<Brain> = Box::new(profile::brain());
    let mut keeper = Keeper::new(EVERY_50);
    let mut shelf = Shelf::new(open(&mut bytes));
    let from = begin(&mut brain, &mut shelf, |_| {}).expect("it is born");
    let mut said = Vec::new();
    let mut live_to = |brain: &mut Brain, from, end| {
        let lived = go_on(
            brain,
            &mut shelf,
            &mut keeper,
            from..end,
            || false,
            |it| said.push(it),
        );
        assert_eq!(lived, Ok(()));
    };
    live_to(&mut brain, from, 50);
    strike(&mut brain, bits);
    live_to(&mut brain, 50, 150);
    // The first two are those of action 50.
    (said.split_off(2), toy::image(&*brain))
}

/// The image after 150 actions of a life that nothing strikes.
fn unhurt() -> Vec<u8> {
    let mut brain = Box::new(profile::brain());
    be_born(&mut brain).expect("it works");
    along(&mut *brain, 0, 150, |_, _, _| {}).expect("it lives");
    let image = toy::image(&*brain);
    assert!(!image.is_empty());
    image
}

#[test]
fn a_brain_with_a_value_that_cannot_be_is_mended_before_it_is_saved() {
    let (said, image) = struck(&DEFERRED);
    assert_eq!(said[1], Event::Mended(1), "{said:?}");
    let ticks: Vec<u32> = said.iter().filter_map(saved_at).collect();
    assert_eq!((said.len(), &ticks[..]), (5, &[100, 150][..]), "{said:?}");
    assert!(image == unhurt());
}

#[test]
fn where_something_is_lost_the_last_life_is_brought_back_and_goes_on() {
    let (said, image) = struck(&WORTH);
    assert_eq!(said[0], Event::Saving(Cause::Ticks, 100), "{said:?}");
    assert_eq!(said[1], Event::Lost("what is worth having"));
    let Event::Resumed(resumed) = said[2] else {
        panic!("{said:?}");
    };
    assert_eq!((resumed.generation, resumed.tick), (1, 50));
    let ticks: Vec<u32> = said.iter().filter_map(saved_at).collect();
    assert_eq!(ticks, [100, 150], "{said:?}");
    assert!(image == unhurt());
}

#[test]
fn where_something_is_lost_and_nothing_was_saved_a_new_life_begins() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let mut brain: Box<Brain> = Box::new(profile::brain());
    let mut keeper = Keeper::new(EVERY_50);
    let mut shelf = Shelf::new(open(&mut bytes));
    begin(&mut brain, &mut shelf, |_| {}).expect("it is born");
    strike(&mut brain, &WORTH);
    let mut said = Vec::new();
    let lived = go_on(
        &mut brain,
        &mut shelf,
        &mut keeper,
        0..150,
        || false,
        |it| said.push(it),
    );
    assert_eq!(lived, Ok(()));
    assert_eq!(said[1], Event::Lost("what is worth having"), "{said:?}");
    assert_eq!(said[2], Event::Born(ResumeError::Nothing));
    let ticks: Vec<u32> = said.iter().filter_map(saved_at).collect();
    assert_eq!(ticks, [50, 100, 150], "{said:?}");
}

/// Tells of an action; whether the brain is to be kept then.
fn due(kept: &mut impl Keep<Brain>, captured: bool, over: bool) -> bool {
    kept.is_due(captured, over)
}

#[test]
fn a_controller_keeps_its_brain_by_policy_and_brings_its_life_back_where_something_is_lost() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let mut brain: Box<Brain> = Box::new(profile::brain());
    profile::be_born(&mut brain, AgentConfig::FORAGER, 1).expect("it works");
    let mut shelf = Shelf::new(open(&mut bytes));
    assert_eq!(shelf.resume(&mut *brain).err(), Some(ResumeError::Nothing));
    let policy = Policy {
        captures: 2,
        ticks: 3,
    };
    let (failing, said) = (Cell::new(false), RefCell::new(Vec::new()));
    let say = |it: Event<NorFlashErrorKind>| said.borrow_mut().push(it);
    let mut kept = ByPolicy::new(shelf, policy, || failing.get(), say);
    // Three actions; two captures, of which none ends an action; the supply.
    let acted = [(); 3].map(|()| due(&mut kept, false, true));
    assert_eq!(acted, [false, false, true]);
    assert_eq!(kept.keep(&mut *brain, Life(4)), Some(1));
    let captured = [(); 2].map(|()| due(&mut kept, true, false));
    assert_eq!(captured, [false, false]);
    assert!(due(&mut kept, false, true));
    assert_eq!(kept.keep(&mut *brain, Life(4)), Some(2));
    failing.set(true);
    assert!(!due(&mut kept, false, false) && due(&mut kept, false, true));
    assert_eq!(kept.keep(&mut *brain, Life(4)), Some(3));
    assert_eq!(said.take().iter().filter_map(saved_at).count(), 3);

    strike(&mut brain, &WORTH);
    assert_eq!(kept.keep(&mut *brain, Life(4)), None);
    let [lost, Event::Resumed(resumed)] = said.take()[..] else {
        panic!("the life is brought back");
    };
    assert_eq!(lost, Event::Lost("what is worth having"));
    assert_eq!((resumed.generation, resumed.tick), (3, 4));
    assert_eq!(brain.audit(), Audit::Sound);

    // Never another life than the one that is kept.
    strike(&mut brain, &WORTH);
    assert_eq!(kept.keep(&mut *brain, Life(5)), None);
    assert_eq!(said.take()[1], Event::Gone(ResumeError::Nothing));
    assert_eq!(brain.audit(), Audit::Lost("what is worth having"));
}

#[test]
fn a_controller_does_not_stand_for_a_save_that_would_be_refused() {
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let shelf = Shelf::new(open(&mut bytes));
    let mut kept = ByPolicy::new(shelf, EVERY_50, || true, |_: Event<NorFlashErrorKind>| {});
    assert!((0..100).all(|_| !due(&mut kept, true, true)));
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
    assert_eq!(shelf.save(&mut *brain, 1).err(), Some(NotSaved::Foreign));
    let mut other = Box::new(profile::brain());
    assert_eq!(shelf.resume(&mut *other).err(), Some(ResumeError::Nothing));
    let kept = shelf.save(&mut *brain, 1).expect("a save");
    assert_eq!((kept.mended, kept.saved.generation), (0, 1));
}
