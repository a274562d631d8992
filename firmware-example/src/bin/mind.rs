#![no_std]
#![no_main]
//! What a tick of the learner for any world takes, in instructions, and the fingerprint of its life.
//!
//! `cargo run --release --bin mind` in this folder; the life is the recording, 20,000 actions on the
//! Cortex-M4F and 2,000 where floats are functions.

use firmware_example::mind::{Forager, Part, relive};
use firmware_example::{board, trace};
use semihosting::{println, process};

/// As in the firmware.
const ACTIONS: u32 = if cfg!(target_abi = "eabihf") {
    trace::ACTIONS
} else {
    trace::ACTIONS / 10
};

static mut MIND: Forager = Forager::new();

/// Sum and greatest of some steps.
#[derive(Clone, Copy, Default)]
struct Steps {
    sum: u64,
    count: u32,
    worst: u32,
}

impl Steps {
    fn add(&mut self, instructions: u32) {
        self.sum += u64::from(instructions);
        self.count += 1;
        self.worst = self.worst.max(instructions);
    }

    fn mean(&self) -> u32 {
        (self.sum / u64::from(self.count.max(1))) as u32
    }
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let mind = &raw mut MIND;
    // SAFETY: this runs once, and no interrupt touches the mind.
    #[allow(unsafe_code)]
    let mind = unsafe { &mut *mind };
    let mut counter = board::Counter::start();
    let (mut chosen, mut learned) = (Steps::default(), Steps::default());
    let lived = relive(mind, ACTIONS, |part| {
        let instructions = counter.lap();
        match part {
            Part::Sensed => {}
            Part::Chosen => chosen.add(instructions),
            Part::Learned => learned.add(instructions),
        }
    });
    match lived {
        Ok(print) => {
            println!("life {print}");
            println!("choose mean {} worst {}", chosen.mean(), chosen.worst);
            println!("learn mean {} worst {}", learned.mean(), learned.worst);
            println!("bytes {}", size_of::<Forager>());
            process::exit(0);
        }
        Err(error) => {
            println!("{error}");
            process::exit(1);
        }
    }
}
