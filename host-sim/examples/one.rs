//! What the one learner earns in every world, with one configuration, beside what lives there today.
//!
//! `cargo run --release -p host-sim --example one -- WORLD [FIRST..LAST]`, where `WORLD` is `forager`,
//! `recover`, `unknown`, `distractors`, `lake`, `shuttle`, `vacuum`, `keys`, `generated` or `bytes`.
//! Every learner trains (20,000 actions, keys 50,000; the forager also 5000 and 50,000), then acts as
//! well as it can; shown is what it earns then, mean ± standard deviation over the seeds, each of them.
//! What the rivals of the other worlds earn is said by the example `worlds`.

use std::ops::Range;
use std::sync::Arc;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forest::{Heard, MindConfig, Voice};
use cla_core::num::Rng;
use host_sim::baseline::tabular::{Tabular, TabularConfig};
use host_sim::baseline::worlds::{keys, lake, shuttle, vacuum};
use host_sim::failure::Failure;
use host_sim::learner::controller::{Controller, Untaught};
use host_sim::learner::forager::Forager;
use host_sim::learner::mind::{Brain, Minded};
use host_sim::learner::rewarded::{Income, driven, rewarded};
use host_sim::learner::{Learner, live};
use host_sim::world::World;
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::{Damage, Damaged};
use host_sim::world::distracted::Distracted;
use host_sim::world::generated::{Generated, Spec};
use host_sim::world::keys::Keys;
use host_sim::world::lake::Lake;
use host_sim::world::pioneer::{ACTIONS, INGRIP, ITEMS, Pioneer};
use host_sim::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE};
use host_sim::world::vacuum::Vacuum;
use host_sim::world::veil::{Lost, Veil, Veiled};
use rayon::prelude::*;

/// What a specimen is worth to the forager, as in its `brain!`.
const SPECIMEN: f32 = 10.0;

/// Actions of a test in the Pioneer's room.
const TEST: u32 = 3000;

fn show(name: &str, scores: &[f64]) {
    let n = scores.len() as f64;
    let mean = scores.iter().fold(0.0, |sum, it| sum + it) / n;
    let squares = scores.iter().fold(0.0, |sum, it| sum + (it - mean).powi(2));
    let spread = (squares / (n - 1.0).max(1.0)).sqrt();
    let each: Vec<String> = scores.iter().map(|it| format!("{it:.4}")).collect();
    println!(
        "{name:36} {mean:9.4} ± {spread:.4}  n = {n}  {}",
        each.join(" ")
    );
}

/// Lives of some seeds, each with some scores under the same names.
fn table(
    seeds: &Range<u64>,
    life: impl Fn(u64) -> Result<Vec<(String, f64)>, Failure> + Sync + Send,
) -> Result<(), Failure> {
    let lives: Result<Vec<_>, Failure> = seeds.clone().into_par_iter().map(life).collect();
    let lives = lives?;
    let Some(first) = lives.first() else {
        return Ok(());
    };
    for (place, (name, _)) in first.iter().enumerate() {
        let scores: Vec<f64> = lives.iter().map(|life| life[place].1).collect();
        show(name, &scores);
    }
    Ok(())
}

