//! The brain's side of the wire as a machine: which orders are followed, and when the robot stops.
//!
//! It does no input and output and knows no brain; time, the stop and what an order means are a
//! [`Robot`]'s.
//!
//! - A hello is answered with a session that nobody has used; the first order in it opens it, if it
//!   comes in time.
//!   Until then a session that was open before goes on, unless the hello gives up this very one: who
//!   repeats an old hello disturbs nobody.
//! - In a session the next number is followed, the last order again is answered as before and not
//!   done twice, and all others are dropped.
//! - The robot is stopped when no order was *followed* for too long, whatever else comes over the
//!   wire; with the stop the session is over, and its orders are refused.

use cla_core::num::Rng;

use super::frame::Fault;
use super::message::{Answer, Call, Dropped, Life, Order, Refusal, Reply, Session, Turn, VERSION};

/// What the machine needs of a robot.
pub trait Robot {
    /// Milliseconds since some beginning, modulo 2³².
    fn now(&mut self) -> u32;

    /// Brings everything that moves to rest.
    fn stop(&mut self);

    /// Does what an order says; never [`Order::Report`], [`Order::Save`] or [`Order::Stop`].
    fn follow(&mut self, order: Order) -> Answer;

    /// Schemas known, and a hash of all schemas with their counts and of all beliefs.
    fn known(&mut self) -> (u16, u64);

    /// Brings everything that moves to rest, because nobody looks at the clock for as long as a save
    /// takes, and keeps the brain under the name of its life; the number of the generation, `None`
    /// where it could not be kept.
    fn save(&mut self, life: Life) -> Option<u32>;
}

/// The machine.
#[derive(Clone, Debug)]
pub struct Desk {
    names: Rng,
    patience: u32,
    life: Life,
    /// The order that was followed last.
    last: Turn,
    open: Option<Open>,
    offered: Option<Offer>,
    told: bool,
    dropped: Dropped,
    expired: u32,
}

/// A session that is open.
#[derive(Clone, Copy, Debug)]
struct Open {
    nonce: u64,
    /// The last order and its answer.
    turn: Turn,
    order: Order,
    answer: Answer,
    /// When an order was followed last.
    since: u32,
    /// Whether a choice waits for what it led to.
    chosen: bool,
}

/// A session that its first order will open.
#[derive(Clone, Copy, Debug)]
struct Offer {
    nonce: u64,
    session: Session,
    at: u32,
}

impl Desk {
    /// Nobody has called yet, and the robot stands.
    ///
    /// `fresh` names the sessions and must be another number after every reset: from a source of
    /// chance, or a counter that outlives it.
    /// `patience`: milliseconds that the robot may go on without an order.
    /// `life`: who lives here, where a brain was brought back; else [`Life::UNBORN`].
    #[must_use]
    pub fn new(fresh: u64, patience: u32, life: Life) -> Self {
        let mut names = Rng::stream(fresh, 15);
        // No order yet, of a session that nobody knows: after a reset nobody is told that what it
        // ordered before was not followed.
        let last = Turn {
            session: name(&mut names),
            number: 0,
        };
        Self {
            names,
            patience,
            life,
            last,
            open: None,
            offered: None,
            told: false,
            dropped: Dropped {
                broken: 0,
                oversized: 0,
                out_of_turn: 0,
                repeated: 0,
                strange: 0,
            },
            expired: 0,
        }
    }

    /// Whether a session is open: otherwise the robot stands.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Whether it was told to end.
    #[must_use]
    pub const fn is_told(&self) -> bool {
        self.told
    }

    /// Who lives here.
    #[must_use]
    pub const fn life(&self) -> Life {
        self.life
    }

    /// Looks at the clock; to be asked at least every few milliseconds, whatever comes over the wire.
    pub fn tick(&mut self, robot: &mut impl Robot) {
        let Some(open) = &self.open else {
            return;
        };
        if robot.now().wrapping_sub(open.since) >= self.patience {
            self.expired = self.expired.saturating_add(1);
            self.close(robot);
        }
    }

    /// Stops the robot and ends the session, if any.
    pub fn close(&mut self, robot: &mut impl Robot) {
        self.open = None;
        robot.stop();
    }

    /// Counts a frame that came to nothing.
    pub fn drop(&mut self, fault: Fault) {
        let counter = match fault {
            Fault::Broken => &mut self.dropped.broken,
            Fault::Oversized => &mut self.dropped.oversized,
        };
        *counter = counter.saturating_add(1);
    }

