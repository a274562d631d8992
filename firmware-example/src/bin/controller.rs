#![no_std]
#![no_main]
//! The forager's brain as a controller: a body at the other end of a wire asks, the brain answers.
//!
//! Here the wire is the emulator's standard input and output, and the body a simulated robot
//! (`host-sim hil`); on a robot it is a serial port.
//! Exit code 0 when told to stop, 3 when the other side is gone.

use firmware_example::controller::{End, Heard, SafeStop, Wire, serve};
use firmware_example::profile::{self, Brain};
use semihosting::io::{Read, Stdin, Stdout, Write, stdin, stdout};
use semihosting::{eprintln, process};

static mut BRAIN: Brain = profile::brain();

/// Standard input and output of the emulator.
struct Streams {
    input: Stdin,
    output: Stdout,
}

impl Wire for Streams {
    fn hear(&mut self, bytes: &mut [u8]) -> Heard {
        match self.input.read(bytes) {
            Ok(0) | Err(_) => Heard::Gone,
            Ok(count) => Heard::Bytes(count),
        }
    }

    fn say(&mut self, bytes: &[u8]) -> bool {
        self.output.write_all(bytes).is_ok()
    }
}

/// The motors of this board: it has none, so it says that it would have stopped them.
struct NoMotors;

impl SafeStop for NoMotors {
    fn stop(&mut self) {
        eprintln!("motors stopped");
    }
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let (Ok(input), Ok(output)) = (stdin(), stdout()) else {
        eprintln!("the emulator gives no standard streams");
        process::exit(1);
    };
    let mut streams = Streams { input, output };
    match serve(brain, &mut streams, &mut NoMotors) {
        End::Told => process::exit(0),
        End::HostGone => {
            eprintln!("the host is gone");
            process::exit(3);
        }
    }
}
