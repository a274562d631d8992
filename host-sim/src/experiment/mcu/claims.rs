//! What is claimed of the brain on microcontrollers.
//!
//! Instructions and bytes are the same in every run; a rate of round trips and a ratio of CPU times
//! are this machine's, shown and never judged by a test.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::{pioneer, small};
use cla_core::num::Rng;
use cla_core::som::Prototypes;
use firmware_example::replay::{Forager, be_born, relive};
use firmware_example::trace;

use super::hil::{self, Life};
use super::peers;
use crate::device::board::{Build, section_bytes};
use crate::device::meter::Load;
use crate::device::target::Target;
use crate::failure::Failure;
use crate::learner::live;
use crate::progress::{Progress, Ticker};
use crate::report::{Bound, Claim, Expectation, Results, Rule, Summary, Table, mean};
use crate::world::config::PioneerConfig;
use crate::world::pioneer::Pioneer;

/// Actions of training and of a test, as in `forage`.
const ACTIONS: (u32, u32) = (10_000, 3_000);

/// Runs everything: the firmware on all boards, the lives, the peers.
///
/// # Errors
/// [`Failure`] when a program cannot be built or ends badly.
pub fn run(seeds: &[u64], progress: &Progress) -> Result<Results, Failure> {
    let mut summary = Summary::new("mcu", seeds);
    summary.parameter(
        "trace",
        format!("seed {}, {} actions", trace::SEED, trace::ACTIONS),
    );
    summary.claims = boards()?;
    summary.claims.extend(kernels()?);
    summary.claims.extend(code()?);
    let lives = lives(seeds, ACTIONS, progress)?;
    summary.claims.extend(in_the_loop(&lives));
    summary.claims.extend(small_profile(seeds, progress)?);
    summary.claims.extend(race()?);
    let mut results = Results::new(summary);
    results.worst_ticks = worst_ticks(&lives);
    Ok(results)
}

fn worst_ticks(lives: &[Life]) -> Vec<(&'static str, u64)> {
    Load::of(lives.iter().map(|life| &life.load)).by_processor()
}

/// Brain in the loop alone.
///
/// # Errors
/// [`Failure`] when the firmware cannot be built, dies, or chooses otherwise than the host's brain.
pub fn run_hil(
    seeds: &[u64],
    actions: (u32, u32),
    progress: &Progress,
) -> Result<Results, Failure> {
    let lives = lives(seeds, actions, progress)?;
    let mut summary = Summary::new("hil", seeds);
    summary.parameter("actions", actions.0);
    summary.parameter("test_actions", actions.1);
    let mut table = Table::new(&[
        "seed",
        "choices",
        "same as the host's",
        "captures in the test",
        "round trips",
    ]);
    for (seed, life) in seeds.iter().zip(&lives) {
        let cells = [
            *seed,
            life.choices.into(),
            life.same.into(),
            life.captures.into(),
            life.round_trips.into(),
        ];
        table.row(cells.map(Into::into));
    }
    summary.table("the brain in the emulated controller", table);
    summary.claims = in_the_loop(&lives);
    let mut results = Results::new(summary);
    results.worst_ticks = worst_ticks(&lives);
    Ok(results)
}