    /// Hears what was said; the reply, if any.
    pub fn hear(&mut self, call: Call, robot: &mut impl Robot) -> Option<Reply> {
        self.tick(robot);
        match call {
            Call::Hello { version, nonce, .. } if version != VERSION => {
                let version = VERSION;
                Some(Reply::OtherVersion { version, nonce })
            }
            Call::Hello { nonce, after, .. } => self.greet(nonce, after, robot),
            Call::Order { turn, order } => self.order(turn, order, robot),
        }
    }

    fn greet(&mut self, nonce: u64, after: Session, robot: &mut impl Robot) -> Option<Reply> {
        match &self.open {
            Some(open) if open.nonce == nonce => {
                // An echo of the handshake of the session that is open.
                self.dropped.out_of_turn = self.dropped.out_of_turn.saturating_add(1);
                return None;
            }
            // What is said of the last order below holds for good.
            Some(open) if open.turn.session == after => self.close(robot),
            _ => {}
        }
        let at = robot.now();
        let offer = match self.offer(at) {
            Some(offer) if offer.nonce == nonce => offer,
            _ => Offer {
                nonce,
                session: name(&mut self.names),
                at,
            },
        };
        self.offered = Some(offer);
        Some(Reply::Welcome {
            nonce,
            session: offer.session,
            life: self.life,
            last: self.last,
        })
    }

    /// The session that was offered, unless that was too long ago.
    fn offer(&self, now: u32) -> Option<Offer> {
        self.offered
            .filter(|offer| now.wrapping_sub(offer.at) < self.patience)
    }

    fn order(&mut self, turn: Turn, order: Order, robot: &mut impl Robot) -> Option<Reply> {
        let answer = match self.open {
            Some(open) if open.turn.session == turn.session => {
                if turn == open.turn && order == open.order {
                    self.dropped.repeated = self.dropped.repeated.saturating_add(1);
                    open.answer
                } else if Some(turn.number) == open.turn.number.checked_add(1) {
                    self.follow(Some(open), open.nonce, turn, order, robot)
                } else {
                    self.dropped.out_of_turn = self.dropped.out_of_turn.saturating_add(1);
                    return None;
                }
            }
            before => match self.offer(robot.now()) {
                Some(offer) if offer.session == turn.session && turn.number == 1 => {
                    self.offered = None;
                    if before.is_some() {
                        self.close(robot);
                    }
                    self.follow(None, offer.nonce, turn, order, robot)
                }
                _ => {
                    self.dropped.strange = self.dropped.strange.saturating_add(1);
                    return Some(Reply::Closed { turn });
                }
            },
        };
        Some(Reply::Answer { turn, answer })
    }

    /// Does what an order says, and keeps it with its answer.
    fn follow(
        &mut self,
        open: Option<Open>,
        nonce: u64,
        turn: Turn,
        order: Order,
        robot: &mut impl Robot,
    ) -> Answer {
        let chosen = open.is_some_and(|it| it.chosen);
        let answer = match order {
            Order::Begin { ends, name, .. }
                if ends != self.life || name == Life::UNBORN || name == ends =>
            {
                Answer::Refused(Refusal::OtherLife)
            }
            Order::Learn { .. } if !chosen => Answer::Refused(Refusal::NothingChosen),
            Order::Stop => {
                self.told = true;
                self.last = turn;
                self.close(robot);
                return Answer::Done;
            }
            Order::Save => match robot.save(self.life) {
                Some(generation) => Answer::Saved(generation),
                None => Answer::Refused(Refusal::NotSaved),
            },
            Order::Report => self.report(robot),
            _ => robot.follow(order),
        };
        let followed = !matches!(answer, Answer::Refused(_)) && order != Order::Report;
        if followed {
            self.last = turn;
        }
        let chosen = match order {
            Order::Begin { name, .. } if followed => {
                self.life = name;
                false
            }
            Order::Learn { .. } if followed => false,
            Order::Save => false,
            Order::Choose { .. } => followed,
            _ => chosen,
        };
        let since = match open {
            Some(open) if !followed => open.since,
            // Work takes its time, and the other side waits for its end.
            _ => robot.now(),
        };
        self.open = Some(Open {
            nonce,
            turn,
            order,
            answer,
            since,
            chosen,
        });
        answer
    }

    fn report(&self, robot: &mut impl Robot) -> Answer {
        let (schemas, knowledge) = robot.known();
        Answer::Report {
            dropped: self.dropped,
            expired: self.expired,
            schemas,
            knowledge,
        }
    }
}

/// A name that no session has had.
fn name(names: &mut Rng) -> Session {
    match names.next_seed() {
        0 => Session(1),
        name => Session(name),
    }
}
