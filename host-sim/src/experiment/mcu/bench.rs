//! What is measured once, whatever the seeds: the recorded life on every board, the kernels, the
//! size of the code, the race against others.

use cla_core::forager::pioneer;
use cla_core::som::Prototypes;
use firmware_example::replay::{Forager, relive};
use firmware_example::trace;
use serde::{Deserialize, Serialize};

use super::peers::{self, Race};
use crate::device::board::{Build, Printed, section_bytes};
use crate::device::target::Target;
use crate::failure::Failure;

/// Instructions of choosing and learning together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tick {
    /// On average.
    pub mean: u64,
    /// At most; harvests apart.
    pub worst: u64,
}

/// The recorded life on one board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Board {
    /// Actions of that life.
    pub actions: u32,
    /// Whether weights, distances, schemas and choices are the host's.
    pub identical: bool,
    /// A tick with level 1.
    pub level1: Tick,
    /// A tick with both levels.
    pub level2: Tick,
}

/// What is measured once.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bench {
    /// In the order of [`Target::ALL`].
    pub boards: [Board; 3],
    /// Bytes of all statics of the small profile.
    pub small_statics: u64,
    /// Bytes of the deepest stack on the reference board, of both profiles the deeper.
    pub stack: u64,
    /// Instructions of a best match over 400 × 142 on the reference board: ours, and CMSIS-DSP's.
    pub best_match: [u64; 2],
    /// Bytes of code and constants for a robot that learns, and for one that only acts.
    pub flash: [u64; 2],
    /// Three maps on the host.
    pub race: Race,
}

impl Bench {
    /// Measures everything.
    ///
    /// # Errors
    /// [`Failure`] when a program cannot be built or ends badly.
    pub fn measured() -> Result<Self, Failure> {
        let host = here(pioneer::brain(), trace::ACTIONS)?;
        let short = here(pioneer::brain(), trace::ACTIONS / 10)?;
        let mut boards = [Board::default(); 3];
        let mut stack = 0;
        for (board, target) in boards.iter_mut().zip(Target::ALL) {
            let printed = Build::new(target, "firmware").run()?;
            let (expected, actions) = match target {
                Target::M4f => (&host, trace::ACTIONS),
                Target::M0 | Target::Riscv => (&short, trace::ACTIONS / 10),
            };
            // Where floats are functions the brain for small parts is what one would take.
            let ticks = match target {
                Target::M0 => small(target).run()?,
                Target::M4f | Target::Riscv => printed.clone(),
            };
            *board = Board {
                actions,
                identical: printed.text().starts_with(expected.as_str()),
                level1: tick(&ticks, "level1")?,
                level2: tick(&ticks, "level2")?,
            };
            if target == Target::M4f {
                stack = printed.number("stack bytes", "")?;
            }
        }
        let printed = small(Target::M4f).run()?;
        let kernels = Build {
            features: "kernels",
            ..Build::new(Target::M4f, "kernels")
        };
        let ours = kernels
            .run()?
            .number("f32 best_match 400x142 on 10 =", "")?;
        Ok(Self {
            boards,
            small_statics: printed.number("static bytes", "")?,
            stack: stack.max(printed.number("stack bytes", "")?),
            best_match: [ours, peers::cmsis()?],
            flash: [code("training")?, code("acting")?],
            race: peers::race()?,
        })
    }
}

/// The recorded life on this machine, as the firmware prints it.
fn here<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + 'static,
>(
    brain: Forager<W, H, P, S, Y, B, M>,
    actions: u32,
) -> Result<String, Failure> {
    let mut brain = Box::new(brain);
    let echo = relive(&mut brain, trace::SEED, actions, |_, _| {})?;
    Ok(echo.to_string())
}

const fn small(target: Target) -> Build {
    Build {
        features: "small",
        ..Build::new(target, "firmware")
    }
}

fn tick(printed: &Printed, level: &str) -> Result<Tick, Failure> {
    let start = format!("tick_{level} instructions");
    Ok(Tick {
        mean: printed.number(&start, "mean")?,
        worst: printed.number(&start, "worst")?,
    })
}

/// Bytes of code and constants of an entry of the core.
fn code(entry: &'static str) -> Result<u64, Failure> {
    let proof = Build {
        opt_level: "s",
        entry,
        ..Build::new(Target::M4f, "panic_free")
    };
    let program = proof.build()?;
    Ok(section_bytes(&program, ".text")? + section_bytes(&program, ".rodata")?)
}
