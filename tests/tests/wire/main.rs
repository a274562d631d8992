//! The wire between a brain and a body, without an emulator: both sides as machines, and sessions that
//! are disturbed.
//!
//! Whole sessions over a disturbed wire are in `host_sim::experiment::hil::disturbed`.

mod frames;
mod served;

use firmware_example::link::{
    ATTEMPTS, Answer, Call, Caller, Desk, Dropped, FRAME, Fault, Life, News, Order, Outcome,
    Receiver, Refusal, Reply, Robot, Said, Seal, Session, Turn, VERSION, encode,
};
use host_sim::experiment::hil::disturbed::{self, Tally};

/// What a robot of these tests may go on for without an order, in milliseconds.
const PATIENCE: u32 = 100;

fn sealed<T: Said>(it: &T, seal: &Seal) -> Vec<u8> {
    let mut frame = [0; FRAME];
    encode(it, seal, &mut frame).expect("it fits").to_vec()
}

fn frame<T: Said>(it: &T) -> Vec<u8> {
    sealed(it, &Seal::Checksum)
}

fn heard<T: Said>(bytes: &[u8], seal: Seal) -> Vec<Result<T, Fault>> {
    let mut receiver = Receiver::new(seal);
    bytes
        .iter()
        .filter_map(|&byte| receiver.take(byte))
        .collect()
}

/// A robot that does everything, and notes it.
#[derive(Default)]
struct Noting {
    now: u32,
    stops: u32,
    followed: Vec<Order>,
}

impl Robot for Noting {
    fn now(&mut self) -> u32 {
        self.now
    }

    fn stop(&mut self) {
        self.stops += 1;
    }

    fn known(&mut self) -> (u16, u64) {
        (9, 77)
    }

    fn save(&mut self, life: Life) -> Option<u32> {
        self.followed.push(Order::Save);
        (life == Life(7)).then_some(3)
    }

    fn follow(&mut self, order: Order) -> Answer {
        self.followed.push(order);
        match order {
            Order::Choose { now } => Answer::Chosen {
                action: now,
                value: 0,
            },
            _ => Answer::Done,
        }
    }
}

/// Both sides, joined by a wire that loses what it is told to.
struct Pair {
    desk: Desk,
    robot: Noting,
    caller: Caller,
    /// Calls that were made.
    calls: u32,
}

impl Pair {
    fn new() -> Self {
        Self {
            desk: Desk::new(1, PATIENCE, Life::UNBORN),
            robot: Noting::default(),
            caller: Caller::new(1),
            calls: 0,
        }
    }

    /// Carries a call and its reply over.
    fn carry(&mut self, call: Call) -> News {
        self.calls += 1;
        match self.desk.hear(call, &mut self.robot) {
            Some(reply) => self.caller.hear(reply),
            None => News::Nothing,
        }
    }

    /// Asks until there is news.
    fn ask(&mut self, order: Order) -> News {
        let mut call = self.caller.ask(order);
        loop {
            match self.carry(call) {
                News::Send(next) => call = next,
                News::Nothing => match self.caller.wait() {
                    News::Send(next) => call = next,
                    news => return news,
                },
                news => return news,
            }
        }
    }

    fn born(mut self) -> Self {
        let begin = Order::Begin {
            seed: 4,
            ends: Life::UNBORN,
            name: Life(7),
        };
        assert_eq!(self.ask(begin), News::Answered(Answer::Done));
        self.calls = 0;
        self
    }
}

const CHOOSE: Order = Order::Choose { now: 2 };
const LEARN: Order = Order::Learn { now: 3 };
const CHOSEN: News = News::Answered(Answer::Chosen {
    action: 2,
    value: 0,
});

#[test]
fn a_session_begins_with_a_handshake_and_needs_one_call_an_order_from_then_on() {
    let mut pair = Pair::new();
    let begin = Order::Begin {
        seed: 4,
        ends: Life::UNBORN,
        name: Life(7),
    };
    assert_eq!(pair.ask(begin), News::Answered(Answer::Done));
    assert_eq!((pair.calls, pair.caller.life()), (2, Life(7)));
    assert_eq!(pair.ask(CHOOSE), CHOSEN);
    assert_eq!(pair.ask(LEARN), News::Answered(Answer::Done));
    assert_eq!((pair.calls, pair.robot.stops), (4, 0));
}

