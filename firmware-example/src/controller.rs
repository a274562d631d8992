//! A brain that serves a body at the other end of a wire, and the safe stop when orders stay away.
//!
//! Which orders are followed and when the robot stops is decided by [`Desk`]; here its decisions meet
//! a brain, a wire and a clock.

use cla_core::agent::{Adaptation, AgentConfig, AgentError, Stage};
use cla_core::som::Prototypes;
use cla_core::word::ActionId;

use crate::fingerprint::Fingerprint;
use crate::link::{Answer, Desk, FRAME, Life, Order, Receiver, Refusal, Robot, Seal, encode};
use crate::replay::{self, Forager};
use crate::trace::from_bits;

/// What is worth a line in the log of a robot; nothing without the feature `defmt`.
mod log {
    use cla_core::agent::{AgentError, Choice, Lesson};

    pub(super) fn chosen(_choice: &Choice) {
        #[cfg(feature = "defmt")]
        defmt::debug!("{}", _choice);
    }

    pub(super) fn learned(_lesson: &Lesson) {
        #[cfg(feature = "defmt")]
        defmt::debug!("{}", _lesson);
    }

    pub(super) fn refused(_error: &AgentError) {
        #[cfg(feature = "defmt")]
        defmt::warn!("{}", _error);
    }
}

/// Bytes to and from the other side.
pub trait Wire {
    /// Takes what bytes there are; waits for the first one longer than bytes of a frame lie apart,
    /// and shorter than a robot may wait for its stop: a few milliseconds.
    fn hear(&mut self, bytes: &mut [u8]) -> Heard;

    /// Sends bytes; whether they went out.
    fn say(&mut self, bytes: &[u8]) -> bool;
}

/// What came over a wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heard {
    /// So many bytes.
    Bytes(usize),
    /// Nothing for now.
    Pause,
    /// The other side is gone for good.
    Gone,
}

/// The part of a body that must work without a brain.
pub trait SafeStop {
    /// Milliseconds since some beginning, modulo 2³².
    fn now(&mut self) -> u32;

    /// Brings everything that moves to rest.
    fn stop(&mut self);
}

/// Where a brain is kept when that is ordered, and by a policy.
pub trait Keep<Brain> {
    /// Looks it through and keeps it under the name of its life; the number of the generation, `None`
    /// where it could not be. Where something is lost of it, what was last kept of that life is brought
    /// back into it.
    fn keep(&mut self, brain: &mut Brain, life: Life) -> Option<u32>;

    /// Something was learned: whether it was worth having, and whether an own action is over with it.
    /// Answers whether the brain is to be kept now; without a policy that is never so.
    fn is_due(&mut self, _captured: bool, _over: bool) -> bool {
        false
    }
}

/// A part that keeps nothing.
impl<Brain> Keep<Brain> for () {
    fn keep(&mut self, _: &mut Brain, _: Life) -> Option<u32> {
        None
    }
}

/// How orders are taken.
#[derive(Clone, Copy, Debug)]
pub struct Service {
    /// Another number after every reset: from a source of chance, or a counter that outlives it.
    pub fresh: u64,
    /// Milliseconds that the robot may go on without an order that is followed.
    pub patience: u32,
    /// Who lives here already; [`Life::UNBORN`] but for a brain that was brought back.
    pub life: Life,
    /// How frames are sealed, in both directions.
    pub seal: Seal,
}

/// Why serving ended; the robot stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It was told to.
    Told,
    /// The other side is gone.
    HostGone,
}

/// Serves until told to stop or until the other side is gone; then, at the beginning, and whenever
/// no order was followed for too long, the robot is stopped. So it is before the brain is kept: when that
/// is ordered, and after a [`Order::Learn`] with which it is due.
pub fn serve<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    wire: &mut impl Wire,
    body: &mut impl SafeStop,
    kept: &mut impl Keep<Forager<W, H, P, S, Y, B, M>>,
    service: Service,
) -> End {
    let mut robot = Whole {
        brain,
        body,
        kept,
        life: service.life,
    };
    attend(&mut robot, wire, service)
}

