//! What fuzzers do with bytes: a body for each target, which ends quietly or panics.
//!
//! The targets in `tests/fuzz` call these bodies, and so does the test `fuzz` on stable, with every
//! file of the committed corpora and with bytes of chance.
//! What a fuzzer finds stays in the corpus, as a test that replays it.

mod agents;
mod images;
mod minds;
mod operations;
mod robots;
mod texts;
mod wires;

use cla_core::Health;
use cla_core::word::WINDOW;

/// What a brain says of its health is what it may say.
fn are_shares(health: &Health) {
    let shares = [health.foreseen, health.unknown, health.fullest];
    assert!(
        shares.iter().all(|it| (0.0..=1.0).contains(it)),
        "{health:?}"
    );
    // A call loses no more than its maps have nodes, and one may be all that was lived.
    assert!(
        (0.0..1.0e8).contains(&health.lost) && health.steps <= WINDOW,
        "{health:?}"
    );
}

/// What is done with some bytes.
pub type Body = fn(&[u8]);

/// All targets: the name of the program in `tests/fuzz`, and its body.
pub const TARGETS: [(&str, Body); 16] = [
    ("images_agent", images::agent),
    ("images_mind", images::mind),
    ("frames", wires::frames),
    ("calls", wires::calls),
    ("sessions", wires::sessions),
    ("controller", wires::controller),
    ("layouts", texts::layouts),
    ("damages", texts::damages),
    ("configs", texts::configs),
    ("rules", texts::rules),
    ("notation", texts::notation),
    ("pomdps", texts::pomdps),
    ("agents_tiny", agents::tiny),
    ("agents_full", agents::full),
    ("minds_tiny", minds::tiny),
    ("minds_full", minds::full),
];

/// The body of a target.
///
/// # Panics
/// When there is none of that name, or when it finds something.
pub fn run(name: &str, bytes: &[u8]) {
    let found = TARGETS.iter().find(|(other, _)| *other == name);
    let (_, body) = found.unwrap_or_else(|| panic!("there is no target {name}"));
    body(bytes);
}
