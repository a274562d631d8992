//! What a mind does in a doubt, one way beside the other: captures after damages, other worlds undamaged.
//!
//! `cargo run --release -p host-sim --example doubts -- [SEEDS [WAYS]]`, where `SEEDS` is `A..B`
//! (0..1) and `WAYS` how many of the ways are lived (all).
//! A life is 20,000 actions of training in two rooms, 3000 in a third, and there 3000 more with a damage;
//! shown is the mean ± standard deviation over the seeds of what those last brought.

use cla_core::forest::{Heard, MindConfig, Voice};
use cla_core::num::Rng;
use host_sim::failure::Failure;
use host_sim::learner::mind::Minded;
use host_sim::learner::rewarded::rewarded;
use host_sim::learner::{Learner, live};
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::{Damage, Damaged};
use host_sim::world::lake::Lake;
use host_sim::world::pioneer::{ACTIONS, INGRIP, ITEMS, Pioneer};
use rayon::prelude::*;

const DAMAGES: [&str; 6] = [
    "none",
    "camera:+12",
    "camera:+30",
    "swap:s2,s4",
    "pull:8",
    "stuck:s3",
];

fn ways() -> [(&'static str, MindConfig); 5] {
    let plain = MindConfig {
        heard_doubting: Heard::DEFAULT,
        trials_doubting: 100.0,
        doubt_lasts: 800,
        ..MindConfig::DEFAULT
    };
    let few = MindConfig {
        trials_doubting: 1.0,
        ..plain
    };
    let habits = MindConfig {
        heard_doubting: Heard::only(Voice::Habits),
        ..plain
    };
    let both = MindConfig {
        heard_doubting: habits.heard_doubting,
        ..few
    };
    let long = MindConfig {
        doubt_lasts: 1600,
        ..both
    };
    [
        ("all voices for 800 actions", plain),
        ("the model's counts weigh one trial", few),
        ("habits lead", habits),
        ("both", both),
        ("as it is: both, for 1600 actions", long),
    ]
}

/// Captures after each damage, and the share of episodes on the lake that end at the goal.
fn lives(config: MindConfig, seed: u64) -> Result<Vec<f64>, Failure> {
    let room = |seed| Pioneer::new(PioneerConfig::NOISY, seed);
    let mut values = [0.0; 7];
    values[usize::from(INGRIP)] = 10.0;
    let mut mind = Minded::<1, 7, 6>::born(config, values, seed)?;
    live(&mut mind, &mut room(seed)?, 10_000)?;
    live(
        &mut mind,
        &mut room(Rng::stream(seed, 4).next_seed())?,
        10_000,
    )?;
    mind.act()?;
    let mut brought = Vec::new();
    for damage in DAMAGES {
        let (mut mind, mut world) = (mind.clone(), room(Rng::stream(seed, 1).next_seed())?);
        live(&mut mind, &mut world, 3000)?;
        let mut world = Damaged::new(world, Damage::parse(damage, &ITEMS, &ACTIONS)?, seed)?;
        brought.push(live(&mut mind, &mut world, 3000)?.total().into());
    }
    let (mut mind, mut lake) = (
        Minded::<1, 16, 4>::born(config, [0.0; 16], seed)?,
        Lake::new(seed),
    );
    rewarded(&mut mind, &mut lake, 20_000)?;
    mind.act()?;
    brought.push(rewarded(&mut mind, &mut lake, 20_000)?.per_episode());
    Ok(brought)
}

fn main() -> Result<(), Failure> {
    let seeds = std::env::args().nth(1).unwrap_or_else(|| "0..1".into());
    let (first, end) = seeds.split_once("..").ok_or("SEEDS is A..B")?;
    let seeds: Vec<u64> = (first.parse()?..end.parse()?).collect();
    let n = seeds.len().max(1) as f64;
    let lived = std::env::args()
        .nth(2)
        .map_or(Ok(usize::MAX), |it| it.parse())?;
    for (name, config) in ways().into_iter().take(lived) {
        let all = seeds.par_iter().map(|&seed| lives(config, seed));
        let all = all.collect::<Result<Vec<_>, Failure>>()?;
        println!("{name}");
        for (place, life) in DAMAGES.into_iter().chain(["lake"]).enumerate() {
            let mean = all.iter().fold(0.0, |sum, it| sum + it[place]) / n;
            let squares = all
                .iter()
                .fold(0.0, |sum, it| sum + (it[place] - mean).powi(2));
            let spread = (squares / (n - 1.0).max(1.0)).sqrt();
            println!("  {life:12} {mean:8.3} ± {spread:7.3}  n = {n}");
        }
    }
    Ok(())
}
