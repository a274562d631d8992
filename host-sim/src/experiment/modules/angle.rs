//! The angle study with each kind of module (book, 2.1.2): young networks look at lines, old ones at angles.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::hierarchy::Hierarchy;
use super::make::made;
use super::module::{Kind, Plan};
use crate::experiment::angle::{
    AngleConfig, AngleStimulus, Looking, MIDPOINT_CHANNELS, ORIENTATION_CHANNELS,
};
use crate::failure::Failure;

/// Novelty at the Top, of a network that met the habituation stimulus alone and of one that has seen angles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Angles {
    /// Habituated only.
    pub young: Looking,
    /// Trained on angles of 45° in all directions, then habituated.
    pub old: Looking,
}

fn read(stimulus: AngleStimulus) -> Vec<f32> {
    let mut all = stimulus.first().to_vec();
    all.extend(stimulus.second());
    all.extend(stimulus.midpoints());
    all
}

fn jittered(config: &AngleConfig, it: AngleStimulus, rng: &mut Rng) -> Vec<f32> {
    let mut off = || config.jitter * (2.0 * rng.unit() - 1.0);
    read(AngleStimulus {
        direction: it.direction + off(),
        angle: it.angle + off(),
    })
}

fn hierarchy(
    kind: Kind,
    trial: usize,
    config: &AngleConfig,
    seed: u64,
) -> Result<Hierarchy, Failure> {
    let mut rng = Rng::stream(seed, 0);
    let plan = |level: usize, side: usize, features: usize| Plan {
        side,
        features,
        width: config.activation_width[level],
        samples: config.trials,
        alpha: config.alpha,
        neighbourhood: config.final_neighbourhood,
    };
    let mut lower = Vec::new();
    for features in [
        ORIENTATION_CHANNELS,
        ORIENTATION_CHANNELS,
        MIDPOINT_CHANNELS,
    ] {
        let module = made(kind, &plan(0, 6, features), trial, &mut rng)?;
        lower.push((features, module));
    }
    let top = made(kind, &plan(1, 8, 3 * 36), trial, &mut rng)?;
    Ok(Hierarchy::new(lower, top))
}

/// Both networks of a kind, the old one after so many trials.
pub(super) fn run(kind: Kind, trial: usize, trials: u32, seed: u64) -> Result<Angles, Failure> {
    let config = AngleConfig {
        trials,
        ..AngleConfig::STANDARD
    };
    let step = 360.0 / f32::from(config.directions);
    let direction = |rng: &mut Rng| step * rng.below(u32::from(config.directions)) as f32;
    let of = |direction| AngleStimulus {
        direction,
        angle: 45.0,
    };
    let habituation = of(direction(&mut Rng::stream(seed, 1)));
    let turn = step * (config.turn / step).round();
    let rotated = of(habituation.direction + turn);
    let tests = [habituation, rotated, habituation.opened()].map(read);

    let mut rng = Rng::stream(seed, 3);
    let familiar: Vec<_> = (0..config.habituation)
        .map(|_| jittered(&config, habituation, &mut rng))
        .collect();
    let mut rng = Rng::stream(seed, 2);
    let before: Vec<_> = (0..config.trials)
        .map(|_| {
            let stimulus = of(direction(&mut rng));
            jittered(&config, stimulus, &mut rng)
        })
        .collect();
    let looking = |stimuli: &[Vec<f32>]| -> Result<Looking, Failure> {
        let mut network = hierarchy(kind, trial, &config, seed)?;
        network.learn(stimuli);
        let [habituated, rotated, opened] =
            [0, 1, 2].map(|it: usize| f64::from(network.answer(&tests[it]).novelty));
        Ok(Looking {
            habituated,
            rotated,
            opened,
        })
    };
    Ok(Angles {
        young: looking(&familiar)?,
        old: looking(&[before, familiar.clone()].concat())?,
    })
}
