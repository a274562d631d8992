//! Ways in which a launching event can be noisy (book, 4.4.1, and our additions).
//!
//! The book's own Noisy event varies the speed and moves the balls irregularly at once; the other
//! kinds take such disturbances apart.
//! Sensor jitter comes on top of all of them.

use std::fmt;

use cla_core::num::Rng;

use super::event::{CELLS, Frame};
use crate::world::shuffle;

/// A disturbance that no training event has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Noise {
    /// The book's: the speed varies and the balls move irregularly (4.4.1).
    Noisy,
    /// Moving balls go forward irregularly, through places where training has been.
    PositionJumps,
    /// Moving balls are a level too fast or too slow.
    SpeedVaries,
    /// Moving balls are half a cell to one and a half cells off: where training has not been.
    OffLattice,
    /// The frames between the first and the last come in another order.
    ShuffledSteps,
    /// A third ball lies somewhere.
    ThirdBall,
    /// A frame between the first and the last is missing.
    DroppedFrame,
}

impl Noise {
    /// All kinds, the book's first.
    pub const ALL: [Self; 7] = [
        Self::Noisy,
        Self::PositionJumps,
        Self::SpeedVaries,
        Self::OffLattice,
        Self::ShuffledSteps,
        Self::ThirdBall,
        Self::DroppedFrame,
    ];

    /// The word that claim ids and file names use.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Noisy => "noisy",
            Self::PositionJumps => "position_jumps",
            Self::SpeedVaries => "speed_varies",
            Self::OffLattice => "off_lattice",
            Self::ShuffledSteps => "shuffled_steps",
            Self::ThirdBall => "third_ball",
            Self::DroppedFrame => "dropped_frame",
        }
    }

    /// The event with this disturbance.
    #[must_use]
    pub fn disturb(self, frames: &[Frame], rng: &mut Rng) -> Vec<Frame> {
        let mut noisy = frames.to_vec();
        match self {
            Self::Noisy => {
                position_jumps(&mut noisy, rng);
                speed_varies(&mut noisy, rng);
            }
            Self::PositionJumps => position_jumps(&mut noisy, rng),
            Self::SpeedVaries => speed_varies(&mut noisy, rng),
            Self::OffLattice => off_lattice(&mut noisy, rng),
            Self::ShuffledSteps => shuffle_steps(&mut noisy, rng),
            Self::ThirdBall => third_ball(&mut noisy, rng),
            Self::DroppedFrame => drop_frame(&mut noisy, rng),
        }
        noisy
    }
}

impl fmt::Display for Noise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Noisy => "Noisy (book)",
            Self::PositionJumps => "position jumps",
            Self::SpeedVaries => "speed varies",
            Self::OffLattice => "off the lattice",
            Self::ShuffledSteps => "shuffled steps",
            Self::ThirdBall => "third ball",
            Self::DroppedFrame => "dropped frame",
        })
    }
}

fn sign(rng: &mut Rng) -> f32 {
    if rng.chance(0.5) { 1.0 } else { -1.0 }
}

/// Each moving ball is a step ahead of itself, a step behind or in its place, and never goes back.
///
/// Draws such ways until one differs from the event's own.
fn position_jumps(frames: &mut [Frame], rng: &mut Rng) {
    let clean = frames.to_vec();
    while *frames == *clean {
        for ball in 0..2 {
            let mut reached = 0;
            for (step, frame) in frames.iter_mut().enumerate() {
                if clean[step].speed[ball] > 0.0 {
                    let drawn = (step + rng.below(3) as usize).saturating_sub(1);
                    reached = drawn.max(reached).min(clean.len() - 1);
                    frame.position[ball] = clean[reached].position[ball];
                }
            }
        }
    }
}

fn speed_varies(frames: &mut [Frame], rng: &mut Rng) {
    for frame in frames {
        for speed in frame.speed.iter_mut().filter(|speed| **speed > 0.0) {
            *speed += sign(rng);
        }
    }
}

fn off_lattice(frames: &mut [Frame], rng: &mut Rng) {
    for frame in frames {
        for (place, speed) in frame.position.iter_mut().zip(frame.speed) {
            if speed > 0.0 {
                *place += sign(rng) * (0.5 + rng.unit());
            }
        }
    }
}

/// Draws orders until one differs from the event's own.
fn shuffle_steps(frames: &mut [Frame], rng: &mut Rng) {
    let last = frames.len().saturating_sub(1);
    let Some(inner) = frames.get_mut(1..last) else {
        return;
    };
    if inner.iter().all(|frame| Some(frame) == inner.first()) {
        return;
    }
    let before = inner.to_vec();
    while *inner == *before {
        shuffle(inner, rng);
    }
}

/// Any cell: balls that come there hide the third one only while they are there.
fn third_ball(frames: &mut [Frame], rng: &mut Rng) {
    let cell = rng.below(CELLS as u32) as f32;
    for frame in frames {
        frame.third = Some(cell);
    }
}

fn drop_frame(frames: &mut Vec<Frame>, rng: &mut Rng) {
    if frames.len() > 2 {
        let inner = frames.len() as u32 - 2;
        frames.remove(1 + rng.below(inner) as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::Noise;
    use crate::world::launching::{Event, LaunchingConfig};
    use cla_core::num::Rng;

    #[test]
    fn every_noise_changes_every_event() {
        let mut rng = Rng::new(3);
        for event in Event::ALL {
            let clean = LaunchingConfig::STANDARD.frames(event);
            for noise in Noise::ALL {
                for _ in 0..50 {
                    assert_ne!(noise.disturb(&clean, &mut rng), clean, "{noise} {event}");
                }
            }
        }
    }
}
