//! Both sides of the wire, each with its end of it.

use firmware_example::link::{
    Answer, Call, Caller, Desk, FRAME, Fault, Life, News, Order, Outcome, Receiver, Reply, Seal,
    Turn, encode,
};

use super::witness::{PATIENCE, Witness};
use super::{Fate, Past};

/// How long a body waits for an answer, in milliseconds.
const WAIT: u32 = 20;

/// The brain's side.
pub(super) struct Brain {
    desk: Desk,
    receiver: Receiver,
}

impl Brain {
    pub(super) fn new(past: &mut Past) -> Self {
        let fresh = if past.forgetful { 0 } else { past.fresh() };
        Self {
            desk: Desk::new(fresh, PATIENCE, Life::UNBORN),
            receiver: Receiver::new(Seal::Checksum),
        }
    }

    /// Hears what has come within a millisecond; what it replies.
    pub(super) fn hear(&mut self, bytes: &[u8], witness: &mut Witness) -> Vec<Reply> {
        if bytes.is_empty()
            && let Some(fault) = self.receiver.pause()
        {
            self.desk.drop(fault);
        }
        self.desk.tick(witness);
        let mut replies = Vec::new();
        for &byte in bytes {
            let call: Call = match self.receiver.take(byte) {
                None => continue,
                Some(Ok(call)) => call,
                Some(Err(fault)) => {
                    self.desk.drop(fault);
                    continue;
                }
            };
            witness.hearing = match call {
                Call::Order { turn, .. } => turn,
                Call::Hello { .. } => Turn::NONE,
            };
            let reply = self.desk.hear(call, witness);
            if let Some(Reply::Answer { turn, answer }) = reply {
                witness.answer(turn, answer);
            }
            replies.extend(reply);
        }
        replies
    }
}

/// The body's side.
pub(super) struct Body {
    caller: Caller,
    receiver: Receiver,
    /// What it orders, and when it does the next thing: order, or ask again.
    order: Order,
    next: u32,
    /// The turn in which that order was given last.
    asked: Turn,
    /// Orders answered.
    pub(super) answered: u32,
}

impl Body {
    /// Knows nothing, and asks who lives there.
    pub(super) fn new(past: &mut Past, now: u32) -> Self {
        Self {
            caller: Caller::new(past.fresh()),
            receiver: Receiver::new(Seal::Checksum),
            order: Order::Report,
            next: now,
            asked: Turn::NONE,
            answered: 0,
        }
    }

    /// Does what is due next without waiting.
    pub(super) const fn hurry(&mut self, now: u32) {
        self.next = now;
    }

    /// Orders this next.
    pub(super) const fn order(&mut self, order: Order, now: u32) {
        (self.order, self.next) = (order, now);
    }

    /// Hears what has come within a millisecond, and goes on; the calls that it makes.
    pub(super) fn hear(
        &mut self,
        bytes: &[u8],
        witness: &mut Witness,
        fate: &mut impl Fate,
    ) -> Vec<Call> {
        let mut calls = Vec::new();
        if bytes.is_empty() {
            // Half a frame is nothing.
            let _: Option<Fault> = self.receiver.pause();
        }
        for &byte in bytes {
            if let Some(Ok(reply)) = self.receiver.take(byte) {
                let waiting = self.caller.asking();
                let news = self.caller.hear(reply);
                if let (News::Answered(answer), Some(turn)) = (news, waiting) {
                    witness.take(turn, answer);
                }
                self.go_on(news, &mut calls, witness, fate);
            }
        }
        if witness.now.wrapping_sub(self.next) < u32::MAX / 2 {
            let news = match self.caller.is_waiting() {
                true => self.caller.wait(),
                false => News::Send(self.caller.ask(self.order)),
            };
            self.go_on(news, &mut calls, witness, fate);
        }
        calls
    }

    fn go_on(
        &mut self,
        news: News,
        calls: &mut Vec<Call>,
        witness: &mut Witness,
        fate: &mut impl Fate,
    ) {
        let now = witness.now;
        match news {
            News::Nothing => {}
            News::Send(call) => {
                if let Call::Order { turn, order } = call {
                    witness.give(turn, order);
                    self.asked = turn;
                }
                self.next = now.wrapping_add(WAIT);
                calls.push(call);
            }
            News::Answered(answer) => {
                self.answered += 1;
                self.order = self.after(answer, fate);
                // Mostly at once, sometimes so late that the robot has been stopped.
                let pause = if fate.hits(30) { 2 * PATIENCE } else { 4 };
                self.next = now.wrapping_add(1 + fate.below(pause));
            }
            News::Interrupted(outcome) => {
                witness.tell(self.asked, outcome);
                self.order = match (outcome, self.order) {
                    (Outcome::Unknown, _) => Order::Report,
                    (_, Order::Learn { .. }) => self.choose(),
                    (Outcome::Followed, Order::Begin { .. }) => self.choose(),
                    (_, order) => order,
                };
                self.next = now;
            }
            News::OtherVersion(_) => witness.wrong += 1,
            News::Silent => self.order(Order::Report, now.wrapping_add(1)),
        }
    }

    const fn choose(&self) -> Order {
        Order::Choose {
            now: self.answered as u8,
        }
    }

    /// What comes after an order and its answer.
    fn after(&self, answer: Answer, fate: &mut impl Fate) -> Order {
        let begin = Order::Begin {
            seed: self.answered.into(),
            ends: self.caller.life(),
            name: Life(self.caller.life().0.wrapping_add(1).max(1)),
        };
        let now = self.answered as u8;
        match (self.order, answer) {
            (Order::Report, _) if self.caller.life() == Life::UNBORN => begin,
            (_, Answer::Refused(_)) => Order::Report,
            (Order::Choose { .. }, _) => Order::Learn { now },
            (Order::Learn { .. }, _) => match fate.below(40) {
                39 => begin,
                38 => Order::Report,
                37 => Order::Act,
                36 => Order::SecondLevel,
                35 => Order::Save,
                30..35 => Order::Observe {
                    before: now,
                    action: 1,
                    after: 0,
                },
                _ => self.choose(),
            },
            _ => self.choose(),
        }
    }
}

/// A frame as it is sent.
pub(super) fn frame<T: firmware_example::link::Said>(it: &T) -> Vec<u8> {
    let mut frame = [0; FRAME];
    let frame = encode(it, &Seal::Checksum, &mut frame);
    frame.map(<[u8]>::to_vec).unwrap_or_default()
}
