//! Others that do the same: CMSIS-DSP on the controller, MiniSom and a plain loop on the host.
//!
//! Neither peer is part of the project: CMSIS-DSP's folder is named by the environment (see
//! `firmware-example/peers/run`) and its last measurement stands here; MiniSom is asked through
//! `python3` and left out where that has none.
//! Times are CPU times, shown and never judged.

use std::io::Write;
use std::process::{Command, Stdio};
use std::{env, fs};

use cla_core::num::{Neighbourhood, Rng};
use cla_core::som::{BinarySom, Grid, SparseStimulus, best_match};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::device::board::{Printed, folder};
use crate::failure::Failure;

/// Instructions of CMSIS-DSP's best variant (matrix · vector) for a best match over 400 × 142 and
/// its version, as `firmware-example/peers/run` measured last: `-Ofast`, GCC 12.2.
pub const CMSIS_LAST: (u64, &str) = (163_767, "1.17.1-16-gec1bb752");

/// Instructions of CMSIS-DSP's best variant for 400 × 142: measured where its folder is named, the
/// last measurement otherwise.
///
/// # Errors
/// When the folder is named but the bench fails.
pub fn cmsis() -> Result<u64, Failure> {
    if env::var_os("CMSIS_DSP").is_none() {
        return Ok(CMSIS_LAST.0);
    }
    let output = Command::new(folder()?.join("peers/run")).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let printed = Printed::from(String::from_utf8_lossy(&output.stdout).into_owned());
    let mut best = u64::MAX;
    for variant in ["distance", "dot_product", "matrix"] {
        best = best.min(printed.number(&format!("{variant} 400x142 on 10 ="), "")?);
    }
    Ok(best)
}

const WIDTH: usize = 20;
const HEIGHT: usize = 20;
const FEATURES: usize = 142;
const ON: usize = 10;
const PATTERNS: usize = 300;
const STEPS: u32 = 4_000;
const SIGMA: f32 = 3.0;
const ALPHA: f32 = 0.5;

/// CPU seconds of a training and the quantization error after it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trained {
    /// CPU seconds of all steps.
    pub seconds: f64,
    /// Mean distance of a stimulus to its best matching unit.
    pub error: f64,
}

/// The three maps on the same stimuli.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Race {
    /// Ours.
    pub binary: Trained,
    /// A plain dense loop.
    pub plain: Trained,
    /// MiniSom; `None` where it is not installed.
    pub minisom: Option<Trained>,
}

/// Trains all three.
///
/// # Errors
/// When MiniSom is there but says nothing that can be read.
pub fn race() -> Result<Race, Failure> {
    let stimuli = stimuli();
    Ok(Race {
        binary: binary(&stimuli),
        plain: plain(&stimuli),
        minisom: minisom(&stimuli)?,
    })
}

type Stimulus = [usize; ON];

/// Patterns that overlap: ten prototypes of twenty features, of which each stimulus has half.
fn stimuli() -> Vec<Stimulus> {
    let mut rng = Rng::new(3);
    let mut below = |bound: usize| rng.below(bound as u32) as usize;
    let groups: Vec<Vec<usize>> = (0..10)
        .map(|_| {
            let mut all: Vec<usize> = (0..FEATURES).collect();
            (0..20).map(|_| all.swap_remove(below(all.len()))).collect()
        })
        .collect();
    let stimulus = |_| {
        let mut group = groups[below(10)].clone();
        core::array::from_fn(|_| group.swap_remove(below(group.len())))
    };
    (0..PATTERNS).map(stimulus).collect()
}

fn schedules(t: u32) -> (f32, f32) {
    let gone = t as f32 / STEPS as f32;
    (ALPHA * (1.0 - gone), SIGMA - gone * (SIGMA - 1.0))
}

fn binary(stimuli: &[Stimulus]) -> Trained {
    let mut map = Box::new(BinarySom::<WIDTH, HEIGHT, FEATURES>::new());
    map.randomize(&mut Rng::new(1));
    let words = |stimulus: &Stimulus| {
        let mut words = [0_u32; FEATURES.div_ceil(32)];
        stimulus
            .iter()
            .for_each(|&j| words[j / 32] |= 1 << (j % 32));
        words
    };
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    let mut nearest = |map: &BinarySom<WIDTH, HEIGHT, FEATURES>, on: &[u32]| {
        let x = SparseStimulus {
            on,
            minus: &[],
            unknown: &[],
        };
        map.squared_distances(&x, &mut scratch, &mut distances);
        best_match(&distances)
    };
    let begin = cpu_seconds();
    for t in 0..STEPS {
        let on = words(&stimuli[t as usize % stimuli.len()]);
        let best = nearest(&map, &on);
        let (alpha, sigma) = schedules(t);
        let near = Neighbourhood::gaussian(sigma, 0.01).unwrap_or(Neighbourhood::winner_only());
        let x = SparseStimulus {
            on: &on,
            minus: &[],
            unknown: &[],
        };
        map.train(&x, best.node, alpha, &near, |_| true);
    }
    let seconds = cpu_seconds() - begin;
    let distances = stimuli
        .iter()
        .map(|stimulus| f64::from(nearest(&map, &words(stimulus)).squared_distance).sqrt());
    Trained {
        seconds,
        error: distances.sum::<f64>() / stimuli.len() as f64,
    }
}

