//! Brain in the loop: the brain in the emulated controller lives the host brain's life to the bit,
//! and the wire's troubles are survived on both sides.
//!
//! Needs qemu-system-arm and the target thumbv7em-none-eabihf; `tests/run` gets both.

use std::path::PathBuf;
use std::process::Command;

use firmware_example::controller::{End, Heard, SafeStop, Wire, serve};
use firmware_example::link::{Answer, Dropped, FRAME, Numbered, Order, Receiver, encode};
use host_sim::device::board::{Build, section_bytes};
use host_sim::device::target::Target;
use host_sim::experiment::hil::distant::Distant;
use host_sim::experiment::hil::{Hil, HilOptions, trial};
use host_sim::experiment::record::judged_again;

fn controller() -> PathBuf {
    let build = Build::new(Target::M4f, "controller");
    build.build().unwrap_or_else(|error| panic!("{error}"))
}

fn frame(number: u32, message: Order) -> Vec<u8> {
    let mut frame = [0; FRAME];
    let message = Numbered { number, message };
    encode(&message, &mut frame).expect("it fits").to_vec()
}

#[test]
fn the_firmware_chooses_what_the_host_chooses_and_ends_up_knowing_the_same() {
    let life =
        trial::run(Target::M4f, &controller(), 3, 600, 200).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((life.choices, life.same), (1_400, 1_400));
    assert!(life.same_knowledge);
    assert!(life.round_trips > 2_800, "{life:?}");
}

#[test]
fn a_life_in_the_loop_is_judged_the_same_when_it_was_written_down() {
    let options = HilOptions::new(vec![5], 100, 50).expect("at least one action");
    let results = judged_again::<Hil>(&options).unwrap_or_else(|e| panic!("{e}"));
    let same = results.summary.find("mcu.hil.same").expect("a claim");
    // One seed is no verdict, but it was the same.
    assert_eq!(same.per_seed, [Some(1.0)]);
}

#[test]
fn a_log_changes_nothing_of_the_life() {
    let build = Build {
        features: "defmt",
        ..Build::new(Target::M4f, "controller")
    };
    let logging = build.build().unwrap_or_else(|error| panic!("{error}"));
    let words = section_bytes(&logging, ".defmt").expect("a program");
    assert!(words > 10, "{words} formats are logged");
    let life = trial::run(Target::M4f, &logging, 3, 200, 100).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((life.choices, life.same), (500, 500));
    assert!(life.same_knowledge);
}

#[test]
fn damaged_frames_are_dropped_and_counted_and_the_life_goes_on() {
    let mut brain = Distant::start(Target::M4f, &controller(), 5).expect("it starts");
    let choose = |brain: &mut Distant| brain.ask(Order::Choose { now: 0 });
    let Ok(Answer::Chosen { .. }) = choose(&mut brain) else {
        panic!("a born brain chooses");
    };
    let good = frame(3, Order::Learn { now: 4 });
    let truncated = [&good[..good.len() / 2], &[0]].concat();
    let mut corrupted = good.clone();
    corrupted[2] ^= 0x10;
    let oversized = [vec![7; 3 * FRAME], vec![0]].concat();
    let replayed = frame(1, Order::Begin { seed: 6 });
    let repeated = frame(2, Order::Choose { now: 0 });
    let early = frame(9, Order::Act);
    for bytes in [
        &truncated, &corrupted, &oversized, &replayed, &repeated, &early,
    ] {
        brain.send(bytes).expect("the wire holds");
    }
    // Number 3 has not been followed yet: the brain still waits for what its choice led to.
    let learned = brain.ask(Order::Learn { now: 4 });
    assert_eq!(learned.expect("it lives"), Answer::Done);
    let Ok(Answer::Report { dropped, .. }) = brain.ask(Order::Report) else {
        panic!("it reports");
    };
    let expected = Dropped {
        broken: 2,
        oversized: 1,
        out_of_turn: 2,
        repeated: 1,
    };
    assert_eq!(dropped, expected);
    assert_eq!(
        brain.ask(Order::Learn { now: 4 }).expect("it lives"),
        Answer::Refused
    );
}

