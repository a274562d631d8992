//! Any bytes over the wire, any calls of its machine, any disturbance of a session.

use arbitrary::{Arbitrary, Unstructured};
use firmware_example::controller::{Heard, SafeStop, Service, Wire, serve};
use firmware_example::link::{
    Answer, Call, Desk, FRAME, Key, Life, Order, Receiver, Reply, Robot, Said, Seal, Session, Turn,
    VERSION, encode,
};
use host_sim::experiment::hil::disturbed::{self, Past, Tally, Written};

/// What a robot of these targets may go on for without an order, in milliseconds.
const PATIENCE: u32 = 50;

/// Everything that is taken is, to the byte, the frame of what it was taken for.
fn exact<T: Said>(bytes: &[u8], seal: Seal) {
    let mut receiver = Receiver::new(seal);
    let mut frame = Vec::new();
    for &byte in bytes {
        let taken = receiver.take::<T>(byte);
        if byte != 0 {
            frame.push(byte);
            assert!(taken.is_none());
            continue;
        }
        if let Some(Ok(it)) = taken {
            let mut again = [0; FRAME];
            let again = encode(&it, &seal, &mut again).expect("it came in a frame");
            assert_eq!(again[1..again.len() - 1], frame);
        }
        frame.clear();
    }
}

/// Any bytes, in both directions, under both seals; then as a message in a frame whose seal is right.
pub(super) fn frames(bytes: &[u8]) {
    for seal in [Seal::Checksum, Seal::Keyed(Key::PUBLISHED)] {
        exact::<Call>(bytes, seal);
        exact::<Reply>(bytes, seal);
    }
    let crc = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI);
    for way in [Call::WAY, Reply::WAY] {
        let mut digest = crc.digest();
        digest.update(&[way]);
        digest.update(bytes);
        let plain = [bytes, &digest.finalize().to_le_bytes()].concat();
        let framed = [&[0], &*cobs::encode_vec(&plain), &[0]].concat();
        exact::<Call>(&framed, Seal::Checksum);
        exact::<Reply>(&framed, Seal::Checksum);
    }
}

/// A robot that notes what it is told.
#[derive(Default)]
struct Noting {
    now: u32,
    moving: Option<u32>,
    followed: Vec<Order>,
}

impl Robot for Noting {
    fn now(&mut self) -> u32 {
        self.now
    }

    fn stop(&mut self) {
        self.moving = None;
    }

    fn known(&mut self) -> (u16, u64) {
        (0, 0)
    }

    fn save(&mut self, life: Life) -> Option<u32> {
        self.moving = None;
        self.followed.push(Order::Save);
        Some(life.0)
    }

    fn follow(&mut self, order: Order) -> Answer {
        self.moving = Some(self.now);
        self.followed.push(order);
        Answer::Done
    }
}

/// What somebody says who knows some of the truth.
#[derive(Clone, Copy, Debug, Arbitrary)]
enum Step {
    Hello {
        nonce: u8,
        after: u8,
        version: bool,
    },
    Order {
        session: u8,
        ahead: i8,
        what: u8,
        now: u8,
    },
    Wait(u8),
    Close,
    Reset,
}

fn order(what: u8, now: u8, life: Life) -> Order {
    match what % 10 {
        0 => Order::Begin {
            seed: now.into(),
            ends: life,
            name: Life(u32::from(now)),
        },
        1 => Order::Begin {
            seed: 1,
            ends: Life(now.into()),
            name: Life(7),
        },
        2..=4 => Order::Choose { now },
        5 | 6 => Order::Learn { now },
        7 => Order::Observe {
            before: now,
            action: now,
            after: 1,
        },
        8 if now < 128 => Order::Report,
        8 => Order::Save,
        _ if now == 255 => Order::Stop,
        _ => Order::Act,
    }
}

