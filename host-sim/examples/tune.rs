//! Tunes the rivals of the recovery experiment: `cargo run --release -p host-sim --example tune`.
//!
//! Arguments: configurations of each rival (2; the committed table has 64), seeds from 0 on (1; 20),
//! then a file for the table of all trials (none; `data/tuning.tsv`).
//! Prints the three best of each rival: captures in 3000 undamaged actions and in the 3000 after the
//! camera was turned by 12°, their sum and its standard error over the seeds, the length of training,
//! the parameters.
//! The grids stand in `experiment/recover/rivals.rs`.

use host_sim::experiment::recover::life::Protocol;
use host_sim::experiment::recover::rivals::{LENGTHS, Rival, tried};
use host_sim::failure::Failure;
use host_sim::report::{mean, sample_sd};
use host_sim::world::config::PioneerConfig;
use host_sim::world::setting::WorldOptions;
use rayon::prelude::*;

/// One line of the table.
struct Line {
    rival: Rival,
    trial: u32,
    training: u32,
    undamaged: f64,
    damaged: f64,
    error: f64,
}

impl Line {
    fn score(&self) -> f64 {
        self.undamaged + self.damaged
    }
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, otherwise: u32| {
        let given = arguments.get(place);
        given.map_or(Ok(otherwise), |text| text.parse::<u32>())
    };
    let (trials, seeds) = (number(0, 2)?, u64::from(number(1, 1)?));
    assert!(
        trials > 0 && (1..=100).contains(&seeds),
        "seeds 0 to 99 are for tuning"
    );
    let world = WorldOptions::new(PioneerConfig::NOISY, None)?;
    let all: Vec<(Rival, u32, u64)> = Rival::ALL
        .into_iter()
        .flat_map(|rival| (0..trials).map(move |trial| (rival, trial)))
        .flat_map(|(rival, trial)| (0..seeds).map(move |seed| (rival, trial, seed)))
        .collect();
    let brought: Vec<[[u32; 2]; 3]> = all
        .par_iter()
        .map(|&(rival, trial, seed)| {
            tried(&rival.draw(trial), &world, seed).expect("the reference world can be lived in")
        })
        .collect();
    let mut lines = Vec::new();
    for (of, brought) in all
        .chunks(seeds as usize)
        .zip(brought.chunks(seeds as usize))
    {
        for (place, quarters) in LENGTHS.into_iter().enumerate() {
            let part = |part: usize| -> Vec<f64> {
                brought
                    .iter()
                    .map(|it| f64::from(it[place][part]))
                    .collect()
            };
            let sums: Vec<f64> = part(0).iter().zip(part(1)).map(|(a, b)| a + b).collect();
            lines.push(Line {
                rival: of[0].0,
                trial: of[0].1,
                training: quarters * Protocol::STANDARD.training / 2,
                undamaged: mean(&part(0)),
                damaged: mean(&part(1)),
                error: sample_sd(&sums) / (seeds as f64).sqrt(),
            });
        }
    }
    if let Some(path) = arguments.get(2) {
        let mut text = "rival\ttrial\ttraining\tundamaged\tdamaged\terror\n".to_owned();
        for it in &lines {
            text.push_str(&format!(
                "{:?}\t{}\t{}\t{}\t{}\t{:.2}\n",
                it.rival, it.trial, it.training, it.undamaged, it.damaged, it.error
            ));
        }
        std::fs::write(path, text)?;
    }
    println!("{trials} configurations on seeds 0 to {}", seeds - 1);
    for rival in Rival::ALL {
        let mut best: Vec<&Line> = lines.iter().filter(|it| it.rival == rival).collect();
        best.sort_by(|a, b| b.score().total_cmp(&a.score()));
        println!("{}", rival.name());
        for it in best.iter().take(3) {
            let setup = rival.draw(it.trial);
            println!(
                "  {:6.2} + {:6.2} = {:6.2} ± {:4.1}, {:6} actions, trial {:2}: {setup:?}",
                it.undamaged,
                it.damaged,
                it.score(),
                it.error,
                it.training,
                it.trial
            );
        }
    }
    Ok(())
}
