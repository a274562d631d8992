//! One session: disturbed, then clean, then without orders.

use firmware_example::link::{Order, Robot};

use super::sides::{Body, Brain, frame};
use super::witness::{PATIENCE, Witness};
use super::{Fate, Past, Tally};

/// The longest a session is disturbed, in milliseconds.
const LONGEST: u32 = 3_000;
/// Orders over the clean wire.
const CLEAN: u32 = 4;
/// Calls that the first of them may take.
const CALLS: u64 = 3;

/// How much is disturbed, in thousandths: of frames, but what intrudes, of milliseconds.
#[derive(Clone, Copy, Debug)]
struct Rates {
    lost: u32,
    damaged: u32,
    late: u32,
    twice: u32,
    noise: u32,
    played_back: u32,
    cut: u32,
    reset: u32,
}

impl Rates {
    const NONE: Self = Self {
        lost: 0,
        damaged: 0,
        late: 0,
        twice: 0,
        noise: 0,
        played_back: 0,
        cut: 0,
        reset: 0,
    };

    /// One session suffers from this, another from that.
    fn drawn(fate: &mut impl Fate) -> Self {
        let mut up_to = |most: u32| match fate.below(3) {
            0 => 0,
            1 => fate.below(most / 5 + 1),
            _ => fate.below(most + 1),
        };
        Self {
            lost: up_to(400),
            damaged: up_to(300),
            late: up_to(300),
            twice: up_to(400),
            noise: up_to(100),
            played_back: up_to(100),
            cut: up_to(10),
            reset: up_to(10),
        }
    }
}

/// Frames under way to one side.
#[derive(Default)]
struct Way {
    frames: Vec<(u32, Vec<u8>)>,
    cut_until: u32,
}

impl Way {
    fn send(&mut self, bytes: Vec<u8>, now: u32, rates: &Rates, fate: &mut impl Fate) -> bool {
        if now < self.cut_until || fate.hits(rates.lost) {
            return true;
        }
        let twice = fate.hits(rates.twice);
        if twice {
            let at = now + 1 + fate.below(2 * PATIENCE);
            self.frames.push((at, bytes.clone()));
        }
        let late = fate.hits(rates.late);
        let at = now + 1 + if late { fate.below(3 * PATIENCE) } else { 0 };
        let damaged = fate.hits(rates.damaged);
        let bytes = if damaged { spoil(bytes, fate) } else { bytes };
        self.frames.push((at, bytes));
        twice || late || damaged
    }

    /// What arrives now, in the order in which it was sent.
    fn arriving(&mut self, now: u32) -> Vec<u8> {
        let mut arrived = Vec::new();
        self.frames.retain(|(at, bytes)| {
            if *at <= now {
                arrived.extend(bytes);
            }
            *at > now
        });
        arrived
    }
}

/// A frame with a flipped bit, without its head or tail, or with a byte too many.
fn spoil(mut bytes: Vec<u8>, fate: &mut impl Fate) -> Vec<u8> {
    let place = fate.below(bytes.len() as u32) as usize;
    match fate.below(4) {
        0 => bytes[place] ^= 1 << fate.below(8),
        1 => bytes.truncate(place),
        2 => drop(bytes.drain(..place)),
        _ => bytes.insert(place, fate.below(256) as u8),
    }
    bytes
}

/// All of a session.
struct Scene<'a, F> {
    fate: &'a mut F,
    past: &'a mut Past,
    tally: &'a mut Tally,
    witness: Witness,
    brain: Brain,
    body: Body,
    to_brain: Way,
    to_body: Way,
    rates: Rates,
}

