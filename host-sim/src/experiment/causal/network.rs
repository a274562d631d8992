//! The hierarchy of the causal experiment and its training (book, 4.2, 4.3.1, Fig 4.4).
//!
//! Position and Movement layers are joined by a Top layer; every step of every event trains all of
//! them, and late in training the overload detectors take note.
//! All numbers that the book leaves open are in [`CausalConfig`].

use cla_core::layer::overload::{
    MatchDistance, MatchDistanceConfig, OverloadDetector, TotalActivation, Transitions,
};
use cla_core::layer::{ActivationComposite, Join, Layer, LayerConfig, Stack, Structure};
use cla_core::num::{Rng, Schedule};
use serde::{Deserialize, Serialize};

use crate::experiment::record::{floats, in_words};
use crate::world::launching::{CELLS, Event, Frame, LaunchingConfig, MOVEMENT, Stimulus, stimuli};

/// 12 × 12 nodes on 20 features.
pub type PositionLayer = Layer<12, 12, CELLS>;
/// 6 × 6 nodes on 60 features.
pub type MovementLayer = Layer<6, 6, MOVEMENT>;
/// 8 × 8 nodes on 144 + 36 activations.
pub type Perception = Stack<Join<PositionLayer, MovementLayer>, 8, 8, 180>;

/// One value for each layer: Position, Movement, Top.
pub type PerLayer<T> = [T; 3];

/// Names of the layers, in the order of [`PerLayer`].
pub const LAYERS: PerLayer<&str> = ["Position", "Movement", "Top"];

/// All parameters of the causal experiment.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CausalConfig {
    /// The events.
    pub launching: LaunchingConfig,
    /// The share of each event in training, in the order of [`Event::ALL`].
    pub shares: [f32; 4],
    /// Training events; one is an epoch of the book's Fig 4.9.
    pub events: u32,
    /// The learning rate, from the first to the last event, geometric.
    pub alpha: (f32, f32),
    /// The neighbourhood's width at the end of training, in nodes; half the side at the start.
    pub final_neighbourhood: PerLayer<f32>,
    /// σ_a of each layer (book, 3.1).
    pub activation_width: PerLayer<f32>,
    /// Whether the layers train together or one level after the other.
    pub training: Training,
    /// From which share of training on the detectors take note.
    pub record_from: f32,
    /// The distance detector of each layer.
    #[serde(serialize_with = "in_words")]
    pub detectors: PerLayer<MatchDistanceConfig>,
    /// The slack of each layer's table of transitions, in nodes; the Position layer has no table.
    pub order_slack: PerLayer<u8>,
}

/// When the levels train.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Training {
    /// All layers at every step (book, 3.2).
    Joint,
    /// Level 1 alone for all events, then the Top layer alone for as many.
    Staged,
}

/// A network, its detectors and what it needs to be trained.
#[derive(Clone, Debug)]
pub struct Causal {
    /// The three layers.
    pub perception: Box<Perception>,
    /// What each layer's detectors know.
    pub watch: Watch,
    config: CausalConfig,
    world: Rng,
}

/// The detectors of the three layers.
#[derive(Clone, Debug)]
pub struct Watch {
    /// Distances of the Position layer.
    pub position: MatchDistance<12, 12>,
    /// Distances of the Movement layer.
    pub movement: MatchDistance<6, 6>,
    /// Distances of the Top layer.
    pub top: MatchDistance<8, 8>,
    /// Successive winners of the Movement layer.
    pub movement_order: Transitions<6, 6, 2>,
    /// Successive winners of the Top layer.
    pub top_order: Transitions<8, 8, 2>,
    /// The book's minimum of each layer.
    pub totals: PerLayer<TotalActivation>,
}

impl CausalConfig {
    /// The one set of all causal claims.
    #[must_use]
    pub fn standard() -> Self {
        let detector = |limit| {
            MatchDistanceConfig::try_new(0.998, 0.25, limit).expect("the constants are in range")
        };
        Self {
            launching: LaunchingConfig::STANDARD,
            shares: [0.85, 0.05, 0.05, 0.05],
            events: 6500,
            alpha: (0.5, 0.04),
            final_neighbourhood: [0.9, 0.72, 0.71],
            activation_width: [0.22, 0.65, 0.43],
            training: Training::Joint,
            record_from: 0.7,
            detectors: [detector(3.0), detector(3.0), detector(1.5)],
            order_slack: [0, 0, 1],
        }
    }

    fn layer(&self, layer: usize, side: f32) -> LayerConfig {
        let schedule = |from, to| {
            Schedule::geometric(from, to, self.events).expect("schedules of a valid configuration")
        };
        LayerConfig::try_new(
            self.activation_width[layer],
            schedule(self.alpha.0, self.alpha.1),
            schedule(side / 2.0, self.final_neighbourhood[layer]),
        )
        .expect("widths of a valid configuration")
    }
}

impl Causal {
    /// An untrained network; `seed` decides its weights and the events it will see.
    #[must_use]
    pub fn new(config: &CausalConfig, seed: u64) -> Self {
        let mut perception = Box::new(Perception::new());
        let mut weights = Rng::stream(seed, 0);
        perception
            .lower
            .first
            .start(&config.layer(0, 12.0), &mut weights);
        perception
            .lower
            .second
            .start(&config.layer(1, 6.0), &mut weights);
        perception.upper.start(&config.layer(2, 8.0), &mut weights);
        let mut watch = Watch {
            position: MatchDistance::new(),
            movement: MatchDistance::new(),
            top: MatchDistance::new(),
            movement_order: Transitions::new(),
            top_order: Transitions::new(),
            totals: [const { TotalActivation::new() }; 3],
        };
        watch.position.configure(&config.detectors[0]);
        watch.movement.configure(&config.detectors[1]);
        watch.top.configure(&config.detectors[2]);
        watch.movement_order.set_slack(config.order_slack[1]);
        watch.top_order.set_slack(config.order_slack[2]);
        Self {
            perception,
            watch,
            config: *config,
            world: Rng::stream(seed, 1),
        }
    }