#[test]
fn a_host_that_vanishes_leaves_the_robot_in_a_safe_stop() {
    let brain = Distant::start(Target::M4f, &controller(), 5).expect("it starts");
    let (status, words) = brain.vanish();
    assert!(status.ends_with(": 3"), "{status}");
    assert_eq!(words, "motors stopped\nthe host is gone");
}

#[test]
fn the_host_says_how_the_firmware_died() {
    let mut brain = Distant::start(Target::M4f, &controller(), 5).expect("it starts");
    let killed = Command::new("kill")
        .args(["-9", &brain.id().to_string()])
        .status();
    assert!(killed.expect("there is a kill").success());
    let sentence = brain
        .ask(Order::Report)
        .expect_err("nobody is there")
        .to_string();
    assert!(
        sentence.contains("the firmware died after 2 frames"),
        "{sentence}"
    );
    assert!(sentence.contains("signal: 9"), "{sentence}");
}

/// A wire that delivers what was written down, and falls silent in between.
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
            return Heard::Silence;
        };
        bytes[..next.len()].copy_from_slice(&next);
        Heard::Bytes(next.len())
    }

    fn say(&mut self, bytes: &[u8]) -> bool {
        self.said.extend(bytes);
        true
    }
}

struct Motors(u32);

impl SafeStop for Motors {
    fn stop(&mut self) {
        self.0 += 1;
    }
}

fn served(heard: Vec<Option<Vec<u8>>>) -> (End, u32, Vec<Answer>) {
    let mut brain = Box::new(cla_core::forager::small::brain());
    let mut wire = Script {
        heard,
        said: Vec::new(),
    };
    let mut motors = Motors(0);
    let end = serve(&mut brain, &mut wire, &mut motors);
    let mut receiver = Receiver::new();
    let answers = wire
        .said
        .iter()
        .filter_map(|&byte| receiver.take::<Answer>(byte));
    let answers = answers
        .map(|it| it.expect("whole frames").message)
        .collect();
    (end, motors.0, answers)
}

#[test]
fn every_silence_and_every_end_stops_the_motors() {
    let begin = Some(frame(1, Order::Begin { seed: 1 }));
    let stop = Some(frame(2, Order::Stop));
    assert_eq!(
        served(vec![begin.clone(), None, None]),
        (End::HostGone, 3, vec![Answer::Done])
    );
    let told = served(vec![begin.clone(), stop.clone(), begin.clone()]);
    assert_eq!(told, (End::Told, 1, vec![Answer::Done, Answer::Done]));
}

#[test]
fn orders_out_of_turn_are_refused_by_a_brain_that_was_not_born() {
    let orders = [
        Order::Choose { now: 1 },
        Order::Learn { now: 1 },
        Order::Act,
    ];
    let frames = (1..)
        .zip(orders)
        .map(|(number, order)| Some(frame(number, order)));
    let (_, _, answers) = served(frames.collect());
    assert_eq!(answers, [Answer::Refused; 3]);
}

#[test]
fn any_cut_and_any_flipped_bit_of_a_frame_is_noticed() {
    let good = frame(
        77,
        Order::Observe {
            before: 3,
            action: 2,
            after: 9,
        },
    );
    let mut receiver = Receiver::new();
    let mut heard = |bytes: &[u8]| {
        bytes
            .iter()
            .filter_map(|&byte| receiver.take::<Order>(byte))
            .collect::<Vec<_>>()
    };
    for bit in 0..8 * (good.len() - 1) {
        let mut damaged = good.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        assert!(heard(&damaged).iter().all(Result::is_err), "bit {bit}");
    }
    for length in 1..good.len() - 1 {
        let cut = [&good[..length], &[0]].concat();
        assert!(heard(&cut).iter().all(Result::is_err), "{length} bytes");
    }
    assert!(heard(&good)[0].is_ok());
}
