//! The camera: which blobs of colour it sees, in which of its five sectors.
//!
//! 60° wide, 160 columns, 8 m; nearer specimens hide farther ones column by column, and
//! neighbouring columns of colour merge into one blob, as in Stage (`host-sim/data/stage/README.md`).
//! The room is convex and everything is inside it, so a wall never stands before a specimen; beyond
//! the walls nothing is seen.
//! Pure geometry: no physics, no noise.

use super::body::SPECIMEN_RADIUS;
use super::geometry::{Point, Pose};

/// Columns of the camera's picture.
pub const COLUMNS: usize = 160;
/// The field of view, degrees.
pub const FIELD_OF_VIEW: f64 = 60.0;
/// The sectors s1 (far left) to s5 (far right), 12° each.
pub const SECTORS: usize = 5;

const DEGREES_PER_COLUMN: f64 = FIELD_OF_VIEW / COLUMNS as f64;
/// tan 30° and 1/cos 30°: the edges of the field of view.
const EDGE_SLOPE: f64 = 0.577_350_269_189_625_8;
const EDGE_SECANT: f64 = 1.154_700_538_379_251_5;
const EMPTY: f32 = f32::INFINITY;

/// Something of the specimens' colour in the camera's picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blob {
    /// Direction of its middle from the camera's axis, degrees, left positive, within ±30.
    pub bearing: f64,
    /// Distance to its nearest specimen's centre, metres.
    pub range: f64,
    /// Columns it covers, 1 to 160.
    pub columns: usize,
    /// Index of its nearest specimen.
    pub specimen: usize,
}

impl Blob {
    /// The sector it lies in: 0 for s1 (far left) to 4 for s5 (far right).
    ///
    /// A blob on a border belongs to the sector on its left; `None` when its direction is no number.
    #[must_use]
    pub fn sector(&self) -> Option<usize> {
        if self.bearing.is_nan() {
            return None;
        }
        let from_left = (0.5 * FIELD_OF_VIEW - self.bearing) * SECTORS as f64 / FIELD_OF_VIEW;
        let sector = libm::ceil(from_left) - 1.0;
        Some(sector.clamp(0.0, (SECTORS - 1) as f64) as usize)
    }
}

/// The camera on the robot's centre of rotation.
#[derive(Clone, Debug)]
pub struct Camera {
    offset: f64,
    range: f64,
    nearest: [f32; COLUMNS],
    owner: [u16; COLUMNS],
}

impl Camera {
    /// A camera that looks `offset` degrees to the left of the heading, as far as `range` metres.
    #[must_use]
    pub const fn new(offset: f64, range: f64) -> Self {
        Self {
            offset: offset.to_radians(),
            range,
            nearest: [EMPTY; COLUMNS],
            owner: [0; COLUMNS],
        }
    }

    /// Turns the camera on its mount: degrees to the left of the heading.
    pub const fn set_offset(&mut self, offset: f64) {
        self.offset = offset.to_radians();
    }

    /// Fills `blobs` with what is seen from `robot`, from left to right.
    pub fn look(&mut self, robot: &Pose, specimens: &[Option<Point>], blobs: &mut Vec<Blob>) {
        blobs.clear();
        self.nearest.fill(EMPTY);
        let eye = if self.offset == 0.0 {
            *robot
        } else {
            robot.turned(self.offset)
        };
        let mut seen = false;
        for (index, specimen) in specimens.iter().enumerate() {
            if let Some(at) = specimen {
                seen |= self.draw(index as u16, eye.to_local(*at));
            }
        }
        if seen {
            self.merge(blobs);
        }
    }

    /// Draws one disc at `local` into the columns; whether any column shows it.
    fn draw(&mut self, index: u16, local: Point) -> bool {
        let beyond_edge = local.y.abs() - EDGE_SLOPE * local.x;
        let squared = local.x * local.x + local.y * local.y;
        if beyond_edge > EDGE_SECANT * SPECIMEN_RADIUS || squared > self.range * self.range {
            return false;
        }
        let distance = libm::sqrt(squared);
        let bearing = libm::atan2(local.y, local.x).to_degrees();
        let half_width = libm::asin((SPECIMEN_RADIUS / distance).min(1.0)).to_degrees();
        // The columns whose middle the disc covers.
        let column = |degrees: f64| (0.5 * FIELD_OF_VIEW - degrees) / DEGREES_PER_COLUMN - 0.5;
        let first = libm::ceil(column(bearing + half_width)).max(0.0) as usize;
        let last = libm::floor(column(bearing - half_width));
        if last < 0.0 {
            return false;
        }
        let last = (last as usize).min(COLUMNS - 1);
        let mut seen = false;
        for column in first..=last {
            if (distance as f32) < self.nearest[column] {
                self.nearest[column] = distance as f32;
                self.owner[column] = index;
                seen = true;
            }
        }
        seen
    }

