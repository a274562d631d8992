//! When a robot keeps its brain in flash, and a life that goes on after every reset.
//!
//! The life is the recording, over and over, so that its brain at any tick is known: however often the
//! part was reset in between, it must be the brain of a part that never was.

use cla_core::agent::{AgentConfig, AgentError};
use cla_core::check::ConfigError;
use cla_core::flash::{ResumeError, Resumed, Saved};
use cla_core::som::Prototypes;
use embedded_storage::nor_flash::NorFlash;

use crate::profile::{Brain, VALUES};
use crate::replay::Forager;
use crate::shelf::{NotSaved, Shelf};
use crate::trace;

/// How often a brain is saved; what was learned since is what a power cut costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Policy {
    /// After so many captures (rewards); 0 is never.
    pub captures: u32,
    /// After so many own actions; 0 is never.
    pub ticks: u32,
}

impl Policy {
    /// The emulated board's.
    pub const EMULATED: Self = Self {
        captures: 20,
        ticks: 100,
    };
}

/// Why a brain is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Enough was captured.
    Captures,
    /// Enough was done.
    Ticks,
    /// The supply fails.
    PowerFailing,
}

/// Keeps to a policy.
#[derive(Clone, Copy, Debug)]
pub struct Keeper {
    policy: Policy,
    captures: u32,
    ticks: u32,
}

impl Keeper {
    /// Nothing was lived since the last save.
    #[must_use]
    pub const fn new(policy: Policy) -> Self {
        Self {
            policy,
            captures: 0,
            ticks: 0,
        }
    }

    /// An own action is over.
    pub fn acted(&mut self) {
        self.ticks = self.ticks.saturating_add(1);
    }

    /// Something was worth having.
    pub fn captured(&mut self) {
        self.captures = self.captures.saturating_add(1);
    }

    /// Why it is time to save; `None` while it is not. A failing supply does not wait for the policy,
    /// but is no reason to save twice.
    #[must_use]
    pub fn due(&self, power_failing: bool) -> Option<Cause> {
        let enough = |count: u32, limit: u32| limit > 0 && count >= limit;
        if power_failing && self.ticks > 0 {
            Some(Cause::PowerFailing)
        } else if enough(self.captures, self.policy.captures) {
            Some(Cause::Captures)
        } else if enough(self.ticks, self.policy.ticks) {
            Some(Cause::Ticks)
        } else {
            None
        }
    }

    /// It was saved, or could not be: the policy begins anew.
    pub fn saved(&mut self) {
        *self = Self::new(self.policy);
    }
}

/// What is worth a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event<E> {
    /// A life goes on.
    Resumed(Resumed),
    /// There is no life to go on with, for this reason: a new one begins. Where a brain lies there that
    /// was refused, nothing is saved over it.
    Born(ResumeError),
    /// The brain is being saved at this tick.
    Saving(Cause, u32),
    /// It was saved.
    Saved(Saved),
    /// It was not; the life goes on.
    Refused(NotSaved<E>),
}

/// Why a life ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// The brain could not be born.
    Config(ConfigError),
    /// The brain refused a step.
    Agent(AgentError),
}

/// Begins the life that is kept.
///
/// # Errors
/// [`ConfigError`] for a configuration that cannot work, which it is not.
pub fn be_born(brain: &mut Brain) -> Result<(), ConfigError> {
    brain.be_born(AgentConfig::RESILIENT_LEVEL2, VALUES, trace::SEED)
}

/// Resumes the newest life in the store, or begins one, and lives until `end` own actions, saving when
/// it is due; `say` hears of it, and `power_failing` is asked before every action.
///
/// # Errors
/// [`End`] when the brain refuses.
pub fn live<F: NorFlash, const SLOTS: usize>(
    brain: &mut Brain,
    shelf: &mut Shelf<F, SLOTS>,
    keeper: &mut Keeper,
    end: u32,
    mut power_failing: impl FnMut() -> bool,
    mut say: impl FnMut(Event<F::Error>),
) -> Result<(), End> {
    let from = match shelf.resume(brain) {
        Ok(resumed) => {
            say(Event::Resumed(resumed));
            resumed.tick
        }
        Err(nothing) => {
            say(Event::Born(nothing));
            be_born(brain).map_err(End::Config)?;
            0
        }
    };
    along(brain, from, end, |brain, tick, moment| match moment {
        Moment::Learned { captured } => {
            if captured {
                keeper.captured();
            }
        }
        Moment::Over => {
            keeper.acted();
            if let Some(cause) = keeper.due(power_failing()) {
                say(Event::Saving(cause, tick));
                match shelf.save(brain, tick) {
                    Ok(saved) => say(Event::Saved(saved)),
                    Err(refused) => say(Event::Refused(refused)),
                }
                keeper.saved();
            }
        }
    })
    .map_err(End::Agent)
}

/// A moment along the recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    /// Something was learned from an action or a reflex.
    Learned {
        /// Whether it was worth having.
        captured: bool,
    },
    /// An own action and the reflexes after it are over.
    Over,
}

/// Lives the recording, over and over, from one own action to another; `at` hears of it with the
/// number of own actions so far.
///
/// # Errors
/// [`AgentError`] when the brain refuses.
pub fn along<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    from: u32,
    end: u32,
    mut at: impl FnMut(&Forager<W, H, P, S, Y, B, M>, u32, Moment),
) -> Result<(), AgentError> {
    let mut tick = from - from % trace::ACTIONS;
    while tick < end {
        for step in trace::steps(trace::ACTIONS) {
            if !step.reflex {
                if tick > from {
                    at(brain, tick, Moment::Over);
                }
                if tick == end {
                    return Ok(());
                }
                tick += 1;
            }
            // The reflexes of the last action before belong to it.
            if tick <= from {
                continue;
            }
            let lesson = if step.reflex {
                brain.observe(&step.before, step.action, &step.after)?
            } else {
                brain.choose(&step.before)?;
                brain.redirect(step.action)?;
                brain.learn(&step.after)?
            };
            let captured = lesson.reward > 0.0;
            at(brain, tick, Moment::Learned { captured });
        }
    }
    at(brain, tick, Moment::Over);
    Ok(())
}