#[test]
fn another_version_is_told_and_not_obeyed() {
    let mut desk = Desk::new(1, PATIENCE, Life::UNBORN);
    let hello = Call::Hello {
        version: VERSION + 1,
        nonce: 5,
        after: Session::NONE,
    };
    let reply = desk.hear(hello, &mut Noting::default());
    let (version, nonce) = (VERSION, 5);
    assert_eq!(reply, Some(Reply::OtherVersion { version, nonce }));
    let mut caller = Caller::new(1);
    let Call::Hello { nonce, .. } = caller.ask(CHOOSE) else {
        panic!("a session begins with a hello");
    };
    let version = VERSION + 1;
    let news = caller.hear(Reply::OtherVersion { version, nonce });
    assert_eq!(news, News::OtherVersion(version));
}

#[test]
fn a_lost_order_a_lost_answer_and_a_stray_frame_cost_one_call() {
    for lost in ["order", "answer", "stray"] {
        let mut pair = Pair::new().born();
        let call = pair.caller.ask(CHOOSE);
        match lost {
            "order" => {}
            "answer" => assert!(pair.desk.hear(call, &mut pair.robot).is_some()),
            _ => {
                // The right session, a number that is not its turn.
                let Call::Order { mut turn, .. } = call else {
                    panic!("a session is open");
                };
                turn.number += 1;
                let stray = Call::Order { turn, order: LEARN };
                assert_eq!(pair.desk.hear(stray, &mut pair.robot), None);
            }
        }
        let News::Send(again) = pair.caller.wait() else {
            panic!("it is asked again");
        };
        assert_eq!((again, pair.carry(again)), (call, CHOSEN), "{lost}");
        let chosen = pair.robot.followed.iter().filter(|it| **it == CHOOSE);
        assert_eq!(chosen.count(), 1, "{lost}");
    }
}

#[test]
fn a_reset_of_either_side_is_over_after_three_calls() {
    let mut pair = Pair::new().born();
    pair.desk = Desk::new(2, PATIENCE, Life::UNBORN);
    let news = pair.ask(CHOOSE);
    assert_eq!(news, News::Interrupted(Outcome::Unknown));
    assert_eq!((pair.calls, pair.caller.life()), (2, Life::UNBORN));
    let begin = Order::Begin {
        seed: 4,
        ends: Life::UNBORN,
        name: Life(8),
    };
    assert_eq!(pair.ask(begin), News::Answered(Answer::Done));
    assert_eq!(pair.calls, 3);

    let mut pair = Pair::new().born();
    pair.caller = Caller::new(2);
    assert!(matches!(
        pair.ask(Order::Report),
        News::Answered(Answer::Report { .. })
    ));
    assert_eq!((pair.calls, pair.caller.life()), (2, Life(7)));
    // Somebody else has taken over: what the robot did for the one before is at an end.
    assert_eq!(pair.robot.stops, 1);
}

#[test]
fn a_body_that_was_replaced_stops_the_robot_of_its_successor() {
    let mut first = Pair::new().born();
    assert_eq!(first.ask(CHOOSE), CHOSEN);
    let mut second = Pair {
        caller: Caller::new(2),
        ..first
    };
    assert_eq!(second.ask(CHOOSE), CHOSEN);
    let (stops, calls) = (second.robot.stops, second.calls);
    assert!(second.desk.is_open());
    let mut first = Pair {
        caller: first.caller,
        ..second
    };
    assert_eq!(first.ask(Order::Stop), News::Answered(Answer::Done));
    assert!(first.desk.is_told() && !first.desk.is_open());
    assert!(first.robot.stops > stops);
    assert_eq!(first.calls - calls, 3);
}

