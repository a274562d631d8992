//! A robot that notes what it is told, and knows what it should have been told.

use std::collections::{BTreeMap, BTreeSet};

use firmware_example::link::{Answer, Life, Order, Outcome, Robot, Session, Turn};

/// Milliseconds that the robot may go on without an order.
pub const PATIENCE: u32 = 100;

/// An order that a body gave.
#[derive(Clone, Copy, Debug)]
struct Given {
    order: Order,
    at: u32,
    followed: bool,
    answer: Option<Answer>,
    /// What its body was told of it, when the answer got lost.
    told: Option<Outcome>,
}

/// The robot, its clock, and all that was ordered.
#[derive(Clone, Debug)]
pub(super) struct Witness {
    pub(super) now: u32,
    pub(super) life: Life,
    /// The order that is heard just now.
    pub(super) hearing: Turn,
    /// When an order was followed last, while the robot moves.
    pub(super) moving: Option<u32>,
    given: BTreeMap<Turn, Given>,
    session: Option<Session>,
    over: BTreeSet<Session>,
    pub(super) followed: u64,
    pub(super) stops: u64,
    pub(super) wrong: u64,
    pub(super) longest: u32,
}

impl Witness {
    pub(super) const fn new() -> Self {
        Self {
            now: 0,
            life: Life::UNBORN,
            hearing: Turn::NONE,
            moving: None,
            given: BTreeMap::new(),
            session: None,
            over: BTreeSet::new(),
            followed: 0,
            stops: 0,
            wrong: 0,
            longest: 0,
        }
    }

    /// A body gives an order, or gives it again.
    pub(super) fn give(&mut self, turn: Turn, order: Order) {
        let given = self.given.entry(turn).or_insert(Given {
            order,
            at: self.now,
            followed: false,
            answer: None,
            told: None,
        });
        // One turn, one order.
        self.wrong += u64::from(given.order != order);
    }

    /// The brain's side answers an order: always the same, and only what was given.
    pub(super) fn answer(&mut self, turn: Turn, answer: Answer) {
        match self.given.get_mut(&turn) {
            Some(given) => {
                let first = *given.answer.get_or_insert(answer);
                self.wrong += u64::from(first != answer);
            }
            None => self.wrong += 1,
        }
    }

    /// A body takes an answer for that of its order.
    pub(super) fn take(&mut self, turn: Turn, answer: Answer) {
        let given = self.given.get(&turn).and_then(|it| it.answer);
        self.wrong += u64::from(given != Some(answer));
    }

    /// A body is told what became of its order.
    pub(super) fn tell(&mut self, turn: Turn, outcome: Outcome) {
        match self.given.get_mut(&turn) {
            Some(given) => {
                let lie = match outcome {
                    Outcome::Followed => !given.followed,
                    Outcome::NotFollowed => given.followed,
                    Outcome::Unknown => false,
                };
                self.wrong += u64::from(lie);
                given.told = Some(outcome);
            }
            None => self.wrong += 1,
        }
    }

    /// Whether an order may be followed now.
    fn may(&self, turn: Turn, order: Order) -> bool {
        let Some(given) = self.given.get(&turn) else {
            return false;
        };
        let later = self.given.range(turn..);
        let overtaken = later
            .take_while(|(other, _)| other.session == turn.session)
            .any(|(_, given)| given.followed);
        let named = match order {
            Order::Begin { ends, .. } => ends == self.life,
            _ => self.life != Life::UNBORN,
        };
        given.order == order
            && self.now.wrapping_sub(given.at) < PATIENCE
            && given.told.is_none()
            && !overtaken
            && !self.over.contains(&turn.session)
            && named
    }

    /// An order is followed.
    fn obey(&mut self, order: Order) {
        let turn = self.hearing;
        self.wrong += u64::from(!self.may(turn, order));
        self.followed += 1;
        self.session = Some(turn.session);
        if let Some(given) = self.given.get_mut(&turn) {
            given.followed = true;
        }
    }

    fn stand(&mut self) {
        if let Some(since) = self.moving.take() {
            self.stops += 1;
            self.longest = self.longest.max(self.now.wrapping_sub(since));
        }
    }
}

impl Robot for Witness {
    fn now(&mut self) -> u32 {
        self.now
    }

    fn stop(&mut self) {
        self.stand();
        self.over.extend(self.session.take());
    }

    fn known(&mut self) -> (u16, u64) {
        (0, 0)
    }

    fn save(&mut self, life: Life) -> Option<u32> {
        if self.life == Life::UNBORN {
            return None;
        }
        self.wrong += u64::from(life != self.life);
        self.obey(Order::Save);
        self.stand();
        Some(self.followed as u32)
    }

    fn follow(&mut self, order: Order) -> Answer {
        const REFUSED: Answer = Answer::Refused(firmware_example::link::Refusal::Brain);
        // As a brain that was not born.
        if self.life == Life::UNBORN && !matches!(order, Order::Begin { .. }) {
            return REFUSED;
        }
        self.obey(order);
        self.moving = Some(self.now);
        match order {
            Order::Begin { name, .. } => {
                self.life = name;
                Answer::Done
            }
            Order::Choose { now } => Answer::Chosen {
                action: now % 6,
                value: self.followed as u32,
            },
            _ => Answer::Done,
        }
    }
}
