//! The examples run, and what they assert holds: a world, a learner and an experiment of one's own.

use std::path::Path;
use std::process::Command;

/// Runs an example, which `cargo test` has built beside the program, and answers what it said.
fn said(name: &str) -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_host-sim"));
    let example = program.with_file_name("examples").join(name);
    if !example.exists() {
        // Only this test was asked for.
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["build", "--package", "host-sim", "--example", name]);
        assert!(cargo.status().expect("cargo runs").success());
    }
    let output = Command::new(example).output().expect("the example runs");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name}: {complaint}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn a_world_with_a_reflex_of_its_own_is_lived_in() {
    assert!(said("new_world").contains("meals"));
}

#[test]
fn a_learner_is_raised_beside_others() {
    assert!(said("new_learner").contains("captures"));
}

#[test]
fn an_experiment_is_run_written_down_and_judged() {
    assert!(said("new_experiment").contains("blinking.cost"));
}

#[test]
fn each_of_them_takes_fewer_than_120_lines() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for name in ["new_world", "new_learner", "new_experiment"] {
        let text = std::fs::read_to_string(folder.join(name).with_extension("rs"));
        let lines = text.expect("an example").lines().count();
        assert!(lines < 120, "{name}: {lines}");
    }
}
