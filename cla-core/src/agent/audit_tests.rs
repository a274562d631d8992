//! What an agent finds when it looks itself through, and how it lives on.

use super::{Agent, Audit, Stage};
use crate::agent::{Adaptation, AgentConfig};
use crate::knowledge::{PatternId, SyntheticId};
use crate::num::Rng;
use crate::snapshot::{
    Names, SaveError, SliceSink, Snapshot, faults, load, load_knowledge, save, save_knowledge,
};
use crate::som::{BinarySom, ByteSom, NodeId, Prototypes};
use crate::word::{ActionId, ItemId, ItemSet, ItemStates};
use std::boxed::Box;
use std::format;
use std::vec::Vec;

type Small = Agent<1, 5, 5, 4, 3, 24, 64, 16, 48>;

/// A ring of four places with a lamp at one of them.
struct Ring {
    rng: Rng,
    place: u16,
}

impl Ring {
    fn sense(&self) -> ItemStates<1> {
        let mut now = ItemStates::all_off(5);
        now.set(ItemId(self.place), Some(true)).unwrap();
        now.set(ItemId(4), Some(self.place == 3)).unwrap();
        now
    }

    /// Lives; the bits of all values that it chose by.
    fn live(&mut self, brain: &mut Small, actions: u32) -> Vec<u32> {
        let mut bits = Vec::new();
        for _ in 0..actions {
            let choice = brain.choose(&self.sense()).unwrap();
            assert!(choice.value.is_finite() && choice.action.0 < 3);
            bits.push(choice.value.to_bits() ^ u32::from(choice.action.0));
            self.place = match choice.action.0 {
                _ if self.rng.chance(0.1) => self.rng.below(4) as u16,
                0 => (self.place + 1) % 4,
                1 => (self.place + 3) % 4,
                _ => self.place,
            };
            brain.learn(&self.sense()).unwrap();
        }
        bits
    }
}

fn learned(acts: bool) -> (Box<Small>, Ring) {
    let mut brain = Box::new(Small::new());
    brain
        .be_born(AgentConfig::RESILIENT_LEVEL2, &[(ItemId(4), 10.0)], 3)
        .unwrap();
    let mut ring = Ring {
        rng: Rng::new(5),
        place: 0,
    };
    ring.live(&mut brain, 1500);
    if acts {
        brain.act(Adaptation::Relearning).unwrap();
        ring.live(&mut brain, 300);
    }
    (brain, ring)
}

fn is_sound(brain: &Small) -> bool {
    unsound(brain).is_none()
}

/// What no image takes; the unborn have nothing to be saved.
fn unsound<B: Snapshot>(brain: &B) -> Option<&'static str> {
    match save(brain, Names::UNKNOWN, &mut 0_u32) {
        Ok(_) | Err(SaveError::NotBorn) => None,
        Err(SaveError::Unsound(part)) => Some(part),
        Err(SaveError::Sink(never)) => match never {},
    }
}

#[test]
fn a_sound_brain_finds_nothing_and_lives_on_to_the_bit() {
    for acts in [false, true] {
        let ((mut one, mut here), (mut two, mut there)) = (learned(acts), learned(acts));
        if acts {
            one.doubt();
            two.doubt();
        }
        for _ in 0..400 {
            assert_eq!(one.audit(), Audit::Sound);
            assert_eq!(here.live(&mut one, 3), there.live(&mut two, 3));
        }
        assert!(image(&one) == image(&two));
    }
}

fn image(brain: &Small) -> Vec<u8> {
    let mut image = std::vec![0; 1 << 16];
    let mut sink = SliceSink::new(&mut image);
    let length = save(brain, Names::UNKNOWN, &mut sink).unwrap();
    image.truncate(length as usize);
    image
}

#[test]
fn what_has_a_value_is_marked_so_whatever_the_marks_said() {
    let (mut brain, _) = learned(false);
    let marks = brain.faculties.knowledge.valued;
    brain.faculties.knowledge.valued = ItemSet::first(3);
    let kept = image(&brain);
    assert_eq!(brain.audit(), Audit::Mended(1));
    assert_eq!(brain.faculties.knowledge.valued, marks);
    load(&mut *brain, Names::UNKNOWN, &mut &*kept).unwrap();
    assert_eq!(brain.faculties.knowledge.valued, marks);
    assert_eq!(brain.audit(), Audit::Sound);
}

