//! Arm's MPS2 board with a Cortex-M4F (AN386), as QEMU emulates it: instruction counter and stack.
//!
//! QEMU runs with `-icount shift=6`: an instruction takes 64 ns of the board's time, and the timer
//! counts every 40 ns, so instructions are 5/8 of its ticks.
//! On a real board this file is the one to replace: by a cycle counter and the part's own memory.

#![allow(unsafe_code)]

/// The CMSDK timer 0: control, value, reload.
const TIMER: *mut u32 = 0x4000_0000 as *mut u32;

/// What the stack is painted with.
const PAINT: u32 = 0xC1A0_2004;

/// Counts instructions from [`start`](Self::start) on.
pub struct Counter {
    last: u32,
}

impl Counter {
    /// Starts the timer at its largest value; it counts down and wraps.
    pub fn start() -> Self {
        // SAFETY: the registers of the board's timer, which nothing else in this program uses.
        unsafe {
            TIMER.write_volatile(0);
            TIMER.add(1).write_volatile(u32::MAX);
            TIMER.add(2).write_volatile(u32::MAX);
            TIMER.write_volatile(1);
        }
        Self { last: u32::MAX }
    }

    /// Instructions since the last call (or the start), to within two.
    pub fn lap(&mut self) -> u32 {
        // SAFETY: reading the timer's value has no effect.
        let now = unsafe { TIMER.add(1).read_volatile() };
        let ticks = self.last.wrapping_sub(now);
        self.last = now;
        (u64::from(ticks) * 5 / 8) as u32
    }
}

unsafe extern "C" {
    static mut __ebss: u32;
    static mut __sdata: u32;
    static mut _stack_start: u32;
}

/// Fills the unused stack with a pattern, so that [`stack_used`] can find how deep it went.
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
pub fn static_bytes() -> usize {
    (&raw const __ebss as usize) - (&raw const __sdata as usize)
}
