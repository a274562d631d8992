//! How a trained robot gets at one specimen that lies aside of its way (book, Fig 6.4).

use cla_core::agent::Adaptation;
use cla_core::forager::pioneer::Brain;
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::learner::watched;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::geometry::{Point, Pose};
use crate::world::layout::Layout;
use crate::world::pioneer::Pioneer;

/// Where the specimen lies, metres ahead and to the left: 4 m away, in the middle of sector 2.
pub(super) const SPECIMEN: [f64; 2] = [3.9126, 0.8316];
/// Actions after which the robot may give up.
const PATIENCE: u32 = 300;

/// One way to a specimen.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Approach {
    /// Where the robot was before each action and at the end, metres from its start.
    pub path: Vec<[f64; 2]>,
    /// Whether it took the specimen.
    pub taken: bool,
}

impl Approach {
    /// Actions that it took.
    #[must_use]
    pub fn actions(&self) -> f64 {
        self.path.len().saturating_sub(1) as f64
    }

    /// Those of them that did not move it: turns.
    #[must_use]
    pub fn turns(&self) -> f64 {
        let still = |ends: &&[[f64; 2]]| match ends {
            [from, to] => (from[0] - to[0]).abs() + (from[1] - to[1]).abs() < 0.01,
            _ => false,
        };
        self.path.windows(2).filter(still).count() as f64
    }
}

/// Lets a copy of a brain go for the specimen, greedy, as in a test.
///
/// # Errors
/// [`Failure`] when the world cannot be built or the brain cannot go on.
pub(super) fn approach(
    brain: &Brain,
    config: PioneerConfig,
    seed: u64,
) -> Result<Approach, Failure> {
    let layout = Layout {
        robot: Pose::new(Point::new(0.0, 0.0), 0.0),
        specimens: vec![Point::new(SPECIMEN[0], SPECIMEN[1])],
    };
    let config = PioneerConfig {
        // There is room for the way there.
        radius: config.radius.max(5.0),
        specimens: 1,
        after_capture: AfterCapture::Removed,
        ..config
    };
    let mut world = Pioneer::with_layout(config, &layout, Rng::stream(seed, 6).next_seed())?;
    let mut copy = Box::new(brain.clone());
    copy.act(Adaptation::Reliabilities)?;
    let mut approach = Approach::default();
    let place = |world: &Pioneer| {
        let at = world.robot().position;
        [at.x, at.y]
    };
    let lived = watched(&mut *copy, &mut world, PATIENCE, &mut |_, world| {
        approach.path.push(place(world));
    })?;
    approach.path.push(place(&world));
    approach.taken = lived.total() > 0;
    Ok(approach)
}

#[cfg(test)]
mod tests {
    use super::Approach;

    #[test]
    fn what_does_not_move_the_robot_is_a_turn() {
        let path = vec![[0.0, 0.0], [0.0, 0.0], [0.5, 0.0], [0.5, 0.0], [0.9, 0.1]];
        let approach = Approach { path, taken: true };
        assert_eq!((approach.actions(), approach.turns()), (4.0, 2.0));
        assert_eq!(Approach::default().actions(), 0.0);
    }
}
