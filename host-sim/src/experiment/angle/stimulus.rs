//! Two line segments that share an end, as three population codes (book, Fig 2.1).
//!
//! A line has an orientation (0–180°), coded without regard to its ends; where the second line lies
//! is the direction from the first midpoint to the second (0–360°).

use std::f32::consts::PI;

/// Channels of an orientation, over 180°.
pub const ORIENTATION_CHANNELS: usize = 12;

/// Channels of the direction between midpoints, over 360°.
pub const MIDPOINT_CHANNELS: usize = 16;

/// An angle: two lines from one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleStimulus {
    /// Where the first line points, in degrees.
    pub direction: f32,
    /// How far the second is turned from it, in degrees.
    pub angle: f32,
}

impl AngleStimulus {
    /// The supplementary angle of the same two orientations: the first line points the other way.
    ///
    /// 45° becomes 135°, test B of Fig 2.1.
    #[must_use]
    pub fn opened(self) -> Self {
        Self {
            direction: self.direction + 180.0,
            angle: self.angle - 180.0,
        }
    }

    /// The code of the first line's orientation.
    #[must_use]
    pub fn first(self) -> [f32; ORIENTATION_CHANNELS] {
        code(self.direction, 180.0)
    }

    /// The code of the second line's orientation.
    #[must_use]
    pub fn second(self) -> [f32; ORIENTATION_CHANNELS] {
        code(self.direction + self.angle, 180.0)
    }

    /// The code of the direction from the first line's midpoint to the second's.
    #[must_use]
    pub fn midpoints(self) -> [f32; MIDPOINT_CHANNELS] {
        let unit = |degrees: f32| {
            let radians = degrees * PI / 180.0;
            (libm::cosf(radians), libm::sinf(radians))
        };
        let (x, y) = unit(self.direction);
        let (u, v) = unit(self.direction + self.angle);
        code(libm::atan2f(v - y, u - x) * 180.0 / PI, 360.0)
    }
}

/// Bell-shaped channels, evenly around a circle of `period` degrees, each half on (.61) at the
/// distance of its neighbour.
fn code<const CHANNELS: usize>(degrees: f32, period: f32) -> [f32; CHANNELS] {
    let spacing = period / CHANNELS as f32;
    core::array::from_fn(|channel| {
        let away = (degrees - spacing * channel as f32).rem_euclid(period);
        let steps = away.min(period - away) / spacing;
        cla_core::num::exp(-0.5 * steps * steps)
    })
}

#[cfg(test)]
mod tests {
    use super::AngleStimulus;

    fn far<const N: usize>(a: [f32; N], b: [f32; N]) -> f32 {
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum()
    }

    #[test]
    fn the_opened_angle_has_the_same_orientations_and_another_place() {
        for step in 0..24_u8 {
            let closed = AngleStimulus {
                direction: 15.0 * f32::from(step),
                angle: 45.0,
            };
            let opened = closed.opened();
            assert!(far(closed.first(), opened.first()) < 1e-3);
            assert!(far(closed.second(), opened.second()) < 1e-3);
            // The midpoints of 135° lie a quarter turn from those of 45°.
            assert!(far(closed.midpoints(), opened.midpoints()) > 3.0);
        }
    }

    #[test]
    fn a_rotation_turns_the_direction_between_the_midpoints_with_it() {
        let at = |direction| {
            AngleStimulus {
                direction,
                angle: 45.0,
            }
            .midpoints()
        };
        let (a, mut b) = (at(0.0), at(90.0));
        b.rotate_left(4); // 90° are four of sixteen channels
        assert!(far(a, b) < 1e-3);
    }
}
