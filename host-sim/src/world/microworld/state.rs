//! The physics of the Microworld: where things are and what the ten primitive actions of Table 5.1
//! do (book, 5.4).
//!
//! It draws no random number except for the start.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

/// Cells of the hand's and the eye's reach along one axis.
pub const REACH: u8 = 3;

/// A cell of the reach, counted from its lower left corner (1, 1 in the book is 0, 0 here).
///
/// ```
/// use host_sim::world::microworld::Cell;
/// assert_eq!(Cell { x: 1, y: 0 }.moved(1, 0), Cell { x: 2, y: 0 });
/// assert_eq!(Cell { x: 2, y: 0 }.moved(1, 0), Cell { x: 2, y: 0 }); // the end of the reach
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Cell {
    /// Column, 0 to 2, rightwards.
    pub x: u8,
    /// Row, 0 to 2, forwards.
    pub y: u8,
}

impl Cell {
    /// The mouth: the cell directly in front of the body.
    pub const MOUTH: Self = Self { x: 1, y: 0 };

    /// All nine cells.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..REACH).flat_map(|x| (0..REACH).map(move |y| Self { x, y }))
    }

    /// One step, or none at the end of the reach.
    #[must_use]
    pub fn moved(self, dx: i8, dy: i8) -> Self {
        let step = |at: u8, by: i8| at.saturating_add_signed(by).min(REACH - 1);
        Self {
            x: step(self.x, dx),
            y: step(self.y, dy),
        }
    }
}

/// What the hand is doing.
///
/// ```
/// use host_sim::world::microworld::Hand;
/// assert_ne!(Hand::Closed, Hand::Gripping); // a fist on top of the ball holds nothing
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Hand {
    /// Open.
    Open,
    /// Closed around nothing.
    Closed,
    /// Closed around the ball.
    Gripping,
}

/// Everything there is to know about the Microworld at one moment.
///
/// ```
/// use host_sim::world::microworld::{Cell, Hand, State, action};
/// let at = Cell { x: 1, y: 1 };
/// let state = State { hand_at: at, eye_at: at, ball_at: at, hand: Hand::Open };
/// let held = state.after(action("grasp").unwrap());
/// assert_eq!(held.after(action("handb").unwrap()).ball_at, Cell::MOUTH);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct State {
    /// Where the hand is.
    pub hand_at: Cell,
    /// Where the centre of the visual field is.
    pub eye_at: Cell,
    /// Where the ball is.
    pub ball_at: Cell,
    /// What the hand does.
    pub hand: Hand,
}

impl State {
    /// A start as the book describes it: hand open, hand and ball at different random cells (5.4.1).
    ///
    /// The eye starts at a random place too; the book does not say.
    #[must_use]
    pub fn random(rng: &mut Rng) -> Self {
        let mut cell = || Cell {
            x: rng.below(u32::from(REACH)) as u8,
            y: rng.below(u32::from(REACH)) as u8,
        };
        let (hand_at, eye_at) = (cell(), cell());
        let ball_at = loop {
            let at = cell();
            if at != hand_at {
                break at;
            }
        };
        Self {
            hand_at,
            eye_at,
            ball_at,
            hand: Hand::Open,
        }
    }

    /// The state that a primitive action, given by its index in `ACTIONS`, leads to (Table 5.1).
    ///
    /// An index beyond the table changes nothing.
    #[must_use]
    pub fn after(self, action: usize) -> Self {
        const STEPS: [(i8, i8); 4] = [(0, 1), (0, -1), (1, 0), (-1, 0)];
        let mut next = self;
        match action {
            0..4 => {
                next.hand_at = self.hand_at.moved(STEPS[action].0, STEPS[action].1);
                if self.hand == Hand::Gripping {
                    next.ball_at = next.hand_at;
                }
            }
            4..8 => next.eye_at = self.eye_at.moved(STEPS[action - 4].0, STEPS[action - 4].1),
            8 if self.hand == Hand::Open => {
                let at_ball = self.hand_at == self.ball_at;
                next.hand = if at_ball {
                    Hand::Gripping
                } else {
                    Hand::Closed
                };
            }
            9 => next.hand = Hand::Open,
            _ => {}
        }
        next
    }
}

/// Whether the agent sees its own body.
///
/// ```
/// use host_sim::world::microworld::Body;
/// assert_eq!(Body::default(), Body::Visible);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Body {
    /// It is an object of the visual field; equations 5.12 and 5.21 need that.
    #[default]
    Visible,
    /// Vision passes over it; touch still feels it.
    Hidden,
}

#[cfg(test)]
mod tests {
    use super::{Cell, Hand, State};
    use crate::world::microworld::action;

    fn state(hand: Hand) -> State {
        State {
            hand_at: Cell { x: 1, y: 1 },
            eye_at: Cell { x: 0, y: 0 },
            ball_at: Cell { x: 1, y: 2 },
            hand,
        }
    }

    #[test]
    fn a_fist_on_the_ball_does_not_grip_it_until_it_opens_and_grasps() {
        let run = |state: State, names: &[&str]| {
            names
                .iter()
                .fold(state, |state, name| state.after(action(name).unwrap()))
        };
        let fist = run(state(Hand::Closed), &["handf", "grasp"]);
        assert_eq!((fist.hand_at, fist.hand), (fist.ball_at, Hand::Closed));
        let held = run(fist, &["ungrasp", "grasp", "handl"]);
        assert_eq!(
            (held.hand, held.ball_at),
            (Hand::Gripping, Cell { x: 0, y: 2 })
        );
        let dropped = run(held, &["ungrasp", "handr"]);
        assert_eq!(dropped.ball_at, Cell { x: 0, y: 2 });
    }

    #[test]
    fn hand_and_eye_stop_at_the_ends_of_their_reach() {
        let mut it = state(Hand::Open);
        for _ in 0..5 {
            it = it
                .after(action("eyer").unwrap())
                .after(action("handb").unwrap());
        }
        assert_eq!((it.eye_at.x, it.hand_at.y), (2, 0));
    }
}