#[test]
fn whatever_bit_turns_knowledge_that_is_saved_is_taken_and_can_be_saved_again() {
    let (mut whole, _) = learned(true);
    let mut other = Box::new(Small::new());
    other
        .be_born(AgentConfig::RESILIENT_LEVEL2, &[(ItemId(4), 10.0)], 8)
        .unwrap();
    let (mut kept, mut refused) = (0, 0);
    for bit in some_bits(&mut whole) {
        let mut brain = whole.clone();
        faults::flip(&mut *brain, bit);
        let mut image = std::vec![0; 1 << 16];
        match save_knowledge(&*brain, Names::UNKNOWN, &mut SliceSink::new(&mut image)) {
            Ok(length) => {
                let taken = load_knowledge(&mut *other, &[], &[], &mut &*image);
                assert_eq!(taken, Ok(length), "bit {bit}");
                assert_eq!(unsound(&*other), None, "bit {bit}");
                kept += 1;
            }
            // A bit of its stage makes it one that was never born.
            Err(SaveError::Unsound(_) | SaveError::NotBorn) => refused += 1,
            Err(other) => panic!("bit {bit}: {other:?}"),
        }
    }
    assert!(kept > 1000 && refused > 100, "{kept} {refused}");
}

#[test]
fn links_that_lead_anywhere_end_every_walk_and_are_made_anew() {
    let mut rng = Rng::new(9);
    for _ in 0..200 {
        let (mut brain, mut ring) = learned(true);
        let knowledge = &mut brain.faculties.knowledge;
        for schema in &mut knowledge.schemas {
            if rng.chance(0.5) {
                schema.skip = rng.next_u32() as u16;
            }
        }
        for pattern in &mut knowledge.patterns {
            if rng.chance(0.5) {
                pattern.first = rng.below(70) as u16;
            }
        }
        ring.live(&mut brain, 20);
        brain.audit();
        assert!(is_sound(&brain));
        assert_eq!(brain.audit(), Audit::Sound);
    }
}

#[test]
fn what_cannot_be_so_is_dropped_and_the_rest_lives_on() {
    let damages: [fn(&mut Small); 17] = [
        |it| it.faculties.knowledge.schemas[3].context = PatternId(999),
        |it| it.faculties.knowledge.schemas[3].result = PatternId(24),
        |it| it.faculties.knowledge.schemas[3].action = ActionId(77),
        |it| {
            it.faculties.knowledge.schemas[3]
                .reliability
                .revise(f32::NAN)
        },
        |it| it.faculties.knowledge.schemas[3].doubt.bonus = f32::INFINITY,
        |it| it.faculties.knowledge.patterns[1].value = f32::NAN,
        |it| it.faculties.knowledge.patterns[1].value = -3.0,
        |it| it.faculties.knowledge.discount = f32::NAN,
        |it| it.faculties.level2.table.rows[0].value = f32::INFINITY,
        |it| it.faculties.level2.table.rows[0].tried[2] = f32::NAN,
        |it| it.faculties.level2.table.beliefs[0].on = -1.0,
        |it| it.faculties.level2.table.beliefs[0].item = SyntheticId(500),
        |it| it.faculties.level2.slow = f32::NAN,
        |it| it.chosen = Some(ActionId(900)),
        |it| it.decided_after = Some(SyntheticId(900)),
        |it| it.faculties.knowledge.deferred[0][2] = f32::NAN,
        |it| it.faculties.knowledge.discount = 1.5,
    ];
    for (index, damage) in damages.into_iter().enumerate() {
        let (mut brain, mut ring) = learned(true);
        assert!(brain.second_level().beliefs().len() > 3);
        damage(&mut brain);
        assert!(!is_sound(&brain), "{index} is saved");
        assert!(matches!(brain.audit(), Audit::Mended(_)), "{index}");
        assert!(is_sound(&brain), "{index}");
        assert_eq!(brain.audit(), Audit::Sound, "{index}");
        ring.live(&mut brain, 300);
        assert!(is_sound(&brain), "{index}");
    }
}

/// Every bit in turn would take long: each of these is every so-manieth.
fn some_bits(brain: &mut Small) -> impl Iterator<Item = u32> + use<> {
    (0..faults::bits(brain)).step_by(5)
}

