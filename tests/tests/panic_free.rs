//! The core has no panic path, proved by linking: `firmware-example/src/bin/panic_free` links
//! only when no code of the core can reach its panic handler.
//!
//! Needs the target thumbv7em-none-eabihf; `tests/run` gets it.

use cla_tests::{root, sources};
use host_sim::device::board::Build;
use host_sim::device::target::Target;

const PROOF: &str = "firmware-example/src/bin/panic_free/main.rs";
/// What some of its entries call.
const KEPT: &str = "firmware-example/src/bin/panic_free/kept.rs";

/// Links one entry (or all) at an optimization level; the linker's complaint when it does not.
fn link(opt_level: &'static str, entry: &str) -> Result<(), String> {
    let proof = Build {
        opt_level,
        // The few names live as long as the test.
        entry: entry.to_owned().leak(),
        ..Build::new(Target::M4f, "panic_free")
    };
    proof.build().map(drop).map_err(|error| error.to_string())
}

fn proof() -> String {
    std::fs::read_to_string(root().join(PROOF)).expect("the proof is there")
}

/// The names of the entries, but for the one that panics on purpose.
fn entries() -> Vec<String> {
    let name = |line: &str| {
        let (name, rest) = line.strip_prefix("    \"")?.split_once('"')?;
        rest.starts_with(" (").then(|| name.to_owned())
    };
    let mut all: Vec<String> = proof().lines().filter_map(name).collect();
    all.retain(|name| name != "control");
    all
}

fn holds_at(opt_level: &'static str) {
    if let Err(complaint) = link(opt_level, "all") {
        let mut guilty = entries();
        guilty.retain(|entry| link(opt_level, entry).is_err());
        panic!("opt-level {opt_level}: {guilty:?} can panic\n{complaint}");
    }
}

#[test]
fn every_entry_of_the_core_links_without_a_panic_path_at_opt_level_3() {
    holds_at("3");
}

#[test]
fn every_entry_of_the_core_links_without_a_panic_path_at_opt_level_s() {
    holds_at("s");
}

#[test]
fn an_entry_that_can_panic_does_not_link() {
    let complaint = link("3", "control").expect_err("indexing a slice can panic");
    assert!(complaint.contains("a_panic_path_is_left"), "{complaint}");
}

/// A name that stands nowhere in the proof is a function that nobody linked.
#[test]
fn every_public_function_of_the_core_is_in_the_proof() {
    let kept = std::fs::read_to_string(root().join(KEPT)).expect("its entries call it");
    let proof = proof() + &kept;
    assert!(entries().len() > 70);
    let mut left_out = Vec::new();
    // No robot has the feature `faults`.
    let linked = |source: &cla_tests::Source| source.path != "cla-core/src/snapshot/faults.rs";
    for source in sources("cla-core/src").into_iter().filter(linked) {
        for (number, line) in source.code_without_tests() {
            let Some((_, rest)) = line.split_once("pub fn ") else {
                continue;
            };
            let name = rest.split(['(', '<']).next().unwrap_or(rest);
            let called = [format!("{name}("), format!("{name}::<")];
            if !called.iter().any(|call| proof.contains(call)) {
                left_out.push(format!("{}:{number}: {name}", source.path));
            }
        }
    }
    assert!(left_out.is_empty(), "{left_out:#?}");
}
