//! One CLASM serves the forager and the Microworld: the forager's `Agent`, described for the
//! Microworld by `brain!` and a configuration, and by nothing else.

use cla_core::agent::{Adaptation, AgentConfig, Reason};
use cla_core::map::{HarvestConfig, ResultCoding};
use cla_core::num::Rng;
use cla_core::word::ItemStates;
use host_sim::experiment::microworld::catalogue::{Schema, VALID};
use host_sim::experiment::microworld::level1::{known, training};
use host_sim::world::World;
use host_sim::world::microworld::{ACTIONS, Body, Family, ITEMS, Microworld, Oracle};

cla_core::brain! {
    /// An infant that likes to hold things: Table 5.1 and Table 5.2.
    pub mod infant {
        items: [
            hp11, hp12, hp13, hp21, hp22, hp23, hp31, hp32, hp33,
            vp11, vp12, vp13, vp21, vp22, vp23, vp31, vp32, vp33,
            tactf, tactb, tactr, tactl, text0, text1, text2, text3,
            bodyf, bodyb, bodyr, bodyl, taste0, taste1, taste2, taste3, hcl, hgr,
            vf00, vf01, vf02, vf03, vf04, vf10, vf11, vf12, vf13, vf14,
            vf20, vf21, vf22, vf23, vf24, vf30, vf31, vf32, vf33, vf34,
            vf40, vf41, vf42, vf43, vf44,
            fovf0, fovf1, fovf2, fovb0, fovb1, fovb2, fovr0, fovr1, fovr2,
            fovl0, fovl1, fovl2, fovx0, fovx1, fovx2,
        ],
        actions: [handf, handb, handr, handl, eyef, eyeb, eyer, eyel, grasp, ungrasp],
        values: [hgr = 10.0],
        maps: 10 x 10,
        patterns: 2048,
        schemas: 1024,
        ram: 750_000,
    }
}

/// Change coding, the book's thresholds and a neighbourhood that settles, in place of the forager's.
fn config() -> AgentConfig {
    AgentConfig {
        training: training(),
        harvest: HarvestConfig::BOOK,
        coding: ResultCoding::Change,
        harvest_every: 5_000,
        greedy_share: 0.0,
        ..AgentConfig::FORAGER
    }
}

fn percept(world: &Microworld) -> ItemStates<{ infant::WORDS }> {
    known(&world.on())
}

/// An infant after so many random actions.
fn educated(seed: u64, actions: u32) -> Box<infant::Brain> {
    let mut brain = Box::new(infant::brain());
    infant::be_born(&mut brain, config(), seed).expect("a configuration that works");
    let mut world = Microworld::new(seed, Body::Visible, 0.0);
    for _ in 0..actions {
        let choice = brain.choose(&percept(&world)).expect("it is born");
        world.act(usize::from(choice.action.0));
        brain.learn(&percept(&world)).expect("it has chosen");
    }
    brain
}

#[test]
fn the_description_is_the_worlds() {
    assert_eq!(infant::VOCABULARY.items, ITEMS);
    assert_eq!(infant::VOCABULARY.actions, ACTIONS);
}

#[test]
fn the_foragers_agent_learns_how_eye_and_hand_move_in_the_microworld() {
    let brain = educated(1, 30_000);
    let knowledge = brain.knowledge();
    let texts = (0..knowledge.schemas().len() as u16)
        .filter_map(|id| knowledge.text(cla_core::knowledge::SchemaId(id)));
    let schemas: Vec<Schema> = texts.collect();
    assert!(schemas.len() > 300, "{}", schemas.len());
    let recall = Oracle::new(Body::Visible).recall(&schemas, VALID);
    let (eye, total) = (recall.of(Family::EyeProprioception), recall.total());
    println!("{} schemas, recall {total}, eye {eye}", schemas.len());
    assert!((0.2..=1.0).contains(&eye), "{eye}");
    assert!((0.1..=1.0).contains(&total), "{total}");
}

#[test]
fn the_foragers_agent_grips_more_often_than_chance_in_the_microworld() {
    let mut brain = educated(2, 30_000);
    brain.act(Adaptation::Reliabilities).expect("it is born");
    let hgr = infant::Item::hgr.id();
    // Many short attempts from fresh starts; the same for random actions.
    let mut grips = |by_value: bool| {
        let (mut rng, mut gripped) = (Rng::new(7), 0);
        for start in 0..200 {
            let mut world = Microworld::new(1000 + start, Body::Visible, 0.0);
            for _ in 0..20 {
                let action = if by_value {
                    let choice = brain.choose(&percept(&world)).expect("it is born");
                    assert_ne!(choice.reason, Reason::Exploration);
                    usize::from(choice.action.0)
                } else {
                    rng.below(ACTIONS.len() as u32) as usize
                };
                world.act(action);
                if by_value {
                    brain.learn(&percept(&world)).expect("it has chosen");
                }
                if world.on().contains(hgr) {
                    gripped += 1;
                    break;
                }
            }
        }
        gripped
    };
    let (chosen, random) = (grips(true), grips(false));
    println!("{chosen} of 200 by value, {random} at random");
    assert!(chosen > 2 * random, "{chosen}, {random}");
}
