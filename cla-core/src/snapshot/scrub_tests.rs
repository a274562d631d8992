//! Bits that turn while nobody looks are turned back.

use super::{CHUNK, Scrub, TooManyChunks, locate, step};
use crate::agent::{Adaptation, AgentConfig};
use crate::forager::small;
use crate::num::Rng;
use crate::snapshot::{Audit, Names, SliceSink, faults, save};
use crate::word::{ItemId, ItemStates};
use std::boxed::Box;
use std::vec::Vec;

/// A ring of places.
fn sense(place: u16) -> ItemStates<1> {
    let mut now = ItemStates::all_off(7);
    now.set(ItemId(place), Some(true)).unwrap();
    now
}

fn live(brain: &mut small::Brain, rng: &mut Rng, place: &mut u16, actions: u32) -> Vec<u32> {
    let mut bits = Vec::new();
    for _ in 0..actions {
        let choice = brain.choose(&sense(*place)).unwrap();
        assert!(choice.value.is_finite());
        bits.push(choice.value.to_bits() ^ u32::from(choice.action.0));
        *place = match choice.action.0 % 3 {
            _ if rng.chance(0.1) => rng.below(7) as u16,
            0 => (*place + 1) % 7,
            1 => (*place + 6) % 7,
            _ => *place,
        };
        brain.learn(&sense(*place)).unwrap();
    }
    bits
}

fn learned() -> Box<small::Brain> {
    let mut brain = Box::new(small::brain());
    small::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, 3).unwrap();
    live(&mut brain, &mut Rng::new(5), &mut 0, 1500);
    brain.act(Adaptation::Relearning).unwrap();
    brain
}

fn image(brain: &small::Brain) -> Vec<u8> {
    let mut image = std::vec![0; 1 << 17];
    let mut sink = SliceSink::new(&mut image);
    let length = save(brain, Names::UNKNOWN, &mut sink).unwrap();
    image.truncate(length as usize);
    image
}

#[test]
fn every_bit_of_every_field_of_a_chunk_changes_its_sum_in_its_own_way() {
    let mut seen = std::collections::BTreeSet::new();
    for bit in 0..32 {
        let mut change = 1_u32 << bit;
        for back in 0..CHUNK {
            assert!(seen.insert(change), "bit {bit}, {back} fields from the end");
            assert_eq!(locate(change, CHUNK), Some((CHUNK - 1 - back, bit)));
            change = step(change);
        }
    }
}

#[test]
fn a_bit_that_turns_between_two_ticks_is_turned_back_and_the_life_is_what_it_would_have_been() {
    let (mut hit, mut whole) = (learned(), learned());
    let (mut here, mut there) = ((Rng::new(8), 0), (Rng::new(8), 0));
    let mut scrub = Scrub::<512>::new();
    let mut rng = Rng::new(12);
    let (mut mended, mut kept) = (0, 0);
    for tick in 0..2000 {
        scrub.seal(&*hit).unwrap();
        let bits = faults::bits(&mut *hit);
        let before = hit.clone();
        faults::flip(&mut *hit, rng.below(bits));
        match scrub.check(&mut *hit) {
            Some(Audit::Mended(1)) => mended += 1,
            // A derived field, or a bit that its place cannot hold.
            Some(Audit::Sound) => kept += 1,
            // The length of a table, or whether something is there.
            Some(Audit::Lost(_)) => hit = before,
            other => panic!("tick {tick}: {other:?}"),
        }
        let one = live(&mut hit, &mut here.0, &mut here.1, 1);
        assert_eq!(
            one,
            live(&mut whole, &mut there.0, &mut there.1, 1),
            "{tick}"
        );
    }
    assert!(image(&hit) == image(&whole));
    assert!(mended > 1500 && mended + kept > 1980, "{mended}, {kept}");
}

#[test]
fn many_bits_are_turned_back_when_they_lie_in_different_chunks_and_named_when_they_do_not() {
    let mut brain = learned();
    let mut scrub = Scrub::<512>::new();
    scrub.seal(&*brain).unwrap();
    let whole = image(&brain);
    let bits = faults::bits(&mut *brain);
    for part in 1..8 {
        faults::flip(&mut *brain, part * (bits / 8));
    }
    let found = scrub.check(&mut *brain);
    assert!(matches!(found, Some(Audit::Mended(5..=7))), "{found:?}");
    assert!(image(&brain) == whole);
    let mut named = 0;
    for trial in 0..200 {
        let mut hit = brain.clone();
        let at = bits / 4 + trial * 64;
        for bit in [at, at + 1, at + 40] {
            faults::flip(&mut *hit, bit);
        }
        match scrub.check(&mut *hit) {
            Some(Audit::Lost(_)) => named += 1,
            found => assert!(image(&hit) == whole, "{trial}: {found:?}"),
        }
    }
    assert!(named > 150, "{named}");
}

#[test]
fn a_seal_needs_room_and_there_is_none_before_the_first() {
    let mut brain = learned();
    let mut scrub = Scrub::<8>::new();
    assert_eq!(scrub.check(&mut *brain), None);
    let Err(TooManyChunks { needed }) = scrub.seal(&*brain) else {
        panic!("eight sums are enough");
    };
    assert!((20..512).contains(&needed), "{needed}");
    assert_eq!(scrub.check(&mut *brain), None);
    // One section at a time takes less.
    let mut knowledge = Scrub::<16>::of(0, 1);
    knowledge.seal(&*brain).unwrap();
    faults::flip(&mut *brain, 100);
    assert_eq!(knowledge.check(&mut *brain), Some(Audit::Mended(1)));
}
