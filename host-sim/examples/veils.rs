//! The forager behind veils and among distractors: what an item, a share of the readings, or twenty
//! items that blink cost both levels and Sarsa(λ).
//!
//! `cargo run --release -p host-sim --example veils -- [SEEDS]`, seeds from 0 on (10).
//! Both levels train for 20,000 actions behind the veil and act for 3000 more, as in `recover`; shown
//! are the specimens of these, mean ± standard deviation over the seeds.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer as plain;
use host_sim::baseline::tabular::{Tabular, TabularConfig};
use host_sim::failure::Failure;
use host_sim::learner::native::Native;
use host_sim::learner::{Learner, live};
use host_sim::world::World;
use host_sim::world::config::PioneerConfig;
use host_sim::world::distracted::Distracted;
use host_sim::world::pioneer::{ITEMS, Pioneer};
use host_sim::world::veil::{Lost, Veil, Veiled};
use rayon::prelude::*;

cla_core::brain! {
    /// The forager with room for twenty items that mean nothing.
    pub mod crowded {
        items: [
            s1, s2, s3, s4, s5, ingrip, bump,
            b0, b1, b2, b3, b4, b5, b6, b7, b8, b9,
            b10, b11, b12, b13, b14, b15, b16, b17, b18, b19,
        ],
        actions: [forward, backward, turnl, turnr, turnaround, grip],
        values: [ingrip = 10.0],
        maps: 20 x 20,
        patterns: 128,
        schemas: 704,
        synthetic: 384,
        beliefs: 3072,
        ram: 700_000,
    }
}

macro_rules! born {
    ($module:ident, $seed:expr) => {{
        let mut brain = Box::new($module::brain());
        $module::be_born(&mut brain, AgentConfig::FORAGER_LEVEL2, $seed)?;
        Box::new(Native::new(brain, Adaptation::Relearning)) as Box<dyn Learner>
    }};
}

fn life<W: World>(
    world: impl Fn(u64) -> W,
    mut learner: Box<dyn Learner>,
    seed: u64,
) -> Result<u32, Failure> {
    live(&mut *learner, &mut world(seed), 20_000)?;
    learner.act()?;
    Ok(live(&mut *learner, &mut world(seed + 1_000_000), 3000)?.total())
}

fn show(name: &str, scores: &[u32]) {
    let (n, scores) = (scores.len() as f64, scores.iter().map(|&it| f64::from(it)));
    let mean = scores.clone().fold(0.0, |sum, it| sum + it) / n;
    let squares = scores.fold(0.0, |sum, it| sum + (it - mean).powi(2));
    println!(
        "{name:32} {mean:6.1} ± {:.1}  n = {n}",
        (squares / (n - 1.0).max(1.0)).sqrt()
    );
}

/// Both learners in the world that `wrap` makes of the Pioneer's.
fn both<W: World>(
    name: &str,
    seeds: u64,
    wrap: impl Fn(Pioneer, u64) -> W + Sync,
    brain: impl Fn(u64) -> Result<Box<dyn Learner>, Failure> + Sync,
) -> Result<(), Failure> {
    let world = |seed| {
        let pioneer = Pioneer::new(PioneerConfig::NOISY, seed).expect("the room is possible");
        wrap(pioneer, seed)
    };
    let seeds: Vec<u64> = (0..seeds).collect();
    let brains = seeds
        .par_iter()
        .map(|&seed| life(world, brain(seed)?, seed));
    show(
        &format!("{name}, both levels"),
        &brains.collect::<Result<Vec<_>, _>>()?,
    );
    let tables = seeds.par_iter().map(|&seed| {
        let table = Box::new(Tabular::new(TabularConfig::SARSA, seed));
        life(world, table, seed)
    });
    show(
        &format!("{name}, Sarsa(λ)"),
        &tables.collect::<Result<Vec<_>, _>>()?,
    );
    Ok(())
}

fn main() -> Result<(), Failure> {
    let seeds = std::env::args()
        .nth(1)
        .map_or(Ok(10), |text| text.parse())?;
    let forager = |seed| Ok(born!(plain, seed));
    both("bare", seeds, |world, _| world, forager)?;
    let s1 = 0;
    for (name, veil) in [
        ("s1 unknown", Veil::Item(s1, Lost::Unknown)),
        ("s1 off", Veil::Item(s1, Lost::Off)),
        ("a tenth unknown", Veil::Share(0.1, Lost::Unknown)),
        ("a tenth held", Veil::Share(0.1, Lost::Held)),
        ("a tenth off", Veil::Share(0.1, Lost::Off)),
        ("three tenths unknown", Veil::Share(0.3, Lost::Unknown)),
        ("three tenths held", Veil::Share(0.3, Lost::Held)),
    ] {
        both(
            name,
            seeds,
            |world, seed| Veiled::new(world, veil, seed),
            forager,
        )?;
    }
    assert_eq!(crowded::ITEMS.len(), ITEMS.len() + 20);
    let crowd = |seed| Ok(born!(crowded, seed));
    both(
        "20 distractors",
        seeds,
        |world, seed| Distracted::new(world, 20, seed),
        crowd,
    )
}
