//! Tunes the rivals of the experiment with aliased worlds: `data/aliased.tsv`, made again.
//!
//! `cargo run --release -p host-sim --example aliased > host-sim/data/aliased.tsv`; with names of worlds
//! as arguments, those alone.
//! Every configuration of a grid lives with the first seeds, the best of them with all seeds; the best
//! mean of all seeds wins, the first of equals.

use cla_core::num::Rng;
use host_sim::baseline::tabular::{Tabular, TabularConfig};
use host_sim::experiment::aliased::Place;
use host_sim::experiment::aliased::rivals::{Budget, Rival};
use host_sim::failure::Failure;
use host_sim::learner::rewarded::rewarded;
use host_sim::learner::{Learner, live};
use host_sim::world::World;
use host_sim::world::barriers::Barriers;
use host_sim::world::pomdp::PomdpWorld;
use rayon::prelude::*;

fn main() -> Result<(), Failure> {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    println!("world\tlearner\talpha\tdiscount\texplore\tlambda\toptimism\tearned");
    for place in Place::ALL {
        if !asked.is_empty() && !asked.iter().any(|it| it == place.name()) {
            continue;
        }
        for rival in Rival::ALL {
            tune(place, rival)?;
        }
    }
    Ok(())
}

/// What is earned in an action after a training.
fn scored(place: Place, config: TabularConfig, seed: u64) -> Result<f64, Failure> {
    let budget = Budget::of(place);
    let Some(model) = place.model()? else {
        let mut room = Barriers::new(seed)?;
        let mut table = Tabular::with_actions(config, room.actions(), seed);
        live(&mut table, &mut room, budget.training)?;
        table.act()?;
        let mut other = Barriers::new(Rng::stream(seed, 1).next_seed())?;
        let captures = live(&mut table, &mut other, budget.test)?.total();
        return Ok(f64::from(captures) / f64::from(budget.test));
    };
    let mut world = PomdpWorld::new(model, seed);
    let mut table = Tabular::with_actions(config, world.actions(), seed);
    rewarded(&mut table, &mut world, budget.training)?;
    table.act()?;
    Ok(rewarded(&mut table, &mut world, budget.test)?.per_action())
}

/// Configurations with their means over the seeds below `seeds`, the best first.
fn ranked(
    place: Place,
    configs: &[TabularConfig],
    seeds: u64,
) -> Result<Vec<(f64, TabularConfig)>, Failure> {
    let mean = |&config: &TabularConfig| {
        let mut sum = 0.0;
        for seed in 0..seeds {
            sum += scored(place, config, seed)?;
        }
        Ok((sum / seeds as f64, config))
    };
    let mut means = configs
        .par_iter()
        .map(mean)
        .collect::<Result<Vec<_>, Failure>>()?;
    means.sort_by(|a, b| b.0.total_cmp(&a.0));
    Ok(means)
}

fn tune(place: Place, rival: Rival) -> Result<(), Failure> {
    let budget = Budget::of(place);
    let first = ranked(place, &rival.grid(place), budget.first_seeds)?;
    let best: Vec<TabularConfig> = first.iter().take(Budget::KEPT).map(|it| it.1).collect();
    let (earned, it) = ranked(place, &best, budget.seeds)?[0];
    println!(
        "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{earned:.5}",
        place.name(),
        rival.name(),
        it.alpha,
        it.discount,
        it.explore,
        it.lambda,
        it.optimism,
    );
    Ok(())
}
