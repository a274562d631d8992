//! Brain in the loop: the brain in the emulated controller lives the host brain's life to the bit,
//! and the wire's troubles are survived on both sides; without an emulator they are in `wire`.
//!
//! Needs qemu-system-arm and the target thumbv7em-none-eabihf; `tests/run` gets both.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use firmware_example::link::{
    Answer, Call, Dropped, FRAME, Key, Life, Order, Receiver, Refusal, Seal, Turn, encode,
};
use host_sim::device::board::{Build, section_bytes};
use host_sim::device::target::Target;
use host_sim::experiment::hil::distant::Distant;
use host_sim::experiment::hil::{Hil, HilOptions, trial};
use host_sim::experiment::record::judged_again;
use tempfile::tempdir;

fn controller() -> PathBuf {
    let build = Build::new(Target::M4f, "controller");
    build.build().unwrap_or_else(|error| panic!("{error}"))
}

/// The turn of the order that a brain was given last.
fn last_turn(brain: &Distant) -> Turn {
    let mut receiver = Receiver::new(Seal::Checksum);
    let mut heard = brain.last_frame().iter();
    match heard.find_map(|&byte| receiver.take::<Call>(byte)) {
        Some(Ok(Call::Order { turn, .. })) => turn,
        other => panic!("{other:?}"),
    }
}

fn frame(turn: Turn, order: Order) -> Vec<u8> {
    let mut frame = [0; FRAME];
    let call = Call::Order { turn, order };
    encode(&call, &Seal::Checksum, &mut frame)
        .expect("it fits")
        .to_vec()
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
    let born = brain.last_frame().to_vec();
    let choose = |brain: &mut Distant| brain.ask(Order::Choose { now: 0 });
    let Ok(Answer::Chosen { .. }) = choose(&mut brain) else {
        panic!("a born brain chooses");
    };
    let turn = last_turn(&brain);
    let at = |number| Turn { number, ..turn };
    let good = frame(at(turn.number + 1), Order::Learn { now: 4 });
    let truncated = [&good[..good.len() / 2], &[0]].concat();
    let mut corrupted = good.clone();
    corrupted[2] ^= 0x10;
    let oversized = [vec![7; 3 * FRAME], vec![0]].concat();
    let longer = [&good[..good.len() - 1], &[1, 0]].concat();
    let repeated = brain.last_frame().to_vec();
    let early = frame(at(turn.number + 7), Order::Act);
    let mut strange = turn;
    strange.session.0 ^= 1;
    let strange = frame(strange, Order::Act);
    for bytes in [
        &truncated, &corrupted, &oversized, &longer, &born, &repeated, &early, &strange,
    ] {
        brain.send(bytes).expect("the wire holds");
    }
    // The third order has not been followed yet: the brain still waits for what its choice led to.
    let learned = brain.ask(Order::Learn { now: 4 });
    assert_eq!(learned.expect("it lives"), Answer::Done);
    let Ok(Answer::Report {
        dropped, expired, ..
    }) = brain.ask(Order::Report)
    else {
        panic!("it reports");
    };
    let expected = Dropped {
        broken: 3,
        oversized: 1,
        out_of_turn: 2,
        repeated: 1,
        strange: 1,
    };
    assert_eq!((dropped, expired), (expected, 0));
    assert_eq!(
        brain.ask(Order::Learn { now: 4 }).expect("it lives"),
        Answer::Refused(Refusal::NothingChosen)
    );
}

#[test]
fn a_wire_full_of_anything_but_orders_stops_the_robot_and_what_was_chosen_is_forgotten() {
    let mut brain = Distant::start(Target::M4f, &controller(), 5).expect("it starts");
    let chosen = brain.ask(Order::Choose { now: 0 });
    assert!(matches!(chosen, Ok(Answer::Chosen { .. })), "{chosen:?}");
    let old = brain.last_frame().to_vec();
    let mut noise = vec![0; 1_000_000];
    noise[..500_000].fill(7);
    brain.send(&noise).expect("the wire holds");
    for _ in 0..500 {
        brain.send(&old).expect("the wire holds");
    }
    let learned = brain.ask(Order::Learn { now: 4 }).expect("it lives");
    assert_eq!(learned, Answer::Refused(Refusal::NothingChosen));
    let Ok(Answer::Report { expired, .. }) = brain.ask(Order::Report) else {
        panic!("it reports");
    };
    assert_eq!(expired, 1);
    let chosen = brain.ask(Order::Choose { now: 0 });
    assert!(matches!(chosen, Ok(Answer::Chosen { .. })), "{chosen:?}");
}

#[test]
fn a_life_ends_only_when_it_is_named() {
    let mut brain = Distant::start(Target::M4f, &controller(), 5).expect("it starts");
    let mut begin = |ends, name| {
        let order = Order::Begin {
            seed: 6,
            ends,
            name,
        };
        brain.ask(order).expect("it lives")
    };
    let refused = Answer::Refused(Refusal::OtherLife);
    assert_eq!(begin(Life::UNBORN, Life(2)), refused);
    assert_eq!(begin(Life(2), Life(3)), refused);
    assert_eq!(begin(Life(1), Life(1)), refused);
    assert_eq!(begin(Life(1), Life(2)), Answer::Done);
    assert_eq!(begin(Life(1), Life(3)), refused);
}

