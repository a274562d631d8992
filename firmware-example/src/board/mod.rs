//! The emulated boards: what counts instructions on them, and their stack.
//!
//! This is for measuring; a robot needs none of it (its file is `hal.rs`).
//! Statics begin at the linker's `__sdata` and end at `__ebss`; above them lies the stack, which
//! grows down from `_stack_start`.

#![allow(unsafe_code)]

mod file_flash;
#[cfg(target_arch = "arm")]
mod mps2;
#[cfg(target_arch = "riscv32")]
mod riscv_virt;

pub use file_flash::FileFlash;
#[cfg(target_arch = "arm")]
use mps2::Clock;
#[cfg(target_arch = "riscv32")]
use riscv_virt::Clock;

/// What the stack is painted with.
const PAINT: u32 = 0xC1A0_2004;

/// Counts instructions from [`start`](Self::start) on.
pub struct Counter {
    clock: Clock,
    overhead: u32,
}

impl Counter {
    /// Starts counting, and finds out what a count itself costs.
    #[must_use]
    pub fn start() -> Self {
        let mut it = Self {
            clock: Clock::start(),
            overhead: 0,
        };
        it.lap();
        it.overhead = it.lap();
        it
    }

    /// Instructions since the last call (or the start), without those of counting, to within two.
    pub fn lap(&mut self) -> u32 {
        self.clock.lap().saturating_sub(self.overhead)
    }
}

/// The time since its start, by the board's own clock; it uses what a [`Counter`] uses.
pub struct Uptime {
    clock: Clock,
    nanos: u64,
}

impl Uptime {
    /// Starts the clock.
    #[must_use]
    pub fn start() -> Self {
        Self {
            clock: Clock::start(),
            nanos: 0,
        }
    }

    /// Milliseconds since the start, modulo 2³²; to be asked at least every two minutes.
    pub fn millis(&mut self) -> u32 {
        self.nanos += u64::from(self.clock.lap()) * Clock::NANOS;
        (self.nanos / 1_000_000) as u32
    }
}

unsafe extern "C" {
    static mut __ebss: u32;
    static mut __sdata: u32;
    static mut _stack_start: u32;
}

/// Fills the unused stack with a pattern, so that [`stack_used`] can find how deep it went.
#[inline(never)]
pub fn paint_stack() {
    let here = 0_u32;
    // A margin for this function's own frame and what the loop pushes.
    let top = (&raw const here as usize) - 256;
    let mut address = &raw const __ebss as usize;
    while address < top {
        // SAFETY: between the end of the statics and the stack pointer nothing lives.
        unsafe { (address as *mut u32).write_volatile(PAINT) };
        address += 4;
    }
}

/// The most bytes of stack in use since [`paint_stack`].
#[must_use]
pub fn stack_used() -> usize {
    let end = &raw const _stack_start as usize;
    let mut address = &raw const __ebss as usize;
    // SAFETY: the memory between the statics and the stack's start is plain RAM.
    while address < end && unsafe { (address as *const u32).read_volatile() } == PAINT {
        address += 4;
    }
    end - address
}

/// Bytes of static memory: initialized and zeroed data.
#[must_use]
pub fn static_bytes() -> usize {
    (&raw const __ebss as usize) - (&raw const __sdata as usize)
}
