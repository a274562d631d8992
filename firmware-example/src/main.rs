#![no_std]
#![no_main]
//! The forager's brain relives a recorded life on a Cortex-M4F and prints what came of it.
//!
//! `cargo run --release` in this folder starts it in QEMU.
//! Exit code 0 when the life was lived to its end.

use cla_core::forager::pioneer::{self, Brain};

use firmware_example::replay::{Moment, relive};
use firmware_example::{board, trace};
use semihosting::{println, process};

/// Instructions of one part of a step.
#[derive(Default)]
struct Cost {
    total: u64,
    worst: u32,
}

impl Cost {
    fn add(&mut self, instructions: u32) {
        self.total += u64::from(instructions);
        self.worst = self.worst.max(instructions);
    }

    fn mean(&self, steps: u32) -> u32 {
        (self.total / u64::from(steps.max(1))) as u32
    }
}

/// The brain lies in `.bss`: all its memory is zero before its birth.
static mut BRAIN: Brain = pioneer::brain();

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    board::paint_stack();
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let (mut choose, mut learn) = (Cost::default(), Cost::default());
    let mut counter = board::Counter::start();
    let lived = relive(brain, trace::SEED, trace::steps(), |moment| {
        let instructions = counter.lap();
        match moment {
            Moment::Sensed => {}
            Moment::Chosen => choose.add(instructions),
            Moment::Learned => learn.add(instructions),
        }
    });
    match lived {
        Ok(echo) => {
            println!("{echo}");
            for (part, cost) in [("choose", &choose), ("learn", &learn)] {
                let (mean, worst) = (cost.mean(echo.steps), cost.worst);
                println!("{part} instructions mean {mean} worst {worst}");
            }
            println!("brain bytes {}", pioneer::RAM);
            println!("static bytes {}", board::static_bytes());
            println!("stack bytes {}", board::stack_used());
            process::exit(0);
        }
        Err(error) => {
            println!("{error}");
            process::exit(1);
        }
    }
}
