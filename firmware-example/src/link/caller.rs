//! The body's side of the wire as a machine: one order at a time, asked until it is answered.
//!
//! It does no input and output: it says what to send, and is told what came and when nothing did.
//! An order without an answer is asked again under its number, which the other side answers without
//! doing it twice; where the session is over, a new one begins with a handshake, and whoever gave the
//! order hears what became of it.

use cla_core::num::Rng;

use super::message::{Answer, Call, Life, Order, Reply, Turn, VERSION};

/// How often a call is made before it is given up.
pub const ATTEMPTS: u32 = 3;

/// What became of an order whose session ended before its answer came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It was followed, once; its answer is lost.
    Followed,
    /// It was not followed.
    NotFollowed,
    /// Somebody else lives there: the brain's side was reset, or another body gave orders.
    Unknown,
}

/// What follows from what came, or from nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum News {
    /// Go on waiting.
    Nothing,
    /// Send this, and wait.
    Send(Call),
    /// The order has its answer.
    Answered(Answer),
    /// The robot was stopped and a new session is open: look anew, and order what is right now.
    Interrupted(Outcome),
    /// Another version is spoken there.
    OtherVersion(u16),
    /// Nobody answers.
    Silent,
}

/// The machine.
#[derive(Clone, Debug)]
pub struct Caller {
    nonces: Rng,
    doing: Doing,
    /// The last session, and the last order in it.
    turn: Turn,
    /// Whether that session is open, as far as is known.
    open: bool,
    tries: u32,
    life: Life,
    /// The order that was followed last, as far as is known.
    last: Turn,
}

#[derive(Clone, Copy, Debug)]
enum Doing {
    Nothing,
    /// Waits for a welcome; then the order is asked.
    Greeting {
        nonce: u64,
        order: Order,
        /// Where it was asked already: then what became of it is told instead.
        asked: Option<Turn>,
    },
    Asking {
        order: Order,
    },
}

impl Caller {
    /// Nothing said yet; `fresh` is another number for each caller.
    #[must_use]
    pub const fn new(fresh: u64) -> Self {
        Self {
            nonces: Rng::stream(fresh, 16),
            doing: Doing::Nothing,
            turn: Turn::NONE,
            open: false,
            tries: 0,
            life: Life::UNBORN,
            last: Turn::NONE,
        }
    }

    /// Who lives at the other side, as far as is known.
    #[must_use]
    pub const fn life(&self) -> Life {
        self.life
    }

    /// Whether an order waits for its answer.
    #[must_use]
    pub const fn is_waiting(&self) -> bool {
        !matches!(self.doing, Doing::Nothing)
    }

    /// The order that waits for its answer, once it was given in a session.
    #[must_use]
    pub const fn asking(&self) -> Option<Turn> {
        match self.doing {
            Doing::Asking { .. } => Some(self.turn),
            _ => None,
        }
    }

    /// Gives an order: what to send. An order that still waits is given up.
    pub fn ask(&mut self, order: Order) -> Call {
        match (self.turn.number.checked_add(1), self.doing) {
            (Some(number), Doing::Nothing) if self.open => self.say(number, order),
            _ => self.hello(order, None),
        }
    }

    fn say(&mut self, number: u32, order: Order) -> Call {
        self.tries = 1;
        self.doing = Doing::Asking { order };
        self.turn.number = number;
        let turn = self.turn;
        Call::Order { turn, order }
    }

    /// Gives up the session, if any, and asks for a new one.
    fn hello(&mut self, order: Order, asked: Option<Turn>) -> Call {
        self.tries = 1;
        self.open = false;
        let nonce = self.nonces.next_seed();
        // Another body may have moved the robot since: a stop is done when it is answered.
        let asked = asked.filter(|_| order != Order::Stop);
        self.doing = Doing::Greeting {
            nonce,
            order,
            asked,
        };
        self.greeting(nonce)
    }

    const fn greeting(&self, nonce: u64) -> Call {
        Call::Hello {
            version: VERSION,
            nonce,
            after: self.turn.session,
        }
    }

    /// Nothing came for as long as an answer may take.
    pub fn wait(&mut self) -> News {
        let patient = self.tries < ATTEMPTS;
        self.tries = self.tries.saturating_add(1);
        match self.doing {
            Doing::Nothing => News::Nothing,
            Doing::Asking { order } if patient => {
                let turn = self.turn;
                News::Send(Call::Order { turn, order })
            }
            Doing::Asking { order } => News::Send(self.hello(order, Some(self.turn))),
            Doing::Greeting { nonce, .. } if patient => News::Send(self.greeting(nonce)),
            Doing::Greeting { .. } => {
                self.doing = Doing::Nothing;
                News::Silent
            }
        }
    }

    /// Hears what was said; what is old or for somebody else means nothing.
    pub fn hear(&mut self, reply: Reply) -> News {
        match (reply, self.doing) {
            (
                Reply::Welcome {
                    nonce: theirs,
                    session,
                    life,
                    last,
                },
                Doing::Greeting {
                    nonce,
                    order,
                    asked,
                },
            ) if theirs == nonce => {
                let outcome = asked.map(|it| self.outcome(it, life, last));
                self.turn = Turn { session, number: 0 };
                (self.open, self.life, self.last) = (true, life, last);
                let Some(outcome) = outcome else {
                    return News::Send(self.say(1, order));
                };
                self.doing = Doing::Nothing;
                News::Interrupted(outcome)
            }
            (
                Reply::OtherVersion {
                    version,
                    nonce: theirs,
                },
                Doing::Greeting { nonce, .. },
            ) if theirs == nonce => {
                self.doing = Doing::Nothing;
                News::OtherVersion(version)
            }
            (Reply::Answer { turn, answer }, Doing::Asking { order }) if turn == self.turn => {
                self.doing = Doing::Nothing;
                match (order, answer) {
                    (Order::Report, _) | (_, Answer::Refused(_)) => {}
                    (Order::Begin { name, .. }, _) => (self.life, self.last) = (name, turn),
                    _ => self.last = turn,
                }
                News::Answered(answer)
            }
            (Reply::Closed { turn }, Doing::Asking { order }) if turn == self.turn => {
                News::Send(self.hello(order, Some(turn)))
            }
            _ => News::Nothing,
        }
    }

    /// What became of an order, by who lives there and which one was followed last.
    fn outcome(&self, asked: Turn, life: Life, last: Turn) -> Outcome {
        if last == asked {
            Outcome::Followed
        } else if (life, last) == (self.life, self.last) {
            Outcome::NotFollowed
        } else {
            Outcome::Unknown
        }
    }
}
