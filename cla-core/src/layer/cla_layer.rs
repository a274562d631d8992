//! The CLA layer: prototypes with their activation vector (book, 3.2).
//!
//! Activating a layer computes every distance once; training uses the winner that was found then
//! and the stimulus that was read then, as the book asks.
//! What the layers above and the overload detectors need to know is here; how layers are joined is
//! in [`structure`](super::Structure).

use core::slice::IterMut;

use super::overload::Response;
use super::signal::{Signal, write_slice};
use crate::check::{ConfigError, Range};
use crate::num::{Neighbourhood, Rng, Schedule, exp};
use crate::som::{BestMatch, DenseSom, Grid, NodeId, StimulusError, best_match};

/// An activation below this is 0, as a weight of the layer above would be.
const SILENCE: f32 = 1e-18;

/// How a [`Layer`] answers and learns.
///
/// ```
/// use cla_core::layer::LayerConfig;
/// use cla_core::num::Schedule;
///
/// let alpha = Schedule::geometric(0.5, 0.04, 6500)?;
/// let width = Schedule::geometric(4.0, 0.7, 6500)?;
/// assert!(LayerConfig::try_new(0.47, alpha, width).is_ok());
/// let flat = LayerConfig::try_new(0.0, alpha, width);
/// assert_eq!(flat.unwrap_err().field, "LayerConfig::activation_width");
/// # Ok::<(), cla_core::num::ScheduleError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerConfig {
    activation_width: f32,
    alpha: Schedule,
    neighbourhood: Schedule,
}

impl LayerConfig {
    /// The share of the neighbourhood's peak below which a node is not trained: 1 %.
    pub const CUT: f32 = 0.01;

    /// A layer whose activations fall with the width `activation_width`, in units of distance.
    ///
    /// `activation_width` is σ_a of equation 3.1: a stimulus at that distance activates a node to
    /// .61, one at twice that distance to .14.
    /// `alpha` is the learning rate, in `[0, 1]`, and `neighbourhood` the width of the
    /// neighbourhood in nodes, both by the number of samples that [`Layer::train`] is given.
    ///
    /// # Errors
    /// [`ConfigError`] when `activation_width` is not above 10⁻⁶ or not finite, or `alpha` is above 1 at
    /// one of its ends: a schedule is never below 0, and no map moves by such a rate.
    pub const fn try_new(
        activation_width: f32,
        alpha: Schedule,
        neighbourhood: Schedule,
    ) -> Result<Self, ConfigError> {
        // Below, its square has no inverse.
        let width = Range::above(1e-6).check("LayerConfig::activation_width", activation_width);
        if let Err(error) = width {
            return Err(error);
        }
        if let Err(error) = Range::SHARE.check("LayerConfig::alpha", alpha.most()) {
            return Err(error);
        }
        Ok(Self {
            activation_width,
            alpha,
            neighbourhood,
        })
    }
}

