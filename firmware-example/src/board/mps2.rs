//! Arm's MPS2 boards with a Cortex-M4F (AN386) or M3 (AN385), as QEMU emulates them.
//!
//! QEMU runs with `-icount shift=6`: an instruction takes 64 ns of the board's time, and the timer
//! counts every 40 ns, so instructions are 5/8 of its ticks.

/// The CMSDK timer 0: control, value, reload.
const TIMER: *mut u32 = 0x4000_0000 as *mut u32;

pub(super) struct Clock {
    last: u32,
}

impl Clock {
    /// Nanoseconds of an instruction.
    pub(super) const NANOS: u64 = 64;

    /// Starts the timer at its largest value; it counts down and wraps.
    pub(super) fn start() -> Self {
        // SAFETY: the registers of the board's timer, which nothing else in this program uses.
        unsafe {
            TIMER.write_volatile(0);
            TIMER.add(1).write_volatile(u32::MAX);
            TIMER.add(2).write_volatile(u32::MAX);
            TIMER.write_volatile(1);
        }
        Self { last: u32::MAX }
    }

    /// Instructions since the last call.
    pub(super) fn lap(&mut self) -> u32 {
        // SAFETY: reading the timer's value has no effect.
        let now = unsafe { TIMER.add(1).read_volatile() };
        let ticks = self.last.wrapping_sub(now);
        self.last = now;
        (u64::from(ticks) * 5 / 8) as u32
    }
}
