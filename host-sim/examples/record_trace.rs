//! Records the life that the firmware relives: `firmware-example/trace.bin`.
//!
//! Run it after a change of the world or of the brain that should be in the recording:
//! `cargo run --release -p host-sim --example record_trace`.

use std::error::Error;
use std::path::Path;

use cla_core::agent::{Adaptation, Agent, AgentConfig};
use cla_core::forager::pioneer::{self, Brain, Percept};
use cla_core::word::ActionId;
use firmware_example::replay::{acting_at, second_level_at};
use firmware_example::trace::{ACTIONS, SEED, Step};
use host_sim::failure::Failure;
use host_sim::learner::native::narrowed;
use host_sim::learner::{Learner, live};
use host_sim::report::Output;
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::Pioneer;
use host_sim::world::{self, World};

/// A brain, and what it was shown.
struct Recorder {
    brain: Box<Brain>,
    chosen: Option<(Percept, ActionId)>,
    trace: Vec<u8>,
}

impl Recorder {
    fn note(&mut self, before: &Percept, action: ActionId, after: &Percept, reflex: bool) {
        let step = Step {
            before: *before,
            action,
            after: *after,
            reflex,
        };
        self.trace.extend(step.to_bytes());
    }
}

impl Learner for Recorder {
    fn choose(&mut self, now: &world::Percept) -> Result<usize, Failure> {
        let action = Learner::choose(&mut *self.brain, now)?;
        self.chosen = Some((narrowed(now), ActionId(action as u16)));
        Ok(action)
    }

    fn learn(&mut self, now: &world::Percept) -> Result<(), Failure> {
        if let Some((before, action)) = self.chosen.take() {
            self.note(&before, action, &narrowed(now), false);
        }
        Learner::learn(&mut *self.brain, now)
    }

    fn observe(
        &mut self,
        before: &world::Percept,
        action: usize,
        after: &world::Percept,
    ) -> Result<(), Failure> {
        self.note(
            &narrowed(before),
            ActionId(action as u16),
            &narrowed(after),
            true,
        );
        Learner::observe(&mut *self.brain, before, action, after)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = Pioneer::new(PioneerConfig::NOISY, SEED)?;
    let mut brain: Box<Brain> = Box::new(Agent::new());
    pioneer::be_born(&mut brain, AgentConfig::FORAGER, SEED)?;
    let mut recorder = Recorder {
        brain,
        chosen: None,
        trace: Vec::new(),
    };
    let (second, acting) = (second_level_at(ACTIONS), acting_at(ACTIONS));
    live(&mut recorder, &mut world, second).map_err(|error| error.to_string())?;
    recorder.brain.reconfigure(AgentConfig::FORAGER_LEVEL2)?;
    live(&mut recorder, &mut world, acting - second).map_err(|error| error.to_string())?;
    recorder.brain.act(Adaptation::Relearning)?;
    live(&mut recorder, &mut world, ACTIONS - acting).map_err(|error| error.to_string())?;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../firmware-example");
    let path = Output::prepare(folder)?.write("trace.bin", &recorder.trace)?;
    println!("{} captures, wrote {}", world.obtained(), path.display());
    Ok(())
}
