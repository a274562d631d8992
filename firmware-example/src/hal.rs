//! The robot itself: **put your part's serial port, motors, flash and reset here**; the README says what of
//! the emulator then goes.
//!
//! What stands here serves the emulated board: its serial port is the emulator's standard input and
//! output, it has no motors, and its program can end.

use semihosting::experimental::random;
use semihosting::io::{Read, Stdin, Stdout, Write, stdin, stdout};
use semihosting::{eprintln, process};

use crate::board::{FileFlash, Uptime};
use crate::controller::{End, Heard, SafeStop, Service, Wire};
use crate::keeper::Policy;
use crate::link::{Life, Seal};

/// Milliseconds that the robot may go on without an order: on a robot, as long as it may move blindly.
pub const PATIENCE: u32 = 500;

/// How orders are taken; `None` where nothing fresh can be had, without which an old session could
/// be replayed.
///
/// On a robot: `fresh` from the part's source of chance, or a counter in flash that every reset raises;
/// with the feature `authentic` a key of its own, from its flash.
#[must_use]
pub fn service() -> Option<Service> {
    let mut fresh = [0; 8];
    if random::fill_bytes(&mut fresh).is_err() {
        eprintln!("the emulator gives no random bytes");
        return None;
    }
    Some(Service {
        fresh: u64::from_le_bytes(fresh),
        patience: PATIENCE,
        life: Life::UNBORN,
        #[cfg(not(feature = "authentic"))]
        seal: Seal::Checksum,
        #[cfg(feature = "authentic")]
        seal: Seal::Keyed(crate::link::Key::PUBLISHED),
    })
}

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
    /// On a robot: wait a few milliseconds at most, then say [`Heard::Pause`].
    /// The emulator's standard input waits for ever, and its clock stands still meanwhile.
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

/// The motors, and the clock of their safe stop.
pub struct Motors(Uptime);

impl Motors {
    /// Starts the clock.
    #[must_use]
    pub fn start() -> Self {
        Self(Uptime::start())
    }
}

impl SafeStop for Motors {
    /// On a robot: any timer that runs. The emulated board counts its instructions.
    fn now(&mut self) -> u32 {
        self.0.millis()
    }

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

/// How often the controller keeps its brain, beside on command: after 20 captures, and every ten minutes
/// of actions that take 200 ms each.
///
/// On a robot: the time of its actions, and what a power cut may cost; the robot stands for each save.
pub const POLICY: Policy = Policy::every(20, 10, 200);

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