/// A map of `WIDTH` × `HEIGHT` nodes that read `FEATURES` values, with the activation of each node.
///
/// `new` gives zeros (a static layer costs RAM, no flash); [`start`](Self::start) readies it.
/// RAM: (`FEATURES` + 1)·(nodes + 1) values of 4 bytes, and about 60 bytes.
///
/// ```
/// use cla_core::layer::{Layer, LayerConfig};
/// use cla_core::num::{Rng, Schedule};
///
/// let config = LayerConfig::try_new(
///     0.5,
///     Schedule::linear(0.5, 0.02, 500)?,
///     Schedule::linear(1.5, 0.3, 500)?,
/// )?;
/// let mut layer = Layer::<3, 3, 2>::new();
/// let mut rng = Rng::new(5);
/// layer.start(&config, &mut rng);
/// for t in 0..500 {
///     layer.activate(&[rng.unit(), rng.unit()])?;
///     layer.train(t);
/// }
/// layer.activate(&[0.5, 0.5])?;
/// assert!(layer.activation().as_slice().iter().all(|&a| (0.0..=1.0).contains(&a)));
/// assert!(layer.novelty() < 0.1);
/// layer.activate(&[9.0, 9.0])?; // nothing like it was ever seen
/// assert!(layer.novelty() > 100.0 && layer.total_activation() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Layer<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> {
    som: DenseSom<WIDTH, HEIGHT, FEATURES>,
    stimulus: [f32; FEATURES],
    activation: Grid<f32, WIDTH, HEIGHT>,
    best_match: BestMatch,
    /// 1 / 2σ_a²; 0 in a layer that was not started.
    sharpness: f32,
    alpha: Schedule,
    neighbourhood: Schedule,
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>
    Layer<WIDTH, HEIGHT, FEATURES>
{
    /// A layer of zeros: it reads stimuli, activates every node to 1 and learns nothing until it is
    /// [started](Self::start).
    #[must_use]
    pub const fn new() -> Self {
        Self {
            som: DenseSom::new(),
            stimulus: [0.0; FEATURES],
            activation: Grid::filled(0.0),
            best_match: BestMatch {
                node: NodeId(0),
                squared_distance: 0.0,
            },
            sharpness: 0.0,
            alpha: Schedule::ZERO,
            neighbourhood: Schedule::ZERO,
        }
    }

    /// Draws every weight from `[0, 1)` and takes over `config`; activations become 0.
    pub fn start(&mut self, config: &LayerConfig, rng: &mut Rng) {
        self.som.randomize(rng);
        self.configure(config);
        self.activation.as_mut_slice().fill(0.0);
    }

    /// Takes over `config` and keeps the weights: for weights that were restored, not drawn.
    pub fn configure(&mut self, config: &LayerConfig) {
        self.sharpness = 1.0 / (2.0 * config.activation_width * config.activation_width);
        self.alpha = config.alpha;
        self.neighbourhood = config.neighbourhood;
    }

    /// Reads `stimulus` and activates every node: a = exp(−‖x − m‖² / 2σ_a²) (book, 3.1); an
    /// activation below 10⁻¹⁸ is 0.
    ///
    /// A `stimulus` with another number of values than `FEATURES` does not compile (`cargo build`
    /// tells, `cargo check` does not).
    ///
    /// # Errors
    /// [`StimulusError`] when a value is not finite; the activations are then those of before, and
    /// the layer must be activated again before it is trained.
    pub fn activate<S: Signal>(&mut self, stimulus: &S) -> Result<(), StimulusError> {
        const {
            assert!(
                S::LEN == FEATURES,
                "a layer's FEATURES must be the number of values it reads"
            )
        }
        stimulus.write(&mut self.stimulus.iter_mut());
        self.som
            .squared_distances(&self.stimulus, &mut self.activation)?;
        self.best_match = best_match(&self.activation);
        for value in self.activation.as_mut_slice() {
            let activation = exp(-(*value * self.sharpness));
            *value = if activation < SILENCE {
                0.0
            } else {
                activation
            };
        }
        Ok(())
    }

    /// Trains the map on the stimulus that it was last activated by, as sample number `samples`.
    ///
    /// No distance is computed again.
    /// `samples` sets the learning rate and the neighbourhood's width; a robot that counts events
    /// instead passes the number of events.
    pub fn train(&mut self, samples: u32) {
        // A schedule is never negative or NaN, so the Gaussian always exists.
        if let Ok(near) = Neighbourhood::gaussian(self.neighbourhood.at(samples), LayerConfig::CUT)
        {
            let alpha = self.alpha.at(samples);
            self.som
                .train(&self.stimulus, self.best_match.node, alpha, &near);
        }
    }

    /// The activation of every node, each in `[0, 1]`: the stimulus of the layers above.
    #[must_use]
    pub const fn activation(&self) -> &Grid<f32, WIDTH, HEIGHT> {
        &self.activation
    }

    /// The node that the last stimulus was nearest to, and its squared distance.
    #[must_use]
    pub const fn best_match(&self) -> BestMatch {
        self.best_match
    }

    /// How new the last stimulus is to this layer: the squared distance to the nearest prototype.
    #[must_use]
    pub const fn novelty(&self) -> f32 {
        self.best_match.squared_distance
    }

    /// The sum of all activations, node 0 first (book, 3.4).
    #[must_use]
    pub fn total_activation(&self) -> f32 {
        let mut total = 0.0;
        for &activation in self.activation.as_slice() {
            total += activation;
        }
        total
    }

    /// What an overload detector looks at: the winner, its distance and the total activation.
    #[must_use]
    pub fn response(&self) -> Response {
        Response {
            best_match: self.best_match,
            total_activation: self.total_activation(),
        }
    }

    /// The map under the layer.
    #[must_use]
    pub const fn som(&self) -> &DenseSom<WIDTH, HEIGHT, FEATURES> {
        &self.som
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Default
    for Layer<WIDTH, HEIGHT, FEATURES>
{
    fn default() -> Self {
        Self::new()
    }
}

/// The activation vector.
impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Signal
    for Layer<WIDTH, HEIGHT, FEATURES>
{
    const LEN: usize = Grid::<f32, WIDTH, HEIGHT>::NODES;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        write_slice(self.activation.as_slice(), out);
    }
}

#[cfg(test)]
mod tests {
    use super::{Layer, LayerConfig};
    use crate::num::{Neighbourhood, Rng, Schedule};
    use crate::som::{DenseSom, StimulusError};

    fn config(activation_width: f32) -> LayerConfig {
        let alpha = Schedule::constant(0.5).unwrap();
        let near = Schedule::constant(1.0).unwrap();
        LayerConfig::try_new(activation_width, alpha, near).unwrap()
    }

    #[test]
    fn activation_is_the_gaussian_of_equation_3_1() {
        let mut layer = Layer::<2, 1, 2>::new();
        layer.configure(&config(0.8));
        layer.som.prototypes_mut().as_mut_slice()[1] = [3.0, 4.0];
        layer.activate(&[0.6, 0.8]).unwrap();
        // Distances 1 and 4: exp(−1/1.28) and exp(−16/1.28).
        let expected = [(-1.0_f64 / 1.28).exp(), (-16.0_f64 / 1.28).exp()];
        for (&a, e) in layer.activation().as_slice().iter().zip(expected) {
            assert!((f64::from(a) - e).abs() < 1e-6, "{a} {e}");
        }
        assert!((f64::from(layer.total_activation()) - expected[0] - expected[1]).abs() < 1e-6);
        assert!((layer.novelty() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn training_after_activation_is_the_plain_map_to_the_bit() {
        let mut layer = Layer::<4, 3, 5>::new();
        layer.start(&config(0.5), &mut Rng::new(9));
        let mut som = DenseSom::<4, 3, 5>::new();
        som.randomize(&mut Rng::new(9));
        let near = Neighbourhood::gaussian(1.0, LayerConfig::CUT).unwrap();
        let mut rng = Rng::new(10);
        for t in 0..50 {
            let stimulus: [f32; 5] = core::array::from_fn(|_| rng.unit());
            layer.activate(&stimulus).unwrap();
            layer.train(t);
            let best = som.best_matching_unit(&stimulus).unwrap();
            som.train(&stimulus, best.node, 0.5, &near);
        }
        assert_eq!(layer.som(), &som);
    }

    #[test]
    fn a_refused_stimulus_leaves_the_activation_as_it_was() {
        let mut layer = Layer::<2, 2, 2>::new();
        layer.start(&config(0.5), &mut Rng::new(1));
        layer.activate(&[0.5, 0.5]).unwrap();
        let before = layer.activation().clone();
        let refused = layer.activate(&([0.0], [f32::NAN]));
        assert_eq!(refused, Err(StimulusError::NotFinite { feature: 1 }));
        assert_eq!(layer.activation(), &before);
    }

    #[test]
    fn a_layer_that_was_not_started_learns_nothing() {
        let mut layer = Layer::<2, 2, 1>::new();
        layer.activate(&[1.0]).unwrap();
        layer.train(0);
        assert_eq!(layer.som(), &DenseSom::new());
    }

    #[test]
    fn widths_that_are_no_widths_are_refused() {
        for width in [0.0, -1.0, 1e-7, f32::NAN, f32::INFINITY] {
            let made = LayerConfig::try_new(width, Schedule::ZERO, Schedule::ZERO);
            assert_eq!(
                made.unwrap_err().field,
                "LayerConfig::activation_width",
                "{width}"
            );
        }
    }

    #[test]
    fn a_rate_that_is_above_1_at_either_end_is_refused() {
        let made = |from, to| {
            let alpha = Schedule::linear(from, to, 9).unwrap();
            LayerConfig::try_new(0.5, alpha, Schedule::ZERO)
        };
        for (from, to) in [(1.1, 0.1), (0.1, 1.1), (1e30, 1e30), (0.0, f32::MAX)] {
            let refused = made(from, to).unwrap_err();
            assert_eq!(
                (refused.field, refused.value),
                ("LayerConfig::alpha", from.max(to))
            );
        }
        assert!(made(1.0, 0.0).is_ok() && made(0.0, 1.0).is_ok());
    }

    #[test]
    fn an_activation_too_small_to_matter_is_none_and_a_small_one_is_what_it_is() {
        let mut layer = Layer::<2, 1, 1>::new();
        layer.configure(&config(1.0));
        // exp(−40.5) is 2.6 · 10⁻¹⁸, exp(−42) is less than 10⁻¹⁸.
        let places = [[9.0], [84.0_f32.sqrt()]];
        layer
            .som
            .prototypes_mut()
            .as_mut_slice()
            .copy_from_slice(&places);
        layer.activate(&[0.0]).unwrap();
        let [small, none] = layer.activation().as_slice() else {
            panic!("two nodes")
        };
        assert!((small / 2.576e-18 - 1.0).abs() < 0.01, "{small:e}");
        assert_eq!(*none, 0.0);
        let response = layer.response();
        assert_eq!(
            (response.best_match, response.total_activation),
            (layer.best_match(), *small)
        );
        assert_eq!(layer.best_match().squared_distance, 81.0);
        assert_eq!(layer.novelty(), 81.0);
    }

    #[test]
    fn a_layer_that_is_started_again_has_new_weights_and_no_activation() {
        let mut layer = Layer::<3, 3, 2>::new();
        layer.start(&config(0.5), &mut Rng::new(1));
        layer.activate(&[0.5, 0.5]).unwrap();
        assert!(layer.total_activation() > 0.0);
        let before = layer.som().clone();
        layer.start(&config(0.5), &mut Rng::new(2));
        assert_eq!(layer.total_activation(), 0.0);
        assert_ne!(*layer.som(), before);
        let flat = LayerConfig::try_new(0.0, Schedule::ZERO, Schedule::ZERO);
        assert!(std::format!("{}", flat.unwrap_err()).contains("width"));
        let edge = LayerConfig::try_new(2e-6, Schedule::ZERO, Schedule::ZERO);
        assert!(edge.is_ok());
    }
}
