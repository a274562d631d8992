//! The robot's measures: body, gripper and specimens of the calibrated Stage 1.3.4 set-up.
//!
//! Plain numbers in metres and seconds, shared by the arena (contacts), the Pioneer (beams, ticks)
//! and the layouts (what fits).
//! Source: `host-sim/data/stage/README.md`.

use super::geometry::{Point, Pose};

/// Length of the body, metres.
pub const BODY_LENGTH: f64 = 0.44;
/// Width of the body, metres.
pub const BODY_WIDTH: f64 = 0.33;
/// How far the body's centre lies behind the centre of rotation, metres: front +0.18, back −0.26.
pub const BODY_SETBACK: f64 = 0.04;
/// The farthest corner of the body from the centre of rotation, metres (rounded up).
pub const BODY_REACH: f64 = 0.31;
/// Radius of a specimen, metres: a disc of 0.08 m.
pub const SPECIMEN_RADIUS: f64 = 0.04;
/// How far ahead of the centre of rotation the two gripper beams lie, metres.
pub const BEAMS_AHEAD: [f64; 2] = [0.28, 0.32];
/// Half the span of a gripper beam, metres.
pub const BEAM_HALF_SPAN: f64 = 0.09;
/// The duration of one tick, seconds.
pub const TICK_SECONDS: f64 = 0.1;
/// What the robot drives in one tick, metres.
pub const TICK_METRES: f64 = 0.02;
/// The backing of the bump reflex, metres.
pub const REFLEX_BACK: f64 = 0.10;

/// Whether a specimen at `local` (robot's frame) breaks a beam: its disc touches a beam's segment.
///
/// Centres from 0.24 to 0.36 m ahead and up to 0.13 m to either side; Stage's raster makes this
/// 0.26 to 0.36 m ahead, 0.10 m to the left and 0.14 m to the right.
#[must_use]
pub fn breaks_a_beam(local: Point) -> bool {
    BEAMS_AHEAD.iter().any(|&ahead| {
        let dx = local.x - ahead;
        let dy = (local.y.abs() - BEAM_HALF_SPAN).max(0.0);
        dx * dx + dy * dy <= SPECIMEN_RADIUS * SPECIMEN_RADIUS
    })
}

/// Whether a specimen at `local` may be touched by the body on a straight drive of `metres`.
///
/// Generous by 2 cm.
/// A specimen between the beams' ends breaks a beam 14 cm before the body's front reaches it, and a
/// broken beam ends the motion, so it does not count.
#[must_use]
pub fn may_be_touched(local: Point, metres: f64) -> bool {
    let margin = SPECIMEN_RADIUS + 0.02;
    let front = 0.5 * BODY_LENGTH - BODY_SETBACK;
    let back = -0.5 * BODY_LENGTH - BODY_SETBACK;
    local.y.abs() <= 0.5 * BODY_WIDTH + margin
        && local.x >= back - margin + metres.min(0.0)
        && local.x <= front + margin + metres.max(0.0)
        && !(local.x > BEAMS_AHEAD[0] && local.y.abs() < BEAM_HALF_SPAN)
}

/// Whether a specimen at `local` may break a beam on a straight drive of `metres`; generous by 1 cm.
#[must_use]
pub fn may_break_a_beam(local: Point, metres: f64) -> bool {
    let margin = SPECIMEN_RADIUS + 0.01;
    local.y.abs() <= BEAM_HALF_SPAN + margin
        && local.x >= BEAMS_AHEAD[0] - margin + metres.min(0.0)
        && local.x <= BEAMS_AHEAD[1] + margin + metres.max(0.0)
}

/// The corners of the body in the room.
#[must_use]
pub fn corners(pose: &Pose) -> [Point; 4] {
    let (length, width) = (0.5 * BODY_LENGTH, 0.5 * BODY_WIDTH);
    [
        (length, width),
        (length, -width),
        (-length, -width),
        (-length, width),
    ]
    .map(|(x, y)| pose.to_room(Point::new(x - BODY_SETBACK, y)))
}

#[cfg(test)]
mod tests {
    use super::{
        BODY_LENGTH, BODY_SETBACK, BODY_WIDTH, Point, SPECIMEN_RADIUS, TICK_METRES, breaks_a_beam,
        may_be_touched, may_break_a_beam,
    };
    use cla_core::num::Rng;

    /// Whether the disc of a specimen at `local` overlaps the body.
    fn touches(local: Point) -> bool {
        let dx = ((local.x + BODY_SETBACK).abs() - 0.5 * BODY_LENGTH).max(0.0);
        let dy = (local.y.abs() - 0.5 * BODY_WIDTH).max(0.0);
        dx * dx + dy * dy <= SPECIMEN_RADIUS * SPECIMEN_RADIUS
    }

    #[test]
    fn no_shortcut_misses_a_contact_or_a_broken_beam() {
        let mut rng = Rng::new(1);
        let mut met = (0, 0);
        for _ in 0..20_000 {
            let at = |rng: &mut Rng| 2.4 * f64::from(rng.unit()) - 1.2;
            let (x, y) = (at(&mut rng), at(&mut rng) * 0.3);
            let metres = if rng.chance(0.5) { 0.5 } else { -0.3 };
            let ticks = (metres / TICK_METRES).abs() as u32;
            for tick in 1..=ticks {
                let driven = metres * f64::from(tick) / f64::from(ticks);
                let now = Point::new(x - driven, y);
                if breaks_a_beam(now) {
                    met.0 += 1;
                    assert!(may_break_a_beam(Point::new(x, y), metres), "{x} {y}");
                    break;
                }
                if touches(now) {
                    met.1 += 1;
                    assert!(may_be_touched(Point::new(x, y), metres), "{x} {y}");
                }
            }
        }
        assert!(met.0 > 500 && met.1 > 500, "{met:?}");
    }

    #[test]
    fn the_beams_see_what_the_stage_gripper_saw() {
        // Stage: centres at 0.26 to 0.36 m ahead, up to 0.10 to 0.14 m to the side.
        for (x, y, broken) in [
            (0.26, 0.0, true),
            (0.35, 0.05, true),
            (0.30, 0.12, true),
            (0.37, 0.0, false),
            (0.22, 0.0, false),
            (0.30, 0.14, false),
        ] {
            assert_eq!(breaks_a_beam(Point::new(x, y)), broken, "{x} {y}");
            assert_eq!(breaks_a_beam(Point::new(x, -y)), broken, "{x} {y}");
        }
    }
}