impl<F: Fate> Scene<'_, F> {
    /// A millisecond; how many calls the body made.
    fn step(&mut self) -> u64 {
        self.witness.now += 1;
        let now = self.witness.now;
        self.intrude();
        let bytes = self.to_brain.arriving(now);
        for reply in self.brain.hear(&bytes, &mut self.witness) {
            let frame = frame(&reply);
            self.past.record(&frame);
            let disturbed = self.to_body.send(frame, now, &self.rates, self.fate);
            self.tally.frames += 1;
            self.tally.disturbed += u64::from(disturbed);
        }
        let bytes = self.to_body.arriving(now);
        let calls = self.body.hear(&bytes, &mut self.witness, self.fate);
        for call in &calls {
            let frame = frame(call);
            self.past.record(&frame);
            let disturbed = self.to_brain.send(frame, now, &self.rates, self.fate);
            self.tally.frames += 1;
            self.tally.disturbed += u64::from(disturbed);
        }
        calls.len() as u64
    }

    /// What comes from elsewhere: noise, a tape, somebody who cuts the wire or pulls a plug.
    fn intrude(&mut self) {
        let rates = self.rates;
        let now = self.witness.now;
        let mut drawn = self.fate.below(1000);
        let mut is = |rate: u32| {
            let it = drawn >= 1000 - rate && drawn < 1000;
            drawn += rate;
            it
        };
        if is(rates.noise) {
            let bytes = (0..1 + self.fate.below(40)).map(|_| self.fate.below(256) as u8);
            let bytes = bytes.collect();
            self.deliver(bytes);
        } else if is(rates.played_back) && !self.past.frames.is_empty() {
            let which = self.fate.below(self.past.frames.len() as u32) as usize;
            let bytes = self.past.frames[which].clone();
            self.deliver(bytes);
        } else if is(rates.cut) {
            let until = now + 1 + self.fate.below(3 * PATIENCE);
            match self.fate.below(3) {
                0 => self.to_brain.cut_until = until,
                1 => self.to_body.cut_until = until,
                _ => (self.to_brain.cut_until, self.to_body.cut_until) = (until, until),
            }
        } else if is(rates.reset) {
            self.tally.resets += 1;
            match self.fate.below(2) {
                0 => {
                    self.brain = Brain::new(self.past);
                    self.witness.life = firmware_example::link::Life::UNBORN;
                    self.witness.stop();
                }
                _ => self.body = Body::new(self.past, now),
            }
        }
    }

    fn deliver(&mut self, bytes: Vec<u8>) {
        self.tally.intruded += 1;
        let now = self.witness.now;
        match self.fate.below(2) {
            0 => self.to_brain.frames.push((now, bytes)),
            _ => self.to_body.frames.push((now, bytes)),
        }
    }

    /// Steps until an order is answered; the calls it took, at most a few more than allowed.
    fn answered(&mut self) -> u64 {
        let before = self.body.answered;
        let mut calls = 0;
        while self.body.answered == before && calls <= CALLS + 1 {
            calls += self.step();
        }
        calls
    }

    /// The wire is clean, and what was under way is lost: are both in step?
    fn clean(&mut self) {
        self.rates = Rates::NONE;
        (self.to_brain, self.to_body) = Default::default();
        self.body.hurry(self.witness.now);
        let first = self.answered();
        let place = first.clamp(1, CALLS + 1) as usize - 1;
        self.tally.calls[place] += 1;
        let mut astray = first > CALLS;
        for _ in 1..CLEAN {
            self.body.hurry(self.witness.now);
            astray |= self.answered() > 1;
        }
        self.tally.astray += u64::from(astray);
    }

    /// The robot moves, and then no order comes any more, but something else: does it stop?
    fn end(&mut self) {
        self.body.order(Order::SecondLevel, self.witness.now);
        self.answered();
        let old = self.past.frames.iter().rev().nth(1).cloned();
        let kind = self.fate.below(4);
        for _ in 0..=PATIENCE {
            self.witness.now += 1;
            let noise = match kind {
                0 => Vec::new(),
                1 => vec![0; 11],
                2 => (0..11).map(|_| self.fate.below(256) as u8).collect(),
                _ => old.clone().unwrap_or_default(),
            };
            // Nobody hears what is replied.
            self.brain.hear(&noise, &mut self.witness);
        }
        // A robot that moves on is one that moves wrongly.
        self.witness.wrong += u64::from(self.witness.moving.is_some());
    }
}

/// Lives through a session and adds what came of it.
pub fn session(fate: &mut impl Fate, past: &mut Past, tally: &mut Tally) {
    let rates = Rates::drawn(fate);
    let brain = Brain::new(past);
    let body = Body::new(past, 0);
    let orders = 5 + fate.below(25);
    let mut scene = Scene {
        fate,
        past,
        tally,
        witness: Witness::new(),
        brain,
        body,
        to_brain: Way::default(),
        to_body: Way::default(),
        rates,
    };
    let mut answered = 0;
    while answered < orders && scene.witness.now < LONGEST {
        let before = scene.body.answered;
        scene.step();
        // A body that was reset begins to count anew.
        answered += scene.body.answered.saturating_sub(before);
    }
    scene.clean();
    scene.end();
    let Scene { witness, .. } = scene;
    tally.sessions += 1;
    tally.followed += witness.followed;
    tally.stops += witness.stops;
    tally.wrong += witness.wrong;
    tally.longest = tally.longest.max(witness.longest);
}