#[test]
fn a_stop_whose_answers_are_lost_is_given_again_until_it_is_answered() {
    let mut pair = Pair::new().born();
    assert_eq!(pair.ask(CHOOSE), CHOSEN);
    let mut call = pair.caller.ask(Order::Stop);
    for _ in 0..ATTEMPTS {
        pair.desk.hear(call, &mut pair.robot);
        let News::Send(next) = pair.caller.wait() else {
            panic!("it is asked again");
        };
        call = next;
    }
    assert!(matches!(call, Call::Hello { .. }), "{call:?}");
    let News::Send(again) = pair.carry(call) else {
        panic!("it is given again");
    };
    assert_eq!(pair.carry(again), News::Answered(Answer::Done));
}

#[test]
fn a_report_and_a_save_are_answered_by_the_desk() {
    let mut pair = Pair::new();
    let refused = News::Answered(Answer::Refused(Refusal::NotSaved));
    assert_eq!(pair.ask(Order::Save), refused);
    let mut pair = pair.born();
    assert_eq!(pair.ask(CHOOSE), CHOSEN);
    assert_eq!(pair.ask(Order::Save), News::Answered(Answer::Saved(3)));
    let cut_off = News::Answered(Answer::Refused(Refusal::NothingChosen));
    assert_eq!(pair.ask(LEARN), cut_off);
    let report = Answer::Report {
        dropped: Dropped::default(),
        expired: 0,
        schemas: 9,
        knowledge: 77,
    };
    assert_eq!(pair.ask(Order::Report), News::Answered(report));
    assert_eq!(pair.robot.followed.last(), Some(&Order::Save));
}

#[test]
fn only_orders_that_are_followed_keep_a_robot_moving() {
    let mut pair = Pair::new().born();
    assert_eq!(pair.ask(CHOOSE), CHOSEN);
    let turn = Turn {
        number: 2,
        session: match pair.caller.ask(LEARN) {
            Call::Order { turn, .. } => turn.session,
            Call::Hello { .. } => panic!("a session is open"),
        },
    };
    let nothing = Order::Begin {
        seed: 1,
        ends: Life(99),
        name: Life(100),
    };
    for step in 1..=PATIENCE {
        assert_eq!(pair.robot.stops, 0, "{step}");
        pair.robot.now += 1;
        let number = 2 + step;
        let refused = Call::Order {
            turn: Turn { number, ..turn },
            order: if step % 2 == 0 {
                nothing
            } else {
                Order::Report
            },
        };
        let old = Call::Order {
            turn,
            order: CHOOSE,
        };
        let hello = Call::Hello {
            version: VERSION,
            nonce: step.into(),
            after: Session::NONE,
        };
        for call in [old, refused, hello] {
            pair.desk.hear(call, &mut pair.robot);
        }
    }
    assert!(pair.robot.stops == 1 && !pair.desk.is_open());
}

#[test]
fn after_a_stop_nothing_is_followed_without_a_handshake_and_nothing_learned_from_what_was_cut_off()
{
    let mut pair = Pair::new().born();
    assert_eq!(pair.ask(CHOOSE), CHOSEN);
    pair.robot.now += PATIENCE;
    pair.desk.tick(&mut pair.robot);
    assert_eq!(pair.robot.stops, 1);
    let before = pair.robot.followed.len();
    let learn = pair.caller.ask(LEARN);
    let reply = pair.desk.hear(learn, &mut pair.robot);
    assert!(matches!(reply, Some(Reply::Closed { .. })), "{reply:?}");
    let news = pair.ask(LEARN);
    let refused = Answer::Refused(Refusal::NothingChosen);
    assert_eq!(news, News::Answered(refused));
    assert_eq!(pair.robot.followed.len(), before);
    assert_eq!(pair.ask(CHOOSE), CHOSEN);
}

#[test]
fn whoever_gave_an_order_hears_what_became_of_it() {
    for followed in [false, true] {
        let mut pair = Pair::new().born();
        let call = pair.caller.ask(CHOOSE);
        if followed {
            // The answer gets lost.
            pair.desk.hear(call, &mut pair.robot);
        }
        let mut told = News::Nothing;
        for _ in 0..=ATTEMPTS {
            told = pair.caller.wait();
        }
        // It gave up the session, which the other side hears first.
        let News::Send(hello) = told else {
            panic!("{told:?}")
        };
        let outcome = match followed {
            true => Outcome::Followed,
            false => Outcome::NotFollowed,
        };
        assert_eq!(pair.carry(hello), News::Interrupted(outcome));
        // The order comes after all, much too late.
        let reply = pair.desk.hear(call, &mut pair.robot);
        assert!(matches!(reply, Some(Reply::Closed { .. })), "{reply:?}");
    }
}

