//! The firmware in QEMU against the host: the same life, the same bits, on three processors.
//!
//! Needs qemu-system-arm, qemu-system-riscv32 and the targets; `tests/run` gets them.

mod budget;
mod meter;
mod snapshots;
mod wire;

use std::sync::{Mutex, PoisonError};

use cla_core::agent::{Adaptation, Agent, AgentConfig};
use cla_core::forager::{pioneer, small};
use cla_core::som::Prototypes;
use cla_core::word::ActionId;
use firmware_example::mind;
use firmware_example::replay::{Echo, Forager, acting_at, relive, second_level_at};
use firmware_example::trace::{self, ACTIONS, SEED, Step};
use host_sim::device::board::{Build, Printed, section_bytes};
use host_sim::device::target::Target;
use host_sim::failure::Failure;
use host_sim::learner::native::narrowed;
use host_sim::learner::{Learner, live};
use host_sim::world;
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::Pioneer;

/// Instructions that a call of the learner for any world may take on a Cortex-M4F.
const MOST: u32 = 120_000;

/// The life on this machine.
fn on_host<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: Forager<W, H, P, S, Y, B, M>,
    actions: u32,
) -> Echo {
    let mut brain = Box::new(brain);
    relive(&mut brain, SEED, actions, |_, _| {}).expect("the recording is whole")
}

/// Runs a program on its board, and answers from memory the next time.
fn run_once(build: &Build) -> Printed {
    static RUNS: Mutex<Vec<(Build, Printed)>> = Mutex::new(Vec::new());
    let mut runs = RUNS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, printed)) = runs.iter().find(|(other, _)| other == build) {
        return printed.clone();
    }
    let printed = build.run().unwrap_or_else(|error| panic!("{error}"));
    runs.push((build.clone(), printed.clone()));
    printed
}

/// The life on a board.
fn in_qemu(target: Target, features: &'static str) -> String {
    let build = Build {
        features,
        ..Build::new(target, "firmware")
    };
    run_once(&build).text().to_owned()
}

fn same(host: &Echo, board: &str) {
    let host = host.to_string();
    assert!(
        board.starts_with(&host),
        "the host says\n{host}the firmware says\n{board}"
    );
}

#[test]
fn twenty_thousand_actions_have_the_same_bits_on_the_cortex_m4f() {
    same(
        &on_host(pioneer::brain(), ACTIONS),
        &in_qemu(Target::M4f, ""),
    );
}

#[test]
fn two_thousand_actions_have_the_same_bits_where_floats_are_functions() {
    let host = on_host(pioneer::brain(), ACTIONS / 10);
    same(&host, &in_qemu(Target::M0, ""));
    same(&host, &in_qemu(Target::Riscv, ""));
}

#[test]
fn the_brain_for_small_parts_has_the_same_bits_too() {
    same(
        &on_host(small::brain(), ACTIONS),
        &in_qemu(Target::M4f, "small"),
    );
    same(
        &on_host(small::brain(), ACTIONS / 10),
        &in_qemu(Target::M0, "small"),
    );
}

/// The number after a word of what a board printed.
fn printed(text: &str, line: &str, word: &str) -> u32 {
    let line = text.lines().find(|it| it.starts_with(line));
    let mut words = line.unwrap_or_default().split_whitespace();
    words.find(|&it| it == word);
    let number = words.next().and_then(|it| it.parse().ok());
    number.unwrap_or_else(|| panic!("{word} of {line:?}"))
}

#[test]
fn the_learner_for_any_world_has_the_same_bits_on_the_cortex_m4f_in_bounded_calls() {
    let mut mind = Box::new(mind::Forager::new());
    let life = mind::relive(&mut mind, ACTIONS, |_| {}).expect("the recording is whole");
    let build = Build::new(Target::M4f, "mind");
    let board = run_once(&build).text().to_owned();
    assert!(
        board.starts_with(&format!("life {life}\n")),
        "{life}, {board}"
    );
    let program = build.build().expect("it has run");
    let data = section_bytes(&program, ".data").expect("a program");
    assert_eq!(data, 0, "the mind would lie in flash as well");
    let choose = printed(&board, "choose", "worst");
    let learn = printed(&board, "learn", "worst");
    assert!(choose > 0 && choose.max(learn) <= MOST, "{board}");
}

