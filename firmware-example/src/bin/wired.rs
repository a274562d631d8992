#![no_std]
#![no_main]
//! Nothing but a wire, between a robot and a port of which nothing is known: for the bytes of its code.
//!
//! With `ENTRY` set the wire is left out, and the rest is what its bytes come on top of; the test
//! `firmware` in `../../tests` takes the difference. It is never run.

use core::hint::black_box;

use firmware_example::controller::{End, Heard, Service, Wire, attend};
use firmware_example::hal::PATIENCE;
use firmware_example::link::{Answer, Life, Order, Robot, Seal};
use semihosting::{println, process};

#[cfg(not(feature = "authentic"))]
const SEAL: Seal = Seal::Checksum;
#[cfg(feature = "authentic")]
const SEAL: Seal = Seal::Keyed(firmware_example::link::Key::PUBLISHED);

/// Whether the wire is left out.
const BARE: bool = option_env!("ENTRY").is_some();

/// A port and a robot that the compiler does not know.
struct Unknown;

impl Wire for Unknown {
    fn hear(&mut self, bytes: &mut [u8]) -> Heard {
        black_box(bytes);
        black_box(Heard::Pause)
    }

    fn say(&mut self, bytes: &[u8]) -> bool {
        black_box(bytes);
        black_box(true)
    }
}

impl Robot for Unknown {
    fn now(&mut self) -> u32 {
        black_box(0)
    }

    fn stop(&mut self) {
        black_box(self);
    }

    fn follow(&mut self, order: Order) -> Answer {
        black_box(order);
        black_box(Answer::Done)
    }

    fn known(&mut self) -> (u16, u64) {
        black_box((0, 0))
    }

    fn save(&mut self, life: Life) -> Option<u32> {
        black_box(life);
        black_box(None)
    }
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let end = if BARE {
        black_box(End::Told)
    } else {
        let service = Service {
            fresh: black_box(1),
            patience: PATIENCE,
            life: Life::UNBORN,
            seal: SEAL,
        };
        attend(&mut Unknown, &mut Unknown, service)
    };
    // What prints and what panics is in both programs.
    assert!(black_box(true), "{}", black_box(1_u32));
    println!("{}", black_box(2_u32));
    match end {
        End::Told => process::exit(0),
        End::HostGone => process::exit(3),
    }
}
