//! The measures of sections 4.3.2–4.3.6: what the layers tell apart, and when they settle.
//!
//! A [`Causality`] holds what a network does over the four clean events; everything the book reads
//! off its composites is a method of it.
//! Overload is measured in [`overload`](super::overload).

use cla_core::layer::ActivationComposite;
use serde::{Deserialize, Serialize};

use super::network::{Causal, PerLayer, View};
use crate::world::launching::Event;

/// A node is special to an event when its isolate is above this.
pub const SPECIAL: f32 = 0.5;

/// A layer separates when events that differ in its own component are this many times as far
/// apart as events that differ in the other one.
pub const SEPARATION_MARGIN: f64 = 2.0;

/// A layer has settled when its composite stays within this share of its final total.
const SETTLED: f32 = 1.0 / 3.0;

/// Checkpoints of the stage measure, evenly over training.
const CHECKPOINTS: u32 = 65;

/// What a network does over the four events, without jitter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Causality {
    /// The views of [`Event::ALL`].
    pub views: [View; 4],
}

/// Differences of two events at the Top layer, Σ |a − b| (book, 4.3.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differences {
    /// Direct – Delay+Gap: the causal pair of Leslie (1984).
    pub direct_delaygap: f64,
    /// Direct – Gap: the causal pair of Cohen and Amsel (1998).
    pub direct_gap: f64,
    /// Direct – Delay: the label of Fig 4.7.
    pub direct_delay: f64,
    /// Delay – Gap: no causal difference.
    pub delay_gap: f64,
}

impl Causality {
    /// Shows the four events to a network.
    #[must_use]
    pub fn of(causal: &mut Causal) -> Self {
        let launching = causal.config().launching;
        Self {
            views: Event::ALL.map(|event| causal.view(&launching.frames(event))),
        }
    }

    /// How many times as far apart events with and without gap are in the Position layer as events
    /// with and without delay.
    #[must_use]
    pub fn position_separation(&self) -> f64 {
        let d = |a: Event, b: Event| self.view(a).position.difference(&self.view(b).position);
        across_gap(d) / across_delay(d)
    }

    /// The reverse in the Movement layer: delay over gap.
    #[must_use]
    pub fn movement_separation(&self) -> f64 {
        let d = |a: Event, b: Event| self.view(a).movement.difference(&self.view(b).movement);
        across_delay(d) / across_gap(d)
    }

    /// The Top layer's isolate of an event: less the composites of the other three (book, 4.3.3).
    #[must_use]
    pub fn isolate(&self, event: Event) -> ActivationComposite<8, 8> {
        let others: Vec<_> = Event::ALL
            .into_iter()
            .filter(|&other| other != event)
            .map(|other| &self.view(other).top)
            .collect();
        self.view(event).top.isolate(&others)
    }

    /// Nodes of the Top layer that are special to each of [`Event::ALL`].
    #[must_use]
    pub fn special_nodes(&self) -> [u16; 4] {
        Event::ALL.map(|event| self.isolate(event).nodes_above(SPECIAL))
    }

    /// Whether Direct and Delay+Gap have special nodes and Delay and Gap have none (4.3.3, 4.3.5).
    #[must_use]
    pub fn has_full_pattern(&self) -> bool {
        let [direct, delay, gap, delay_gap] = self.special_nodes();
        direct > 0 && delay_gap > 0 && delay == 0 && gap == 0
    }

    /// The differences of Fig 4.7.
    #[must_use]
    pub fn differences(&self) -> Differences {
        let d = |a, b| f64::from(self.view(a).top.difference(&self.view(b).top));
        Differences {
            direct_delaygap: d(Event::Direct, Event::DelayGap),
            direct_gap: d(Event::Direct, Event::Gap),
            direct_delay: d(Event::Direct, Event::Delay),
            delay_gap: d(Event::Delay, Event::Gap),
        }
    }

    /// The view of one event.
    #[must_use]
    pub const fn view(&self, event: Event) -> &View {
        &self.views[event as usize]
    }
}

fn across_gap(difference: impl Fn(Event, Event) -> f32) -> f64 {
    let same_delay = difference(Event::Direct, Event::Gap);
    f64::from(same_delay) + f64::from(difference(Event::Delay, Event::DelayGap))
}

fn across_delay(difference: impl Fn(Event, Event) -> f32) -> f64 {
    let same_gap = difference(Event::Direct, Event::Delay);
    f64::from(same_gap) + f64::from(difference(Event::Gap, Event::DelayGap))
}

/// The composites of the Direct event at one moment of training.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stage {
    /// Training events before it.
    pub event: u32,
    /// The composites, node by node.
    pub composites: PerLayer<Vec<f32>>,
}

/// Trains a network and looks at the Direct event on the way (book, 4.3.6).
#[must_use]
pub fn train_with_stages(causal: &mut Causal) -> Vec<Stage> {
    let direct = causal.config().launching.frames(Event::Direct);
    let total = causal.config().events;
    let every = (total / CHECKPOINTS).max(1);
    let mut stages = Vec::new();
    let mut look = |event: u32, causal: &mut Causal| {
        let view = causal.view(&direct);
        let composites = [
            view.position.nodes().as_slice().to_vec(),
            view.movement.nodes().as_slice().to_vec(),
            view.top.nodes().as_slice().to_vec(),
        ];
        stages.push(Stage { event, composites });
    };
    causal.train(|event, causal| {
        if event % every == 0 {
            look(event, causal);
        }
    });
    look(total, causal);
    stages
}

/// From which share of training on each layer has settled.
#[must_use]
pub fn settled(stages: &[Stage]) -> PerLayer<f64> {
    [0, 1, 2].map(|layer| {
        let Some((last, before)) = stages.split_last() else {
            return 1.0;
        };
        let end = &last.composites[layer];
        let near = |stage: &&Stage| {
            let moved: f32 = stage.composites[layer]
                .iter()
                .zip(end)
                .map(|(a, b)| (a - b).abs())
                .sum();
            moved <= SETTLED * end.iter().sum::<f32>()
        };
        let first = before.iter().rev().take_while(near).last().unwrap_or(last);
        f64::from(first.event) / f64::from(last.event)
    })
}

#[cfg(test)]
mod tests {
    use super::{Stage, settled};

    #[test]
    fn a_layer_has_settled_where_it_comes_near_its_end_for_good() {
        let stage = |event, value: f32| Stage {
            event,
            composites: [
                vec![value],
                vec![1.0],
                vec![if event < 40 { 0.0 } else { 1.0 }],
            ],
        };
        let stages = [
            stage(0, 1.0),
            stage(10, 0.2),
            stage(20, 0.7),
            stage(30, 1.2),
            stage(40, 1.0),
        ];
        assert_eq!(settled(&stages), [0.5, 0.0, 1.0]);
    }
}
