//! A log as a robot with 24 ultrasound sensors leaves it: ranges in metres and one of four moves a row,
//! of the shape of the wall-following robot's in the UCI repository, made by a simulated robot.
//!
//! `cargo run --release -p host-sim --example ranges -- [FOLDER [ROWS [SEED]]]` writes `ranges.csv` and
//! `ranges.toml`, of which `host-sim teach --log FOLDER/ranges.csv --mapping FOLDER/ranges.toml` learns.
//! A round robot in a room of 6 × 5 m with a pillar follows the wall on its left and does at times
//! something else; every range errs by 2 cm, one of 200 sees no echo, and moves err by a few percent.

use std::fmt::Write as _;
use std::path::Path;

use cla_core::num::Rng;

/// Beams, evenly around the robot; the first looks ahead, the next ones to the left.
const BEAMS: usize = 24;
/// The room, metres, and a pillar in it: left, bottom, right, top.
const ROOM: [f64; 4] = [0.0, 0.0, 6.0, 5.0];
const PILLAR: [f64; 4] = [3.6, 2.2, 4.4, 3.0];
/// What a sensor says at most.
const FARTHEST: f64 = 5.0;
/// The names of the moves, as in the repository, with metres and degrees.
const MOVES: [(&str, f64, f64); 4] = [
    ("Move-Forward", 0.25, 0.0),
    ("Slight-Right-Turn", 0.1, -15.0),
    ("Sharp-Right-Turn", 0.0, -45.0),
    ("Slight-Left-Turn", 0.1, 15.0),
];

struct Robot {
    at: [f64; 2],
    heading: f64,
    rng: Rng,
}

/// Where a beam from inside leaves a box, or one from outside enters it; infinite where it does not.
fn crossing(at: [f64; 2], way: [f64; 2], walls: &[f64; 4], inside: bool) -> f64 {
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..2 {
        let to = |wall: f64| (wall - at[axis]) / way[axis];
        let (one, other) = (to(walls[axis]), to(walls[axis + 2]));
        near = near.max(one.min(other));
        far = far.min(one.max(other));
    }
    if inside {
        far
    } else if near > 0.0 && near < far {
        near
    } else {
        f64::INFINITY
    }
}

impl Robot {
    fn noise(&mut self, sd: f64) -> f64 {
        // Twelve even numbers together are nearly normal.
        let sum: f64 = (0..12).map(|_| f64::from(self.rng.unit())).sum();
        sd * (sum - 6.0)
    }

    fn range(&self, angle: f64) -> f64 {
        let angle = angle.to_radians();
        // A beam along a wall's direction would divide by nothing.
        let way = [libm::cos(angle) + 1e-9, libm::sin(angle) + 1e-9];
        let wall = crossing(self.at, way, &ROOM, true);
        wall.min(crossing(self.at, way, &PILLAR, false))
            .min(FARTHEST)
    }

    fn sense(&mut self) -> [f64; BEAMS] {
        core::array::from_fn(|beam| {
            let whole = self.range(self.heading + 15.0 * beam as f64) + self.noise(0.02);
            if self.rng.chance(0.005) {
                FARTHEST
            } else {
                whole.clamp(0.0, FARTHEST)
            }
        })
    }

    /// Follows the wall on its left, and now and then does not.
    fn choose(&mut self, ranges: &[f64; BEAMS]) -> usize {
        let least = |beams: &[usize]| beams.iter().map(|&it| ranges[it]).fold(FARTHEST, f64::min);
        let (ahead, left) = (least(&[22, 23, 0, 1, 2]), least(&[4, 5, 6, 7, 8]));
        if ahead < 0.6 {
            2
        } else if self.rng.chance(0.25) {
            self.rng.below(4) as usize
        } else if left < 0.5 {
            1
        } else if left > 0.9 {
            3
        } else {
            0
        }
    }

    fn act(&mut self, action: usize) {
        let (_, metres, degrees) = MOVES[action];
        self.heading += degrees * (1.0 + self.noise(0.03));
        let free = self.range(self.heading) - 0.2;
        let metres = (metres * (1.0 + self.noise(0.03))).min(free).max(0.0);
        let angle = self.heading.to_radians();
        self.at[0] += metres * libm::cos(angle);
        self.at[1] += metres * libm::sin(angle);
    }
}

/// So many rows of a log.
pub(crate) fn log(rows: usize, seed: u64) -> String {
    let mut robot = Robot {
        at: [1.5, 1.5],
        heading: 90.0,
        rng: Rng::new(seed),
    };
    let names: Vec<String> = (0..BEAMS).map(|it| format!("us{it}")).collect();
    let mut text = format!("{},move\n", names.join(","));
    for _ in 0..rows {
        let ranges = robot.sense();
        let action = robot.choose(&ranges);
        for range in ranges {
            // A string takes everything.
            let _ = write!(text, "{range:.3},");
        }
        text.push_str(MOVES[action].0);
        text.push('\n');
        robot.act(action);
    }
    text
}

/// Every range is near or not; the four that look ahead and to the sides have bins beside that.
pub(crate) fn mapping() -> String {
    let names: Vec<String> = MOVES.iter().map(|it| format!("{:?}", it.0)).collect();
    let mut text = format!(
        "[action]\ncolumn = \"move\"\nnames = [{}]\n",
        names.join(", ")
    );
    for beam in 0..BEAMS {
        let item = format!(
            "\n[[item]]\ncolumn = \"us{beam}\"\nname = \"near{beam}\"\nbelow = 1.0\nband = 0.05\n"
        );
        text.push_str(&item);
    }
    for beam in [0, 6, 18] {
        let item =
            format!("\n[[item]]\ncolumn = \"us{beam}\"\nbins = [0.5, 1.5, 2.5]\nband = 0.05\n");
        text.push_str(&item);
    }
    text
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().unwrap_or_else(|| "runs/ranges".to_owned());
    let rows = arguments.next().map_or(Ok(5000), |it| it.parse())?;
    let seed = arguments.next().map_or(Ok(1), |it| it.parse())?;
    std::fs::create_dir_all(&folder)?;
    let at = |name: &str| Path::new(&folder).join(name);
    std::fs::write(at("ranges.csv"), log(rows, seed))?;
    std::fs::write(at("ranges.toml"), mapping())?;
    println!("{rows} rows in {}", at("ranges.csv").display());
    Ok(())
}
