//! The processors that brains are made for, and the emulator of each.
//!
//! Instructions are exact because QEMU counts them (`-icount`); the settings are those of
//! `firmware-example/.cargo/config.toml`.

use std::path::Path;
use std::process::Command;

/// A processor that QEMU emulates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Cortex-M4F: floats in hardware.
    M4f,
    /// Code for a Cortex-M0+, run on a Cortex-M3, which understands all of it.
    M0,
    /// RV32IMAC.
    Riscv,
}

impl Target {
    /// All of them, the reference first.
    pub const ALL: [Self; 3] = [Self::M4f, Self::M0, Self::Riscv];

    /// The name in tables and claims.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::M4f => "Cortex-M4F",
            Self::M0 => "Cortex-M0+",
            Self::Riscv => "RV32IMAC",
        }
    }

    /// The compiler's name of it.
    #[must_use]
    pub const fn triple(self) -> &'static str {
        match self {
            Self::M4f => "thumbv7em-none-eabihf",
            Self::M0 => "thumbv6m-none-eabi",
            Self::Riscv => "riscv32imac-unknown-none-elf",
        }
    }

    /// The emulator, and the package that has it on Debian.
    #[must_use]
    pub const fn qemu(self) -> (&'static str, &'static str) {
        match self {
            Self::M4f | Self::M0 => ("qemu-system-arm", "qemu-system-arm"),
            Self::Riscv => ("qemu-system-riscv32", "qemu-system-misc"),
        }
    }

    /// The emulator and its machine; an instruction takes 64 ns on the Arm boards, 1 ns on RISC-V.
    const fn machine(self) -> [&'static str; 5] {
        match self {
            Self::M4f => [
                "qemu-system-arm",
                "-M",
                "mps2-an386",
                "-icount",
                "shift=6,align=off,sleep=off",
            ],
            Self::M0 => [
                "qemu-system-arm",
                "-M",
                "mps2-an385",
                "-icount",
                "shift=6,align=off,sleep=off",
            ],
            Self::Riscv => [
                "qemu-system-riscv32",
                "-M",
                "virt",
                "-icount",
                "shift=0,align=off,sleep=off",
            ],
        }
    }

    /// The command that runs a program on the board, with the program's streams as its own.
    #[must_use]
    pub fn emulator(self, program: &Path) -> Command {
        let [qemu, machine @ ..] = self.machine();
        let mut command = Command::new(qemu);
        command.args(machine);
        if self == Self::Riscv {
            command.args(["-bios", "none"]);
        }
        command.args(["-nographic", "-monitor", "none", "-serial", "null"]);
        command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]);
        command.arg(program);
        command
    }
}