#[test]
fn a_recorded_session_played_again_moves_nothing() {
    let mut pair = Pair::new();
    let mut tape = Vec::new();
    let orders = [
        Order::Begin {
            seed: 4,
            ends: Life::UNBORN,
            name: Life(7),
        },
        CHOOSE,
        LEARN,
        Order::Act,
    ];
    for order in orders {
        let mut call = pair.caller.ask(order);
        loop {
            tape.push(call);
            match pair.carry(call) {
                News::Send(next) => call = next,
                news => break assert!(matches!(news, News::Answered(_))),
            }
        }
    }
    assert_eq!((tape.len(), pair.robot.followed.len()), (5, 4));
    // After a reset; then in the middle of another session.
    for reset in [true, false] {
        let mut robot = Noting::default();
        if reset {
            pair.desk = Desk::new(2, PATIENCE, Life::UNBORN);
        }
        for &call in &tape {
            pair.desk.hear(call, &mut robot);
        }
        assert_eq!((robot.followed.len(), robot.stops), (0, 0));
        let mut pair = Pair {
            desk: pair.desk.clone(),
            robot,
            caller: Caller::new(3),
            calls: 0,
        };
        let report = pair.ask(Order::Report);
        assert!(matches!(report, News::Answered(_)));
    }
}

#[test]
fn an_offer_that_nobody_takes_up_in_time_is_none() {
    let mut pair = Pair::new();
    let hello = pair.caller.ask(CHOOSE);
    let News::Send(order) = pair.carry(hello) else {
        panic!("it is welcome");
    };
    pair.robot.now += PATIENCE;
    let reply = pair.desk.hear(order, &mut pair.robot);
    assert!(matches!(reply, Some(Reply::Closed { .. })), "{reply:?}");
    assert_eq!(pair.robot.followed, []);
}

#[test]
fn a_caller_whom_nobody_answers_says_so() {
    let mut caller = Caller::new(1);
    caller.ask(CHOOSE);
    for _ in 1..ATTEMPTS {
        assert!(matches!(caller.wait(), News::Send(Call::Hello { .. })));
    }
    assert_eq!(caller.wait(), News::Silent);
    assert_eq!(caller.wait(), News::Nothing);
    assert!(!caller.is_waiting());
}

#[test]
fn disturbed_sessions_move_nothing_wrongly_and_find_back_within_three_calls() {
    // `tests/run all` asks for more.
    let sessions = std::env::var("CLA_SESSIONS").map_or(20_000, |it| it.parse().unwrap());
    let batches: Vec<u64> = (0..20).collect();
    let many = |seed: &u64| disturbed::many(*seed, sessions / 20, false);
    let mut tally = Tally::default();
    std::thread::scope(|scope| {
        let halves = batches.chunks(10);
        let halves: Vec<_> = halves
            .map(|half| scope.spawn(move || half.iter().map(many).collect::<Vec<_>>()))
            .collect();
        for half in halves {
            for one in half.join().expect("it ends") {
                tally.merge(&one);
            }
        }
    });
    println!("{tally:#?}");
    assert_eq!((tally.wrong, tally.astray, tally.calls[3]), (0, 0, 0));
    assert!(tally.longest <= disturbed::PATIENCE + 1);
    // It was disturbed, in every way, and went on.
    assert_eq!(tally.sessions, u64::from(sessions));
    for many in [tally.disturbed, tally.intruded, tally.stops, tally.resets] {
        assert!(many > tally.sessions, "{tally:#?}");
    }
    assert!(tally.calls.iter().take(3).all(|it| *it > 0));
}

#[test]
fn a_firmware_that_names_its_sessions_as_before_its_reset_is_found_out() {
    let tally = disturbed::many(3, 3_000, true);
    assert!(tally.wrong > 0, "{tally:#?}");
}
