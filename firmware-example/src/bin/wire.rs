#![no_std]
#![no_main]
//! What orders over a wire take: bytes of a session, stack, and instructions from a frame that was heard
//! to its answer; the body at the other end lives in the same program, and the robot does nothing.
//!
//! `cargo run --release --bin wire` in this folder; with `--features authentic` frames have a key.
//! The session is that of a thousand recorded actions, with pauses, frames that are broken, and a stop
//! because no order was followed for too long.

use core::cell::Cell;
use core::hint::black_box;

use firmware_example::board::{self, Counter};
use firmware_example::controller::{End, Heard, Service, Wire, attend};
use firmware_example::hal::PATIENCE;
use firmware_example::link::{
    Answer, Call, Caller, Desk, FRAME, Life, News, Order, Receiver, Reply, Robot, Seal, Session,
    Turn, encode,
};
use firmware_example::trace;
use semihosting::{println, process};

#[cfg(not(feature = "authentic"))]
const SEAL: Seal = Seal::Checksum;
#[cfg(feature = "authentic")]
const SEAL: Seal = Seal::Keyed(firmware_example::link::Key::PUBLISHED);

/// Own actions of the session.
const ACTIONS: u32 = 1_000;

/// Milliseconds from one thing that the body does to the next.
const STEP: u32 = 10;

/// The pause that is too long: a multiple of 16, as every pause.
const SILENCE: u32 = 1_600;

/// The longest order.
const BEGIN: Order = Order::Begin {
    seed: u64::MAX,
    ends: Life::UNBORN,
    name: Life(1),
};

/// Every kind of order, in a life along the recording.
fn orders() -> impl Iterator<Item = Order> {
    let life = trace::steps(ACTIONS).flat_map(|step| {
        let [before, _, after] = step.to_bytes();
        let action = step.action.0 as u8;
        let reflex = Order::Observe {
            before,
            action,
            after,
        };
        match step.reflex {
            true => [Some(reflex), None],
            false => [
                Some(Order::Choose { now: before }),
                Some(Order::Learn { now: after }),
            ],
        }
    });
    let last = [
        Order::SecondLevel,
        Order::Act,
        Order::Save,
        Order::Report,
        Order::Stop,
    ];
    [BEGIN].into_iter().chain(life.flatten()).chain(last)
}

/// Instructions of what happened more than once.
#[derive(Default)]
struct Cost {
    sum: u64,
    times: u32,
    worst: u32,
}

impl Cost {
    fn add(&mut self, instructions: u32) {
        self.sum += u64::from(instructions);
        self.times += 1;
        self.worst = self.worst.max(instructions);
    }

    fn mean(&self) -> u32 {
        (self.sum / u64::from(self.times.max(1))) as u32
    }
}

/// What the body does, and the other side answers or not.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Doing {
    Nothing,
    Greeting,
    Ordering,
    Disturbing,
    Pausing,
}

/// The body, and what its doings cost the other side.
struct Body<'a, Orders> {
    counter: Counter,
    clock: &'a Cell<u32>,
    orders: Orders,
    caller: Caller,
    receiver: Receiver,
    /// What is sent next, where it is not a new order.
    call: Option<Call>,
    turn: u32,
    doing: Doing,
    hello: Cost,
    order: Cost,
    broken: Cost,
    pause: Cost,
    answered: u32,
    interrupted: u32,
    /// What should not have happened.
    lost: u32,
}

impl<Orders: Iterator<Item = Order>> Body<'_, Orders> {
    /// Does the next thing; `None` when there is no order left.
    fn go_on(&mut self, frame: &mut [u8; FRAME]) -> Option<Heard> {
        self.turn += 1;
        let passed = if self.turn == SILENCE { PATIENCE } else { STEP };
        self.clock.set(self.clock.get() + passed);
        let (doing, length) = match self.turn % 16 {
            0 => {
                self.doing = Doing::Pausing;
                return Some(Heard::Pause);
            }
            1 => (Doing::Disturbing, damaged(frame)?),
            2 => (Doing::Disturbing, nonsense(frame)),
            _ => {
                let (orders, caller) = (&mut self.orders, &mut self.caller);
                let next = || orders.next().map(|order| caller.ask(order));
                let call = self.call.take().or_else(next)?;
                let doing = match call {
                    Call::Hello { .. } => Doing::Greeting,
                    Call::Order { .. } => Doing::Ordering,
                };
                (doing, encode(&call, &SEAL, frame)?.len())
            }
        };
        self.doing = doing;
        Some(Heard::Bytes(length))
    }
}

