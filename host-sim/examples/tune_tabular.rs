//! The grid on which the tabular learners were tuned: `cargo run --release --example tune_tabular`.
//!
//! Arguments: how many seeds from 0 on, then which method (`q`, `sarsa`), then `history` or nothing,
//! then `coarse` for the part of the grid that had proved good without history.
//! Prints, for each set of parameters, the captures in 3000 undamaged actions and in 0–3k and
//! 10–13k actions after the camera was turned, summed up best first.

use cla_core::agent::Escape;
use host_sim::baseline::tabular::{History, Method, Tabular, TabularConfig, Traces};
use host_sim::failure::Failure;
use host_sim::learner::{Learner, live};
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::{Damage, Damaged};
use host_sim::world::pioneer::Pioneer;
use rayon::prelude::*;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let has = |word: &str| arguments.iter().any(|argument| argument == word);
    let seeds: u64 = arguments.first().map_or(Ok(10), |text| text.parse())?;
    let history = if has("history") {
        History::OneStep
    } else {
        History::None
    };
    let coarse = has("coarse");
    let mut grid = Vec::new();
    let methods = if has("q") {
        vec![(Method::QLearning, vec![0.0])]
    } else {
        vec![
            (Method::Sarsa(Traces::Replacing), vec![0.5, 0.8, 0.9, 0.95]),
            (Method::Sarsa(Traces::Accumulating), vec![0.5, 0.8, 0.9]),
        ]
    };
    for (method, lambdas) in methods {
        for &lambda in &lambdas {
            for alpha in [0.03, 0.1, 0.3] {
                for discount in [0.9, 0.95, 0.98] {
                    for explore in [0.1, 0.3] {
                        for explore_acting in [0.02, 0.05, 0.1] {
                            for optimism in [0.0, 0.5] {
                                for escape in [
                                    None,
                                    Some(Escape {
                                        after: 100,
                                        burst: 10,
                                    }),
                                ] {
                                    grid.push(TabularConfig {
                                        method,
                                        history,
                                        alpha,
                                        discount,
                                        lambda,
                                        explore,
                                        explore_acting,
                                        optimism,
                                        escape,
                                    });
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    if coarse {
        grid.retain(|it| {
            it.method != Method::Sarsa(Traces::Accumulating)
                && it.lambda != 0.5
                && it.lambda != 0.95
                && it.discount < 0.98
                && it.explore_acting == 0.02
                && it.optimism == 0.5
        });
    }
    let mut scores: Vec<(f64, [f64; 3], TabularConfig)> = grid
        .par_iter()
        .map(|&config| {
            let mut sums = [0.0; 3];
            for seed in 0..seeds {
                let life = life(config, seed).expect("the reference world can be lived in");
                for (sum, captures) in sums.iter_mut().zip(life) {
                    *sum += f64::from(captures) / seeds as f64;
                }
            }
            (sums.iter().sum(), sums, config)
        })
        .collect();
    scores.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (score, parts, config) in scores.iter().take(25) {
        println!("{score:6.1} {parts:6.1?} {config:?}");
    }
    Ok(())
}

fn life(config: TabularConfig, seed: u64) -> Result<[u32; 3], Failure> {
    let mut learner = Tabular::new(config, seed);
    live(
        &mut learner,
        &mut Pioneer::new(PioneerConfig::NOISY, seed)?,
        10_000,
    )?;
    learner.act()?;
    let mut world = Pioneer::new(PioneerConfig::NOISY, seed + 1_000_000)?;
    let before = live(&mut learner, &mut world, 3000)?.total();
    let mut world = Damaged::new(world, Damage::Camera(12.0), seed)?;
    let after = live(&mut learner, &mut world, 13_000)?.obtained;
    let sum = |part: &[u32]| part.iter().sum();
    Ok([before, sum(&after[..120]), sum(&after[400..])])
}
