//! What is felt again: a path becomes known from its end, episodes stay apart, doubt replays the new.

use super::super::memory::{Memory, Sample};
use super::super::sarsa::{Replaying, Sarsa, Scene};
use super::{FEW, drawn, replay};
use crate::num::Rng;
use crate::word::{ItemId, ItemSet, ItemStates};

type Habits = Sarsa<1, 8, 2, 64>;
type Samples = Memory<1, 16>;

const HOW: Replaying = Replaying {
    rate: 0.2,
    discount: 0.9,
    lambda: 0.8,
};

fn at(place: u16) -> ItemStates<1> {
    let mut now = ItemStates::all_off(8);
    now.set(ItemId(place), Some(true)).unwrap();
    now
}

fn all() -> ItemSet<1> {
    ItemSet::first(8)
}

/// Places 0 to 4, one after the other by action 1; the last step brings a reward.
fn walked(reward: f32) -> Samples {
    let mut memory = Samples::new();
    memory.push(Sample::new(&at(0), 1, 0.0).beginning());
    for place in 1..4 {
        memory.push(Sample::new(&at(place), 1, 0.0));
    }
    memory.push(Sample::new(&at(4), 1, reward));
    memory.interrupt();
    memory.push(Sample::new(&at(0), 0, 0.0).beginning());
    memory
}

fn worth(habits: &Habits, memory: &Samples, place: u16) -> [f32; 2] {
    let scene = Scene::of(&memory.moment(place), &all(), 64);
    habits.worth(&scene, HOW.discount)
}

fn born() -> Habits {
    let mut habits = Habits::new();
    // What can be earned is known once something was earned.
    let scene = Scene::of(&walked(1.0).moment(0), &ItemSet::EMPTY, 64);
    let rates = super::super::sarsa::Rates {
        rate: 0.0,
        discount: 0.9,
        lambda: 0.0,
        replacing: false,
    };
    habits.feel(scene, 0, 1.0, &rates);
    habits
}

#[test]
fn one_replay_brings_what_was_felt_at_the_end_to_the_beginning() {
    let (mut habits, memory) = (born(), walked(1.0));
    replay(&mut habits, &memory, &all(), 4, 5, &HOW);
    let begin = worth(&habits, &memory, 0);
    assert!(begin[1] > 0.05, "{begin:?}");
    assert_eq!(begin[0], 0.0);
    // Again and again: towards 0.9⁴ and not beyond.
    for _ in 0..200 {
        replay(&mut habits, &memory, &all(), 4, 5, &HOW);
    }
    let (begin, end) = (worth(&habits, &memory, 0)[1], worth(&habits, &memory, 4)[1]);
    assert!((begin - 0.656).abs() < 0.02, "{begin}");
    assert!((end - 1.0).abs() < 0.02, "{end}");
}

#[test]
fn an_episode_that_ended_gets_nothing_from_the_next() {
    let learned = |ends: bool| {
        let (mut habits, mut memory) = (born(), Samples::new());
        for place in 0..4 {
            memory.push(Sample::new(&at(place), 1, 0.0));
        }
        if ends {
            memory.interrupt();
        }
        memory.push(Sample::new(&at(7), 1, 1.0));
        memory.push(Sample::new(&at(7), 1, 0.0));
        for _ in 0..50 {
            // Ends with the reward, and goes back into what was before.
            replay(&mut habits, &memory, &all(), 4, 5, &HOW);
        }
        [3, 4].map(|place| worth(&habits, &memory, place)[1])
    };
    let ([apart, rewarded], [joined, _]) = (learned(true), learned(false));
    assert!(rewarded > 0.5, "{rewarded}");
    // What all share, the constant, moves as ever.
    assert!(apart < 0.3 * joined, "{apart} {joined}");
}

#[test]
fn the_newest_sample_waits_for_what_follows() {
    let (mut habits, memory) = (born(), walked(1.0));
    let newest = memory.newest().unwrap();
    assert_eq!(replay(&mut habits, &memory, &all(), newest, 5, &HOW), 1);
    assert_eq!(worth(&habits, &memory, 4), [0.0; 2]);
}

#[test]
fn after_a_doubt_only_the_new_is_replayed_as_soon_as_there_is_enough() {
    let mut memory = Samples::new();
    let mut rng = Rng::stream(1, 1);
    assert_eq!(drawn(&memory, &mut rng), None);
    for _ in 0..100 {
        memory.push(Sample::new(&at(0), 1, 0.0));
    }
    let oldest = |memory: &Samples, rng: &mut Rng| {
        (0..400).filter_map(|_| drawn(memory, rng)).min().unwrap()
    };
    assert!(oldest(&memory, &mut rng) < 5);
    memory.doubt();
    for _ in 1..FEW {
        memory.push(Sample::new(&at(1), 1, 0.0));
    }
    assert!(oldest(&memory, &mut rng) < 5);
    memory.push(Sample::new(&at(1), 1, 0.0));
    assert_eq!(oldest(&memory, &mut rng), 100);
}

#[test]
fn what_is_asked_is_bounded_by_what_there_is() {
    let (mut habits, memory) = (born(), walked(1.0));
    let all_of_it = replay(&mut habits, &memory, &all(), 4, 5, &HOW);
    assert_eq!(
        replay(&mut habits, &memory, &all(), 4, u16::MAX, &HOW),
        all_of_it
    );
    assert_eq!(replay(&mut habits, &memory, &all(), 4, 0, &HOW), 0);
}

#[test]
fn what_fades_keeps_its_share_whatever_it_is_a_value_of() {
    let (mut habits, memory) = (born(), walked(1.0));
    for _ in 0..50 {
        replay(&mut habits, &memory, &all(), 4, 5, &HOW);
    }
    let known = worth(&habits, &memory, 4)[1];
    habits.fade(0.3);
    let kept = worth(&habits, &memory, 4)[1];
    assert!((kept - 0.3 * known).abs() < 1e-5, "{known} {kept}");
}

#[test]
fn after_a_doubt_no_replay_goes_back_into_what_was_before() {
    let learned = |doubts: bool| {
        let (mut habits, mut memory) = (born(), Samples::new());
        for place in 0..3 {
            memory.push(Sample::new(&at(place), 1, 0.0));
        }
        if doubts {
            memory.doubt();
        }
        for place in 3..6 {
            memory.push(Sample::new(&at(place), 0, 1.0));
        }
        let units = replay(&mut habits, &memory, &all(), 4, 5, &HOW);
        (
            units,
            worth(&habits, &memory, 2)[1],
            worth(&habits, &memory, 3)[0],
        )
    };
    let ((all_of_it, old, _), (new, nothing, known)) = (learned(false), learned(true));
    assert!(old > 0.0 && new < all_of_it, "{old} {new} {all_of_it}");
    assert_eq!(nothing, 0.0);
    assert!(known > 0.1, "{known}");
    // One that ends before the doubt goes back as ever.
    let (mut habits, mut memory) = (born(), walked(1.0));
    memory.doubt();
    memory.push(Sample::new(&at(7), 0, 0.0));
    replay(&mut habits, &memory, &all(), 4, 5, &HOW);
    assert!(worth(&habits, &memory, 0)[1] > 0.05);
}
