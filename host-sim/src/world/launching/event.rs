//! Launching events: two balls on a line, one of which may set the other going (book, 4.1, 4.2).
//!
//! An event is a list of [`Frame`]s, and a frame is what the two sensors of the book's Fig 4.3
//! report: positions, and three consecutive speed matrices.
//! What the book leaves open (speeds, the sizes of gap and delay, jitter, how events are noisy) is
//! a field of [`LaunchingConfig`] or a [`Noise`](super::Noise).
//! Nothing learns here.

use std::fmt;

use cla_core::num::Rng;
use serde::Serialize;

/// Elements of the Position input (book, 4.2).
pub const CELLS: usize = 20;

/// Elements of one ball's speed.
pub const SPEED_ELEMENTS: usize = 10;

/// Elements of the Movement input: three consecutive 2 × 10 speed matrices.
pub const MOVEMENT: usize = 3 * 2 * SPEED_ELEMENTS;

/// What the two sensors report at one step: Position and Movement.
pub type Stimulus = ([f32; CELLS], [f32; MOVEMENT]);

/// A launching event without noise (book, Fig 4.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// The first ball touches the second, which moves at once.
    Direct,
    /// It touches, and the second moves after a delay.
    Delay,
    /// The first stops before it touches; the second moves at once.
    Gap,
    /// It stops before, and the second moves after a delay.
    DelayGap,
}

impl Event {
    /// All four, in the book's order.
    pub const ALL: [Self; 4] = [Self::Direct, Self::Delay, Self::Gap, Self::DelayGap];

    /// Whether the second ball waits.
    #[must_use]
    pub const fn has_delay(self) -> bool {
        matches!(self, Self::Delay | Self::DelayGap)
    }

    /// Whether the first ball stops before it touches the second.
    #[must_use]
    pub const fn has_gap(self) -> bool {
        matches!(self, Self::Gap | Self::DelayGap)
    }

    /// Draws an event; `shares` are the probabilities of [`ALL`](Self::ALL) and sum to 1.
    #[must_use]
    pub fn draw(shares: &[f32; 4], rng: &mut Rng) -> Self {
        let mut left = rng.unit();
        for (event, share) in Self::ALL.into_iter().zip(shares) {
            left -= share;
            if left < 0.0 {
                return event;
            }
        }
        Self::Direct
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Direct => "Direct",
            Self::Delay => "Delay",
            Self::Gap => "Gap",
            Self::DelayGap => "Delay+Gap",
        })
    }
}

/// What the book does not say about launching events; lengths in cells, times in steps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LaunchingConfig {
    /// Where the first ball starts: the far left (book, 4.2).
    pub first_start: f32,
    /// Where the second ball waits: element 11, the centre (book, 4.2).
    pub second_start: f32,
    /// Cells that a moving ball covers in a step; the last step may be shorter.
    pub cells_per_step: f32,
    /// Elements of the speed bar that a moving ball turns on, 1 to 8.
    pub speed_level: f32,
    /// How far before the touching position the first ball stops in events with a gap.
    pub gap: f32,
    /// Steps that the second ball waits in events with a delay.
    pub delay: u32,
    /// Still frames before and after the event.
    pub still_frames: u32,
    /// Each position is off by up to this much, uniformly; up to half a cell.
    pub position_jitter: f32,
    /// Each moving ball's speed level is off by up to this much, uniformly; below 1.
    pub speed_jitter: f32,
}

/// A [`LaunchingConfig`] that describes no launching event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaunchingConfigError(&'static str);

impl fmt::Display for LaunchingConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl std::error::Error for LaunchingConfigError {}

impl LaunchingConfig {
    /// The events of all causal results.
    pub const STANDARD: Self = Self {
        first_start: 0.0,
        second_start: 10.0,
        cells_per_step: 3.0,
        speed_level: 3.0,
        gap: 4.0,
        delay: 3,
        still_frames: 1,
        position_jitter: 0.25,
        speed_jitter: 0.25,
    };

