#![no_std]
#![no_main]
//! The forager's brain relives a recorded life on a microcontroller and prints what came of it.
//!
//! `cargo run --release` in this folder starts it in QEMU; with `--features small` it is the brain
//! for small parts.
//! Exit code 0 when the life was lived to its end.

use firmware_example::profile::{self, Brain};
use firmware_example::replay::{Moment, doubt, relive};
use firmware_example::{board, trace};
use semihosting::{println, process};

/// Actions that are relived: all where floats are fast, and a tenth where each costs a function.
const ACTIONS: u32 = if cfg!(target_abi = "eabihf") {
    trace::ACTIONS
} else {
    trace::ACTIONS / 10
};

/// What is measured: the parts of a step while level 1 learns alone and with both levels, a whole
/// step of each, a step that harvests, and the end of training.
const NAMES: [&str; 8] = [
    "choose_level1",
    "learn_level1",
    "tick_level1",
    "choose_level2",
    "learn_level2",
    "tick_level2",
    "harvest",
    "settle",
];

/// Instructions of one part of a step.
#[derive(Default)]
struct Cost {
    total: u64,
    times: u32,
    worst: u32,
}

impl Cost {
    fn add(&mut self, instructions: u32) {
        self.total += u64::from(instructions);
        self.times += 1;
        self.worst = self.worst.max(instructions);
    }

    fn mean(&self) -> u32 {
        (self.total / u64::from(self.times.max(1))) as u32
    }
}

/// The brain lies in `.bss`: all its memory is zero before its birth.
static mut BRAIN: Brain = profile::brain();

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    board::paint_stack();
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let mut costs: [Cost; NAMES.len()] = Default::default();
    let (mut second, mut choosing) = (false, None);
    let mut counter = board::Counter::start();
    let lived = relive(brain, trace::SEED, ACTIONS, |moment, _| {
        let instructions = counter.lap();
        let [
            choose1,
            learn1,
            tick1,
            choose2,
            learn2,
            tick2,
            harvest,
            settle,
        ] = &mut costs;
        let (choose, learn, tick) = match second {
            false => (choose1, learn1, tick1),
            true => (choose2, learn2, tick2),
        };
        match moment {
            Moment::Sensed => {}
            Moment::SecondLevel => second = true,
            Moment::Chosen => {
                choose.add(instructions);
                choosing = Some(instructions);
            }
            Moment::Learned => {
                learn.add(instructions);
                if let Some(choosing) = choosing.take() {
                    tick.add(choosing + instructions);
                }
            }
            Moment::Harvested => {
                harvest.add(instructions);
                choosing = None;
            }
            Moment::Settled => settle.add(instructions),
        }
    });
    // Before anything is printed, which takes more stack than a brain does.
    let stack = board::stack_used();
    let mut weighing = Cost::default();
    let lived = lived.and_then(|echo| {
        doubt(brain, ACTIONS, |moment| {
            let instructions = counter.lap();
            if moment == Moment::Learned {
                weighing.add(instructions);
            }
        })?;
        Ok(echo)
    });
    let in_doubt = board::stack_used();
    match lived {
        Ok(echo) => {
            println!("{echo}");
            for (part, cost) in NAMES.iter().zip(&costs) {
                println!(
                    "{part} instructions mean {} worst {}",
                    cost.mean(),
                    cost.worst
                );
            }
            println!("weighing instructions worst {}", weighing.worst);
            println!("brain bytes {}", profile::RAM);
            println!("static bytes {}", board::static_bytes());
            println!("stack bytes {stack}");
            println!("doubting bytes {in_doubt}");
            process::exit(0);
        }
        Err(error) => {
            println!("{error}");
            process::exit(1);
        }
    }
}
