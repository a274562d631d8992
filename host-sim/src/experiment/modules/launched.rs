//! Launching events as the hierarchies of the causal study and of invariance see them.

use cla_core::num::Rng;

use super::hierarchy::{Answer, Hierarchy};
use super::make::made;
use super::module::{Kind, Module, Plan};
use super::pooled::Pooled;
use crate::experiment::causal::network::CausalConfig;
use crate::failure::Failure;
use crate::world::launching::{CELLS, Event, Frame, MOVEMENT, stimuli};

/// Cells of a window: no event of half the size is longer.
pub(super) const WINDOW: usize = 12;
/// Windows that hold both balls, in the middle of events; a map's schedules run by them.
const WINDOWS: u32 = 4;

/// The stimuli of an event, Position and Movement together.
pub(super) fn read(frames: &[Frame]) -> Vec<Vec<f32>> {
    let joined = |(position, movement): &([f32; CELLS], [f32; MOVEMENT])| {
        position.iter().chain(movement).copied().collect()
    };
    stimuli(frames).iter().map(joined).collect()
}

/// What was seen of one event.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Seen {
    /// The sum of level 1's activations, first the Position module's.
    pub(super) lower: Vec<f32>,
    /// The Top's.
    pub(super) top: Vec<f32>,
    /// The largest activation of each of the Top's units.
    pub(super) most: Vec<f32>,
    /// How many of the Top's units share the work of a step, the mean of the steps: (Σa)² / Σa².
    pub(super) sharing: f64,
    /// The largest novelty at the Top.
    pub(super) novelty: f64,
}

/// Shows an event.
pub(super) fn view(hierarchy: &Hierarchy, frames: &[Frame]) -> Seen {
    let stimuli = read(frames);
    let mut seen = Seen {
        lower: Vec::new(),
        top: Vec::new(),
        most: Vec::new(),
        sharing: 0.0,
        novelty: 0.0,
    };
    for stimulus in &stimuli {
        let answer = hierarchy.answer(stimulus);
        seen.add(&answer, stimuli.len() as f64);
    }
    seen
}

impl Seen {
    fn add(&mut self, answer: &Answer, steps: f64) {
        self.lower.resize(answer.lower.len(), 0.0);
        self.top.resize(answer.top.len(), 0.0);
        self.most.resize(answer.top.len(), 0.0);
        for (sum, it) in self.lower.iter_mut().zip(&answer.lower) {
            *sum += it;
        }
        for ((sum, most), &it) in self.top.iter_mut().zip(&mut self.most).zip(&answer.top) {
            *sum += it;
            *most = most.max(it);
        }
        let sum: f32 = answer.top.iter().sum();
        let squares: f32 = answer.top.iter().map(|it| it * it).sum();
        if squares > 0.0 {
            self.sharing += f64::from(sum * sum / squares) / steps;
        }
        self.novelty = self.novelty.max(f64::from(answer.novelty));
    }
}

/// Σ |a − b| of composites (book, 4.3.4).
pub(super) fn difference(a: &[f32], b: &[f32]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from((a - b).abs())).sum()
}

/// The place of the composite among `known` that is nearest to `seen`.
pub(super) fn nearest(known: &[Vec<f32>], seen: &[f32]) -> usize {
    let differences: Vec<f32> = known.iter().map(|it| difference(it, seen) as f32).collect();
    super::module::least(&differences)
}

/// Position and Movement, and a Top on both, with as many units each as in the causal study; `pooled`
/// lets the Position module pool over shifts.
pub(super) fn hierarchy(
    kind: Kind,
    trial: usize,
    config: &CausalConfig,
    samples: usize,
    pooled: bool,
    rng: &mut Rng,
) -> Result<Hierarchy, Failure> {
    let samples = samples as u32;
    let plan = |layer: usize, side: usize, features: usize| Plan {
        side,
        features,
        width: config.activation_width[layer],
        samples,
        alpha: config.alpha,
        neighbourhood: config.final_neighbourhood[layer],
    };
    let position: Box<dyn Module> = if pooled {
        let plan = Plan {
            samples: WINDOWS * samples,
            ..plan(0, 12, WINDOW)
        };
        Box::new(Pooled::new(made(kind, &plan, trial, rng)?, WINDOW))
    } else {
        made(kind, &plan(0, 12, CELLS), trial, rng)?
    };
    let movement = made(kind, &plan(1, 6, MOVEMENT), trial, rng)?;
    let top = made(kind, &plan(2, 8, 180), trial, rng)?;
    Ok(Hierarchy::new(
        vec![(CELLS, position), (MOVEMENT, movement)],
        top,
    ))
}

/// Events with these shares as they are met in training, one after the other.
pub(super) fn training(
    config: &CausalConfig,
    shares: &[f32; 4],
    events: u32,
    rng: &mut Rng,
    mut frames: impl FnMut(Event, &mut Rng) -> Vec<Frame>,
) -> Vec<Vec<f32>> {
    let mut all = Vec::new();
    for _ in 0..events {
        let event = Event::draw(shares, rng);
        let clean = frames(event, rng);
        all.extend(read(&config.launching.jittered(&clean, rng)));
    }
    all
}