    /// This configuration, if it describes launching events on [`CELLS`] cells.
    ///
    /// # Errors
    /// [`LaunchingConfigError`] says which field is out of range.
    pub fn validated(self) -> Result<Self, LaunchingConfigError> {
        let last = (CELLS - 1) as f32;
        let path = self.second_start - self.first_start - 1.0;
        let checks = [
            (
                self.first_start >= 0.0,
                "the first ball must start in a cell",
            ),
            (
                path >= 1.0,
                "the second ball must wait at least two cells to the right of the first",
            ),
            (
                self.second_start < last,
                "the second ball needs room to move",
            ),
            (
                self.cells_per_step > 0.0 && self.cells_per_step.is_finite(),
                "balls must move a finite way in a step",
            ),
            (
                (1.0..=8.0).contains(&self.speed_level),
                "the speed level must be 1 to 8",
            ),
            (
                self.gap > 0.0 && self.gap < path,
                "the gap must be shorter than the first ball's way",
            ),
            (
                (1..=100).contains(&self.delay),
                "the delay must be 1 to 100 steps",
            ),
            (
                (1..=100).contains(&self.still_frames),
                "an event has 1 to 100 still frames at its ends",
            ),
            (
                (0.0..=0.5).contains(&self.position_jitter),
                "positions jitter by at most half a cell",
            ),
            (
                (0.0..1.0).contains(&self.speed_jitter),
                "speeds jitter by less than a level",
            ),
        ];
        match checks.into_iter().find(|(holds, _)| !holds) {
            Some((_, message)) => Err(LaunchingConfigError(message)),
            None => Ok(self),
        }
    }

    /// The frames of an event without jitter.
    #[must_use]
    pub fn frames(&self, event: Event) -> Vec<Frame> {
        let touching = self.second_start - 1.0;
        let stop = if event.has_gap() {
            touching - self.gap
        } else {
            touching
        };
        let end = (CELLS - 1) as f32;
        let still = |first, second| Frame {
            position: [first, second],
            ..Frame::default()
        };
        let mut frames =
            vec![still(self.first_start, self.second_start); self.still_frames as usize];
        for first in self.way(self.first_start, stop) {
            let speed = [self.speed_level, 0.0];
            frames.push(Frame {
                speed,
                ..still(first, self.second_start)
            });
        }
        if event.has_delay() {
            let waiting = still(stop, self.second_start);
            frames.extend(std::iter::repeat_n(waiting, self.delay as usize));
        }
        for second in self.way(self.second_start, end) {
            frames.push(Frame {
                speed: [0.0, self.speed_level],
                ..still(stop, second)
            });
        }
        frames.extend(std::iter::repeat_n(
            still(stop, end),
            self.still_frames as usize,
        ));
        frames
    }

    /// The frames of an event as a sensor reports them: with jitter.
    #[must_use]
    pub fn jittered(&self, frames: &[Frame], rng: &mut Rng) -> Vec<Frame> {
        let mut draw = |most: f32| most * (2.0 * rng.unit() - 1.0);
        let mut jittered = frames.to_vec();
        for frame in &mut jittered {
            for position in &mut frame.position {
                *position += draw(self.position_jitter);
            }
            for speed in frame.speed.iter_mut().filter(|speed| **speed > 0.0) {
                *speed += draw(self.speed_jitter);
            }
        }
        jittered
    }

    /// The places after each step from `from` (left out) to `to`.
    fn way(&self, from: f32, to: f32) -> Vec<f32> {
        let mut places = Vec::new();
        let mut at = from;
        while at < to {
            at = (at + self.cells_per_step).min(to);
            places.push(at);
        }
        places
    }
}

/// One moment of an event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    /// Where the two balls are, in cells from the left.
    pub position: [f32; 2],
    /// Their speed levels; 0 is still.
    pub speed: [f32; 2],
    /// A third ball, which only the Position input can show.
    pub third: Option<f32>,
}

impl Frame {
    /// The Position input: 1 at each ball's cell, shared by two cells when it is between them.
    #[must_use]
    pub fn position_input(&self) -> [f32; CELLS] {
        let mut input = [0.0; CELLS];
        for position in self.position.into_iter().chain(self.third) {
            let place = position.clamp(0.0, (CELLS - 1) as f32);
            let (cell, part) = (place as usize, place.fract());
            input[cell] = (input[cell] + 1.0 - part).min(1.0);
            if part > 0.0 {
                input[cell + 1] = (input[cell + 1] + part).min(1.0);
            }
        }
        input
    }

    /// The speed matrix: for each ball element 0 when still, or elements 1 to its level.
    ///
    /// The last element is on by the level's fraction.
    #[must_use]
    pub fn speed_matrix(&self) -> [f32; 2 * SPEED_ELEMENTS] {
        let mut matrix = [0.0; 2 * SPEED_ELEMENTS];
        for (bar, &speed) in matrix.chunks_exact_mut(SPEED_ELEMENTS).zip(&self.speed) {
            if speed <= 0.0 {
                bar[0] = 1.0;
            }
            for (level, element) in bar.iter_mut().enumerate().skip(1) {
                *element = (speed - (level as f32 - 1.0)).clamp(0.0, 1.0);
            }
        }
        matrix
    }
}

