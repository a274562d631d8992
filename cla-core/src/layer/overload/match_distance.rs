//! Overload by distance: is the winner farther away than it normally is when it wins?
//!
//! One value a node: a slowly forgetting maximum of the squared distances at which the node won
//! late in training; and the layer's mean of them.
//! Our extension of section 3.4, whose single minimum is blind to noise of the same total.
//! It does not see a wrong order of right moments; [`Transitions`](super::Transitions) does.

use super::{OverloadDetector, Response};
use crate::check::{ConfigError, Range};
use crate::som::{BestMatch, Grid};

/// When a distance is too far.
///
/// ```
/// use cla_core::layer::overload::MatchDistanceConfig;
/// assert!(MatchDistanceConfig::try_new(0.998, 0.25, 1.5).is_ok());
/// assert!(MatchDistanceConfig::try_new(1.5, 0.25, 1.5).is_err());
/// assert_eq!(MatchDistanceConfig::default(), MatchDistanceConfig::STANDARD);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchDistanceConfig {
    decay: f32,
    pooling: f32,
    limit: f32,
}

impl MatchDistanceConfig {
    /// Decay .998 a win, a quarter of the layer's mean added, limit 1.5.
    pub const STANDARD: Self = Self {
        decay: 0.998,
        pooling: 0.25,
        limit: 1.5,
    };

    /// A rule of three numbers.
    ///
    /// `decay`, in `[0, 1]`: what is left of a node's largest squared distance after its next win;
    /// the training's early, larger distances are forgotten with it.
    /// `pooling`, ≥ 0: how much of the layer's mean is added to a node's own value, so that rare
    /// winners are not held to the little they have seen.
    /// `limit`, > 0: how many times that sum a squared distance may be.
    ///
    /// # Errors
    /// [`ConfigError`] names the number that is out of range.
    pub const fn try_new(decay: f32, pooling: f32, limit: f32) -> Result<Self, ConfigError> {
        // `?` is not for constants.
        if let Err(error) = Range::SHARE.check("MatchDistanceConfig::decay", decay) {
            return Err(error);
        }
        if let Err(error) = Range::NOT_NEGATIVE.check("MatchDistanceConfig::pooling", pooling) {
            return Err(error);
        }
        if let Err(error) = Range::ABOVE_ZERO.check("MatchDistanceConfig::limit", limit) {
            return Err(error);
        }
        Ok(Self {
            decay,
            pooling,
            limit,
        })
    }
}

impl MatchDistanceConfig {
    /// How many times what is normal a squared distance may be.
    #[must_use]
    pub const fn limit(&self) -> f32 {
        self.limit
    }
}

impl Default for MatchDistanceConfig {
    fn default() -> Self {
        Self::STANDARD
    }
}

/// What distance is normal for each winner of a layer of `WIDTH` × `HEIGHT` nodes.
///
/// RAM: 4 bytes a node and 20 bytes.
///
/// ```
/// use cla_core::layer::overload::{MatchDistance, MatchDistanceConfig, OverloadDetector, Response};
/// use cla_core::som::{BestMatch, NodeId};
///
/// let response = |squared_distance| Response {
///     best_match: BestMatch { node: NodeId(3), squared_distance },
///     total_activation: 1.0,
/// };
/// let mut detector = MatchDistance::<2, 2>::new();
/// detector.configure(&MatchDistanceConfig::STANDARD);
/// for d in [0.02, 0.1, 0.05] {
///     detector.record(&response(d));
/// }
/// assert!(!detector.overloaded(&response(0.1)));
/// assert!(detector.overloaded(&response(0.2)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MatchDistance<const WIDTH: usize, const HEIGHT: usize> {
    /// The decaying maximum of each node; 0 where a node never won.
    reach: Grid<f32, WIDTH, HEIGHT>,
    config: MatchDistanceConfig,
}

impl<const WIDTH: usize, const HEIGHT: usize> MatchDistance<WIDTH, HEIGHT> {
    /// A detector of zeros, to be [configured](Self::configure): until then it finds no overload.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            reach: Grid::filled(0.0),
            config: MatchDistanceConfig {
                decay: 0.0,
                pooling: 0.0,
                limit: 0.0,
            },
        }
    }

    /// Takes over `config` and keeps what was recorded.
    pub const fn configure(&mut self, config: &MatchDistanceConfig) {
        self.config = *config;
    }

    /// The squared distance that is normal for each node; 0 where a node never won.
    #[must_use]
    pub const fn reach(&self) -> &Grid<f32, WIDTH, HEIGHT> {
        &self.reach
    }

    /// The mean over the nodes that have won; 0 before any has.
    fn mean_reach(&self) -> f32 {
        let (mut total, mut count) = (0.0, 0_u16);
        for &reach in self.reach.as_slice() {
            if reach > 0.0 {
                total += reach;
                count += 1;
            }
        }
        if count == 0 {
            0.0
        } else {
            total / f32::from(count)
        }
    }
}

impl<const WIDTH: usize, const HEIGHT: usize> Default for MatchDistance<WIDTH, HEIGHT> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const WIDTH: usize, const HEIGHT: usize> OverloadDetector for MatchDistance<WIDTH, HEIGHT> {
    fn record(&mut self, response: &Response) {
        let BestMatch {
            node,
            squared_distance,
        } = response.best_match;
        if let Some(reach) = self.reach.as_mut_slice().get_mut(usize::from(node.0)) {
            let faded = self.config.decay * *reach;
            *reach = if squared_distance > faded {
                squared_distance
            } else {
                faded
            };
        }
    }

