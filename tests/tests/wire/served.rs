//! A controller with a brain, served from a script.

use cla_core::flash::{FlashStore, RamFlash};
use cla_core::forager::small;
use firmware_example::controller::{End, Heard, Keep, SafeStop, Service, Wire, serve};
use firmware_example::link::{
    Answer, Call, Desk, Life, Order, Refusal, Reply, Seal, Session, Turn, VERSION,
};

use firmware_example::shelf::Shelf;

use super::{CHOOSE, LEARN, Noting, PATIENCE, frame};

/// A wire that delivers what was written down, and pauses in between.
struct Script {
    heard: Vec<Option<Vec<u8>>>,
    said: Vec<u8>,
}

impl Wire for Script {
    fn hear(&mut self, bytes: &mut [u8]) -> Heard {
        if self.heard.is_empty() {
            return Heard::Gone;
        }
        let Some(next) = self.heard.remove(0) else {
            return Heard::Pause;
        };
        bytes[..next.len()].copy_from_slice(&next);
        Heard::Bytes(next.len())
    }

    fn say(&mut self, bytes: &[u8]) -> bool {
        self.said.extend(bytes);
        true
    }
}

/// Motors whose clock goes on a millisecond whenever it is looked at.
#[derive(Default)]
struct Motors {
    now: u32,
    stops: u32,
}

impl SafeStop for Motors {
    fn now(&mut self) -> u32 {
        self.now += 1;
        self.now
    }

    fn stop(&mut self) {
        self.stops += 1;
    }
}

/// What a controller for small parts answers, and how often it stops its motors.
fn served(heard: Vec<Option<Vec<u8>>>) -> (End, u32, Vec<Answer>) {
    kept_and_served(heard, &mut ())
}

/// The same where its brain can be kept.
fn kept_and_served(
    heard: Vec<Option<Vec<u8>>>,
    kept: &mut impl Keep<small::Brain>,
) -> (End, u32, Vec<Answer>) {
    let mut brain = Box::new(small::brain());
    let mut wire = Script {
        heard,
        said: Vec::new(),
    };
    let mut motors = Motors::default();
    let service = Service {
        fresh: 11,
        patience: PATIENCE,
        life: Life::UNBORN,
        seal: Seal::Checksum,
    };
    let end = serve(&mut brain, &mut wire, &mut motors, kept, service);
    let replies = super::heard::<Reply>(&wire.said, Seal::Checksum);
    let answers = replies.into_iter().filter_map(|it| match it {
        Ok(Reply::Answer { answer, .. }) => Some(answer),
        Ok(_) => None,
        Err(fault) => panic!("{fault:?}"),
    });
    (end, motors.stops, answers.collect())
}

/// A hello and orders as frames, in the session that such a controller offers first.
fn session(orders: &[Order]) -> Vec<Option<Vec<u8>>> {
    let hello = Call::Hello {
        version: VERSION,
        nonce: 1,
        after: Session::NONE,
    };
    let mut desk = Desk::new(11, PATIENCE, Life::UNBORN);
    let Some(Reply::Welcome { session, .. }) = desk.hear(hello, &mut Noting::default()) else {
        panic!("it is welcome");
    };
    let orders = (1..).zip(orders).map(|(number, &order)| {
        let turn = Turn { session, number };
        Call::Order { turn, order }
    });
    let calls = [hello].into_iter().chain(orders);
    calls.map(|call| Some(frame(&call))).collect()
}

const BEGIN: Order = Order::Begin {
    seed: 1,
    ends: Life::UNBORN,
    name: Life(1),
};

#[test]
fn a_controller_stops_its_motors_at_its_beginning_at_its_end_and_when_orders_stay_away() {
    let gone = served(session(&[BEGIN]));
    assert_eq!(gone, (End::HostGone, 2, vec![Answer::Done]));
    let told = served(session(&[BEGIN, Order::Stop, BEGIN]));
    assert_eq!(told, (End::Told, 2, vec![Answer::Done, Answer::Done]));
    for noise in [None, Some(vec![0; 100]), Some(vec![9; 100])] {
        let mut wire = session(&[BEGIN, CHOOSE]);
        wire.extend(vec![noise.clone(); PATIENCE as usize + 1]);
        let (end, stops, answers) = served(wire);
        assert_eq!(
            (end, stops, answers.len()),
            (End::HostGone, 3, 2),
            "{noise:?}"
        );
    }
}

const SLOT: u32 = 96 * 1024;

fn open(bytes: &mut [u8]) -> Shelf<RamFlash<'_, 4, 4096>, 2> {
    let flash = RamFlash::new(bytes);
    Shelf::new(FlashStore::open(flash, 0, SLOT).expect("whole pages"))
}

#[test]
fn a_brain_is_kept_when_that_is_ordered_and_the_robot_stands_meanwhile() {
    let orders = [BEGIN, CHOOSE, Order::Save, LEARN, CHOOSE];
    let mut bytes = vec![0xff; 2 * SLOT as usize];
    let mut shelf = open(&mut bytes);
    let mut brain = Box::new(small::brain());
    assert!(shelf.resume(&mut *brain).is_err());
    let (end, stops, answers) = kept_and_served(session(&orders), &mut shelf);
    assert_eq!((end, stops), (End::HostGone, 3));
    assert_eq!(answers[2], Answer::Saved(1));
    // What a stop has cut off is not learned from, and the session goes on.
    assert_eq!(answers[3], Answer::Refused(Refusal::NothingChosen));
    assert!(matches!(answers[4], Answer::Chosen { .. }));
    let resumed = open(&mut bytes).resume(&mut *brain).expect("it was saved");
    assert_eq!((resumed.generation, resumed.tick), (1, 1));
    let (_, stops, answers) = served(session(&orders));
    assert_eq!(stops, 3);
    assert_eq!(answers[2], Answer::Refused(Refusal::NotSaved));
}

#[test]
fn orders_that_an_unborn_brain_cannot_follow_are_refused() {
    let (_, _, answers) = served(session(&[
        Order::Choose { now: 1 },
        Order::Act,
        Order::SecondLevel,
    ]));
    assert_eq!(answers, [Answer::Refused(Refusal::Brain); 3]);
}
