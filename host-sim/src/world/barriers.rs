//! The forager's room with barriers that only a bump shows (book, 7.1.5).
//!
//! Neither the camera nor a beam sees a barrier, and specimens lie and slide beneath it: what is seen
//! beyond one looks as near as anything else, and the robot has to go round what it does not see.

use cla_core::num::Rng;

use super::World;
use super::arena::Barrier;
use super::config::PioneerConfig;
use super::geometry::{Point, Pose};
use super::pioneer::{Pioneer, PioneerError};

/// Barriers in a room.
pub const COUNT: usize = 8;
/// From one end of a barrier to the other, metres.
pub const LENGTH: f64 = 2.0;
/// Least distance of their centres from the robot's first place, and from the wall, metres.
const GAPS: (f64, f64) = (1.5, 1.0);

/// A Pioneer among barriers.
///
/// ```
/// use host_sim::world::World;
/// use host_sim::world::barriers::{Barriers, COUNT};
/// let mut room = Barriers::new(100)?;
/// room.act(0);
/// assert_eq!((room.items().len(), room.barriers().len()), (7, COUNT));
/// # Ok::<(), host_sim::world::pioneer::PioneerError>(())
/// ```
pub struct Barriers {
    pioneer: Pioneer,
    barriers: Vec<Barrier>,
}

impl Barriers {
    /// A room of the reference world with barriers; `seed` decides them, the layout and the noise.
    ///
    /// # Errors
    /// [`PioneerError`] as for the room without them.
    pub fn new(seed: u64) -> Result<Self, PioneerError> {
        let mut pioneer = Pioneer::new(PioneerConfig::NOISY, seed)?;
        let mut rng = Rng::stream(seed, 64);
        let radius = pioneer.config().radius;
        let barriers: Vec<Barrier> = (0..COUNT).map(|_| drawn(radius, &mut rng)).collect();
        for &barrier in &barriers {
            pioneer.raise(barrier);
        }
        Ok(Self { pioneer, barriers })
    }

    /// Where they stand.
    #[must_use]
    pub fn barriers(&self) -> &[Barrier] {
        &self.barriers
    }

    /// The robot, which knows nothing of them.
    #[must_use]
    pub const fn pioneer(&self) -> &Pioneer {
        &self.pioneer
    }
}

fn drawn(radius: f64, rng: &mut Rng) -> Barrier {
    let mut unit = || f64::from(rng.unit());
    let (least, most) = (GAPS.0, radius - GAPS.1);
    // Evenly over the ring.
    let squared = least * least + unit() * (most * most - least * least);
    let at =
        Pose::new(Point::default(), unit() * core::f64::consts::TAU).ahead(libm::sqrt(squared));
    Barrier {
        pose: Pose::new(at.position, unit() * core::f64::consts::PI),
        length: LENGTH,
    }
}

impl World for Barriers {
    around!(self => self.pioneer;
        items actions sense act reflex obtained finished earned episode_ended begin_episode suffer);
}

#[cfg(test)]
#[path = "barriers_tests.rs"]
mod tests;
