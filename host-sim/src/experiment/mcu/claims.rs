//! What is claimed of the brain on microcontrollers.
//!
//! Instructions and bytes are the same in every run; a rate of round trips and a ratio of CPU times
//! are this machine's, shown and never judged by a test.

use firmware_example::trace;

use super::bench::Bench;
use super::options::McuOptions;
use super::peers;
use super::trial::{Lives, Trial};
use crate::device::target::Target;
use crate::experiment::hil::Life;
use crate::experiment::hil::claims::in_the_loop;
use crate::report::{Bound, Claim, Expectation, Rule, Statistic, Summary};

pub(super) fn summary(options: &McuOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("mcu", &options.seeds);
    summary.parameter(
        "trace",
        format!("seed {}, {} actions", trace::SEED, trace::ACTIONS),
    );
    let benches = || {
        trials.iter().filter_map(|trial| match trial {
            Trial::Bench(bench) => Some(bench),
            Trial::Lives(_) => None,
        })
    };
    for bench in benches() {
        summary.claims.extend(boards(bench));
        summary.claims.extend(kernels(bench));
        summary.claims.extend(code(bench));
    }
    let lives: Vec<Lives> = lives(trials).collect();
    let in_loop: Vec<Life> = lives.iter().map(|it| it.in_the_loop).collect();
    summary.claims.extend(in_the_loop(&in_loop));
    summary.claims.push(small_profile(&lives));
    for bench in benches() {
        summary.claims.extend(race(bench));
    }
    summary
}

/// The lives of all seeds.
pub(super) fn lives(trials: &[Trial]) -> impl Iterator<Item = Lives> {
    trials.iter().filter_map(|trial| match trial {
        Trial::Lives(lives) => Some(*lives),
        Trial::Bench(_) => None,
    })
}

fn extension(id: &str, unit: &str) -> Expectation {
    Expectation::new(id, "–", unit).extension()
}

fn boards(bench: &Bench) -> Vec<Claim> {
    let mut all = Vec::new();
    let named = Target::ALL.into_iter().zip(["m4f", "m0", "riscv"]);
    for (board, (target, name)) in bench.boards.iter().zip(named) {
        all.push(
            extension(&format!("mcu.hash.{name}"), "identical to the host")
                .rule(Rule::mean(Bound::AtLeast(1.0)))
                .note(format!(
                    "weights, distances, schemas and choices of {} actions on {}",
                    board.actions,
                    target.name()
                ))
                .judge_count(f64::from(u8::from(board.identical))),
        );
        let maps = match target {
            Target::M0 => "10 × 10 with a byte a weight",
            Target::M4f | Target::Riscv => "20 × 20 in f32",
        };
        for (level, tick) in [("level1", board.level1), ("level2", board.level2)] {
            let aim = match (level, target) {
                ("level2", Target::M4f) => Some(60_000.0),
                ("level2", Target::M0) => Some(250_000.0),
                _ => None,
            };
            let mut claim = extension(&format!("mcu.tick.{level}.{name}"), "instructions").note(format!(
                "mean of choosing and learning together; worst {}; harvests apart; maps of {maps}",
                tick.worst
            ));
            if let Some(aim) = aim {
                claim = claim.rule(Rule::mean(Bound::AtMost(aim)));
            }
            all.push(claim.judge_count(tick.mean as f64));
        }
    }
    all.push(
        extension("mcu.ram.small_profile", "bytes")
            .rule(Rule::mean(Bound::AtMost(100.0 * 1024.0)))
            .note("all statics of the program; both levels")
            .judge_count(bench.small_statics as f64),
    );
    all.push(
        extension("mcu.stack", "bytes")
            .rule(Rule::mean(Bound::AtMost(1536.0)))
            .note("deepest stack of the program on the Cortex-M4F, of both profiles the deeper; the measuring is in it")
            .judge_count(bench.stack as f64),
    );
    all
}

fn kernels(bench: &Bench) -> [Claim; 2] {
    let [ours, cmsis] = bench.best_match.map(|instructions| instructions as f64);
    let version = peers::CMSIS_LAST.1;
    [
        extension("mcu.bmu.m4f", "instructions")
            .rule(Rule::mean(Bound::AtMost(15_000.0)))
            .note("best match over 400 nodes, 142 features, ten on, Cortex-M4F")
            .judge_count(ours),
        extension("mcu.bmu.vs_cmsis", "times fewer instructions")
            .rule(Rule::mean(Bound::AtLeast(15.0)))
            .note(format!("CMSIS-DSP {version}, its best of three variants (matrix by vector): {cmsis} instructions"))
            .judge_count(cmsis / ours),
    ]
}

fn code(bench: &Bench) -> [Claim; 2] {
    let [training, acting] = bench.flash.map(|bytes| bytes as f64);
    [
        extension("mcu.flash", "bytes")
            .rule(Rule::mean(Bound::AtMost(32.0 * 1024.0)))
            .note("the core's code and constants for a robot that learns, opt-level s, Cortex-M4F")
            .judge_count(training),
        extension("mcu.flash.acting", "bytes")
            .rule(Rule::mean(Bound::AtMost(16.0 * 1024.0)))
            .note("as mcu.flash, for a robot that only acts")
            .judge_count(acting),
    ]
}

fn small_profile(lives: &[Lives]) -> Claim {
    let small: Vec<f64> = lives.iter().map(|it| f64::from(it.small)).collect();
    let large: Vec<f64> = lives.iter().map(|it| f64::from(it.large)).collect();
    extension(
        "mcu.small_profile.captures@2",
        "of the host profile's captures",
    )
    .rule(Rule::Equivalent(Statistic::Low, Bound::AtLeast(0.97)))
    .note("both levels, 3000 actions")
    .judge_ratio(&small, &large)
}

fn race(bench: &Bench) -> [Claim; 3] {
    let race = &bench.race;
    let (ours, plain) = (race.binary, race.plain);
    let times = |other: f64| other / ours.seconds;
    let minisom = race.minisom.map_or(f64::NAN, |it| times(it.seconds));
    let error = race.minisom.map_or(f64::NAN, |it| ours.error / it.error);
    [
        extension("host.som.vs_minisom", "times less CPU time")
            .note("MiniSom 2.3.6, an online step of 20 × 20 nodes, 142 features, ten on; hoped for 10")
            .judge(&[minisom]),
        extension("host.som.vs_minisom.error", "of its quantization error")
            .rule(Rule::mean(Bound::Between(0.98, 1.02)))
            .judge(&[error]),
        extension("host.som.vs_plain", "times less CPU time")
            .note("a plain dense loop in Rust; hoped for 3")
            .judge(&[times(plain.seconds)]),
    ]
}