/// The longest call, whose seal is wrong; answers its bytes.
fn damaged(frame: &mut [u8; FRAME]) -> Option<usize> {
    let turn = Turn {
        session: Session(u64::MAX),
        number: u32::MAX,
    };
    let call = Call::Order { turn, order: BEGIN };
    let length = encode(&call, &SEAL, frame)?.len();
    let last = frame.get_mut(length.checked_sub(2)?)?;
    *last = if *last == 1 { 2 } else { 1 };
    Some(length)
}

/// As many bytes as a frame may have, and no message; answers their number.
fn nonsense(frame: &mut [u8; FRAME]) -> usize {
    frame.fill(0x55);
    // All of it without a zero inside, as COBS says it.
    let [first, .., last] = frame;
    (*first, *last) = (FRAME as u8 - 1, 0);
    FRAME
}

impl<Orders: Iterator<Item = Order>> Wire for Body<'_, Orders> {
    fn hear(&mut self, bytes: &mut [u8]) -> Heard {
        let instructions = self.counter.lap();
        match core::mem::replace(&mut self.doing, Doing::Nothing) {
            Doing::Pausing => self.pause.add(instructions),
            Doing::Disturbing => self.broken.add(instructions),
            Doing::Nothing => {}
            // It was not answered.
            Doing::Greeting | Doing::Ordering => self.lost += 1,
        }
        let frame = bytes.first_chunk_mut::<FRAME>();
        let heard = frame.and_then(|frame| self.go_on(frame));
        let heard = heard.unwrap_or(Heard::Gone);
        self.counter.lap();
        heard
    }

    fn say(&mut self, bytes: &[u8]) -> bool {
        let instructions = self.counter.lap();
        match core::mem::replace(&mut self.doing, Doing::Nothing) {
            Doing::Greeting => self.hello.add(instructions),
            Doing::Ordering => self.order.add(instructions),
            _ => self.lost += 1,
        }
        for &byte in bytes {
            let reply = match self.receiver.take::<Reply>(byte) {
                None => continue,
                Some(Ok(reply)) => reply,
                Some(Err(_)) => {
                    self.lost += 1;
                    continue;
                }
            };
            match self.caller.hear(reply) {
                News::Send(call) => self.call = Some(call),
                News::Answered(_) => self.answered += 1,
                News::Interrupted(_) => self.interrupted += 1,
                _ => self.lost += 1,
            }
        }
        true
    }
}

/// A robot that does nothing and knows nothing.
struct Still<'a> {
    clock: &'a Cell<u32>,
    stops: u32,
}

impl Robot for Still<'_> {
    fn now(&mut self) -> u32 {
        self.clock.get()
    }

    fn stop(&mut self) {
        self.stops += 1;
    }

    fn follow(&mut self, order: Order) -> Answer {
        let answer = match order {
            Order::Choose { .. } => Answer::Chosen {
                action: 3,
                value: 1.5_f32.to_bits(),
            },
            _ => Answer::Done,
        };
        black_box(answer)
    }

    fn known(&mut self) -> (u16, u64) {
        black_box((u16::MAX, u64::MAX))
    }

    fn save(&mut self, _: Life) -> Option<u32> {
        self.stop();
        black_box(Some(1))
    }
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    board::paint_stack();
    let clock = Cell::new(0);
    let mut robot = Still {
        clock: &clock,
        stops: 0,
    };
    let mut body = Body {
        counter: Counter::start(),
        clock: &clock,
        orders: orders(),
        caller: Caller::new(1),
        receiver: Receiver::new(SEAL),
        call: None,
        turn: 0,
        doing: Doing::Nothing,
        hello: Cost::default(),
        order: Cost::default(),
        broken: Cost::default(),
        pause: Cost::default(),
        answered: 0,
        interrupted: 0,
        lost: 0,
    };
    let service = Service {
        fresh: 1,
        patience: PATIENCE,
        life: Life::UNBORN,
        seal: SEAL,
    };
    let end = attend(&mut robot, &mut body, service);
    // Before anything is printed, which takes more stack.
    let stack = board::stack_used();
    println!("session bytes {}", size_of::<Desk>());
    println!("receiver bytes {}", size_of::<Receiver>());
    // What was heard, and what is said.
    println!("buffer bytes {}", 2 * FRAME);
    println!("stack bytes {stack}");
    let order = &body.order;
    println!(
        "order instructions mean {} worst {}",
        order.mean(),
        order.worst
    );
    println!("hello instructions worst {}", body.hello.worst);
    println!("broken instructions worst {}", body.broken.worst);
    println!("pause instructions worst {}", body.pause.worst);
    println!("answered {}", body.answered);
    println!("interrupted {}", body.interrupted);
    println!("stopped {}", robot.stops);
    println!("lost {}", body.lost);
    match end {
        End::Told => process::exit(0),
        End::HostGone => process::exit(1),
    }
}
