//! Sessions between a body and a brain over a wire that loses, damages, delays, repeats, invents and
//! plays back, while either side is reset.

use super::super::part::{Part, Scale, claim, never, tried};
use crate::experiment::hil::disturbed::{PATIENCE, many};
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::report::{Bound, Claim, Rule};

/// The part.
pub(crate) const PART: Part = Part {
    name: "wire",
    measure,
    claims,
    ..Part::QUICK
};

/// Sessions with each seed.
const SESSIONS: u32 = 100_000;

fn measure(scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let tally = many(seed, scale.of(SESSIONS), false);
    let [one, two, three, more] = tally.calls;
    for (name, number) in [
        ("sessions", tally.sessions),
        ("followed", tally.followed),
        ("frames", tally.frames),
        ("disturbed", tally.disturbed),
        ("intruded", tally.intruded),
        ("resets", tally.resets),
        ("stops", tally.stops),
        ("wrong", tally.wrong),
        ("astray", tally.astray),
        ("calls.1", one),
        ("calls.2", two),
        ("calls.3", three),
        ("calls.more", more),
        ("longest", tally.longest.into()),
    ] {
        trial.note(format!("wire.{name}"), number as f64);
    }
    Ok(())
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    let of = |name: &str| of(trials, &format!("wire.{name}"));
    vec![
        never(
            "wire",
            "orders",
            "orders followed that nobody gave, or too old, twice, out of turn, after a stop, or after \
             their body had heard that they were not; answers of others; robots that move on",
            &of("wrong"),
        ),
        never(
            "wire.astray",
            "sessions",
            "sessions that needed more than three calls over a wire that was clean again, or then more \
             than one",
            &of("astray"),
        ),
        claim("wire.longest", "ms")
            .rule(Rule::every_seed(Bound::AtMost(f64::from(PATIENCE))))
            .note("the longest time from the last order followed to the stop; 100 ms are allowed")
            .judge(&of("longest")),
        tried("wire.sessions", "sessions", 1_000_000.0, &of("sessions")),
        tried("wire.disturbed", "frames", 1_000_000.0, &of("disturbed")),
        tried("wire.intruded", "intrusions", 1_000_000.0, &of("intruded")),
        tried("wire.resets", "resets", 1_000_000.0, &of("resets")),
    ]
}
