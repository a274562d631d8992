//! A brain that moves: saved on the host, gone on with on an emulated board, taken back.

use std::fs;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer;
use firmware_example::resume::{BACK, FROM_BOARD, THERE, TO_BOARD, live, names};
use firmware_example::trace::{ACTIONS, SEED};
use host_sim::device::board::{Build, Printed};
use host_sim::device::target::Target;
use host_sim::keeping::{keep, recall};
use tempfile::{TempDir, tempdir};

use super::budget::{Tolerance, hold};

/// What the board printed; `None` when it refused the image.
fn on_board(folder: &TempDir) -> (bool, String) {
    let build = Build::new(Target::M4f, "snapshot");
    let program = build.build().unwrap_or_else(|error| panic!("{error}"));
    let mut emulator = Target::M4f.emulator(&program);
    let output = emulator
        .current_dir(folder.path())
        .output()
        .expect("QEMU runs");
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    (output.status.success(), printed)
}

fn at_home() -> Box<pioneer::Brain> {
    let mut brain = Box::new(pioneer::brain());
    pioneer::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, SEED).expect("it is sound");
    live(&mut brain, 0, THERE / 2).expect("it lives");
    brain.act(Adaptation::Relearning).expect("it was born");
    brain.doubt();
    live(&mut brain, THERE / 2, THERE).expect("it lives");
    brain
}

/// A row of the budget: its name, and the number that was printed behind these words.
fn row(printed: &Printed, (name, start): (&str, &str)) -> (String, Vec<Option<u64>>) {
    let number = printed.number(start, "");
    let number = number.unwrap_or_else(|error| panic!("{error}"));
    (name.to_owned(), vec![Some(number)])
}

/// What loading, saving and keeping that brain in flash take, against the budget.
fn kept(printed: &Printed) {
    let row = |it| row(printed, it);
    let exact = [
        ("the store, two slots, bytes", "store bytes"),
        ("save: deepest stack", "flash save stack"),
        ("open: deepest stack", "flash open stack"),
        ("resume: deepest stack", "flash resume stack"),
        ("save: pages erased", "flash save pages"),
        ("save: bytes written", "flash save written"),
    ];
    let counted = [
        ("save: instructions", "flash save instructions"),
        ("open: instructions", "flash open instructions"),
        ("resume: instructions", "flash resume instructions"),
    ];
    let head = "| | Cortex-M4F |";
    let image = [
        ("image, bytes", "loaded"),
        ("load: deepest stack", "load stack"),
        ("save: deepest stack", "save stack"),
    ];
    let moved = [
        ("load: instructions", "load instructions"),
        ("save: instructions", "save instructions"),
    ];
    hold("image", head, &image.map(row).to_vec(), Tolerance::None);
    let moved = moved.map(row).to_vec();
    hold("image instructions", head, &moved, Tolerance::Percent);
    hold("store", head, &exact.map(row).to_vec(), Tolerance::None);
    let counted = counted.map(row).to_vec();
    hold("store instructions", head, &counted, Tolerance::Percent);
}

/// What it takes to find a bit of it that turned between two ticks.
fn scrubbed(printed: &Printed) {
    let row = |it| row(printed, it);
    let exact = [
        ("sums of a whole forager, bytes", "scrub bytes"),
        ("seal: deepest stack", "scrub seal stack"),
        ("check: deepest stack", "scrub check stack"),
    ];
    let counted = [
        ("seal: instructions", "scrub seal instructions"),
        ("check: instructions", "scrub check instructions"),
    ];
    let head = "| | Cortex-M4F |";
    hold("scrub", head, &exact.map(row).to_vec(), Tolerance::None);
    let counted = counted.map(row).to_vec();
    hold("scrub instructions", head, &counted, Tolerance::Percent);
}

#[test]
fn a_life_goes_from_the_host_to_a_board_and_back_and_nobody_can_tell() {
    let folder = tempdir().expect("a folder");
    let (there, back) = (folder.path().join(TO_BOARD), folder.path().join(FROM_BOARD));
    let mut home = at_home();
    let sent = keep(&*home, names(), &there).expect("it is saved");
    let (taken, printed) = on_board(&folder);
    assert!(taken, "{printed}");
    println!("{printed}");
    // The life that was never interrupted, on this machine.
    let print = live(&mut home, THERE, BACK).expect("it lives");
    let whole = folder.path().join("whole.brain");
    let bytes = keep(&*home, names(), &whole).expect("it is saved");
    for line in [
        format!("loaded {sent}"),
        format!("life {print}"),
        format!("saved {bytes}"),
    ] {
        assert!(printed.lines().any(|it| it == line), "{line}: {printed}");
    }
    assert!(fs::read(&whole).expect("whole") == fs::read(&back).expect("back"));
    let printed = Printed::from(printed);
    kept(&printed);
    scrubbed(&printed);
    let mut returned = Box::new(pioneer::brain());
    recall(&mut *returned, names(), &back).expect("it is whole");
    let lives = [&mut home, &mut returned].map(|it| live(it, BACK, ACTIONS / 4).expect("it lives"));
    assert_eq!(lives[0], lives[1]);

    // A damaged image is refused there as here.
    let mut damaged = fs::read(&there).expect("the image");
    let middle = damaged.len() / 2;
    damaged[middle] ^= 0x10;
    fs::write(&there, damaged).expect("a file");
    let (taken, printed) = on_board(&folder);
    assert!(
        !taken && printed.contains("the image is damaged in its maps"),
        "{printed}"
    );
}
