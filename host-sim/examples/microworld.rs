//! How the one learner knows, plans and lives in the Microworld, with its one configuration.
//!
//! `cargo run --release -p host-sim --example microworld -- [FIRST..LAST] [ACTIONS] [SLIP]`: for each
//! seed a life of so many random actions (30,000), told to it as a teacher's, and one in which it acts
//! by value from the start.
//! Shown are, mean ± standard deviation over the seeds and each of them: recall (the share of all item
//! changes that truly reliable schemas predict), precision of all its schemas; the share of 200 tries of
//! 20 actions from the book's starts in which it grips the ball, which is what it values; the share of
//! goals that it reaches within 20 actions, without a thought before and after 100,000 units of them.
//! `-- bytes` says what it takes.

use std::ops::Range;

use cla_core::forest::{Mind, MindConfig};
use cla_core::num::Rng;
use cla_core::reason::{Pursuit, Reason};
use cla_core::word::{ItemStates, SchemaText};
use host_sim::experiment::microworld::goals::{GOALS, GoalGroup, STEP_LIMIT, goal};
use host_sim::failure::Failure;
use host_sim::learner::native::narrowed;
use host_sim::world::World;
use host_sim::world::microworld::{ACTIONS, Body, ITEMS, Microworld, Oracle, WORDS, item};
use rayon::prelude::*;

const ITEM_COUNT: usize = ITEMS.len();
const ACTION_COUNT: usize = ACTIONS.len();

/// 150 samples an action, 1500 schemas, 1700 imagined states.
type Thoughts = Reason<WORDS, ITEM_COUNT, ACTION_COUNT, 150, 1500, 1700>;
/// Beside them 768 samples of all actions, 64 leaves, 256 rows, 64 states and links.
type Brain = Mind<WORDS, ITEM_COUNT, ACTION_COUNT, 48, 64, 256, 64, 64, Thoughts>;

/// What a grip is worth.
const GRIP: f32 = 10.0;
/// Tries to grip, and actions of each.
const TRIES: u64 = 200;

fn senses(world: &Microworld) -> ItemStates<WORDS> {
    narrowed(&world.sense())
}

fn grips(world: &Microworld) -> bool {
    world.on().contains(item("hgr").expect("an item"))
}

fn born(seed: u64) -> Result<Box<Brain>, Failure> {
    let mut brain = Box::new(Brain::unborn());
    let mut values = [0.0; ITEM_COUNT];
    values[usize::from(item("hgr").expect("an item").0)] = GRIP;
    brain.be_born(MindConfig::DEFAULT, values, seed)?;
    Ok(brain)
}

/// Random actions, watched.
fn watched(seed: u64, actions: u32, slip: f32) -> Result<Box<Brain>, Failure> {
    let (mut brain, mut rng) = (born(seed)?, Rng::stream(seed, 52));
    let mut world = Microworld::new(seed, Body::Visible, slip);
    for _ in 0..actions {
        let action = rng.below(ACTION_COUNT as u32) as u16;
        let before = senses(&world);
        world.act(usize::from(action));
        brain.observe(&before, cla_core::ActionId(action), &senses(&world))?;
    }
    Ok(brain)
}

/// One action of its own.
fn act(brain: &mut Brain, world: &mut Microworld) -> Result<(), Failure> {
    let choice = brain.choose(&senses(world))?;
    world.act(usize::from(choice.action.0));
    brain.learn(&senses(world))?;
    Ok(())
}

/// A life by value, which nobody interrupts.
fn lived(seed: u64, actions: u32, slip: f32) -> Result<Box<Brain>, Failure> {
    let mut brain = born(seed)?;
    let mut world = Microworld::new(seed, Body::Visible, slip);
    for _ in 0..actions {
        act(&mut brain, &mut world)?;
    }
    Ok(brain)
}

/// The share of tries in which it grips.
fn tries(brain: &Brain, seed: u64, slip: f32) -> Result<f64, Failure> {
    let mut brain = Box::new(brain.clone());
    brain.act()?;
    let mut gripped = 0;
    for start in 0..TRIES {
        let mut world = Microworld::new(seed * TRIES + start, Body::Visible, slip);
        brain.interrupt()?;
        for _ in 0..STEP_LIMIT {
            act(&mut brain, &mut world)?;
            if grips(&world) {
                gripped += 1;
                break;
            }
        }
    }
    Ok(f64::from(gripped) / TRIES as f64)
}

