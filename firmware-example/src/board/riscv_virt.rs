//! QEMU's RISC-V machine `virt`: the hart itself counts the instructions that it retires.

use core::arch::asm;

pub(super) struct Clock {
    last: u32,
}

impl Clock {
    /// Nanoseconds of an instruction.
    pub(super) const NANOS: u64 = 1;

    pub(super) fn start() -> Self {
        Self { last: retired() }
    }

    /// Instructions since the last call; exact.
    pub(super) fn lap(&mut self) -> u32 {
        let now = retired();
        let instructions = now.wrapping_sub(self.last);
        self.last = now;
        instructions
    }
}

fn retired() -> u32 {
    let count: u32;
    // SAFETY: reading a counter has no effect.
    unsafe { asm!("csrr {}, minstret", out(reg) count, options(nomem, nostack)) };
    count
}
