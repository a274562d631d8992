//! A goal that is pursued: for how long, and what has come of it.

use crate::snapshot::{Flip, Reader, Stored, Writer, stored};
use crate::word::{ItemStates, SignedItems};

/// Where the pursuit of a goal stands.
///
/// In the field: the execution of an option (Sutton, Precup and Singh 1999).
///
/// ```
/// use cla_core::reason::Pursuit;
/// assert!(Pursuit::Underway { left: 3 }.is_underway());
/// assert!(!Pursuit::Reached.is_underway());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Pursuit {
    /// Nothing is pursued.
    Nothing,
    /// Not yet; so many actions are left.
    Underway {
        /// Actions that may still be done, at least 1.
        left: u16,
    },
    /// The goal was perceived to hold.
    Reached,
    /// All actions are done, and the goal does not hold or nobody knows.
    TimedOut,
}

impl Pursuit {
    /// Whether it goes on.
    #[must_use]
    pub const fn is_underway(self) -> bool {
        matches!(self, Self::Underway { .. })
    }
}

/// How far a goal is.
///
/// ```
/// assert_ne!(cla_core::reason::Way::Unknown, cla_core::reason::Way::Actions(3));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Way {
    /// It holds in so many actions, if all comes as foreseen.
    Actions(u8),
    /// No way is known, yet or at all.
    Unknown,
}

/// A goal and what is left of its time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim<const WORDS: usize> {
    pub(super) goal: SignedItems<WORDS>,
    pub(super) state: Pursuit,
}

impl<const WORDS: usize> Aim<WORDS> {
    pub(super) const NONE: Self = Self {
        goal: SignedItems::EMPTY,
        state: Pursuit::Nothing,
    };

    /// Pursued for at most `limit` actions, from a moment that is perceived so.
    pub(super) fn begin(goal: SignedItems<WORDS>, limit: u16, now: &ItemStates<WORDS>) -> Self {
        let mut aim = Self {
            goal,
            state: Pursuit::Underway { left: limit },
        };
        aim.look(now, limit);
        aim
    }

    fn look(&mut self, now: &ItemStates<WORDS>, left: u16) {
        self.state = if self.goal.truth(now) == Some(true) {
            Pursuit::Reached
        } else if left == 0 {
            Pursuit::TimedOut
        } else {
            Pursuit::Underway { left }
        };
    }

    /// An action was done.
    pub(super) fn count(&mut self, now: &ItemStates<WORDS>) {
        if let Pursuit::Underway { left } = self.state {
            self.look(now, left.saturating_sub(1));
        }
    }

    /// The goal, while it is pursued.
    pub(super) fn goal(&self) -> Option<&SignedItems<WORDS>> {
        self.state.is_underway().then_some(&self.goal)
    }
}

stored! { impl[const WORDS: usize] Aim<WORDS> { goal, state } }

impl Stored for Pursuit {
    const BLANK: Self = Self::Nothing;

    fn store(&self, to: &mut Writer<'_>) {
        let (kind, left) = match *self {
            Self::Nothing => (0_u8, 0),
            Self::Underway { left } => (1, left),
            Self::Reached => (2, 0),
            Self::TimedOut => (3, 0),
        };
        (kind, left).store(to);
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        let (mut kind, mut left) = (0_u8, 0_u16);
        kind.restore(from);
        left.restore(from);
        *self = match kind {
            0 => Self::Nothing,
            1 => Self::Underway { left },
            2 => Self::Reached,
            _ => Self::TimedOut,
        };
        from.require(kind <= 3);
    }

    fn flip(&mut self, by: &mut Flip) {
        let kind = by.field(8);
        let left = by.field(16);
        *self = match (*self, kind, left) {
            (Self::Underway { left }, None, Some(bit)) => Self::Underway {
                left: left ^ 1_u16.wrapping_shl(bit),
            },
            (Self::Nothing, Some(0), _) => Self::Underway { left: 0 },
            (Self::Underway { .. }, Some(0), _) => Self::Nothing,
            (Self::Reached, Some(0), _) => Self::TimedOut,
            (Self::TimedOut, Some(0), _) => Self::Reached,
            (same, _, _) => same,
        };
    }
}
