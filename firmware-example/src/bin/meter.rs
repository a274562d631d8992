#![no_std]
#![no_main]
//! Prints the instructions of every step of a life; the host, which lives the same life, weighs by
//! them what its brain says that a step has touched.

use firmware_example::profile::{self, Brain};
use firmware_example::{board, meter, trace};
use semihosting::{println, process};

/// As in the firmware.
const ACTIONS: u32 = if cfg!(target_abi = "eabihf") {
    trace::ACTIONS
} else {
    trace::ACTIONS / 10
};

static mut BRAIN: Brain = profile::brain();

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let mut counter = board::Counter::start();
    let lived = meter::steps(
        brain,
        ACTIONS,
        || counter.lap(),
        |_, instructions, _| println!("{instructions}"),
    );
    if let Err(error) = lived {
        println!("{error}");
        process::exit(1);
    }
    process::exit(0);
}