/// The configurations that are compared: the default, and its parts alone.
fn configs() -> [(&'static str, MindConfig); 6] {
    let only = |voice| MindConfig {
        heard: Heard::only(voice),
        ..MindConfig::DEFAULT
    };
    [
        ("mind", MindConfig::DEFAULT),
        ("mind, trees and habits", only(Voice::TreesAndHabits)),
        ("mind, trees", only(Voice::Trees)),
        ("mind, habits", only(Voice::Habits)),
        ("mind, model", only(Voice::Model)),
        ("mind, model and habits", only(Voice::ModelAndHabits)),
    ]
}

fn room(seed: u64) -> Result<Pioneer, Failure> {
    Ok(Pioneer::new(PioneerConfig::NOISY, seed)?)
}

/// The room of the second half of a training, and that of the test, as everywhere in the project.
fn rooms(seed: u64) -> [u64; 2] {
    [4, 1].map(|stream| Rng::stream(seed, stream).next_seed())
}

/// A forager's value of its items, and of as many others as there are.
fn values<const ITEMS: usize>() -> [f32; ITEMS] {
    let mut values = [0.0; ITEMS];
    values[INGRIP as usize] = SPECIMEN;
    values
}

fn foraging(config: MindConfig, seed: u64) -> Result<Minded<1, 7, 6>, Failure> {
    Minded::born(config, values(), seed)
}

/// Trains in two rooms, half of the actions in each.
fn raise(learner: &mut dyn Learner, actions: u32, seed: u64) -> Result<(), Failure> {
    live(learner, &mut room(seed)?, actions / 2)?;
    live(learner, &mut room(rooms(seed)[0])?, actions / 2)?;
    learner.act()
}

fn forager(seeds: &Range<u64>) -> Result<(), Failure> {
    for actions in [20_000, 5_000, 50_000] {
        println!("captures in {TEST} actions after {actions} of training");
        table(seeds, |seed| {
            let mut out = Vec::new();
            let mut test = |name: &str, learner: &mut dyn Learner| -> Result<(), Failure> {
                raise(learner, actions, seed)?;
                let captures = live(learner, &mut room(rooms(seed)[1])?, TEST)?.total();
                out.push((name.to_owned(), f64::from(captures)));
                Ok(())
            };
            // The parts alone at the middle length only.
            let parts = if actions == 20_000 {
                configs().len()
            } else {
                1
            };
            for (name, config) in configs().into_iter().take(parts) {
                test(name, &mut foraging(config, seed)?)?;
            }
            let both = AgentConfig::FORAGER_LEVEL2;
            test(
                "both levels",
                &mut Forager::born(both, Adaptation::Reliabilities, seed)?,
            )?;
            test("Sarsa(λ)", &mut Tabular::new(TabularConfig::SARSA, seed))?;
            Ok(out)
        })?;
    }
    Ok(())
}

/// Lives undamaged and then damaged, as `recover` does it.
fn damaged(
    learner: &mut dyn Learner,
    damage: Damage,
    seed: u64,
    name: &str,
    out: &mut Vec<(String, f64)>,
) -> Result<(), Failure> {
    let mut world = room(rooms(seed)[1])?;
    live(learner, &mut world, TEST)?;
    let mut world = Damaged::new(world, damage, seed)?;
    for (part, actions, shown) in [
        ("0–3k", 3000, true),
        ("3–6k", 3000, true),
        ("6–10k", 4000, false),
        ("10–13k", 3000, true),
    ] {
        let captures = live(learner, &mut world, actions)?.total();
        if shown {
            out.push((format!("{name} {damage} {part}"), f64::from(captures)));
        }
    }
    Ok(())
}

fn recover(seeds: &Range<u64>) -> Result<(), Failure> {
    println!("captures after a damage that came in mid-life, after 20,000 actions of training");
    table(seeds, |seed| {
        let mut out = Vec::new();
        let mut mind = foraging(MindConfig::DEFAULT, seed)?;
        raise(&mut mind, 20_000, seed)?;
        let mut both = Forager::born(AgentConfig::FORAGER_LEVEL2, Adaptation::Relearning, seed)?;
        raise(&mut both, 20_000, seed)?;
        let surprise = AgentConfig::RESILIENT_LEVEL2.surprise;
        let mut sarsa = Tabular::new(TabularConfig::SARSA, seed);
        raise(&mut sarsa, 20_000, seed)?;
        for text in ["camera:+12", "stuck:s3", "dead:s3"] {
            let damage = Damage::parse(text, &ITEMS, &ACTIONS)?;
            damaged(&mut mind.clone(), damage, seed, "mind", &mut out)?;
            let mut acting = both.acting(Adaptation::Relearning, surprise)?;
            damaged(&mut acting, damage, seed, "both levels, surprise", &mut out)?;
            damaged(&mut sarsa.clone(), damage, seed, "Sarsa(λ)", &mut out)?;
        }
        Ok(out)
    })
}

fn unknown(seeds: &Range<u64>) -> Result<(), Failure> {
    println!("captures in {TEST} actions with readings that get lost after 20,000 of training");
    table(seeds, |seed| {
        let mut mind = foraging(MindConfig::DEFAULT, seed)?;
        raise(&mut mind, 20_000, seed)?;
        let veils = [
            ("nothing lost", None),
            ("s1 unknown", Some(Veil::Item(0, Lost::Unknown))),
            ("s1 off", Some(Veil::Item(0, Lost::Off))),
            ("s3 unknown", Some(Veil::Item(2, Lost::Unknown))),
            ("s3 off", Some(Veil::Item(2, Lost::Off))),
            ("a tenth unknown", Some(Veil::Share(0.1, Lost::Unknown))),
            ("a tenth held", Some(Veil::Share(0.1, Lost::Held))),
        ];
        let mut out = Vec::new();
        for (name, veil) in veils {
            let mut learner = mind.clone();
            let world = room(rooms(seed)[1])?;
            let lived = match veil {
                None => live(&mut learner, &mut { world }, TEST)?,
                Some(veil) => live(&mut learner, &mut Veiled::new(world, veil, seed), TEST)?,
            };
            out.push((format!("mind, {name}"), f64::from(lived.total())));
        }
        Ok(out)
    })
}

fn distractors(seeds: &Range<u64>) -> Result<(), Failure> {
    println!("captures in {TEST} actions beside items that blink, after 20,000 of training");
    fn life<const ALL: usize>(more: usize, seed: u64) -> Result<f64, Failure> {
        let mut mind = Minded::<1, ALL, 6>::born(MindConfig::DEFAULT, values(), seed)?;
        let around = |seed| -> Result<_, Failure> { Ok(Distracted::new(room(seed)?, more, seed)) };
        live(&mut mind, &mut around(seed)?, 10_000)?;
        live(&mut mind, &mut around(rooms(seed)[0])?, 10_000)?;
        mind.act()?;
        let lived = live(&mut mind, &mut around(rooms(seed)[1])?, TEST)?;
        Ok(f64::from(lived.total()))
    }
    table(seeds, |seed| {
        Ok(vec![
            ("mind, 8 distractors".to_owned(), life::<15>(8, seed)?),
            ("mind, 20 distractors".to_owned(), life::<27>(20, seed)?),
        ])
    })
}

/// One world, and by what one is judged there.
struct Place<W> {
    make: fn(u64) -> W,
    train: &'static [u32],
    test: u32,
    /// Of a test: the world before and after, and what was earned between.
    score: fn(&W, &W, &Income) -> f64,
}

impl<W: World + Clone> Place<W> {
    fn test(&self, world: &mut W, learner: &mut dyn Learner) -> Result<f64, Failure> {
        learner.act()?;
        let before = world.clone();
        let income = rewarded(learner, world, self.test)?;
        Ok((self.score)(&before, world, &income))
    }

    fn run<const WORDS: usize, const ITEMS: usize, const N: usize, C: Controller>(
        &self,
        seeds: &Range<u64>,
        by_hand: Option<fn(&W) -> C>,
    ) -> Result<(), Failure> {
        for &actions in self.train {
            println!("after {actions} actions of training");
            table(seeds, |seed| {
                let mut out = Vec::new();
                for (name, config) in configs() {
                    let mut world = (self.make)(seed);
                    let mut mind = Minded::<WORDS, ITEMS, N>::born(config, [0.0; ITEMS], seed)?;
                    rewarded(&mut mind, &mut world, actions)?;
                    out.push((name.to_owned(), self.test(&mut world, &mut mind)?));
                }
                if let Some(by_hand) = by_hand {
                    let mut world = (self.make)(seed);
                    let mut hand = Untaught::new(by_hand(&world), seed);
                    out.push(("by hand".to_owned(), self.test(&mut world, &mut hand)?));
                }
                Ok(out)
            })?;
        }
        Ok(())
    }
}

fn the_shuttle() -> Arc<Pomdp> {
    Arc::new(Pomdp::parse(SHUTTLE).expect("the project's own file can be read"))
}

/// A generated world has its own numbers of items and actions; all minds have room for the largest.
fn generated(seeds: &Range<u64>) -> Result<(), Failure> {
    println!("share of the optimum in 5000 actions after 20,000 of training");
    table(seeds, |seed| {
        let mut out = Vec::new();
        for (name, config) in configs() {
            let mut world = Generated::new(Arc::new(Spec::random(seed)), seed);
            let earned = match world.actions().len() {
                3 => chance::<3>(&mut world, config, seed)?,
                4 => chance::<4>(&mut world, config, seed)?,
                5 => chance::<5>(&mut world, config, seed)?,
                6 => chance::<6>(&mut world, config, seed)?,
                7 => chance::<7>(&mut world, config, seed)?,
                8 => chance::<8>(&mut world, config, seed)?,
                9 => chance::<9>(&mut world, config, seed)?,
                10 => chance::<10>(&mut world, config, seed)?,
                11 => chance::<11>(&mut world, config, seed)?,
                _ => chance::<12>(&mut world, config, seed)?,
            };
            out.push((name.to_owned(), earned));
        }
        let world = &mut Generated::new(Arc::new(Spec::random(seed)), seed);
        let plan = world.spec().model().rate(1e-6);
        let planned = driven(world, 5000, |it| plan.policy[it.state()]);
        let planned = planned.per_action() / world.optimum();
        out.push(("planner".to_owned(), planned));
        Ok(out)
    })
}

fn chance<const N: usize>(
    world: &mut Generated,
    config: MindConfig,
    seed: u64,
) -> Result<f64, Failure> {
    let mut mind = Minded::<2, 64, N>::born(config, [0.0; 64], seed)?;
    rewarded(&mut mind, world, 20_000)?;
    mind.act()?;
    let income = rewarded(&mut mind, world, 5000)?;
    Ok(income.per_action() / world.optimum())
}

fn bytes() {
    let of = |name: &str, bytes: usize| println!("{name:36} {bytes:9} bytes");
    of("forager", size_of::<Brain<1, 7, 6>>());
    of("forager, 20 distractors", size_of::<Brain<1, 27, 6>>());
    of("lake", size_of::<Brain<1, 16, 4>>());
    of("shuttle", size_of::<Brain<1, 5, 3>>());
    of("vacuum", size_of::<Brain<1, 15, 5>>());
    of("keys", size_of::<Brain<2, 48, 6>>());
    of("generated, the largest", size_of::<Brain<2, 64, 12>>());
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let world = arguments.first().map_or("", String::as_str);
    let seeds = match arguments.get(1).and_then(|text| text.split_once("..")) {
        Some((first, last)) => first.parse()?..last.parse()?,
        None => 0..10,
    };
    println!("{world}, seeds {seeds:?}");
    match world {
        "forager" => forager(&seeds),
        "recover" => recover(&seeds),
        "unknown" => unknown(&seeds),
        "distractors" => distractors(&seeds),
        "generated" => generated(&seeds),
        "lake" => Place {
            make: Lake::new,
            train: &[20_000],
            test: 20_000,
            score: |_, _, income| income.per_episode(),
        }
        .run::<1, 16, 4, _>(&seeds, Some(|_| lake::Careful)),
        "shuttle" => Place {
            make: |seed| PomdpWorld::new(the_shuttle(), seed),
            train: &[20_000],
            test: 10_000,
            score: |_, _, income| income.per_action(),
        }
        .run::<1, 5, 3, _>(&seeds, Some(|_| shuttle::Docker::default())),
        "vacuum" => Place {
            make: Vacuum::new,
            train: &[3_000, 20_000],
            test: TEST,
            score: |_, _, income| income.earned,
        }
        .run::<1, 15, 5, _>(&seeds, Some(|_| vacuum::Sweeper::default())),
        "keys" => Place {
            make: Keys::new,
            train: &[50_000],
            test: 10_000,
            score: |before: &Keys, after, _| {
                let tries = (after.tries() - before.tries()).max(1);
                (after.efficiency() - before.efficiency()) / f64::from(tries)
            },
        }
        .run::<2, 48, 6, _>(&seeds, Some(|_| keys::Searcher::default())),
        "bytes" => {
            bytes();
            Ok(())
        }
        other => {
            println!("{other:?} is no world; the head of this file names them");
            Ok(())
        }
    }
}
