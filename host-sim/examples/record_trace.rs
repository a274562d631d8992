//! Records the life that the firmware relives: `firmware-example/trace.bin`.
//!
//! Run it after a change of the world or of the brain that should be in the recording:
//! `cargo run --release -p host-sim --example record_trace`.

use std::error::Error;
use std::path::Path;

use cla_core::clasm::AgentConfig;
use cla_core::forager::pioneer;
use firmware_example::trace::{ACTIONS, SEED, Step};
use host_sim::experiment::forage::life::percept;
use host_sim::report::Output;
use host_sim::world::World;
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::Pioneer;

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = Pioneer::new(PioneerConfig::NOISY, SEED)?;
    let mut brain = Box::new(pioneer::brain());
    pioneer::be_born(&mut brain, AgentConfig::FORAGER, SEED)?;
    let mut trace = Vec::with_capacity(3 * ACTIONS);
    for _ in 0..ACTIONS {
        let before = percept(&world.sense());
        let choice = brain.choose(&before)?;
        world.act(choice.action.0.into());
        let after = percept(&world.sense());
        brain.learn(&after)?;
        while world.reflex() {}
        let step = Step {
            before,
            action: choice.action,
            after,
        };
        trace.extend(step.to_bytes());
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../firmware-example");
    let path = Output::prepare(folder)?.write("trace.bin", &trace)?;
    println!("{} captures, wrote {}", world.captures(), path.display());
    Ok(())
}