    /// Joins neighbouring columns of colour into blobs.
    fn merge(&self, blobs: &mut Vec<Blob>) {
        let mut column = 0;
        while column < COLUMNS {
            if self.nearest[column] == EMPTY {
                column += 1;
                continue;
            }
            let first = column;
            let mut nearest = column;
            while column < COLUMNS && self.nearest[column] != EMPTY {
                if self.nearest[column] < self.nearest[nearest] {
                    nearest = column;
                }
                column += 1;
            }
            let middle = 0.5 * (first + column) as f64;
            blobs.push(Blob {
                bearing: 0.5 * FIELD_OF_VIEW - middle * DEGREES_PER_COLUMN,
                range: f64::from(self.nearest[nearest]),
                columns: column - first,
                specimen: usize::from(self.owner[nearest]),
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Blob, Camera, Point, Pose};

    fn look_with(camera: &mut Camera, specimens: &[(f64, f64)]) -> Vec<Blob> {
        // Given as distance in metres and bearing in degrees.
        let specimens: Vec<Option<Point>> = specimens
            .iter()
            .map(|&(distance, bearing)| {
                let pose = Pose::new(Point::default(), bearing.to_radians());
                Some(pose.ahead(distance).position)
            })
            .collect();
        let mut blobs = Vec::new();
        camera.look(&Pose::new(Point::default(), 0.0), &specimens, &mut blobs);
        blobs
    }

    fn look(specimens: &[(f64, f64)]) -> Vec<Blob> {
        look_with(&mut Camera::new(0.0, 8.0), specimens)
    }

    #[test]
    fn five_sectors_go_from_far_left_to_far_right() {
        for (bearing, sector) in [(24.0, 0), (12.0, 1), (0.0, 2), (-12.0, 3), (-24.0, 4)] {
            let blobs = look(&[(2.0, bearing)]);
            assert_eq!(blobs.len(), 1);
            assert_eq!(blobs[0].sector(), Some(sector));
            assert!((blobs[0].bearing - bearing).abs() < 0.2);
        }
    }

    #[test]
    fn a_specimen_behind_another_is_not_seen() {
        let blobs = look(&[(4.0, 5.0), (2.0, 5.0)]);
        assert_eq!(blobs.len(), 1);
        assert_eq!(blobs[0].specimen, 1);
        assert!((blobs[0].range - 2.0).abs() < 1e-6);
    }

    #[test]
    fn neighbours_merge_into_one_blob_and_others_do_not() {
        assert_eq!(look(&[(2.0, 0.0), (2.5, 2.0)]).len(), 1);
        assert_eq!(look(&[(2.0, 0.0), (2.5, 4.0)]).len(), 2);
    }

    #[test]
    fn what_is_behind_beside_or_too_far_is_not_seen() {
        assert!(look(&[(2.0, 180.0), (2.0, 40.0), (2.0, -40.0), (8.1, 0.0)]).is_empty());
        assert_eq!(look(&[(7.9, 0.0)]).len(), 1);
        assert!(look(&[]).is_empty());
    }

    #[test]
    fn a_camera_knocked_left_sees_what_is_ahead_farther_right() {
        let mut camera = Camera::new(0.0, 8.0);
        camera.set_offset(12.0);
        assert_eq!(look_with(&mut camera, &[(2.0, 0.0)])[0].sector(), Some(3));
    }

    #[test]
    fn a_specimen_at_the_edge_shows_the_part_that_is_inside() {
        let blobs = look(&[(1.0, 31.0)]);
        assert_eq!(blobs.len(), 1);
        assert!(blobs[0].columns < 6 && blobs[0].bearing > 29.0);
    }
}
