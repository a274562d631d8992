//! Layouts: where the specimens lie when a run begins, and the robot's heading.
//!
//! Drawn at random from a seed, or read from a file: the heading in degrees on the first line, then
//! `x y` of one specimen a line, in metres from the room's centre, where the robot stands.
//! Random layouts follow those of the Stage runs (`host-sim/data/stage/layouts`): 0.5 m from the
//! wall, 0.7 m from the robot, 0.3 m apart.

use core::fmt;

use cla_core::num::Rng;
use serde::Serialize;

use super::body::SPECIMEN_RADIUS;
use super::geometry::{Point, Pose};

/// Distance of a specimen's centre from the wall in random layouts, metres.
pub const WALL_GAP: f64 = 0.5;
/// Distance of a specimen's centre from the robot's in random layouts, metres.
pub const ROBOT_GAP: f64 = 0.7;
/// Distance between two specimens' centres in random layouts, metres.
pub const SPECIMEN_GAP: f64 = 0.3;
/// Places tried for one specimen before the room counts as too small.
const TRIES: u32 = 10_000;

/// Where everything stands at the beginning.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Layout {
    /// The robot at the room's centre.
    pub robot: Pose,
    /// The specimens' centres.
    pub specimens: Vec<Point>,
}

/// Why there is no such layout.
#[derive(Clone, Debug, PartialEq)]
pub enum LayoutError {
    /// A line is not one (heading) or two (specimen) finite numbers.
    Malformed {
        /// The line, counted from 1.
        line: usize,
    },
    /// A specimen does not lie wholly inside the room.
    Outside {
        /// The line, counted from 1.
        line: usize,
        /// The room's radius, metres.
        radius: f64,
    },
    /// There is no specimen.
    NoSpecimens,
    /// The specimens do not fit the room.
    TooSmall {
        /// How many there should be.
        specimens: usize,
        /// The room's radius, metres.
        radius: f64,
    },
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Malformed { line: 1 } => {
                write!(f, "line 1 of the layout is not a heading in degrees")
            }
            Self::Malformed { line } => {
                write!(f, "line {line} of the layout is not two numbers, x and y")
            }
            Self::Outside { line, radius } => write!(
                f,
                "the specimen on line {line} of the layout is outside the room of radius {radius} m"
            ),
            Self::NoSpecimens => write!(f, "a room needs at least one specimen"),
            Self::TooSmall { specimens, radius } => {
                write!(
                    f,
                    "{specimens} specimens do not fit a room of radius {radius} m"
                )
            }
        }
    }
}

impl core::error::Error for LayoutError {}

impl Layout {
    /// Draws a layout that fits: uniform over the room, with the gaps of this module.
    ///
    /// # Errors
    /// [`LayoutError::NoSpecimens`] for none, [`LayoutError::TooSmall`] when they do not fit.
    pub fn random(radius: f64, specimens: usize, rng: &mut Rng) -> Result<Self, LayoutError> {
        if specimens == 0 {
            return Err(LayoutError::NoSpecimens);
        }
        let too_small = LayoutError::TooSmall { specimens, radius };
        let robot = Pose::new(
            Point::default(),
            f64::from(rng.unit()) * core::f64::consts::TAU,
        );
        let mut placed: Vec<Point> = Vec::with_capacity(specimens);
        // A NaN radius fails this test, too.
        if radius - WALL_GAP > ROBOT_GAP {
            let fits = |at: &Point, placed: &[Point]| clearance(*at, robot.position, placed) >= 0.0;
            while placed.len() < specimens {
                let found = (0..TRIES)
                    .map(|_| random_place(radius, rng))
                    .find(|at| fits(at, &placed));
                match found {
                    Some(at) => placed.push(at),
                    None => return Err(too_small),
                }
            }
            Ok(Self {
                robot,
                specimens: placed,
            })
        } else {
            Err(too_small)
        }
    }

    /// Whether every specimen lies wholly inside a room of `radius` metres.
    ///
    /// # Errors
    /// [`LayoutError::NoSpecimens`], or [`LayoutError::Outside`] with the line that the specimen
    /// has in a layout file.
    pub fn check(&self, radius: f64) -> Result<(), LayoutError> {
        if self.specimens.is_empty() {
            return Err(LayoutError::NoSpecimens);
        }
        match self.specimens.iter().position(|&at| !inside(at, radius)) {
            Some(index) => Err(LayoutError::Outside {
                line: index + 2,
                radius,
            }),
            None => Ok(()),
        }
    }

    /// Reads a layout for a room of `radius` metres.
    ///
    /// Empty lines are skipped.
    ///
    /// # Errors
    /// Any [`LayoutError`] but `TooSmall`; lines are counted from 1.
    pub fn parse(text: &str, radius: f64) -> Result<Self, LayoutError> {
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line))
            .filter(|(_, line)| !line.trim().is_empty());
        let (line, first) = lines.next().ok_or(LayoutError::Malformed { line: 1 })?;
        let [heading] = numbers(first).ok_or(LayoutError::Malformed { line })?;
        let mut specimens = Vec::new();
        for (line, text) in lines {
            let [x, y] = numbers(text).ok_or(LayoutError::Malformed { line })?;
            let at = Point::new(x, y);
            if !inside(at, radius) {
                return Err(LayoutError::Outside { line, radius });
            }
            specimens.push(at);
        }
        if specimens.is_empty() {
            return Err(LayoutError::NoSpecimens);
        }
        Ok(Self {
            robot: Pose::new(Point::default(), heading.to_radians()),
            specimens,
        })
    }
}

