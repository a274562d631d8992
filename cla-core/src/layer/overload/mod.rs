//! Overload: a stimulus that the learned prototypes under-represent (book, 3.4).
//!
//! Three detectors, each told of normal responses late in training and then asked about new ones:
//! [`TotalActivation`] is the book's minimum, [`MatchDistance`] compares the best match's distance
//! with what is normal for that node, [`Transitions`] knows which winner follows which.
//! All of them have a [`strain`](OverloadDetector::strain), so that one threshold rule, and one
//! fallback, serves all.
//! The book's second way, by the reliability of schemas, is not here.

mod match_distance;
mod total_activation;
mod transitions;

pub use match_distance::{MatchDistance, MatchDistanceConfig};
pub use total_activation::TotalActivation;
pub use transitions::Transitions;

use crate::som::BestMatch;

/// What a layer answered to one stimulus, as far as overload goes.
///
/// ```
/// use cla_core::layer::Layer;
/// let mut layer = Layer::<2, 2, 1>::new();
/// layer.activate(&[3.0])?;
/// assert_eq!(layer.response().best_match.squared_distance, 9.0);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// The winner and its squared distance.
    pub best_match: BestMatch,
    /// The sum of the layer's activations.
    pub total_activation: f32,
}

/// Tells whether a layer is overloaded.
///
/// ```
/// use cla_core::layer::overload::{OverloadDetector, TotalActivation};
/// use cla_core::layer::Layer;
///
/// fn watch<D: OverloadDetector>(detector: &mut D, layer: &Layer<2, 2, 1>) -> bool {
///     detector.overloaded(&layer.response())
/// }
/// let mut layer = Layer::<2, 2, 1>::new();
/// layer.activate(&[0.0])?;
/// let mut detector = TotalActivation::new();
/// detector.record(&layer.response());
/// assert!(!watch(&mut detector, &layer));
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
pub trait OverloadDetector {
    /// Takes note of a normal response; to be called late in training, when the layer has settled.
    fn record(&mut self, response: &Response);

    /// How far `response` is from normal: 1 is the limit, more is overload, never negative.
    ///
    /// Detectors that look at successive responses take note of this one as the last.
    fn strain(&mut self, response: &Response) -> f32;

    /// A new event begins: what comes next follows nothing.
    fn forget_context(&mut self);

    /// Whether `response` overloads the layer: its strain is above 1.
    fn overloaded(&mut self, response: &Response) -> bool {
        self.strain(response) > 1.0
    }
}
