//! The ring of samples: neighbours, interruptions, what is recent.

use super::super::moment::NO_ACTION;
use super::{MOST_WORTH, Memory, STRETCH, Sample};
use crate::word::{ItemId, ItemStates};

type Two = Memory<1, 2>;

/// A percept that names its number in binary, so that samples can be told apart.
fn percept(number: u16) -> ItemStates<1> {
    let mut now = ItemStates::all_off(16);
    for bit in 0..16 {
        now.set(ItemId(bit), Some(number >> bit & 1 == 1)).unwrap();
    }
    now
}

fn lived(count: u16) -> Two {
    let mut memory = Two::new();
    for number in 0..count {
        memory.push(Sample::new(&percept(number), (number % 5) as u8, 0.0));
    }
    memory
}

#[test]
fn the_moment_before_a_sample_is_its_neighbour_across_stretches_and_round_the_ring() {
    // Two stretches hold 32 samples; 40 were lived, so the ring has gone round.
    let memory = lived(40);
    assert_eq!(memory.len(), 2 * STRETCH as u16);
    let mut at = memory.newest();
    for number in (9..40).rev() {
        let moment = memory.moment(at.unwrap());
        assert_eq!(moment.now, percept(number));
        assert_eq!(moment.before, percept(number - 1));
        assert_eq!(u16::from(moment.action), (number - 1) % 5);
        at = memory.earlier(at.unwrap());
    }
    // The oldest that is left: what was before it was overwritten.
    let moment = memory.moment(at.unwrap());
    assert_eq!((moment.now, moment.action), (percept(8), NO_ACTION));
    assert_eq!(memory.earlier(at.unwrap()), None);
}

#[test]
fn going_later_leads_back_to_the_newest_which_nothing_follows() {
    let memory = lived(40);
    let newest = memory.newest().unwrap();
    let before = memory.earlier(newest).unwrap();
    assert_eq!(memory.later(before), Some(newest));
    assert_eq!(memory.later(newest), None);
}

#[test]
fn nothing_is_remembered_across_an_interruption() {
    let mut memory = lived(3);
    memory.interrupt();
    memory.push(Sample::new(&percept(77), 1, 0.0).beginning());
    let first = memory.newest().unwrap();
    let moment = memory.moment(first);
    assert_eq!(moment.action, NO_ACTION);
    assert_eq!(moment.before, ItemStates::UNKNOWN);
    let last = memory.earlier(first).unwrap();
    assert!(memory.get(last).unwrap().ends());
    assert!(!memory.get(first).unwrap().ends());
}

#[test]
fn a_target_that_is_no_number_is_not_taken() {
    let mut memory = lived(1);
    memory.set_target(0, f32::NAN);
    memory.set_target(0, f32::INFINITY);
    assert_eq!(memory.get(0).unwrap().target(), None);
    memory.set_target(0, -2.5);
    assert_eq!(memory.get(0).unwrap().target(), Some(-2.5));
}

#[test]
fn after_a_doubt_only_what_is_lived_then_is_recent() {
    let mut memory = lived(40);
    memory.doubt();
    assert!((0..32).all(|at| !memory.is_recent(at)));
    for number in 40..45 {
        memory.push(Sample::new(&percept(number), 0, 0.0));
    }
    let recent = (0..32).filter(|&at| memory.is_recent(at)).count();
    assert_eq!(recent, 5);
    let newest = memory.newest().unwrap();
    assert!(memory.is_recent(newest));
}

#[test]
fn what_a_sample_was_worth_stays_within_what_anything_is_worth() {
    let mut memory = lived(3);
    memory.set_target(1, 1e30);
    memory.set_target(2, f32::NAN);
    let target = |at| memory.get(at).and_then(Sample::target);
    assert_eq!([target(1), target(2)], [Some(MOST_WORTH), None]);
}

#[test]
fn only_what_led_to_an_item_is_worth_what_that_is_worth_now() {
    // Items 0 and 1 bring 10 each in turn, and what is given beside brings 10 where neither came.
    let rewards = |memory: &Two| {
        let all = (0..memory.len()).filter_map(|at| memory.get(at));
        all.map(|it| it.reward).collect::<std::vec::Vec<_>>()
    };
    let mut memory = Two::new();
    for number in [0, 1, 2, 0, 1] {
        memory.push(Sample::new(&percept(number), 0, 10.0));
    }
    // Each is followed by the next one's percept: 1 says item 0, 2 says item 1.
    assert_eq!(memory.revalue(ItemId(0), (10.0, -5.0), false), (-5.0, 10.0));
    assert_eq!(rewards(&memory), [-5.0, 10.0, 10.0, -5.0, 10.0]);
    // Of the newest nobody knows what came: its reward tells, if nothing else is worth as much.
    assert_eq!(memory.revalue(ItemId(1), (10.0, 3.0), true), (-5.0, 10.0));
    assert_eq!(rewards(&memory), [-5.0, 3.0, 10.0, -5.0, 3.0]);
}

#[test]
fn what_ended_an_episode_is_told_by_its_reward() {
    let mut memory = Two::new();
    memory.push(Sample::new(&percept(4), 0, 10.0));
    memory.interrupt();
    // Item 0 is on where the next episode begins: that is not what came of the last one.
    memory.push(Sample::new(&percept(1), 0, 0.0).beginning());
    memory.push(Sample::new(&percept(4), 0, 0.0));
    let first = |memory: &Two| memory.get(0).unwrap().reward;
    memory.revalue(ItemId(0), (10.0, 2.0), false);
    assert_eq!(first(&memory), 10.0);
    memory.revalue(ItemId(0), (10.0, 2.0), true);
    assert_eq!(first(&memory), 2.0);
    // Through values that are no differences of others.
    memory.revalue(ItemId(0), (2.0, 0.1), true);
    memory.revalue(ItemId(0), (0.1, 5.0), true);
    assert_eq!(first(&memory), 5.0);
}
