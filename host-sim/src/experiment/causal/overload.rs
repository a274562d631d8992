//! Fallback under overload: how often the detectors alarm on clean and on noisy events (book, 4.4).
//!
//! Clean events are new draws of the training distribution, jitter included; noisy events are such
//! draws, disturbed.
//! The Position and Movement layers form Level 1, which is overloaded when both are.

use cla_core::layer::{Level, answering_level};
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::network::{Causal, PerLayer, View};
use crate::experiment::record::floats;
use crate::world::launching::{Event, Noise};

/// New events of each sort that a network is tested on.
pub const TESTS: u32 = 400;

/// Shares of events, each in `[0, 1]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Events in which the distance detector of each layer alarms.
    pub distance: PerLayer<f64>,
    /// Events in which the table of transitions of each layer alarms.
    pub order: PerLayer<f64>,
    /// Events in which the book's minimum of each layer alarms.
    pub literal: PerLayer<f64>,
    /// Events in which a layer is overloaded by either of its two detectors.
    pub overloaded: PerLayer<f64>,
    /// Events in which any detector of any layer alarms, the book's minimum left out.
    pub any: f64,
    /// Events that the Top layer leaves to Level 1.
    pub fallback: f64,
}

/// What the Top layer's detectors measure of each event, for ROC curves.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Scores {
    /// The largest strain of the distance detector.
    #[serde(with = "floats")]
    pub distance: Vec<f64>,
    /// The largest squared distance of a best match, as it is.
    #[serde(with = "floats")]
    pub raw_distance: Vec<f64>,
    /// The largest strain of the book's minimum.
    #[serde(with = "floats")]
    pub literal: Vec<f64>,
}

/// One sort of event and how the detectors took it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reaction {
    /// Shares of events.
    pub rates: Rates,
    /// Scores of events.
    pub scores: Scores,
    /// Mean activation of each layer a step, over that in clean Direct events.
    #[serde(with = "floats")]
    pub activation: PerLayer<f64>,
}

/// Everything that section 4.4 asks of one network.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Overload {
    /// Clean events, drawn with the training shares.
    pub clean: Reaction,
    /// The book's Noisy event: a disturbed Direct event.
    pub noisy: Reaction,
    /// Each of [`Noise::ALL`] on events drawn with the training shares.
    pub kinds: [Reaction; 7],
    /// Each of [`Noise::ALL`] on each of [`Event::ALL`]: the share that any detector finds.
    pub found: [[f64; 4]; 7],
}

impl Overload {
    /// Tests a trained network; `rng` draws the events.
    #[must_use]
    pub fn of(causal: &mut Causal, rng: &mut Rng) -> Self {
        let direct = react(causal, rng, TESTS, None, |_| Event::Direct);
        let shares = causal.config().shares;
        let draw = |rng: &mut Rng| Event::draw(&shares, rng);
        let clean = react(causal, rng, TESTS, None, draw);
        let mut noisy = react(causal, rng, TESTS, Some(Noise::Noisy), |_| Event::Direct);
        for (share, base) in noisy.activation.iter_mut().zip(direct.activation) {
            *share /= base;
        }
        let kinds = Noise::ALL.map(|noise| react(causal, rng, TESTS, Some(noise), draw));
        let found = Noise::ALL.map(|noise| {
            Event::ALL.map(|event| {
                react(causal, rng, TESTS / 4, Some(noise), |_| event)
                    .rates
                    .any
            })
        });
        Self {
            clean,
            noisy,
            kinds,
            found,
        }
    }
}

fn react(
    causal: &mut Causal,
    rng: &mut Rng,
    events: u32,
    noise: Option<Noise>,
    draw: impl Fn(&mut Rng) -> Event,
) -> Reaction {
    let launching = causal.config().launching;
    let mut reaction = Reaction::default();
    let share = 1.0 / f64::from(events);
    for _ in 0..events {
        let clean = launching.frames(draw(rng));
        let disturbed = noise.map_or_else(|| clean.clone(), |noise| noise.disturb(&clean, rng));
        let view = causal.view(&launching.jittered(&disturbed, rng));
        reaction.rates.count(&view);
        reaction.scores.distance.push(f64::from(view.distance[2]));
        reaction.scores.raw_distance.push(f64::from(view.farthest));
        reaction.scores.literal.push(f64::from(view.total[2]));
        let totals = [
            view.position.total(),
            view.movement.total(),
            view.top.total(),
        ];
        for (mean, total) in reaction.activation.iter_mut().zip(totals) {
            *mean += share * f64::from(total) / f64::from(view.steps);
        }
    }
    reaction.rates.divide(f64::from(events));
    reaction
}

impl Rates {
    /// Counts one event.
    fn count(&mut self, view: &View) {
        let alarms = |strain: f32| strain > 1.0;
        let overloaded = [0, 1, 2].map(|l| alarms(view.distance[l]) || alarms(view.order[l]));
        let count = |rate: &mut f64, alarm: bool| *rate += f64::from(u8::from(alarm));
        for (layer, &overloaded) in overloaded.iter().enumerate() {
            count(&mut self.distance[layer], alarms(view.distance[layer]));
            count(&mut self.order[layer], alarms(view.order[layer]));
            count(&mut self.literal[layer], alarms(view.total[layer]));
            count(&mut self.overloaded[layer], overloaded);
        }
        count(&mut self.any, overloaded.contains(&true));
        let [position, movement, top] = overloaded;
        let answer = answering_level([position && movement, top]);
        count(&mut self.fallback, answer == Some(Level(1)));
    }

    /// Turns counts into shares of so many events.
    fn divide(&mut self, events: f64) {
        let layers = [
            &mut self.distance,
            &mut self.order,
            &mut self.literal,
            &mut self.overloaded,
        ];
        for rate in layers
            .into_iter()
            .flatten()
            .chain([&mut self.any, &mut self.fallback])
        {
            *rate /= events;
        }
    }
}
