//! A brain that serves a body at the other end of a wire, and the safe stop when the wire is cut.
//!
//! Orders are numbered. The next one is followed; the last one again is answered as before and not
//! followed twice, so that the other side may ask again; any other is dropped and counted.

use cla_core::agent::{Adaptation, AgentConfig, AgentError};
use cla_core::som::Prototypes;
use cla_core::word::ActionId;

use crate::fingerprint::Fingerprint;
use crate::link::{Answer, Dropped, FRAME, Fault, Numbered, Order, Receiver, encode};
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
    /// Waits for some bytes.
    fn hear(&mut self, bytes: &mut [u8]) -> Heard;

    /// Sends bytes; whether they went out.
    fn say(&mut self, bytes: &[u8]) -> bool;
}

/// What came over a wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heard {
    /// So many bytes.
    Bytes(usize),
    /// Nothing for longer than a robot may wait.
    Silence,
    /// The other side is gone for good.
    Gone,
}

/// The part of a body that must work without a brain.
pub trait SafeStop {
    /// Brings everything that moves to rest.
    fn stop(&mut self);
}

/// Why serving ended; the robot stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It was told to.
    Told,
    /// The other side is gone.
    HostGone,
}

/// Serves until told to stop or until the other side is gone; then, and in every silence, the robot
/// is stopped.
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
) -> End {
    let mut receiver = Receiver::new();
    let mut desk = Desk::default();
    let mut bytes = [0; FRAME];
    loop {
        let heard = match wire.hear(&mut bytes) {
            Heard::Bytes(count) => count,
            Heard::Silence => {
                body.stop();
                continue;
            }
            Heard::Gone => {
                body.stop();
                return End::HostGone;
            }
        };
        for &byte in bytes.get(..heard).unwrap_or_default() {
            let Some(order) = receiver.take::<Order>(byte) else {
                continue;
            };
            let Some(answer) = desk.answer(order, brain) else {
                continue;
            };
            let told = desk.last == Some(Order::Stop);
            if told {
                body.stop();
            }
            let mut frame = [0; FRAME];
            let said = encode(&answer, &mut frame).is_some_and(|frame| wire.say(frame));
            if told {
                return End::Told;
            }
            if !said {
                body.stop();
                return End::HostGone;
            }
        }
    }
}

/// Keeps the numbers.
#[derive(Default)]
struct Desk {
    number: u32,
    last: Option<Order>,
    answer: Option<Answer>,
    dropped: Dropped,
}

impl Desk {
    /// The answer to an order; `None` to one that is dropped.
    fn answer<
        const W: usize,
        const H: usize,
        const P: usize,
        const S: usize,
        const Y: usize,
        const B: usize,
        M: Prototypes<W, H>,
    >(
        &mut self,
        order: Result<Numbered<Order>, Fault>,
        brain: &mut Forager<W, H, P, S, Y, B, M>,
    ) -> Option<Numbered<Answer>> {
        let dropped = &mut self.dropped;
        let Numbered { number, message } = match order {
            Ok(order) => order,
            Err(fault) => {
                match fault {
                    Fault::Broken => dropped.broken = dropped.broken.saturating_add(1),
                    Fault::Oversized => dropped.oversized = dropped.oversized.saturating_add(1),
                }
                return None;
            }
        };
        if number == self.number && self.last == Some(message) {
            dropped.repeated = dropped.repeated.saturating_add(1);
            let message = self.answer?;
            return Some(Numbered { number, message });
        }
        if number != self.number.wrapping_add(1) {
            dropped.out_of_turn = dropped.out_of_turn.saturating_add(1);
            return None;
        }
        let answer = follow(message, brain, *dropped);
        self.number = number;
        self.last = Some(message);
        self.answer = Some(answer);
        Some(Numbered {
            number,
            message: answer,
        })
    }
}

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
    dropped: Dropped,
) -> Answer {
    let done = |outcome: Result<(), AgentError>| match outcome {
        Ok(()) => Answer::Done,
        Err(error) => {
            log::refused(&error);
            Answer::Refused
        }
    };
    match order {
        Order::Begin { seed } => match replay::be_born(brain, AgentConfig::FORAGER, seed) {
            Ok(()) => Answer::Done,
            Err(_) => Answer::Refused,
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
                    .map(drop),
            )
        }
        Order::SecondLevel => match brain.reconfigure(AgentConfig::FORAGER_LEVEL2) {
            Ok(()) => Answer::Done,
            Err(_) => Answer::Refused,
        },
        Order::Act => done(brain.act(Adaptation::Reliabilities)),
        Order::Report => Answer::Report {
            dropped,
            schemas: brain.knowledge().schemas().len() as u16,
            knowledge: knowledge(brain),
        },
        Order::Stop => Answer::Done,
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
