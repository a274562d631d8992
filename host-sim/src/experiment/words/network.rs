//! The network that listens: a layer that reads a syllable and what it answered to those before.
//!
//! A syllable is one of twelve sensors; the layer's own activations of the step before are its context,
//! scaled so that the syllable weighs more.
//! Looking time stands for novelty: the squared distance of what is heard from the nearest prototype,
//! the mean of the syllables of a test item.

use cla_core::layer::{Input, Join, LayerConfig, Recurrent, Scaled, Stack, Structure};
use cla_core::num::{Rng, Schedule};
use serde::Serialize;

use super::stimuli::{Item, SYLLABLES};
use crate::failure::Failure;

/// Nodes of the layer.
const NODES: usize = 64;
/// A syllable, and whether it is the last one or the last but one, for who can tell.
const SENSORS: usize = SYLLABLES + 2;
/// What the context weighs, percent.
const CONTEXT: u32 = 50;

type Loop = Stack<Join<Input<SENSORS>, Scaled<Input<NODES>, CONTEXT>>, 8, 8, { SENSORS + NODES }>;

/// All parameters of the network.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ListenerConfig {
    /// σ_a of the layer.
    pub activation_width: f32,
    /// The learning rate, at the first and the last syllable, geometric.
    pub alpha: (f32, f32),
    /// The neighbourhood in nodes, at the first and the last syllable, geometric.
    pub neighbourhood: (f32, f32),
    /// Whether it hears that a syllable is the last one, or the last but one.
    pub compares: bool,
}

impl ListenerConfig {
    /// The set of all claims.
    pub const STANDARD: Self = Self {
        activation_width: 0.5,
        alpha: (0.5, 0.05),
        neighbourhood: (3.0, 0.5),
        compares: false,
    };
}

/// A network that listens.
#[derive(Clone)]
pub(super) struct Listener {
    net: Box<Recurrent<Loop, NODES, 1>>,
    compares: bool,
    /// The last syllable and the one before it.
    heard: [Option<usize>; 2],
    samples: u32,
}

impl Listener {
    /// A network that has heard nothing and will hear about so many syllables.
    pub(super) fn new(
        config: &ListenerConfig,
        syllables: usize,
        seed: u64,
    ) -> Result<Self, Failure> {
        let mut net = Box::new(Recurrent::<Loop, NODES, 1>::new());
        let schedule = |(from, to)| Schedule::geometric(from, to, syllables as u32);
        let layer = LayerConfig::try_new(
            config.activation_width,
            schedule(config.alpha)?,
            schedule(config.neighbourhood)?,
        )?;
        net.source.upper.start(&layer, &mut Rng::stream(seed, 0));
        Ok(Self {
            net,
            compares: config.compares,
            heard: [None; 2],
            samples: 0,
        })
    }

    fn sensors(&mut self, syllable: usize) -> [f32; SENSORS] {
        let mut sensors = [0.0; SENSORS];
        sensors[syllable] = 1.0;
        if self.compares {
            for (sensor, heard) in sensors[SYLLABLES..].iter_mut().zip(self.heard) {
                *sensor = f32::from(u8::from(heard == Some(syllable)));
            }
        }
        self.heard = [Some(syllable), self.heard[0]];
        sensors
    }

    /// Hears syllables and learns from them.
    pub(super) fn hear(&mut self, syllables: &[usize]) -> Result<(), Failure> {
        for &syllable in syllables {
            let sensors = self.sensors(syllable);
            self.net.learn(&sensors, self.samples)?;
            self.samples += 1;
        }
        Ok(())
    }

    /// Silence: what comes next has nothing before it.
    pub(super) fn pause(&mut self) {
        self.net.forget_context();
        self.heard = [None; 2];
    }

    /// How novel a test item is to it, after silence and without learning.
    pub(super) fn novelty(&self, item: &Item) -> Result<f64, Failure> {
        let mut it = self.clone();
        it.pause();
        let mut sum = 0.0;
        for &syllable in item {
            let sensors = it.sensors(syllable);
            it.net.activate(&sensors)?;
            sum += f64::from(it.net.source.upper.novelty());
        }
        Ok(sum / item.len() as f64)
    }
}
