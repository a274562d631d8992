//! When a robot keeps its brain in flash, and a life that goes on after every reset.
//!
//! What is saved was looked through before; a brain in which something is lost is no life to go on
//! with, and the last one that was saved is brought back.
//! The life is the recording, over and over, so that its brain at any tick is known: however often the
//! part was reset in between, it must be the brain of a part that never was.

use core::ops::{ControlFlow, Range};

use cla_core::agent::{AgentConfig, AgentError};
use cla_core::check::ConfigError;
use cla_core::flash::{ResumeError, Resumed, Saved};
use cla_core::som::Prototypes;
use embedded_storage::nor_flash::NorFlash;

use crate::controller::Keep;
use crate::link::Life;
use crate::profile::{Brain, VALUES};
use crate::replay::Forager;
use crate::shelf::{Audited, Kept, NotSaved, Shelf};
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

    /// After so many captures, and after so many minutes of own actions, of which each takes so many
    /// milliseconds (0 is taken for 1): never later, and not before one action is over. 0 is never.
    #[must_use]
    pub const fn every(captures: u32, minutes: u32, tick_ms: u32) -> Self {
        let tick_ms = if tick_ms == 0 { 1 } else { tick_ms };
        let ticks = minutes as u64 * 60_000 / tick_ms as u64;
        let ticks = match ticks {
            0 if minutes > 0 => 1,
            many if many > u32::MAX as u64 => u32::MAX,
            many => many as u32,
        };
        Self { captures, ticks }
    }
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
    /// A life goes on: at boot, or after what was lost.
    Resumed(Resumed),
    /// There is no life to go on with, for this reason: a new one begins. Where a brain lies there that
    /// was refused, nothing is saved over it.
    Born(ResumeError),
    /// The brain is being saved at this tick.
    Saving(Cause, u32),
    /// So many entries of it were mended or dropped before.
    Mended(u32),
    /// It was saved.
    Saved(Saved),
    /// It was not; the life goes on.
    Refused(NotSaved<E>),
    /// The part of that name is lost and cannot be mended: the last life is brought back, and what was
    /// learned since is gone.
    Lost(&'static str),
    /// Nothing of this life is left to be brought back, for this reason.
    Gone(ResumeError),
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

/// Resumes the newest life in the store, or begins one; the own actions that it has behind it.
///
/// # Errors
/// [`End`] when the brain cannot be born.
pub fn begin<F: NorFlash, const SLOTS: usize>(
    brain: &mut Brain,
    shelf: &mut Shelf<F, SLOTS>,
    mut say: impl FnMut(Event<F::Error>),
) -> Result<u32, End> {
    match shelf.resume(brain) {
        Ok(resumed) => {
            say(Event::Resumed(resumed));
            Ok(resumed.tick)
        }
        Err(nothing) => {
            say(Event::Born(nothing));
            be_born(brain).map_err(End::Config)?;
            Ok(0)
        }
    }
}

/// Resumes the newest life in the store, or begins one, and lives until `end` own actions, saving when
/// it is due; `say` hears of it, and `power_failing` is asked after every action.
///
/// # Errors
/// [`End`] when the brain refuses.
pub fn live<F: NorFlash, const SLOTS: usize>(
    brain: &mut Brain,
    shelf: &mut Shelf<F, SLOTS>,
    keeper: &mut Keeper,
    end: u32,
    power_failing: impl FnMut() -> bool,
    mut say: impl FnMut(Event<F::Error>),
) -> Result<(), End> {
    let from = begin(brain, shelf, &mut say)?;
    go_on(brain, shelf, keeper, from..end, power_failing, say)
}

/// As [`live`], from a brain that has lived already.
///
/// Where the audit before a save finds something lost, the newest life in the store goes on in the place
/// of this one, or another begins.
///
/// # Errors
/// [`End`] when the brain refuses.
pub fn go_on<F: NorFlash, const SLOTS: usize>(
    brain: &mut Brain,
    shelf: &mut Shelf<F, SLOTS>,
    keeper: &mut Keeper,
    actions: Range<u32>,
    mut power_failing: impl FnMut() -> bool,
    mut say: impl FnMut(Event<F::Error>),
) -> Result<(), End> {
    let Range { mut start, end } = actions;
    loop {
        let lived = walk(brain, start, end, |brain, tick, moment| {
            match moment {
                Moment::Learned { captured: true } => keeper.captured(),
                Moment::Learned { captured: false } => {}
                Moment::Over => {
                    keeper.acted();
                    if let Some(cause) = keeper.due(power_failing()) {
                        say(Event::Saving(cause, tick));
                        keeper.saved();
                        let kept = shelf.save(brain, tick);
                        return told(kept, &mut say);
                    }
                }
            }
            ControlFlow::Continue(())
        });
        match lived.map_err(End::Agent)? {
            ControlFlow::Continue(()) => return Ok(()),
            ControlFlow::Break(()) => start = begin(brain, shelf, &mut say)?,
        }
    }
}

/// Says what became of a save; breaks off where something is lost of the brain.
fn told<E>(kept: Result<Kept, NotSaved<E>>, mut say: impl FnMut(Event<E>)) -> ControlFlow<()> {
    match kept {
        Ok(Kept { mended, saved }) => {
            if mended > 0 {
                say(Event::Mended(mended));
            }
            say(Event::Saved(saved));
        }
        Err(NotSaved::Lost(part)) => {
            say(Event::Lost(part));
            return ControlFlow::Break(());
        }
        Err(refused) => say(Event::Refused(refused)),
    }
    ControlFlow::Continue(())
}

/// A shelf on which the brain of a controller is kept by a policy, beside on command.
pub struct ByPolicy<F, P, S, const SLOTS: usize> {
    shelf: Shelf<F, SLOTS>,
    keeper: Keeper,
    power_failing: P,
    say: S,
}

impl<F: NorFlash, P: FnMut() -> bool, S: FnMut(Event<F::Error>), const SLOTS: usize>
    ByPolicy<F, P, S, SLOTS>
{
    /// On a shelf that was looked into ([`Shelf::resume`]); `power_failing` is asked after every action,
    /// and `say` hears what becomes of the brain.
    #[must_use]
    pub const fn new(shelf: Shelf<F, SLOTS>, policy: Policy, power_failing: P, say: S) -> Self {
        Self {
            shelf,
            keeper: Keeper::new(policy),
            power_failing,
            say,
        }
    }
}

impl<F, P, S, B, const SLOTS: usize> Keep<B> for ByPolicy<F, P, S, SLOTS>
where
    F: NorFlash,
    P: FnMut() -> bool,
    S: FnMut(Event<F::Error>),
    B: Audited,
{
    fn is_due(&mut self, captured: bool, over: bool) -> bool {
        if captured {
            self.keeper.captured();
        }
        if over {
            self.keeper.acted();
        }
        // A robot does not stand for a save that is refused.
        over && self.shelf.is_free() && self.keeper.due((self.power_failing)()).is_some()
    }

    fn keep(&mut self, brain: &mut B, life: Life) -> Option<u32> {
        self.keeper.saved();
        let kept = self.shelf.save(brain, life.0);
        let generation = kept.as_ref().ok().map(|it| it.saved.generation);
        if told(kept, &mut self.say).is_break() {
            (self.say)(match self.shelf.bring_back(brain, life) {
                Ok(resumed) => Event::Resumed(resumed),
                Err(nothing) => Event::Gone(nothing),
            });
        }
        generation
    }
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
    let lived = walk(brain, from, end, |brain, tick, moment| {
        at(brain, tick, moment);
        ControlFlow::Continue(())
    });
    lived.map(drop)
}

/// The same, broken off where `at` says so.
fn walk<
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
    mut at: impl FnMut(&mut Forager<W, H, P, S, Y, B, M>, u32, Moment) -> ControlFlow<()>,
) -> Result<ControlFlow<()>, AgentError> {
    let mut tick = from - from % trace::ACTIONS;
    while tick < end {
        for step in trace::steps(trace::ACTIONS) {
            if !step.reflex {
                if tick > from && at(brain, tick, Moment::Over).is_break() {
                    return Ok(ControlFlow::Break(()));
                }
                if tick == end {
                    return Ok(ControlFlow::Continue(()));
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
            if at(brain, tick, Moment::Learned { captured }).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
    }
    Ok(at(brain, tick, Moment::Over))
}
