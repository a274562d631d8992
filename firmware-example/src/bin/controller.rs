#![no_std]
#![no_main]
//! The forager's brain as a controller: a body at the other end of a wire asks, the brain answers.
//!
//! Wire, motors and end are those of `hal.rs`; in the emulator the body is a simulated robot
//! (`host-sim hil`).
//! Exit code 0 when told to stop, 3 when the other side is gone.

use firmware_example::controller::serve;
use firmware_example::hal::{self, Motors, Serial};
use firmware_example::profile::{self, Brain};

static mut BRAIN: Brain = profile::brain();

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let end = Serial::open()
        .zip(hal::service())
        .map(|(mut serial, service)| serve(brain, &mut serial, &mut Motors::start(), service));
    hal::end(end)
}
