//! The robot itself: **put your part's serial port, motors, flash and reset here**; the README says what of
//! the emulator then goes.
//!
//! What stands here serves the emulated board: its serial port is the emulator's standard input and
//! output, it has no motors, and its program can end.

use semihosting::io::{Read, Stdin, Stdout, Write, stdin, stdout};
use semihosting::{eprintln, process};

use crate::board::FileFlash;
use crate::controller::{End, Heard, SafeStop, Wire};

/// The serial port.
pub struct Serial {
    input: Stdin,
    output: Stdout,
}

impl Serial {
    /// Opens the port; `None` when there is none.
    #[must_use]
    pub fn open() -> Option<Self> {
        match (stdin(), stdout()) {
            (Ok(input), Ok(output)) => Some(Self { input, output }),
            _ => {
                eprintln!("the emulator gives no standard streams");
                None
            }
        }
    }
}

impl Wire for Serial {
    /// On a robot: wait no longer than it may move without orders, then say [`Heard::Silence`].
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

/// The motors.
pub struct Motors;

impl SafeStop for Motors {
    /// On a robot: bring everything that moves to rest, whatever state the program is in.
    fn stop(&mut self) {
        eprintln!("motors stopped");
    }
}

/// The flash that a brain is kept in.
///
/// On a robot: the part's own, behind the program, or a chip beside it, as its HAL crate has it; any
/// type that is a `NorFlash`.
pub type Flash = FileFlash;

/// Opens the flash, with so many bytes; `None` when there is none.
#[must_use]
pub fn flash(bytes: usize) -> Option<Flash> {
    FileFlash::open(bytes)
}

/// Whether the supply is about to fail, so that a save cannot wait.
///
/// On a robot: what the part's brown-out detector warns of, if it warns, and only where what is stored
/// in the supply lasts for a save (`FlashStore::cost`). The emulated board's supply never warns.
#[must_use]
pub fn power_is_failing() -> bool {
    false
}

/// What happens when nobody gives orders any more; the motors stand.
///
/// On a robot: reset the part, or wait for the next host.
pub fn end(end: Option<End>) -> ! {
    match end {
        Some(End::Told) => process::exit(0),
        Some(End::HostGone) => {
            eprintln!("the host is gone");
            process::exit(3);
        }
        None => process::exit(1),
    }
}
