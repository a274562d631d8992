//! An emulated board that is killed at random moments, its flash in a file, and started again.

use std::path::PathBuf;
use std::sync::Mutex;

use super::super::part::{Part, Scale, never, tried};
use crate::device::board::look_for_tools;
use crate::device::flash::kills::{kill_again_and_again, program};
use crate::device::target::Target;
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::report::Claim;

/// The part.
pub(crate) const PART: Part = Part {
    name: "kill",
    is_slow: true,
    look_for_tools: || look_for_tools("survive --part kill", &[Target::M4f]),
    measure,
    claims,
    ..Part::QUICK
};

/// Kills with each seed.
const KILLS: u32 = 20;

fn measure(scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let kills = kill_again_and_again(&built()?, scale.of(KILLS), seed)?;
    for (name, number) in [
        ("kills", kills.kills),
        ("within", kills.within),
        ("before", kills.before),
        ("saves", kills.saves),
        ("lost", kills.lost),
        ("wrong", kills.wrong),
        ("refused", kills.refused),
        ("last tick", kills.last.1),
    ] {
        trial.note(format!("kill.{name}"), number);
    }
    Ok(())
}

/// The program, built once for all seeds.
fn built() -> Result<PathBuf, Failure> {
    static BUILT: Mutex<Option<PathBuf>> = Mutex::new(None);
    let mut built = BUILT
        .lock()
        .map_err(|_| "another seed failed to build it")?;
    let path = match built.take() {
        Some(path) => path,
        None => program()?,
    };
    *built = Some(path.clone());
    Ok(path)
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    let of = |name: &str| of(trials, &format!("kill.{name}"));
    vec![
        never(
            "kill",
            "generations",
            "generations that the firmware had saved and that were not there after the kill, or not \
             resumed",
            &of("lost"),
        ),
        never(
            "kill.wrong",
            "brains",
            "brains in the flash that are not to the byte those of a life that was never interrupted",
            &of("wrong"),
        ),
        tried("kill.kills", "kills", 200.0, &of("kills")),
        tried("kill.within", "kills", 50.0, &of("within")),
    ]
}