/// A place for a specimen that reappears: free, and not next to the robot.
///
/// The first of many random places that keeps the gaps of random layouts; when a crowded room has
/// none, the one with the most room around it.
#[must_use]
pub fn free_place(radius: f64, robot: Point, others: &[Point], rng: &mut Rng) -> Point {
    let mut best = random_place(radius, rng);
    let mut best_clearance = clearance(best, robot, others);
    for _ in 0..TRIES {
        if best_clearance >= 0.0 {
            break;
        }
        let at = random_place(radius, rng);
        let room = clearance(at, robot, others);
        if room > best_clearance {
            (best, best_clearance) = (at, room);
        }
    }
    best
}

/// False for a NaN radius.
fn inside(at: Point, radius: f64) -> bool {
    at.distance(Point::default()) + SPECIMEN_RADIUS <= radius
}

/// How much farther than the wanted gaps robot and specimens are, in metres; negative if nearer.
fn clearance(at: Point, robot: Point, others: &[Point]) -> f64 {
    others
        .iter()
        .map(|&other| at.distance(other) - SPECIMEN_GAP)
        .fold(at.distance(robot) - ROBOT_GAP, f64::min)
}

/// Uniform over the disc that keeps the gap to the wall.
fn random_place(radius: f64, rng: &mut Rng) -> Point {
    loop {
        let x = 2.0 * f64::from(rng.unit()) - 1.0;
        let y = 2.0 * f64::from(rng.unit()) - 1.0;
        if x * x + y * y <= 1.0 {
            let reach = radius - WALL_GAP;
            return Point::new(x * reach, y * reach);
        }
    }
}

fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    let mut words = line.split_whitespace();
    let mut out = [0.0; N];
    for number in &mut out {
        *number = words.next()?.parse().ok().filter(|n: &f64| n.is_finite())?;
    }
    words.next().is_none().then_some(out)
}

#[cfg(test)]
mod tests {
    use super::{Layout, LayoutError, Point, free_place};
    use cla_core::num::Rng;

    #[test]
    fn random_layouts_keep_their_gaps() {
        for seed in 0..20 {
            let layout = Layout::random(3.0, 28, &mut Rng::new(seed)).unwrap();
            for (index, &a) in layout.specimens.iter().enumerate() {
                let from_centre = a.distance(Point::default());
                assert!((0.7..=2.5).contains(&from_centre));
                for &b in &layout.specimens[..index] {
                    assert!(a.distance(b) >= 0.3);
                }
            }
        }
    }

    #[test]
    fn a_room_that_is_too_small_is_refused() {
        for radius in [1.3, 1.0, 0.0, -1.0, f64::NAN] {
            let error = Layout::random(radius, 28, &mut Rng::new(1)).unwrap_err();
            assert!(matches!(error, LayoutError::TooSmall { .. }), "{error}");
        }
        let none = Layout::random(5.0, 0, &mut Rng::new(1));
        assert_eq!(none, Err(LayoutError::NoSpecimens));
    }

    #[test]
    fn a_layout_file_gives_heading_and_places() {
        let layout = Layout::parse("90\n1.5 -2\n\n-1 0.25\n", 3.0).unwrap();
        assert!((layout.robot.heading().to_degrees() - 90.0).abs() < 1e-9);
        let places = [Point::new(1.5, -2.0), Point::new(-1.0, 0.25)];
        assert_eq!(layout.specimens, places);
    }

    #[test]
    fn malformed_lines_are_named_in_one_sentence() {
        let wrong = |text: &str| Layout::parse(text, 3.0).unwrap_err();
        assert_eq!(wrong(""), LayoutError::Malformed { line: 1 });
        assert_eq!(wrong("1 2\n"), LayoutError::Malformed { line: 1 });
        assert_eq!(wrong("0\n1 1\n1 2 3\n"), LayoutError::Malformed { line: 3 });
        assert_eq!(wrong("0\n1 NaN\n"), LayoutError::Malformed { line: 2 });
        assert_eq!(wrong("0\n\n"), LayoutError::NoSpecimens);
        let outside = wrong("0\n2.97 0\n");
        assert_eq!(
            outside.to_string(),
            "the specimen on line 2 of the layout is outside the room of radius 3 m"
        );
    }

    #[test]
    fn a_reappearing_specimen_is_not_next_to_the_robot() {
        let mut rng = Rng::new(3);
        let robot = Point::new(1.0, 1.0);
        for _ in 0..1000 {
            let at = free_place(3.0, robot, &[Point::new(0.0, 0.0)], &mut rng);
            assert!(at.distance(robot) >= 0.7 && at.distance(Point::default()) >= 0.3);
        }
    }

    #[test]
    fn a_crowded_room_still_takes_a_specimen_back() {
        let crowd = vec![Point::default(); 1000];
        let at = free_place(1.0, Point::default(), &crowd, &mut Rng::new(4));
        assert!(at.distance(Point::default()) <= 0.5);
    }
}