fn extension(id: &str, unit: &str) -> Expectation {
    Expectation::new(id, "–", unit).extension()
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

fn boards() -> Result<Vec<Claim>, Failure> {
    let mut all = Vec::new();
    let mut stack = 0;
    let host = here(pioneer::brain(), trace::ACTIONS)?;
    let host_short = here(pioneer::brain(), trace::ACTIONS / 10)?;
    for (target, name) in Target::ALL.into_iter().zip(["m4f", "m0", "riscv"]) {
        let printed = Build::new(target, "firmware").run()?;
        let (expected, actions) = match target {
            Target::M4f => (&host, trace::ACTIONS),
            Target::M0 | Target::Riscv => (&host_short, trace::ACTIONS / 10),
        };
        all.push(
            extension(&format!("mcu.hash.{name}"), "identical to the host")
                .rule(Rule::mean(Bound::AtLeast(1.0)))
                .note(format!(
                    "weights, distances, schemas and choices of {actions} actions on {}",
                    target.name()
                ))
                .judge_share(&[printed.text().starts_with(expected.as_str())]),
        );
        // Where floats are functions the brain for small parts is what one would take.
        let (ticks, maps) = if target == Target::M0 {
            let small = Build {
                features: "small",
                ..Build::new(target, "firmware")
            };
            (small.run()?, "10 × 10 with a byte a weight")
        } else {
            (printed.clone(), "20 × 20 in f32")
        };
        for level in ["level1", "level2"] {
            let tick = |word| ticks.number(&format!("tick_{level} instructions"), word);
            let aim = match (level, target) {
                ("level2", Target::M4f) => Some(60_000.0),
                ("level2", Target::M0) => Some(250_000.0),
                _ => None,
            };
            let mut claim = extension(&format!("mcu.tick.{level}.{name}"), "instructions").note(format!(
                "mean of choosing and learning together; worst {}; harvests apart; maps of {maps}",
                tick("worst")?
            ));
            if let Some(aim) = aim {
                claim = claim.rule(Rule::mean(Bound::AtMost(aim)));
            }
            all.push(claim.judge(&[tick("mean")? as f64]));
        }
        if target == Target::M4f {
            stack = printed.number("stack bytes", "")?;
        }
    }
    let small = Build {
        features: "small",
        ..Build::new(Target::M4f, "firmware")
    };
    let printed = small.run()?;
    stack = stack.max(printed.number("stack bytes", "")?);
    all.push(
        extension("mcu.ram.small_profile", "bytes")
            .rule(Rule::mean(Bound::AtMost(100.0 * 1024.0)))
            .note("all statics of the program; both levels")
            .judge(&[printed.number("static bytes", "")? as f64]),
    );
    all.push(
        extension("mcu.stack", "bytes")
            .rule(Rule::mean(Bound::AtMost(1536.0)))
            .note("deepest stack of the program on the Cortex-M4F, of both profiles the deeper; the measuring is in it")
            .judge(&[stack as f64]),
    );
    Ok(all)
}

fn kernels() -> Result<Vec<Claim>, Failure> {
    let bench = Build {
        features: "kernels",
        ..Build::new(Target::M4f, "kernels")
    };
    let ours = bench.run()?.number("f32 best_match 400x142 on 10 =", "")? as f64;
    let cmsis = peers::cmsis()? as f64;
    let version = peers::CMSIS_LAST.1;
    Ok(vec![
        extension("mcu.bmu.m4f", "instructions")
            .rule(Rule::mean(Bound::AtMost(15_000.0)))
            .note("best match over 400 nodes, 142 features, ten on, Cortex-M4F")
            .judge(&[ours]),
        extension("mcu.bmu.vs_cmsis", "times fewer instructions")
            .rule(Rule::mean(Bound::AtLeast(15.0)))
            .note(format!("CMSIS-DSP {version}, its best of three variants (matrix by vector): {cmsis} instructions"))
            .judge_ratio(&[cmsis], &[ours]),
    ])
}

fn code() -> Result<Vec<Claim>, Failure> {
    let bytes = |entry| -> Result<f64, Failure> {
        let proof = Build {
            opt_level: "s",
            entry,
            ..Build::new(Target::M4f, "panic_free")
        };
        let program = proof.build()?;
        Ok((section_bytes(&program, ".text")? + section_bytes(&program, ".rodata")?) as f64)
    };
    Ok(vec![
        extension("mcu.flash", "bytes")
            .rule(Rule::mean(Bound::AtMost(32.0 * 1024.0)))
            .note("the core's code and constants for a robot that learns, opt-level s, Cortex-M4F")
            .judge(&[bytes("training")?]),
        extension("mcu.flash.acting", "bytes")
            .rule(Rule::mean(Bound::AtMost(16.0 * 1024.0)))
            .note("as mcu.flash, for a robot that only acts")
            .judge(&[bytes("acting")?]),
    ])
}

fn lives(seeds: &[u64], actions: (u32, u32), progress: &Progress) -> Result<Vec<Life>, Failure> {
    let program = Build::new(Target::M4f, "controller").build()?;
    let job = |&seed: &u64, ticker: &Ticker| {
        let life = hil::run(Target::M4f, &program, seed, actions.0, actions.1);
        ticker.advance(1);
        life
    };
    progress
        .over("living in the loop", seeds, 1, job)
        .into_iter()
        .collect()
}

fn in_the_loop(lives: &[Life]) -> Vec<Claim> {
    let of = |number: fn(&Life) -> f64| lives.iter().map(number).collect::<Vec<f64>>();
    let same: Vec<bool> = lives
        .iter()
        .map(|it| it.same == it.choices && it.same_knowledge)
        .collect();
    vec![
        extension("mcu.hil.captures", "captures in the test")
            .note("the firmware's brain from birth, both levels; every choice is the host brain's, see mcu.hil.same")
            .judge(&of(|it| f64::from(it.captures))),
        extension("mcu.hil.same", "share of seeds")
            .rule(Rule::mean(Bound::AtLeast(1.0)))
            .note("all choices with their values, and all schemas at the end, are the host brain's to the bit")
            .judge_share(&same),
        extension("mcu.hil.round_trips", "a second")
            .note("by the clock, the world's and the host brain's work included; hoped for 3000 on an idle machine")
            .judge(&of(|it| f64::from(it.round_trips) / it.took.as_secs_f64())),
    ]
}

/// Captures of one profile in the test of `forage`.
fn captures<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + 'static,
>(
    brain: Forager<W, H, P, S, Y, B, M>,
    seed: u64,
) -> Result<u32, Failure> {
    let mut brain: Box<Forager<W, H, P, S, Y, B, M>> = Box::new(brain);
    be_born(&mut brain, AgentConfig::FORAGER, seed)?;
    let mut world = Pioneer::new(PioneerConfig::NOISY, seed)?;
    live(&mut *brain, &mut world, ACTIONS.0)?;
    brain.reconfigure(AgentConfig::FORAGER_LEVEL2)?;
    let mut world = Pioneer::new(PioneerConfig::NOISY, Rng::stream(seed, 4).next_seed())?;
    live(&mut *brain, &mut world, ACTIONS.0)?;
    brain.act(Adaptation::Reliabilities)?;
    let test = Rng::stream(seed, 1).next_seed();
    let mut world = Pioneer::new(PioneerConfig::NOISY, test)?;
    Ok(live(&mut *brain, &mut world, ACTIONS.1)?.total())
}

fn small_profile(seeds: &[u64], progress: &Progress) -> Result<Vec<Claim>, Failure> {
    let job = |&seed: &u64, ticker: &Ticker| -> Result<(u32, u32), Failure> {
        let pair = (
            captures(small::brain(), seed)?,
            captures(pioneer::brain(), seed)?,
        );
        ticker.advance(1);
        Ok(pair)
    };
    let pairs = progress.over("small and large", seeds, 1, job);
    let pairs = pairs.into_iter().collect::<Result<Vec<_>, _>>()?;
    let small: Vec<f64> = pairs.iter().map(|pair| f64::from(pair.0)).collect();
    let large: Vec<f64> = pairs.iter().map(|pair| f64::from(pair.1)).collect();
    Ok(vec![
        extension(
            "mcu.small_profile.captures",
            "of the host profile's captures",
        )
        .rule(Rule::mean(Bound::AtLeast(0.97)))
        .note(format!(
            "both levels; {:.1} against {:.1} in 3000 actions",
            mean(&small),
            mean(&large)
        ))
        .judge_ratio(&small, &large),
    ])
}

fn race() -> Result<Vec<Claim>, Failure> {
    let race = peers::race()?;
    let (ours, plain) = (race.binary, race.plain);
    let times = |other: f64| other / ours.seconds;
    let minisom = race.minisom.map_or(f64::NAN, |it| times(it.seconds));
    let error = race.minisom.map_or(f64::NAN, |it| ours.error / it.error);
    Ok(vec![
        extension("host.som.vs_minisom", "times less CPU time")
            .note("MiniSom 2.3.6, an online step of 20 × 20 nodes, 142 features, ten on; hoped for 10")
            .judge(&[minisom]),
        extension("host.som.vs_minisom.error", "of its quantization error")
            .rule(Rule::mean(Bound::Between(0.98, 1.02)))
            .judge(&[error]),
        extension("host.som.vs_plain", "times less CPU time")
            .note("a plain dense loop in Rust; hoped for 3")
            .judge(&[times(plain.seconds)]),
    ])
}
