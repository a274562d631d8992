//! Points and poses in the plane, as the room sees them.
//!
//! Metres and radians, x to the robot's front at heading 0, y to its left, headings
//! counter-clockwise.
//! Sines and cosines come from `libm`, so that a run has the same bits on every host.

use core::f64::consts::{PI, TAU};
use serde::Serialize;

/// A place in the room, in metres; the room's centre is the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Point {
    /// Metres along the room's x axis.
    pub x: f64,
    /// Metres along the room's y axis.
    pub y: f64,
}

impl Point {
    /// The point at `x`, `y` metres.
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The squared distance to another point, in m².
    #[must_use]
    pub fn distance_squared(self, other: Self) -> f64 {
        let (dx, dy) = (self.x - other.x, self.y - other.y);
        dx * dx + dy * dy
    }

    /// The distance to another point, in metres.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        libm::sqrt(self.distance_squared(other))
    }
}

/// Where the robot's centre of rotation is and where it looks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pose {
    /// The centre of rotation.
    pub position: Point,
    heading: f64,
    cos: f64,
    sin: f64,
}

impl Pose {
    /// A pose at `position` with a heading in radians, brought into `(-π, π]`.
    #[must_use]
    pub fn new(position: Point, heading: f64) -> Self {
        let mut heading = libm::fmod(heading, TAU);
        if heading > PI {
            heading -= TAU;
        } else if heading <= -PI {
            heading += TAU;
        }
        let (sin, cos) = libm::sincos(heading);
        Self {
            position,
            heading,
            cos,
            sin,
        }
    }

    /// The heading in radians, in `(-π, π]`.
    #[must_use]
    pub const fn heading(&self) -> f64 {
        self.heading
    }

    /// The cosine and sine of the heading.
    #[must_use]
    pub const fn direction(&self) -> (f64, f64) {
        (self.cos, self.sin)
    }

    /// The pose `metres` straight ahead (behind, when negative).
    #[must_use]
    pub fn ahead(&self, metres: f64) -> Self {
        Self {
            position: self.to_room(Point::new(metres, 0.0)),
            ..*self
        }
    }

    /// The pose turned by `radians` to the left about the centre of rotation.
    #[must_use]
    pub fn turned(&self, radians: f64) -> Self {
        Self::new(self.position, self.heading + radians)
    }

    /// A point of the room as the robot sees it: x ahead, y to the left.
    #[must_use]
    pub fn to_local(&self, point: Point) -> Point {
        let (dx, dy) = (point.x - self.position.x, point.y - self.position.y);
        Point::new(dx * self.cos + dy * self.sin, dy * self.cos - dx * self.sin)
    }

    /// A point in the robot's frame as a point of the room.
    #[must_use]
    pub fn to_room(&self, local: Point) -> Point {
        Point::new(
            self.position.x + local.x * self.cos - local.y * self.sin,
            self.position.y + local.x * self.sin + local.y * self.cos,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Point, Pose};

    #[test]
    fn a_point_ahead_lies_on_the_robots_x_axis() {
        let pose = Pose::new(Point::new(1.0, 2.0), 0.7);
        let local = pose.to_local(pose.ahead(0.5).position);
        assert!((local.x - 0.5).abs() < 1e-12 && local.y.abs() < 1e-12);
    }

    #[test]
    fn a_left_turn_brings_what_was_left_ahead() {
        let pose = Pose::new(Point::default(), 0.0).turned(core::f64::consts::FRAC_PI_2);
        let local = pose.to_local(Point::new(0.0, 1.0));
        assert!((local.x - 1.0).abs() < 1e-12 && local.y.abs() < 1e-12);
    }

    #[test]
    fn headings_stay_within_one_turn() {
        let mut pose = Pose::new(Point::default(), 100.0);
        for _ in 0..1000 {
            pose = pose.turned(0.5);
            assert!(pose.heading().abs() <= core::f64::consts::PI);
        }
    }
}
