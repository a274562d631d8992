//! Layouts: where the specimens lie when a run begins, and the robot's heading.
//!
//! Drawn at random from a seed, or read from a file: the heading in degrees on the first line, then
//! `x y` of one specimen a line, in metres from the room's centre, where the robot stands.
//! Random layouts follow those of the Stage runs (`host-sim/data/stage/layouts`): 0.5 m from the
//! wall, 0.7 m from the robot, 0.3 m apart.

use core::fmt;

use cla_core::num::Rng;
use serde::Serialize;

use super::body::{BODY_LENGTH, BODY_SETBACK, BODY_WIDTH, SPECIMEN_RADIUS};
use super::geometry::{Point, Pose};

/// Distance of a specimen's centre from the wall in random layouts, metres.
pub const WALL_GAP: f64 = 0.5;
/// Distance of a specimen's centre from the robot's in random layouts, metres.
pub const ROBOT_GAP: f64 = 0.7;
/// Distance between two specimens' centres in random layouts, metres.
pub const SPECIMEN_GAP: f64 = 0.3;
/// Most specimens of a layout file.
pub const MOST_SPECIMENS: usize = 1000;
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
    /// Two specimens lie in one place.
    Overlapping {
        /// The line of the second, counted from 1.
        line: usize,
    },
    /// A specimen lies where the robot stands.
    UnderRobot {
        /// The line, counted from 1.
        line: usize,
    },
    /// There are more than [`MOST_SPECIMENS`].
    TooMany,
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
            Self::Overlapping { line } => write!(
                f,
                "the specimen on line {line} of the layout overlaps an earlier one"
            ),
            Self::UnderRobot { line } => write!(
                f,
                "the specimen on line {line} of the layout is under the robot"
            ),
            Self::TooMany => write!(f, "a room takes {MOST_SPECIMENS} specimens at most"),
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
    /// Empty lines are skipped, and what follows a `#`.
    ///
    /// # Errors
    /// Any [`LayoutError`] but `TooSmall`; lines are counted from 1.
    pub fn parse(text: &str, radius: f64) -> Result<Self, LayoutError> {
        // Editors of some systems begin a text with a mark of its byte order.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line.split('#').next().unwrap_or(line)))
            .filter(|(_, line)| !line.trim().is_empty());
        let (line, first) = lines.next().ok_or(LayoutError::Malformed { line: 1 })?;
        let [heading] = numbers(first).ok_or(LayoutError::Malformed { line })?;
        let robot = Pose::new(Point::default(), heading.to_radians());
        let mut specimens: Vec<Point> = Vec::new();
        for (line, text) in lines {
            let [x, y] = numbers(text).ok_or(LayoutError::Malformed { line })?;
            let at = Point::new(x, y);
            if !inside(at, radius) {
                return Err(LayoutError::Outside { line, radius });
            }
            if touches_the_body(robot.to_local(at)) {
                return Err(LayoutError::UnderRobot { line });
            }
            let overlaps = |other: &Point| at.distance(*other) < 2.0 * SPECIMEN_RADIUS;
            if specimens.iter().any(overlaps) {
                return Err(LayoutError::Overlapping { line });
            }
            if specimens.len() == MOST_SPECIMENS {
                return Err(LayoutError::TooMany);
            }
            specimens.push(at);
        }
        if specimens.is_empty() {
            return Err(LayoutError::NoSpecimens);
        }
        Ok(Self { robot, specimens })
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

/// Whether a specimen at `local` (robot's frame) touches the body.
fn touches_the_body(local: Point) -> bool {
    let beyond = |distance: f64, half: f64| (distance.abs() - half).max(0.0);
    let dx = beyond(local.x + BODY_SETBACK, 0.5 * BODY_LENGTH);
    let dy = beyond(local.y, 0.5 * BODY_WIDTH);
    dx * dx + dy * dy < SPECIMEN_RADIUS * SPECIMEN_RADIUS
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
        let told = "\u{feff}# By hand.\r\n90 # degrees\r\n1.5 -2\r\n#0 0\r\n-1 0.25\r\n";
        assert_eq!(Layout::parse(told, 3.0), Ok(layout));
    }

    #[test]
    fn malformed_lines_are_named_in_one_sentence() {
        let wrong = |text: &str| Layout::parse(text, 3.0).unwrap_err();
        assert_eq!(wrong(""), LayoutError::Malformed { line: 1 });
        assert_eq!(wrong("1 2\n"), LayoutError::Malformed { line: 1 });
        assert_eq!(wrong("0\n1 1\n1 2 3\n"), LayoutError::Malformed { line: 3 });
        assert_eq!(wrong("0\n1 NaN\n"), LayoutError::Malformed { line: 2 });
        assert_eq!(wrong("0\n\n"), LayoutError::NoSpecimens);
        assert_eq!(
            wrong("0\n1 1\n2 1\n1.05 1.05\n"),
            LayoutError::Overlapping { line: 4 }
        );
        assert_eq!(wrong("0\n0.1 0\n"), LayoutError::UnderRobot { line: 2 });
        // Beside the robot's head, and under its long body when it looks that way.
        assert!(Layout::parse("0\n0 -0.24\n", 3.0).is_ok());
        assert_eq!(wrong("90\n0 -0.24\n"), LayoutError::UnderRobot { line: 2 });
        let grid = |n: usize| {
            let place = |at: usize| format!("{} {}\n", at % 40, at / 40);
            let places: String = (1..=n).map(place).collect();
            Layout::parse(&format!("0\n{places}"), 50.0)
        };
        assert_eq!(grid(1000).map(|it| it.specimens.len()), Ok(1000));
        assert_eq!(grid(1001), Err(LayoutError::TooMany));
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