    /// The squared distance over what is normal for the winner; 0 before anything was recorded.
    fn strain(&mut self, response: &Response) -> f32 {
        let BestMatch {
            node,
            squared_distance,
        } = response.best_match;
        let own = self
            .reach
            .as_slice()
            .get(usize::from(node.0))
            .copied()
            .unwrap_or(0.0);
        let normal = self.config.limit * (own + self.config.pooling * self.mean_reach());
        if normal > 0.0 {
            squared_distance / normal
        } else {
            0.0
        }
    }

    fn forget_context(&mut self) {}
}

#[cfg(test)]
mod tests {
    use super::{MatchDistance, MatchDistanceConfig};
    use crate::layer::overload::{OverloadDetector, Response};
    use crate::som::{BestMatch, NodeId};

    fn response(node: u16, squared_distance: f32) -> Response {
        let best_match = BestMatch {
            node: NodeId(node),
            squared_distance,
        };
        Response {
            best_match,
            total_activation: 1.0,
        }
    }

    fn detector(decay: f32, pooling: f32, limit: f32) -> MatchDistance<2, 1> {
        let mut detector = MatchDistance::new();
        detector.configure(&MatchDistanceConfig::try_new(decay, pooling, limit).unwrap());
        detector
    }

    #[test]
    fn each_node_is_held_to_its_own_distances_and_a_share_of_the_mean() {
        let mut detector = detector(1.0, 0.5, 2.0);
        detector.record(&response(0, 3.0));
        detector.record(&response(1, 1.0));
        // The mean is 2: the limits are 2·(3 + 1) and 2·(1 + 1).
        assert_eq!(detector.strain(&response(0, 8.0)), 1.0);
        assert_eq!(detector.strain(&response(1, 8.0)), 2.0);
    }

    #[test]
    fn early_large_distances_are_forgotten() {
        let mut detector = detector(0.5, 0.0, 1.0);
        for d in [8.0, 1.0, 1.0, 1.5] {
            detector.record(&response(0, d));
        }
        assert_eq!(detector.reach().as_slice(), [1.5, 0.0]);
    }

    #[test]
    fn without_a_record_or_a_configuration_nothing_is_an_overload() {
        assert!(!detector(1.0, 0.25, 1.5).overloaded(&response(0, 1e9)));
        assert!(!MatchDistance::<2, 1>::new().overloaded(&response(7, 1e9)));
    }

    #[test]
    fn numbers_out_of_range_are_named() {
        for (decay, pooling, limit, field) in [
            (f32::NAN, 0.0, 1.0, "MatchDistanceConfig::decay"),
            (0.5, -1.0, 1.0, "MatchDistanceConfig::pooling"),
            (0.5, 0.0, 0.0, "MatchDistanceConfig::limit"),
        ] {
            let refused = MatchDistanceConfig::try_new(decay, pooling, limit).unwrap_err();
            assert_eq!(refused.field, field);
        }
    }

    #[test]
    fn the_mean_is_that_of_the_nodes_that_have_won() {
        let mut detector = MatchDistance::<4, 1>::new();
        detector.configure(&MatchDistanceConfig::try_new(1.0, 1.0, 1.0).unwrap());
        assert_eq!(detector.strain(&response(0, 3.0)), 0.0);
        detector.record(&response(0, 3.0));
        detector.record(&response(1, 1.0));
        assert_eq!(detector.reach().as_slice(), [3.0, 1.0, 0.0, 0.0]);
        // A node that never won is held to the mean alone: 2.
        assert_eq!(detector.strain(&response(2, 3.0)), 1.5);
        assert_eq!(detector.strain(&response(9, 3.0)), 1.5);
        // What has been exactly as far as it may be is no overload.
        assert!(!detector.overloaded(&response(2, 2.0)) && detector.overloaded(&response(2, 2.1)));
        detector.record(&response(9, 5.0));
        detector.forget_context();
        assert_eq!(detector.strain(&response(2, 3.0)), 1.5);
    }

    #[test]
    fn every_number_of_the_rule_is_checked_and_its_edges_are_good() {
        let [decay, pooling, limit] = ["decay", "pooling", "limit"]
            .map(|field| Some(std::format!("MatchDistanceConfig::{field}")));
        let made = |decay, pooling, limit| {
            let error = MatchDistanceConfig::try_new(decay, pooling, limit).err();
            error.map(|error| std::string::String::from(error.field))
        };
        for good in [(0.0, 0.0, 0.1), (1.0, 9.0, 99.0)] {
            assert_eq!(made(good.0, good.1, good.2), None);
        }
        for wrong in [-0.1, 1.1, f32::NAN] {
            assert_eq!(made(wrong, 0.5, 1.0), decay);
        }
        for wrong in [-0.1, f32::INFINITY, f32::NAN] {
            assert_eq!(made(0.5, wrong, 1.0), pooling);
        }
        for wrong in [0.0, -1.0, f32::INFINITY, f32::NAN] {
            assert_eq!(made(0.5, 0.5, wrong), limit);
        }
        assert_eq!(MatchDistanceConfig::STANDARD.limit(), 1.5);
    }
}