/// What the sensors report at each frame: the speeds of the last three frames, oldest first.
///
/// Before the first frame the balls were as still as in the first.
#[must_use]
pub fn stimuli(frames: &[Frame]) -> Vec<Stimulus> {
    let matrices: Vec<_> = frames.iter().map(Frame::speed_matrix).collect();
    (0..frames.len())
        .map(|now| {
            let mut movement = [0.0; MOVEMENT];
            let parts = movement.chunks_exact_mut(2 * SPEED_ELEMENTS);
            for (part, back) in parts.zip([2, 1, 0]) {
                part.copy_from_slice(&matrices[now.saturating_sub(back)]);
            }
            (frames[now].position_input(), movement)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Event, Frame, LaunchingConfig, stimuli};
    use cla_core::num::Rng;

    const CONFIG: LaunchingConfig = LaunchingConfig::STANDARD;

    #[test]
    fn in_a_direct_event_the_second_ball_moves_the_step_after_the_touch() {
        let frames = CONFIG.frames(Event::Direct);
        let places: Vec<_> = frames.iter().map(|frame| frame.position).collect();
        assert_eq!(places[3..5], [[9.0, 10.0], [9.0, 13.0]]);
        assert_eq!(
            (places[0], *places.last().unwrap()),
            ([0.0, 10.0], [9.0, 19.0])
        );
        assert_eq!(frames.len(), 8);
    }

    #[test]
    fn a_delay_adds_still_frames_and_a_gap_moves_the_stop() {
        let frames = |event| CONFIG.frames(event);
        assert_eq!(frames(Event::Delay).len(), frames(Event::Direct).len() + 3);
        assert_eq!(frames(Event::Gap).last().unwrap().position, [5.0, 19.0]);
        let waiting = frames(Event::DelayGap);
        assert_eq!(
            waiting.iter().filter(|f| f.position == [5.0, 10.0]).count(),
            4
        );
    }

    #[test]
    fn positions_are_snapshots_and_movement_is_a_window_of_three() {
        let seen = stimuli(&CONFIG.frames(Event::Direct));
        for (position, _) in &seen {
            assert_eq!(position.iter().filter(|&&on| on == 1.0).count(), 2);
        }
        // At the touch: the first ball still, moving, moving is two steps back.
        let (_, movement) = seen[2];
        assert_eq!(movement[0], 1.0); // the first ball was still
        assert_eq!(movement[40..44], [0.0, 1.0, 1.0, 1.0]); // and moves at level 3 now
        assert_eq!(movement[50], 1.0); // the second ball is still
    }

    #[test]
    fn jitter_stays_within_its_bounds_and_off_still_balls() {
        let frames = CONFIG.frames(Event::Delay);
        let mut rng = Rng::new(4);
        for _ in 0..200 {
            for (clean, seen) in frames.iter().zip(CONFIG.jittered(&frames, &mut rng)) {
                for ball in 0..2 {
                    assert!((clean.position[ball] - seen.position[ball]).abs() <= 0.25);
                    assert!((clean.speed[ball] - seen.speed[ball]).abs() <= 0.25);
                    assert_eq!(clean.speed[ball] == 0.0, seen.speed[ball] == 0.0);
                }
            }
        }
    }

    #[test]
    fn a_ball_between_two_cells_is_shared_by_them() {
        let frame = Frame {
            position: [2.25, 10.0],
            speed: [2.5, 0.0],
            third: None,
        };
        let input = frame.position_input();
        assert_eq!((input[2], input[3], input[10]), (0.75, 0.25, 1.0));
        assert_eq!(frame.speed_matrix()[..5], [0.0, 1.0, 1.0, 0.5, 0.0]);
    }

    #[test]
    fn events_are_drawn_with_their_shares() {
        let mut rng = Rng::new(1);
        let mut counts = [0; 4];
        for _ in 0..20_000 {
            counts[Event::draw(&[0.85, 0.05, 0.05, 0.05], &mut rng) as usize] += 1;
        }
        assert!((16_750..=17_250).contains(&counts[0]), "{counts:?}");
        assert!(
            counts[1..].iter().all(|count| (850..=1150).contains(count)),
            "{counts:?}"
        );
    }

    #[test]
    fn configurations_without_a_launching_event_are_refused() {
        let wrong = [
            LaunchingConfig { gap: 9.0, ..CONFIG },
            LaunchingConfig {
                cells_per_step: 0.0,
                ..CONFIG
            },
            LaunchingConfig {
                speed_level: 9.0,
                ..CONFIG
            },
            LaunchingConfig {
                position_jitter: f32::NAN,
                ..CONFIG
            },
            LaunchingConfig {
                second_start: 19.0,
                ..CONFIG
            },
        ];
        for config in wrong {
            assert!(config.validated().is_err(), "{config:?}");
        }
        assert_eq!(CONFIG.validated(), Ok(CONFIG));
    }
}