/// What one writes first: every feature of every node, in the search and in the update.
fn plain(stimuli: &[Stimulus]) -> Trained {
    let mut rng = Rng::new(1);
    let mut map = vec![[0.0_f32; FEATURES]; WIDTH * HEIGHT];
    map.iter_mut()
        .flatten()
        .for_each(|weight| *weight = rng.unit());
    let dense = |stimulus: &Stimulus| {
        let mut x = [0.0_f32; FEATURES];
        stimulus.iter().for_each(|&j| x[j] = 1.0);
        x
    };
    let nearest = |map: &[[f32; FEATURES]], x: &[f32; FEATURES]| {
        let mut best = (0, f32::INFINITY);
        for (node, prototype) in map.iter().enumerate() {
            let mut distance = 0.0;
            for (a, b) in x.iter().zip(prototype) {
                distance += (a - b) * (a - b);
            }
            if distance < best.1 {
                best = (node, distance);
            }
        }
        best
    };
    let begin = cpu_seconds();
    for t in 0..STEPS {
        let x = dense(&stimuli[t as usize % stimuli.len()]);
        let (winner, _) = nearest(&map, &x);
        let (alpha, sigma) = schedules(t);
        let at = |node: usize| ((node % WIDTH) as f32, (node / WIDTH) as f32);
        let (column, row) = at(winner);
        for (node, prototype) in map.iter_mut().enumerate() {
            let (x_of, y_of) = at(node);
            let squared = (x_of - column).powi(2) + (y_of - row).powi(2);
            let step = alpha * (-squared / (2.0 * sigma * sigma)).exp();
            for (weight, x) in prototype.iter_mut().zip(&x) {
                *weight += step * (x - *weight);
            }
        }
    }
    let seconds = cpu_seconds() - begin;
    let distances = stimuli
        .iter()
        .map(|s| f64::from(nearest(&map, &dense(s)).1).sqrt());
    Trained {
        seconds,
        error: distances.sum::<f64>() / stimuli.len() as f64,
    }
}

fn minisom(stimuli: &[Stimulus]) -> Result<Option<Trained>, Failure> {
    let script = folder()?.join("../tests/fixtures/time_minisom.py");
    let python = Command::new("python3")
        .arg(script)
        .env("OMP_NUM_THREADS", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn();
    let Ok(mut python) = python else {
        return Ok(None);
    };
    let task = json!({
        "on": stimuli, "features": FEATURES, "width": WIDTH, "height": HEIGHT,
        "sigma": SIGMA, "alpha": ALPHA, "steps": STEPS,
    });
    if let Some(mut input) = python.stdin.take() {
        // A script that ended at its imports reads nothing; its exit code tells.
        let _ = input.write_all(task.to_string().as_bytes());
    }
    let output = python.wait_with_output()?;
    if !output.status.success() {
        return Ok(None);
    }
    let answer: Value = serde_json::from_slice(&output.stdout)?;
    let number = |name: &str| {
        answer[name]
            .as_f64()
            .ok_or("MiniSom's answer lacks a number")
    };
    Ok(Some(Trained {
        seconds: number("seconds")?,
        error: number("error")?,
    }))
}

/// Seconds that this thread has had a processor; where the system does not tell, the clock's.
fn cpu_seconds() -> f64 {
    let stat = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = stat.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(
        || {
            let start = std::time::UNIX_EPOCH.elapsed();
            start.map_or(0.0, |it| it.as_secs_f64())
        },
        |nanoseconds| nanoseconds / 1e9,
    )
}

#[cfg(test)]
mod tests {
    use super::{binary, plain, stimuli};

    #[test]
    fn the_sparse_map_represents_as_well_as_the_plain_loop() {
        let stimuli = stimuli();
        let (ours, plain) = (binary(&stimuli).error, plain(&stimuli).error);
        assert!(
            (ours - plain).abs() <= 0.02 * plain,
            "{ours} against {plain}"
        );
    }
}