    /// Trains on all events; `look` is called before each, with its number.
    pub fn train(&mut self, mut look: impl FnMut(u32, &mut Self)) {
        let rounds: &[_] = match self.config.training {
            Training::Joint => &[(true, true)],
            Training::Staged => &[(true, false), (false, true)],
        };
        for (round, &(lower, upper)) in rounds.iter().enumerate() {
            for t in 0..self.config.events {
                look(round as u32 * self.config.events + t, self);
                let event = Event::draw(&self.config.shares, &mut self.world);
                let clean = self.config.launching.frames(event);
                let frames = self.config.launching.jittered(&clean, &mut self.world);
                let late = upper && t as f32 >= self.config.record_from * self.config.events as f32;
                self.watch.forget_context();
                for stimulus in stimuli(&frames) {
                    self.perception
                        .activate(&stimulus)
                        .expect("stimuli are finite");
                    if late {
                        self.watch.record(&self.perception);
                    }
                    if lower {
                        self.perception.lower.train(t);
                    }
                    if upper {
                        self.perception.upper.train(t);
                    }
                }
            }
        }
    }

    /// What the network does over an event.
    pub fn view(&mut self, frames: &[Frame]) -> View {
        let mut view = View::default();
        self.watch.forget_context();
        for stimulus in stimuli(frames) {
            view.add(self, &stimulus);
        }
        view
    }

    /// The parameters the network was made with.
    #[must_use]
    pub const fn config(&self) -> &CausalConfig {
        &self.config
    }
}

impl Watch {
    fn forget_context(&mut self) {
        self.movement_order.forget_context();
        self.top_order.forget_context();
    }

    fn record(&mut self, perception: &Perception) {
        let (position, movement, top) = (
            perception.lower.first.response(),
            perception.lower.second.response(),
            perception.upper.response(),
        );
        self.position.record(&position);
        self.movement.record(&movement);
        self.top.record(&top);
        self.movement_order.record(&movement);
        self.top_order.record(&top);
        for (total, response) in self.totals.iter_mut().zip([position, movement, top]) {
            total.record(&response);
        }
    }
}

/// What the layers and their detectors did over one event.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// The Position layer's activation composite.
    #[serde(with = "nodes")]
    pub position: ActivationComposite<12, 12>,
    /// The Movement layer's.
    #[serde(with = "nodes")]
    pub movement: ActivationComposite<6, 6>,
    /// The Top layer's.
    #[serde(with = "nodes")]
    pub top: ActivationComposite<8, 8>,
    /// The largest strain of the distance detector of each layer; above 1 is overload.
    #[serde(with = "floats")]
    pub distance: PerLayer<f32>,
    /// The largest strain of the book's minimum of each layer.
    #[serde(with = "floats")]
    pub total: PerLayer<f32>,
    /// The largest strain of the tables of transitions; the Position layer has none.
    #[serde(with = "floats")]
    pub order: PerLayer<f32>,
    /// The largest squared distance of the Top layer's best match.
    #[serde(with = "floats")]
    pub farthest: f32,
    /// Steps of the event.
    pub steps: u32,
}

impl View {
    fn add(&mut self, causal: &mut Causal, stimulus: &Stimulus) {
        let Causal {
            perception, watch, ..
        } = causal;
        perception.activate(stimulus).expect("stimuli are finite");
        self.position.add(perception.lower.first.activation());
        self.movement.add(perception.lower.second.activation());
        self.top.add(perception.upper.activation());
        let responses = [
            perception.lower.first.response(),
            perception.lower.second.response(),
            perception.upper.response(),
        ];
        let distances = [
            watch.position.strain(&responses[0]),
            watch.movement.strain(&responses[1]),
            watch.top.strain(&responses[2]),
        ];
        for (layer, response) in responses.iter().enumerate() {
            let total = watch.totals[layer].strain(response);
            self.distance[layer] = self.distance[layer].max(distances[layer]);
            self.total[layer] = self.total[layer].max(total);
        }
        let movement = watch.movement_order.strain(&responses[1]);
        let top = watch.top_order.strain(&responses[2]);
        self.order[1] = self.order[1].max(movement);
        self.order[2] = self.order[2].max(top);
        self.farthest = self.farthest.max(responses[2].best_match.squared_distance);
        self.steps += 1;
    }
}

/// Composites written down as the sums of their nodes.
mod nodes {
    use cla_core::layer::ActivationComposite;
    use cla_core::som::Grid;
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer, const W: usize, const H: usize>(
        it: &ActivationComposite<W, H>,
        to: S,
    ) -> Result<S::Ok, S::Error> {
        it.nodes().as_slice().serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>, const W: usize, const H: usize>(
        from: D,
    ) -> Result<ActivationComposite<W, H>, D::Error> {
        let sums = Vec::<f32>::deserialize(from)?;
        let mut grid = Grid::<f32, W, H>::filled(0.0);
        if sums.len() != grid.as_slice().len() {
            return Err(D::Error::invalid_length(sums.len(), &"a sum for each node"));
        }
        grid.as_mut_slice().copy_from_slice(&sums);
        let mut composite = ActivationComposite::new();
        composite.add(&grid);
        Ok(composite)
    }
}