/// The same for any robot: what a wire brings is put together, followed as [`Desk`] says, and answered.
pub fn attend(robot: &mut impl Robot, wire: &mut impl Wire, service: Service) -> End {
    let mut receiver = Receiver::new(service.seal);
    let mut desk = Desk::new(service.fresh, service.patience, service.life);
    let mut bytes = [0; FRAME];
    robot.stop();
    loop {
        let heard = match wire.hear(&mut bytes) {
            Heard::Bytes(count) => count,
            Heard::Pause => {
                if let Some(fault) = receiver.pause() {
                    desk.drop(fault);
                }
                0
            }
            Heard::Gone => {
                desk.close(robot);
                return End::HostGone;
            }
        };
        // Whatever came: what counts are orders.
        desk.tick(robot);
        for &byte in bytes.get(..heard).unwrap_or_default() {
            let call = match receiver.take(byte) {
                None => continue,
                Some(Ok(call)) => call,
                Some(Err(fault)) => {
                    desk.drop(fault);
                    continue;
                }
            };
            let Some(reply) = desk.hear(call, robot) else {
                continue;
            };
            let mut frame = [0; FRAME];
            let frame = encode(&reply, receiver.seal(), &mut frame);
            let said = frame.is_some_and(|frame| wire.say(frame));
            if desk.is_told() {
                return End::Told;
            }
            if !said {
                desk.close(robot);
                return End::HostGone;
            }
        }
    }
}

/// A body and its brain, and where that is kept.
struct Whole<'a, Brain, Body, Kept> {
    brain: &'a mut Brain,
    body: &'a mut Body,
    kept: &'a mut Kept,
    /// Who lives here, as the desk knows it.
    life: Life,
}

impl<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
    Body: SafeStop,
    Kept: Keep<Forager<W, H, P, S, Y, B, M>>,
> Robot for Whole<'_, Forager<W, H, P, S, Y, B, M>, Body, Kept>
{
    fn now(&mut self) -> u32 {
        self.body.now()
    }

    fn stop(&mut self) {
        self.body.stop();
    }

    fn follow(&mut self, order: Order) -> Answer {
        let mut reward = 0.0;
        let answer = follow(order, self.brain, &mut reward);
        match order {
            Order::Begin { name, .. } if answer == Answer::Done => self.life = name,
            Order::Learn { .. } | Order::Observe { .. } if answer == Answer::Done => {
                // Between a choice and what it led to a save would cut the action off.
                let over = matches!(order, Order::Learn { .. });
                if self.kept.is_due(reward > 0.0, over) {
                    self.save(self.life);
                }
            }
            _ => {}
        }
        answer
    }

    fn known(&mut self) -> (u16, u64) {
        let schemas = self.brain.knowledge().schemas().len();
        (schemas as u16, knowledge(self.brain))
    }

    fn save(&mut self, life: Life) -> Option<u32> {
        self.body.stop();
        self.kept.keep(self.brain, life)
    }
}

/// Does what an order says; `reward` becomes that of what was learned.
fn follow<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    order: Order,
    brain: &mut Forager<W, H, P, S, Y, B, M>,
    reward: &mut f32,
) -> Answer {
    const REFUSED: Answer = Answer::Refused(Refusal::Brain);
    let done = |outcome: Result<(), AgentError>| match outcome {
        Ok(()) => Answer::Done,
        Err(error) => {
            log::refused(&error);
            REFUSED
        }
    };
    match order {
        Order::Begin { seed, .. } => match replay::be_born(brain, AgentConfig::FORAGER, seed) {
            Ok(()) => Answer::Done,
            Err(_) => REFUSED,
        },
        Order::Choose { now } => match brain.choose(&from_bits(now)) {
            Ok(choice) => {
                log::chosen(&choice);
                Answer::Chosen {
                    action: choice.action.0 as u8,
                    value: choice.value.to_bits(),
                }
            }
            Err(error) => done(Err(error)),
        },
        Order::Learn { now } => done(brain.learn(&from_bits(now)).map(|it| {
            log::learned(&it);
            *reward = it.reward;
        })),
        Order::Observe {
            before,
            action,
            after,
        } => {
            let action = ActionId(action.into());
            done(
                brain
                    .observe(&from_bits(before), action, &from_bits(after))
                    .map(|it| *reward = it.reward),
            )
        }
        // An unborn brain would take a configuration and stay unborn.
        Order::SecondLevel if brain.stage() == Stage::Unborn => REFUSED,
        Order::SecondLevel => match brain.reconfigure(AgentConfig::FORAGER_LEVEL2) {
            Ok(()) => Answer::Done,
            Err(_) => REFUSED,
        },
        Order::Act => done(brain.act(Adaptation::Reliabilities)),
        // Those are the desk's.
        Order::Report | Order::Save | Order::Stop => REFUSED,
    }
}

/// A hash of all schemas with their counts and of all beliefs.
pub fn knowledge<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &Forager<W, H, P, S, Y, B, M>,
) -> u64 {
    let mut print = Fingerprint::new();
    replay::add_schemas(&mut print, brain);
    replay::add_beliefs(&mut print, brain);
    print.value()
}
