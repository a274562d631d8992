//! What a mind finds when it looks itself through, and how it lives on.

use super::Mind;
use crate::forest::{MindConfig, MindError};
use crate::num::Rng;
use crate::reason::Reason;
use crate::snapshot::{
    Audit, Names, SaveError, Scrub, SliceSink, Snapshot, faults, load_knowledge, save,
    save_knowledge,
};
use crate::word::{ActionId, ItemId, ItemStates, SignedItems};
use std::boxed::Box;
use std::format;
use std::vec::Vec;

type Plain = Mind<1, 6, 3, 16, 12, 32, 48, 160>;
type Thinking = Mind<1, 6, 3, 16, 12, 32, 48, 160, Reason<1, 6, 3, 16, 32, 32>>;

/// A corridor of five places with a lamp at one end.
#[derive(Clone)]
struct Corridor {
    rng: Rng,
    place: u16,
}

impl Corridor {
    fn sense(&self) -> ItemStates<1> {
        let mut now = ItemStates::all_off(6);
        now.set(ItemId(self.place), Some(true)).unwrap();
        now.set(ItemId(5), Some(self.place == 4)).unwrap();
        now
    }

    fn go(&mut self, action: ActionId) {
        self.place = match action.0 {
            _ if self.place == 4 || self.rng.chance(0.05) => self.rng.below(4) as u16,
            0 => self.place.saturating_sub(1),
            2 => (self.place + 1).min(4),
            _ => self.place,
        };
    }
}

macro_rules! live {
    ($world:expr, $mind:expr, $actions:expr) => {{
        let mut bits = Vec::new();
        for _ in 0..$actions {
            let choice = $mind.choose(&$world.sense()).unwrap();
            assert!(choice.value.is_finite() && choice.action.0 < 3);
            bits.push(choice.value.to_bits() ^ u32::from(choice.action.0));
            $world.go(choice.action);
            let taught = $mind.learn(&$world.sense()).unwrap();
            assert!(taught.reward.is_finite());
        }
        bits
    }};
}

macro_rules! learned {
    ($type:ty) => {{
        let mut mind = Box::new(<$type>::unborn());
        mind.be_born(MindConfig::DEFAULT, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], 3)
            .unwrap();
        let mut world = Corridor {
            rng: Rng::new(13),
            place: 0,
        };
        live!(world, mind, 900);
        mind.act().unwrap();
        live!(world, mind, 200);
        (mind, world)
    }};
}

fn unsound<B: Snapshot>(brain: &B) -> Option<&'static str> {
    match save(brain, Names::UNKNOWN, &mut 0_u32) {
        Ok(_) | Err(SaveError::NotBorn) => None,
        Err(SaveError::Unsound(part)) => Some(part),
        Err(SaveError::Sink(never)) => match never {},
    }
}

fn image<B: Snapshot>(brain: &B) -> Vec<u8> {
    let mut image = std::vec![0; 1 << 18];
    let mut sink = SliceSink::new(&mut image);
    let length = save(brain, Names::UNKNOWN, &mut sink).unwrap();
    image.truncate(length as usize);
    image
}

#[test]
fn a_sound_mind_finds_nothing_and_lives_on_to_the_bit() {
    let ((mut one, mut here), (mut two, mut there)) = (learned!(Thinking), learned!(Thinking));
    let mut goal = SignedItems::EMPTY;
    goal.insert(ItemId(2), true).unwrap();
    for step in 0..600 {
        if step % 50 == 0 {
            one.pursue(goal, 20, &here.sense()).unwrap();
            two.pursue(goal, 20, &there.sense()).unwrap();
        }
        assert_eq!(one.audit(), Audit::Sound, "{step}");
        assert_eq!(live!(here, one, 1), live!(there, two, 1), "{step}");
    }
    assert!(image(&*one) == image(&*two));
}