#[test]
fn the_recorded_life_is_worth_reliving() {
    let echo = on_host(pioneer::brain(), ACTIONS);
    assert_eq!((echo.actions, echo.agreed), (ACTIONS, ACTIONS));
    assert!(echo.schemas > 50, "{echo}");
    let all = || trace::steps(ACTIONS);
    let gripped = all().filter(|step| step.reflex && step.action == pioneer::Action::grip.id());
    let bumped =
        all().filter(|step| step.reflex && step.action == pioneer::Action::turnaround.id());
    let (gripped, bumped) = (gripped.count(), bumped.count());
    assert!(
        gripped > 500 && bumped > 100,
        "{gripped} captures, {bumped} bumps"
    );
}

/// Lives beside the recording and compares.
struct Witness {
    brain: Box<pioneer::Brain>,
    chosen: ActionId,
    before: pioneer::Percept,
    recorded: Box<dyn Iterator<Item = Step>>,
}

impl Witness {
    fn compare(&mut self, step: Step) {
        assert_eq!(
            self.recorded.next(),
            Some(step),
            "record_trace makes it again"
        );
    }
}

impl Learner for Witness {
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        let action = Learner::choose(&mut *self.brain, now)?;
        self.before = narrowed(now);
        self.chosen = ActionId(action as u16);
        Ok(action)
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        self.compare(Step {
            before: self.before,
            action: self.chosen,
            after: narrowed(now),
            reflex: false,
        });
        Learner::learn(&mut *self.brain, now)
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        self.compare(Step {
            before: narrowed(before),
            action: ActionId(action as u16),
            after: narrowed(after),
            reflex: true,
        });
        Learner::observe(&mut *self.brain, before, action, after)
    }
}

#[test]
fn the_recording_is_of_the_present_world_and_the_present_brain() {
    let mut brain: Box<pioneer::Brain> = Box::new(Agent::new());
    pioneer::be_born(&mut brain, AgentConfig::FORAGER, SEED).expect("a valid configuration");
    let mut witness = Witness {
        brain,
        chosen: ActionId(0),
        before: pioneer::Percept::all_off(7),
        recorded: Box::new(trace::steps(ACTIONS)),
    };
    let mut world = Pioneer::new(PioneerConfig::NOISY, SEED).expect("the reference world");
    let (second, acting) = (second_level_at(ACTIONS), acting_at(ACTIONS));
    live(&mut witness, &mut world, second).expect("it lives");
    let level2 = AgentConfig::FORAGER_LEVEL2;
    witness.brain.reconfigure(level2).expect("it is sound");
    live(&mut witness, &mut world, acting - second).expect("it lives");
    witness
        .brain
        .act(Adaptation::Relearning)
        .expect("it was born");
    live(&mut witness, &mut world, ACTIONS - acting).expect("it lives");
    assert_eq!(witness.recorded.next(), None);
}

#[test]
fn another_life_has_another_fingerprint() {
    let here = on_host(pioneer::brain(), 2_000);
    let mut brain = Box::new(pioneer::brain());
    let other = relive(&mut brain, SEED + 1, 2_000, |_, _| {}).expect("it lives");
    assert_ne!(here.weights, other.weights);
    assert_ne!(here.distances, other.distances);
    assert_ne!(here.choices, other.choices);
}

#[test]
fn a_brain_that_does_not_fit_its_part_does_not_link() {
    let fits = |target, part, features| {
        let build = Build {
            part: Some(part),
            features,
            ..Build::new(target, "firmware")
        };
        match build.build() {
            Ok(_) => true,
            Err(error) => {
                let error = error.to_string();
                let too_large = error.contains("will not fit in region 'RAM'")
                    || error.contains("leave the stack less than 4 KiB");
                assert!(too_large, "{error}");
                false
            }
        }
    };
    // The RP2040 has two Cortex-M0+.
    assert!(fits(Target::M0, "rp2040", ""));
    for part in ["rp2350", "stm32h743"] {
        assert!(fits(Target::M4f, part, ""), "{part}");
    }
    for part in ["nrf52840", "stm32f405"] {
        assert!(fits(Target::M4f, part, "small"), "{part}");
        assert!(!fits(Target::M4f, part, ""), "{part} has no room for it");
    }
}
