//! Ticks and actions: when an action ends, when its successor is due, and what is done when the brain
//! is late.
//!
//! The control task ticks; an action lasts so many ticks. At the end of an action the percept goes to
//! the brain, and its answer is due at the next tick: until then the last action goes on. A brain that
//! has not answered has missed a tick; then the action is held or the safe one takes its place, and
//! its answer is followed when it comes. That action has begun in another moment than the one it was
//! chosen for, and is learned from as somebody else's.

use crate::robot::cart::{Action, SAFE};

/// What a robot does while its brain is late.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhenLate {
    /// It goes on with the last action.
    Hold,
    /// It does the safe one.
    Safe,
}

/// What the control task does after a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// The action begins.
    Began(Action),
    /// The action goes on.
    On(Action),
    /// The action is over: the percept goes to the brain, and until it answers this is done.
    Ended {
        /// What was done.
        done: Action,
        /// Whether it had begun later than it was due.
        late: bool,
    },
}

impl Turn {
    /// What is done in this tick.
    #[must_use]
    pub const fn action(self) -> Action {
        match self {
            Self::Began(action) | Self::On(action) => action,
            Self::Ended { done, .. } => done,
        }
    }
}

/// Where an action is.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    ticks: u16,
    when_late: WhenLate,
    done: Action,
    /// Ticks of the action so far.
    at: u16,
    /// Whether the brain was asked and has not answered.
    asked: bool,
    /// Whether the action began later than it was due, or will.
    late: bool,
    missed: u32,
    /// Ticks since the brain answered, for the watchdog.
    silent: u32,
}

impl Pace {
    /// An action of so many ticks (at least 2: one of them for the brain); the first is the safe one.
    #[must_use]
    pub const fn new(ticks: u16, when_late: WhenLate) -> Self {
        Self {
            ticks: if ticks < 2 { 2 } else { ticks },
            when_late,
            done: SAFE,
            at: 0,
            asked: false,
            late: false,
            missed: 0,
            silent: 0,
        }
    }

    /// A tick; `answer` is what the brain has decided since the last one.
    pub fn tick(&mut self, answer: Option<Action>) -> Turn {
        match answer {
            // An answer that nobody asked for is none.
            Some(action) if self.asked => {
                self.asked = false;
                self.done = action;
                self.at = 0;
                self.silent = 0;
            }
            _ => self.silent = self.silent.saturating_add(1),
        }
        if self.asked {
            self.missed = self.missed.saturating_add(1);
            self.late = true;
            if self.when_late == WhenLate::Safe {
                self.done = SAFE;
            }
            return Turn::On(self.done);
        }
        self.at += 1;
        if self.at == 1 {
            return Turn::Began(self.done);
        }
        if self.at < self.ticks {
            return Turn::On(self.done);
        }
        self.at = 0;
        self.asked = true;
        Turn::Ended {
            done: self.done,
            late: core::mem::take(&mut self.late),
        }
    }

    /// Ticks in which the brain was late.
    #[must_use]
    pub const fn missed(&self) -> u32 {
        self.missed
    }

    /// Whether the brain has answered within the last `ticks`; a watchdog is fed only then.
    #[must_use]
    pub const fn lives(&self, ticks: u32) -> bool {
        self.silent < ticks
    }
}
