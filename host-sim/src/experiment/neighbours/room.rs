//! A square room with a robot that feels where it is, and goes a step to one of four sides.

use cla_core::num::Rng;

/// Length of a wall, in metres.
pub(super) const SIDE: f32 = 10.0;
/// A step, in metres.
const STEP: f32 = 1.0;
/// A step ends up to this far off on each axis, uniformly, in metres.
const OFF: f32 = 0.15;
/// Channels of an axis.
const CHANNELS: usize = 10;
/// Values that the robot senses.
pub(super) const FEATURES: usize = 2 * CHANNELS;
/// What it can do: a step along or against either axis.
pub(super) const ACTIONS: usize = 4;

/// A place, in metres from the corner.
pub(super) type Place = [f32; 2];

/// A place by chance.
pub(super) fn anywhere(rng: &mut Rng) -> Place {
    [SIDE * rng.unit(), SIDE * rng.unit()]
}

/// What is sensed at a place: bell-shaped channels along each axis, a metre apart.
pub(super) fn sensed(place: Place) -> [f32; FEATURES] {
    core::array::from_fn(|at| {
        let centre = (at % CHANNELS) as f32 + 0.5;
        let off = place[at / CHANNELS] - centre;
        cla_core::num::exp(-0.5 * off * off)
    })
}

/// Where a step ends; walls stop it. With `swapped` the wheels go against the orders along the first axis.
pub(super) fn stepped(place: Place, action: usize, swapped: bool, rng: &mut Rng) -> Place {
    let axis = action / 2;
    let back = (action % 2 == 1) != (swapped && axis == 0);
    let mut after = place;
    after[axis] += if back { -STEP } else { STEP };
    after.map(|it| (it + OFF * (2.0 * rng.unit() - 1.0)).clamp(0.0, SIDE))
}

/// Metres between two places.
pub(super) fn apart(a: Place, b: Place) -> f32 {
    let [x, y] = [a[0] - b[0], a[1] - b[1]];
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{apart, sensed, stepped};
    use cla_core::num::Rng;

    #[test]
    fn steps_are_a_metre_stay_in_the_room_and_turn_round_where_wheels_are_swapped() {
        let mut rng = Rng::new(1);
        let [x, y] = stepped([5.0, 5.0], 0, false, &mut rng);
        assert!((x - 6.0).abs() <= 0.15 && (y - 5.0).abs() <= 0.15);
        assert!(stepped([5.0, 5.0], 0, true, &mut rng)[0] < 4.2);
        assert!(stepped([5.0, 5.0], 2, true, &mut rng)[1] > 5.8);
        assert_eq!(stepped([5.0, 0.1], 3, false, &mut rng)[1], 0.0);
        assert!((apart([0.0, 0.0], [3.0, 4.0]) - 5.0).abs() < 1e-6);
    }

    #[test]
    fn places_that_are_nearer_feel_more_alike() {
        let far = |a: [f32; 2], b: [f32; 2]| -> f32 {
            let pairs = sensed(a).into_iter().zip(sensed(b));
            pairs.map(|(a, b)| (a - b) * (a - b)).sum()
        };
        assert!(far([4.0, 4.0], [4.5, 4.0]) < far([4.0, 4.0], [6.0, 4.0]));
    }
}