#[test]
fn frames_with_a_key_are_understood_by_who_has_it() {
    let build = Build {
        features: "authentic",
        ..Build::new(Target::M4f, "controller")
    };
    let program = build.build().unwrap_or_else(|error| panic!("{error}"));
    let seal = Seal::Keyed(Key::PUBLISHED);
    let mut brain =
        Distant::connect(Target::M4f, &program, Path::new("."), seal).expect("it starts");
    let (ends, name) = (Life::UNBORN, Life(1));
    let born = brain.ask(Order::Begin {
        seed: 5,
        ends,
        name,
    });
    assert_eq!(born.expect("it lives"), Answer::Done);
    // The same words under a checksum, and under another key.
    let turn = Turn {
        number: 2,
        ..Turn::NONE
    };
    let mut other = [0; FRAME];
    let call = Call::Order {
        turn,
        order: Order::Act,
    };
    let other = encode(&call, &Seal::Keyed(Key([1; 16])), &mut other).expect("it fits");
    for bytes in [frame(turn, Order::Act), other.to_vec()] {
        brain.send(&bytes).expect("the wire holds");
    }
    let Ok(Answer::Report { dropped, .. }) = brain.ask(Order::Report) else {
        panic!("it reports");
    };
    assert_eq!((dropped.broken, dropped.strange), (2, 0));
}

#[test]
fn a_brain_that_is_saved_by_an_order_lives_on_after_a_reset() {
    let build = Build {
        features: "flash small",
        ..Build::new(Target::M4f, "controller")
    };
    let program = build.build().unwrap_or_else(|error| panic!("{error}"));
    let folder = std::env::temp_dir().join(format!("saved-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let start = || Distant::connect(Target::M4f, &program, &folder, Seal::Checksum);
    let report = |brain: &mut Distant| match brain.ask(Order::Report) {
        Ok(Answer::Report {
            schemas, knowledge, ..
        }) => (schemas, knowledge),
        other => panic!("{other:?}"),
    };
    let begin = |ends, name| Order::Begin {
        seed: 5,
        ends,
        name,
    };
    let mut brain = start().expect("it starts");
    let unsaved = brain.ask(Order::Save).expect("it lives");
    assert_eq!(unsaved, Answer::Refused(Refusal::NotSaved));
    let born = brain.ask(begin(Life::UNBORN, Life(9))).expect("it lives");
    assert_eq!(born, Answer::Done);
    for now in (0..8).cycle().take(600) {
        brain.ask(Order::Choose { now }).expect("it lives");
        let now = (now + 1) % 8;
        let learned = brain.ask(Order::Learn { now }).expect("it lives");
        assert_eq!(learned, Answer::Done);
    }
    let known = report(&mut brain);
    assert!(known.0 > 0, "{known:?}");
    let saved = [(); 2].map(|()| brain.ask(Order::Save).expect("it lives"));
    assert_eq!(saved, [Answer::Saved(1), Answer::Saved(2)]);
    drop(brain);
    let mut brain = start().expect("it starts");
    assert_eq!((report(&mut brain), brain.life()), (known, Life(9)));
    let over = brain.ask(begin(Life::UNBORN, Life(10)));
    assert_eq!(over.expect("it lives"), Answer::Refused(Refusal::OtherLife));
    let (_, words) = brain.vanish();
    assert!(words.contains("resumed generation 2 of life 9"), "{words}");
    fs::remove_dir_all(&folder).expect("it was made above");
}

#[test]
fn a_brain_is_kept_by_its_policy_after_an_action_and_the_session_goes_on() {
    let build = Build {
        features: "flash small",
        ..Build::new(Target::M4f, "controller")
    };
    let program = build.build().unwrap_or_else(|error| panic!("{error}"));
    let folder = tempdir().expect("a folder");
    let brain = Distant::connect(Target::M4f, &program, folder.path(), Seal::Checksum);
    let mut brain = brain.expect("it starts");
    let mut ask = |order| brain.ask(order).expect("it lives");
    let (ends, name) = (Life::UNBORN, Life(9));
    let seed = 5;
    assert_eq!(ask(Order::Begin { seed, ends, name }), Answer::Done);
    // Twenty captures by a reflex (`hal::POLICY`), and the end of an action.
    let grip = Order::Observe {
        before: 0,
        action: 5,
        after: 1 << 5,
    };
    for _ in 0..20 {
        assert_eq!(ask(grip), Answer::Done);
    }
    for _ in 0..2 {
        let chosen = ask(Order::Choose { now: 0 });
        assert!(matches!(chosen, Answer::Chosen { .. }), "{chosen:?}");
        assert_eq!(ask(Order::Learn { now: 0 }), Answer::Done);
    }
    assert_eq!(ask(Order::Save), Answer::Saved(2));
    let (_, words) = brain.vanish();
    assert!(words.contains("kept generation 1 of life 9"), "{words}");
}

#[test]
fn a_host_that_vanishes_leaves_the_robot_in_a_safe_stop() {
    let brain = Distant::start(Target::M4f, &controller(), 5).expect("it starts");
    let (status, words) = brain.vanish();
    assert!(status.ends_with(": 3"), "{status}");
    assert_eq!(words, "motors stopped\nmotors stopped\nthe host is gone");
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
        sentence.contains("the firmware died after 2 orders"),
        "{sentence}"
    );
    assert!(sentence.contains("signal: 9"), "{sentence}");
}
