//! The book's detector: a total activation below any seen in training (book, 3.4).
//!
//! Recorded from the first sample on it never triggers, because the totals of an untrained layer
//! are near 0: record the late part of training.
//! Totals separate noise from clean events weakly; the detector stands here as the book's, and
//! beside [`MatchDistance`](super::MatchDistance) in every result.

use super::{OverloadDetector, Response};

/// The smallest total activation that was normal; less is overload.
///
/// ```
/// use cla_core::layer::overload::{OverloadDetector, Response, TotalActivation};
/// use cla_core::som::{BestMatch, NodeId};
///
/// let best_match = BestMatch { node: NodeId(0), squared_distance: 0.0 };
/// let response = |total_activation| Response { best_match, total_activation };
/// let mut detector = TotalActivation::new();
/// for total in [2.0, 1.5, 3.0] {
///     detector.record(&response(total));
/// }
/// assert_eq!(detector.minimum(), Some(1.5));
/// assert!(!detector.overloaded(&response(1.5)));
/// assert!(detector.overloaded(&response(1.4)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TotalActivation {
    minimum: f32,
    recorded: bool,
}

impl TotalActivation {
    /// A detector that was told of nothing, and finds nothing too little.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            minimum: 0.0,
            recorded: false,
        }
    }

    /// The smallest total recorded; `None` before the first.
    #[must_use]
    pub fn minimum(&self) -> Option<f32> {
        self.recorded.then_some(self.minimum)
    }
}

impl Default for TotalActivation {
    fn default() -> Self {
        Self::new()
    }
}

/// The total of a response: what is below 0 or no number counts as 0, infinity as the largest number.
fn total_of(response: &Response) -> f32 {
    let total = response.total_activation;
    if total > 0.0 {
        total.min(f32::MAX)
    } else {
        0.0
    }
}

impl OverloadDetector for TotalActivation {
    /// Totals lie in `[0, ∞)`; one below, and NaN, counts as 0, an infinite one as the largest number.
    fn record(&mut self, response: &Response) {
        let total = total_of(response);
        if !self.recorded || total < self.minimum {
            self.minimum = total;
        }
        self.recorded = true;
    }

    /// The minimum over the total, which counts as in [`record`](Self::record); the strain of a silent
    /// layer, where silence is not normal, is the largest number.
    fn strain(&mut self, response: &Response) -> f32 {
        if self.minimum <= 0.0 {
            0.0
        } else {
            (self.minimum / total_of(response)).min(f32::MAX)
        }
    }

    fn forget_context(&mut self) {}
}

#[cfg(test)]
mod tests {
    use super::TotalActivation;
    use crate::layer::overload::{OverloadDetector, Response};
    use crate::som::{BestMatch, NodeId};

    fn response(total_activation: f32) -> Response {
        let best_match = BestMatch {
            node: NodeId(0),
            squared_distance: 0.0,
        };
        Response {
            best_match,
            total_activation,
        }
    }

    #[test]
    fn without_a_record_nothing_is_an_overload() {
        let mut detector = TotalActivation::new();
        assert_eq!(detector.minimum(), None);
        assert!(!detector.overloaded(&response(0.0)));
    }

    #[test]
    fn a_silent_layer_is_overloaded_when_silence_is_not_normal() {
        let mut detector = TotalActivation::new();
        detector.record(&response(0.5));
        assert!(detector.overloaded(&response(0.0)));
        assert_eq!(detector.strain(&response(0.0)), f32::MAX);
        assert_eq!(detector.strain(&response(0.25)), 2.0);
    }

    #[test]
    fn the_smallest_of_the_totals_is_the_limit() {
        let mut detector = TotalActivation::new();
        let mut minima = std::vec::Vec::new();
        for total in [2.0, 1.5, 3.0] {
            detector.record(&response(total));
            minima.push(detector.minimum());
        }
        assert_eq!(minima, [Some(2.0), Some(1.5), Some(1.5)]);
        assert!(!detector.overloaded(&response(1.5)) && detector.overloaded(&response(1.4)));
        assert_eq!(detector.strain(&response(3.0)), 0.5);
        // Where silence is normal, nothing is too little.
        detector.record(&response(0.0));
        assert_eq!(detector.minimum(), Some(0.0));
        assert_eq!(detector.strain(&response(0.0)), 0.0);
    }
}