macro_rules! bits_turn {
    ($type:ty, $every:expr) => {{
        let (mut whole, world) = learned!($type);
        let (mut mended, mut lost, mut unseen, mut unborn) = (0, 0, 0, 0);
        for bit in (0..faults::bits(&mut *whole)).step_by($every) {
            let mut mind = whole.clone();
            let section = faults::flip(&mut *mind, bit);
            let could = unsound(&*mind);
            let before = mind.clone();
            match mind.audit() {
                Audit::Sound => {
                    assert_eq!(could, None, "bit {bit} of {section:?}");
                    unseen += 1;
                }
                Audit::Mended(_) => {
                    assert_eq!(unsound(&*mind), None, "bit {bit} of {section:?}");
                    assert_eq!(mind.audit(), Audit::Sound, "bit {bit} of {section:?}");
                    mended += 1;
                }
                Audit::Lost(_) => {
                    assert!(could.is_some(), "bit {bit} of {section:?}");
                    assert_eq!(format!("{mind:?}"), format!("{before:?}"));
                    lost += 1;
                    continue;
                }
            }
            match mind.choose(&world.sense()) {
                Ok(_) => drop(live!(world.clone(), mind, 6)),
                Err(error) => {
                    assert_eq!(error, MindError::Unborn, "bit {bit} of {section:?}");
                    unborn += 1;
                }
            }
        }
        assert!(
            mended > 100 && lost > 0 && unseen > 1000 && unborn < 3,
            "{mended} {lost} {unseen} {unborn}"
        );
    }};
}

#[test]
fn whatever_bit_turns_a_mind_that_was_looked_through_can_be_saved_and_lives_on() {
    bits_turn!(Plain, 5);
}

#[test]
fn and_so_can_one_that_reasons() {
    bits_turn!(Thinking, 5);
}

#[test]
fn whatever_bit_turns_knowledge_that_is_saved_is_taken_and_can_be_saved_again() {
    let (mut whole, _) = learned!(Thinking);
    let (mut other, _) = learned!(Thinking);
    let (mut kept, mut refused) = (0, 0);
    for bit in (0..faults::bits(&mut *whole)).step_by(11) {
        let mut mind = whole.clone();
        faults::flip(&mut *mind, bit);
        let mut image = std::vec![0; 1 << 18];
        let mut sink = SliceSink::new(&mut image);
        match save_knowledge(&*mind, Names::UNKNOWN, &mut sink) {
            Ok(length) => {
                let taken = load_knowledge(&mut *other, &[], &[], &mut &*image);
                assert_eq!(taken, Ok(length), "bit {bit}");
                assert_eq!(unsound(&*other), None, "bit {bit}");
                kept += 1;
            }
            Err(SaveError::Unsound(_)) => refused += 1,
            Err(other) => assert_eq!(other, SaveError::NotBorn),
        }
    }
    assert!(kept > 1000 && refused > 100, "{kept} {refused}");
}

#[test]
fn bits_that_turn_and_are_not_looked_for_end_no_life() {
    let (whole, world) = learned!(Thinking);
    let (mut lived, mut looked) = (0, 0);
    for life in 0..40 {
        let (mut mind, mut world) = (whole.clone(), world.clone());
        let mut rng = Rng::new(life);
        for _ in 0..60 {
            let bits = faults::bits(&mut *mind);
            faults::flip(&mut *mind, rng.below(bits));
            let Ok(choice) = mind.choose(&world.sense()) else {
                break;
            };
            assert!(choice.action.0 < 3);
            world.go(choice.action);
            if mind.learn(&world.sense()).is_err() {
                break;
            }
            mind.idle(500);
            mind.contexts(ActionId(2), |_, _| {});
            lived += 1;
        }
        if !matches!(mind.audit(), Audit::Lost(_)) && mind.choose(&world.sense()).is_ok() {
            live!(world, mind, 20);
            looked += 1;
        }
    }
    // Few lives end early: the one bit that says whether there is one was hit.
    assert!(lived > 2300 && looked > 30, "{lived} {looked}");
}

#[test]
fn a_bit_that_turns_between_two_ticks_is_turned_back_and_the_life_is_what_it_would_have_been() {
    let ((mut hit, mut here), (mut whole, mut there)) = (learned!(Thinking), learned!(Thinking));
    let mut scrub = Scrub::<128>::new();
    let mut rng = Rng::new(12);
    let (mut mended, mut kept) = (0, 0);
    for tick in 0..1000 {
        scrub.seal(&*hit).unwrap();
        let bits = faults::bits(&mut *hit);
        let before = hit.clone();
        faults::flip(&mut *hit, rng.below(bits));
        match scrub.check(&mut *hit) {
            Some(Audit::Mended(1)) => mended += 1,
            // A bit that its place cannot hold.
            Some(Audit::Sound) => kept += 1,
            // The length of a table, or whether something is there.
            Some(Audit::Lost(_)) => hit = before,
            other => panic!("tick {tick}: {other:?}"),
        }
        assert_eq!(live!(here, hit, 1), live!(there, whole, 1), "{tick}");
    }
    assert!(image(&*hit) == image(&*whole));
    assert!(mended > 900 && mended + kept > 980, "{mended}, {kept}");
}
