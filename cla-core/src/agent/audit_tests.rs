//! What an agent finds when it looks itself through, and how it lives on.

use super::{Agent, Audit, Stage};
use crate::agent::{Adaptation, AgentConfig};
use crate::knowledge::{PatternId, SyntheticId};
use crate::num::Rng;
use crate::snapshot::{Names, SliceSink, save};
use crate::word::{ActionId, ItemId, ItemStates};
use std::boxed::Box;
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
    save(brain, Names::UNKNOWN, &mut 0_u32).is_ok()
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
        let image = |brain: &Small| {
            let mut image = std::vec![0; 1 << 16];
            save(brain, Names::UNKNOWN, &mut SliceSink::new(&mut image)).unwrap();
            image
        };
        assert!(image(&one) == image(&two));
    }
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
    let damages: [fn(&mut Small); 14] = [
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

#[test]
fn what_cannot_be_found_again_is_named() {
    let (mut brain, _) = learned(true);
    brain.faculties.knowledge.inherent[0][4] = f32::NAN;
    assert_eq!(brain.audit(), Audit::Lost("what is worth having"));
    let (mut brain, _) = learned(true);
    brain.rng = Rng::UNSEEDED;
    let lost = brain.audit();
    assert_eq!(lost, Audit::Lost("the generator"));
    let sentence = "the generator cannot be mended: load the last image";
    assert_eq!(std::format!("{lost}"), sentence);
    let sentence = "3 entries were mended or dropped";
    assert_eq!(std::format!("{}", Audit::Mended(3)), sentence);
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