/// Any calls of the brain's machine: what is followed is the next order of a session that was offered,
/// and a robot that moves stops in time.
pub(super) fn calls(bytes: &[u8]) {
    let mut said = Unstructured::new(bytes);
    let mut desk = Desk::new(1, PATIENCE, Life::UNBORN);
    let mut robot = Noting::default();
    let mut sessions = vec![Session::NONE];
    let mut last = Turn::NONE;
    let mut resets = 1;
    while let (false, Ok(one)) = (said.is_empty(), said.arbitrary::<Step>()) {
        let before = robot.followed.len();
        let session = |index: u8| sessions[usize::from(index) % sessions.len()];
        match one {
            Step::Hello {
                nonce,
                after,
                version,
            } => {
                let call = Call::Hello {
                    version: VERSION + u16::from(version),
                    nonce: nonce.into(),
                    after: session(after),
                };
                match desk.hear(call, &mut robot) {
                    Some(Reply::Welcome {
                        session,
                        last: told,
                        ..
                    }) => {
                        assert!(!version);
                        if robot.followed.is_empty() {
                            last = told;
                        }
                        assert_eq!(told, last);
                        if !sessions.contains(&session) {
                            sessions.push(session);
                        }
                    }
                    Some(Reply::OtherVersion { .. }) => assert!(version),
                    None => assert!(desk.is_open()),
                    other => panic!("{other:?} to a hello"),
                }
                assert_eq!(robot.followed.len(), before);
            }
            Step::Order {
                session: which,
                ahead,
                what,
                now,
            } => {
                let session = session(which);
                let number = if session == last.session {
                    last.number.wrapping_add_signed(ahead.into())
                } else {
                    u32::from(ahead.unsigned_abs())
                };
                let turn = Turn { session, number };
                let order = order(what, now, desk.life());
                let reply = desk.hear(Call::Order { turn, order }, &mut robot);
                if robot.followed.len() > before {
                    assert_eq!(robot.followed.len(), before + 1);
                    assert_eq!(robot.followed.last(), Some(&order));
                    assert_ne!(session, Session::NONE);
                    assert!(turn > last || session != last.session);
                    assert!(matches!(reply, Some(Reply::Answer { .. })));
                    last = turn;
                }
                if order == Order::Stop && desk.is_told() {
                    assert!(robot.moving.is_none() && !desk.is_open());
                    return;
                }
            }
            Step::Wait(millis) => {
                robot.now = robot.now.wrapping_add(millis.into());
                desk.tick(&mut robot);
            }
            Step::Close => {
                desk.close(&mut robot);
                assert!(!desk.is_open());
            }
            Step::Reset => {
                // Never the same number twice.
                resets += 1;
                desk = Desk::new(resets, PATIENCE, Life::UNBORN);
                robot.stop();
                robot.followed.clear();
            }
        }
        // Whoever moves was ordered to, not long ago.
        if let Some(since) = robot.moving {
            assert!(desk.is_open());
            assert!(robot.now.wrapping_sub(since) < PATIENCE || matches!(one, Step::Wait(_)));
        }
        desk.tick(&mut robot);
        if let Some(since) = robot.moving {
            assert!(robot.now.wrapping_sub(since) < PATIENCE);
        }
    }
}

/// Whole sessions, disturbed as the bytes say.
pub(super) fn sessions(bytes: &[u8]) {
    let mut fate = Written(bytes);
    let (mut past, mut tally) = (Past::default(), Tally::default());
    // The second one may hear the first one's frames.
    for _ in 0..2 {
        disturbed::session(&mut fate, &mut past, &mut tally);
    }
    assert_eq!((tally.wrong, tally.astray), (0, 0), "{tally:?}");
    assert!(tally.longest <= disturbed::PATIENCE, "{tally:?}");
}

/// A wire that delivers the bytes in pieces; a piece of no bytes is a pause.
struct Tape<'a>(&'a [u8]);

impl Wire for Tape<'_> {
    fn hear(&mut self, bytes: &mut [u8]) -> Heard {
        let Some((&length, rest)) = self.0.split_first() else {
            return Heard::Gone;
        };
        let length = usize::from(length).min(bytes.len()).min(rest.len());
        let (piece, rest) = rest.split_at(length);
        self.0 = rest;
        if length == 0 {
            return Heard::Pause;
        }
        bytes[..length].copy_from_slice(piece);
        Heard::Bytes(length)
    }

    fn say(&mut self, bytes: &[u8]) -> bool {
        assert!(bytes.len() <= FRAME && bytes.first() == Some(&0) && bytes.last() == Some(&0));
        true
    }
}

struct Motors(u32);

impl SafeStop for Motors {
    fn now(&mut self) -> u32 {
        self.0 += 1;
        self.0
    }

    fn stop(&mut self) {}
}

/// Of a controller whose clock goes on whenever it is looked at: for a few hundred orders.
const LONG_PATIENCE: u32 = 2_000;

/// The controller with a brain, and calls that are framed for it in the session that it offers first.
pub(super) fn controller(bytes: &[u8]) {
    let hello = Call::Hello {
        version: VERSION,
        nonce: 1,
        after: Session::NONE,
    };
    let mut desk = Desk::new(1, LONG_PATIENCE, Life::UNBORN);
    let offered = desk.hear(hello, &mut Noting::default());
    let Some(Reply::Welcome { session, .. }) = offered else {
        panic!("{offered:?} to a hello");
    };
    let mut tape = Vec::new();
    let mut put = |call: Call| {
        let mut frame = [0; FRAME];
        let frame = encode(&call, &Seal::Checksum, &mut frame).expect("it fits");
        tape.push(frame.len() as u8);
        tape.extend(frame);
    };
    put(hello);
    for (number, pair) in (1..).zip(bytes.chunks(2)) {
        let turn = Turn { session, number };
        let now = pair.get(1).copied().unwrap_or_default();
        let order = order(pair[0], now, Life(u32::from(number > 1)));
        put(Call::Order { turn, order });
    }
    tape.extend(bytes);
    let mut brain = Box::new(cla_core::forager::small::brain());
    let service = Service {
        fresh: 1,
        patience: LONG_PATIENCE,
        life: Life::UNBORN,
        seal: Seal::Checksum,
    };
    let (mut wire, mut motors) = (Tape(&tape), Motors(0));
    serve(&mut brain, &mut wire, &mut motors, &mut (), service);
    assert_eq!(brain.audit(), cla_core::agent::Audit::Sound);
}