#[test]
fn whatever_bit_turns_what_audit_calls_sound_or_mended_can_be_saved_and_lives_on() {
    let (mut whole, ring) = learned(true);
    let (mut mended, mut lost, mut unseen) = (0, 0, 0);
    for bit in some_bits(&mut whole) {
        let mut brain = whole.clone();
        let section = faults::flip(&mut *brain, bit);
        let could = unsound(&*brain);
        let before = brain.clone();
        match brain.audit() {
            Audit::Sound => {
                assert_eq!(could, None, "bit {bit} of {section:?}");
                unseen += 1;
            }
            Audit::Mended(_) => {
                assert!(is_sound(&brain), "bit {bit} of {section:?}");
                assert_eq!(brain.audit(), Audit::Sound, "bit {bit} of {section:?}");
                mended += 1;
            }
            Audit::Lost(_) => {
                assert!(could.is_some(), "bit {bit} of {section:?}");
                // What is lost is seen before anything is changed.
                assert_eq!(format!("{brain:?}"), format!("{before:?}"));
                lost += 1;
                continue;
            }
        }
        if bit % 11 == 0 {
            let mut ring = Ring {
                rng: ring.rng.clone(),
                place: ring.place,
            };
            ring.live(&mut brain, 5);
        }
    }
    assert!(
        mended > 100 && lost > 10 && unseen > 1000,
        "{mended} {lost} {unseen}"
    );
}

#[test]
fn a_map_of_bytes_whose_rounding_stands_still_goes_on() {
    type Bytes = Agent<1, 5, 5, 4, 3, 24, 64, 0, 0, ByteSom<5, 4, 5>>;
    let mut brain = Box::new(Bytes::zeroed());
    brain
        .be_born(AgentConfig::FORAGER, &[(ItemId(4), 10.0)], 3)
        .unwrap();
    assert_eq!(brain.audit(), Audit::Sound);
    let mut stood = 0;
    for bit in 0..faults::bits(&mut *brain) {
        let section = faults::flip(&mut *brain, bit);
        let could = unsound(&*brain);
        let found = brain.audit();
        let seen = could.is_none() || found != Audit::Sound;
        assert!(seen, "bit {bit} of {section:?}: {could:?}");
        stood += u32::from(could.is_some());
        if found == Audit::Sound {
            faults::flip(&mut *brain, bit);
        } else {
            brain
                .be_born(AgentConfig::FORAGER, &[(ItemId(4), 10.0)], 3)
                .unwrap();
        }
    }
    assert!(stood > 10);
    // Its own noise is one number among many: all of its bits gone, as a map that was never drawn.
    let mut map = ByteSom::<5, 4, 5>::ZERO;
    assert!(map.audit_whole() && !map.audit_whole());
}

#[test]
fn a_node_of_many_features_is_mended_whole() {
    let mut map = BinarySom::<2, 1, 3000>::new();
    map.randomize(&mut Rng::new(1));
    map.scale.as_mut_slice()[1] = f32::NAN;
    assert!(!map.audit(NodeId(0)) && map.audit(NodeId(1)));
    let weights = [0, 2047, 2048, 2999].map(|feature| map.weight(NodeId(1), feature));
    assert_eq!(weights, [0.5; 4]);
    assert!(!map.audit(NodeId(1)));
}

#[test]
fn what_cannot_be_found_again_is_named() {
    let (mut brain, _) = learned(true);
    brain.faculties.knowledge.inherent[0][4] = f32::NAN;
    assert_eq!(brain.audit(), Audit::Lost("what is worth having"));
    brain.faculties.knowledge.inherent[0][4] = -1.0;
    assert_eq!(unsound(&*brain), Some("knowledge"));
    assert_eq!(brain.audit(), Audit::Lost("what is worth having"));
    let (mut brain, _) = learned(true);
    brain.rng = Rng::UNSEEDED;
    let lost = brain.audit();
    assert_eq!(lost, Audit::Lost("the generator"));
    let sentence = "the generator cannot be mended: load the last image";
    assert_eq!(format!("{lost}"), sentence);
    let sentence = "3 entries were mended or dropped";
    assert_eq!(format!("{}", Audit::Mended(3)), sentence);
    let (mut brain, _) = learned(true);
    for schema in &mut brain.faculties.knowledge.schemas {
        schema.context = PatternId(500);
    }
    assert_eq!(brain.audit(), Audit::Lost("all that was known"));
    let mut unborn = Box::new(Small::new());
    assert_eq!(
        (unborn.audit(), unborn.stage),
        (Audit::Sound, Stage::Unborn)
    );
}

#[test]
fn what_an_earlier_life_has_lost_does_not_cramp_one_with_knowledge_of_another() {
    let (known, _) = learned(true);
    let mut image = std::vec![0; 1 << 16];
    save_knowledge(&*known, Names::UNKNOWN, &mut SliceSink::new(&mut image)).unwrap();
    let (mut brain, mut ring) = learned(true);
    brain.faculties.level2.table.losses.refused_items = 1000;
    ring.live(&mut brain, 10);
    load_knowledge(&mut *brain, &[], &[], &mut &*image).unwrap();
    ring.live(&mut brain, 1100);
    let health = brain.health();
    assert!(health.lost < 1000.0 && health.steps == 1000, "{health:?}");
}