/// The share of goals that are reached from random states, each by a brain as it was.
fn reached(
    brain: &Brain,
    group: &GoalGroup,
    oracle: &Oracle,
    thoughts: u32,
    seed: u64,
    slip: f32,
) -> Result<f64, Failure> {
    let mut rng = Rng::stream(seed, 77);
    let (mut hits, mut attempts) = (0, 0);
    for name in group.items {
        let wanted = item(name).expect("a goal is an item");
        for _ in 0..group.attempts {
            let mut brain = Box::new(brain.clone());
            let mut world = Microworld::new(rng.next_seed(), Body::Visible, slip);
            loop {
                let state = rng.below(oracle.states().len() as u32) as usize;
                if !oracle.items(state).contains(wanted) {
                    world.set_state(oracle.states()[state]);
                    break;
                }
            }
            brain.act()?;
            brain.interrupt()?;
            brain.pursue(goal(wanted), STEP_LIMIT, &senses(&world))?;
            brain.idle(thoughts);
            while brain.pursuit().is_underway() {
                act(&mut brain, &mut world)?;
            }
            hits += u32::from(brain.pursuit() == Pursuit::Reached);
            attempts += 1;
        }
    }
    Ok(f64::from(hits) / f64::from(attempts))
}

fn judged(
    name: &str,
    brain: &Brain,
    oracle: &Oracle,
    seed: u64,
    slip: f32,
) -> Result<Vec<(String, f64)>, Failure> {
    let schemas = brain.reason().schemas();
    let texts: Vec<SchemaText<WORDS>> = schemas.iter().map(|it| it.text()).collect();
    let mut out = vec![
        (
            format!("{name}: recall"),
            oracle.recall(&texts, 0.9).total(),
        ),
        (
            format!("{name}: precision"),
            oracle.predicted(&texts).precision(),
        ),
        (format!("{name}: grips by value"), tries(brain, seed, slip)?),
    ];
    for group in GOALS.iter().take(6) {
        for (how, thoughts) in [("at once", 0), ("after a thought", 100_000)] {
            let share = reached(brain, group, oracle, thoughts, seed, slip)?;
            out.push((format!("{name}: goal {}, {how}", group.name), share));
        }
    }
    Ok(out)
}

fn show(name: &str, scores: &[f64]) {
    let n = scores.len() as f64;
    let mean = scores.iter().fold(0.0, |sum, it| sum + it) / n;
    let squares = scores.iter().fold(0.0, |sum, it| sum + (it - mean).powi(2));
    let spread = (squares / (n - 1.0).max(1.0)).sqrt();
    let each: Vec<String> = scores.iter().map(|it| format!("{it:.3}")).collect();
    println!(
        "{name:44} {mean:.3} ± {spread:.3}  n = {n}  {}",
        each.join(" ")
    );
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    println!(
        "{} bytes, of them {} for schemas, imagined states and goals",
        size_of::<Brain>(),
        size_of::<Thoughts>()
    );
    if arguments.first().is_some_and(|word| word == "bytes") {
        return Ok(());
    }
    let bounds = arguments.first().and_then(|text| text.split_once(".."));
    let seeds: Range<u64> = match bounds {
        Some((first, last)) => first.parse()?..last.parse()?,
        None => 0..10,
    };
    let actions: u32 = arguments.get(1).map_or(Ok(30_000), |it| it.parse())?;
    let slip: f32 = arguments.get(2).map_or(Ok(0.0), |it| it.parse())?;
    println!("seeds {seeds:?}, {actions} actions, slip {slip}");
    let oracle = Oracle::new(Body::Visible);
    let lives: Result<Vec<_>, Failure> = seeds
        .into_par_iter()
        .map(|seed| {
            let random = watched(seed, actions, slip)?;
            let mut out = judged("random actions", &random, &oracle, seed, slip)?;
            let by_value = lived(seed, actions, slip)?;
            out.extend(judged("by value", &by_value, &oracle, seed, slip)?);
            Ok(out)
        })
        .collect();
    let lives = lives?;
    let names = lives.first().map_or(&[][..], Vec::as_slice);
    for (place, (name, _)) in names.iter().enumerate() {
        let scores: Vec<f64> = lives.iter().map(|life| life[place].1).collect();
        show(name, &scores);
    }
    Ok(())
}
