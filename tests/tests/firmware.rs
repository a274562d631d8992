//! The firmware in QEMU against the host: the same life, the same bits.
//!
//! Needs qemu-system-arm and the target thumbv7em-none-eabihf; `tests/run` gets both.

use std::process::Output;

use cla_core::forager::pioneer;
use firmware_example::replay::{Echo, relive};
use firmware_example::trace;

fn on_host() -> Echo {
    let mut brain = Box::new(pioneer::brain());
    relive(&mut brain, trace::SEED, trace::steps(), |_| {}).expect("the recording is whole")
}

/// Builds the firmware and runs it, as its user does.
fn in_qemu() -> Output {
    cla_tests::firmware_cargo()
        .args(["run", "--release", "--locked"])
        .output()
        .expect("cargo runs")
}

#[test]
fn the_recorded_life_has_the_same_bits_on_the_cortex_m4f() {
    let output = in_qemu();
    let printed = String::from_utf8_lossy(&output.stdout);
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "the firmware failed (is qemu-system-arm there? tests/run gets it):\n{printed}{complaints}"
    );
    let expected = on_host().to_string();
    assert!(
        printed.starts_with(&expected),
        "the host says\n{expected}the firmware says\n{printed}"
    );
}

#[test]
fn the_recorded_life_is_worth_reliving() {
    let echo = on_host();
    assert_eq!(echo.steps as usize, trace::ACTIONS);
    assert!(echo.schemas > 50, "{echo}");
    let gripped = trace::steps()
        .filter(|step| step.after.get(pioneer::Item::ingrip.id()) == Some(true))
        .count();
    assert!(gripped > 0, "no specimen was ever in the gripper");
}

#[test]
fn another_seed_leaves_another_fingerprint() {
    let mut brain = Box::new(pioneer::brain());
    let other = relive(&mut brain, trace::SEED + 1, trace::steps(), |_| {}).expect("it lives");
    let one = on_host();
    assert_ne!(one.weights, other.weights);
    assert_ne!(one.distances, other.distances);
    assert_ne!(one.choices, other.choices);
}

#[test]
fn a_step_comes_back_from_its_bytes() {
    for step in trace::steps() {
        assert_eq!(trace::Step::from_bytes(step.to_bytes()), step);
    }
}
