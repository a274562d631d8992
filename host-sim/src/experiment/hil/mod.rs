//! Brain in the loop: the simulated robot lives, the brain in an emulated controller decides.
//!
//! `distant` is the wire to that brain, `trial` a life with it and with the host's beside it;
//! `disturbed` is the wire alone, with everything that can happen to it.

pub mod claims;
pub mod distant;
pub mod disturbed;
mod options;
mod tables;
pub mod trial;

pub use options::HilOptions;
pub use trial::Life;

use super::plan::Experiment;
use crate::device::board::look_for_tools;
use crate::device::meter::Load;
use crate::device::target::Target;
use crate::failure::{Failure, Impossible};
use crate::progress::Ticker;
use crate::report::Results;

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Hil;

impl Experiment for Hil {
    type Options = HilOptions;
    type Case = u64;
    type Trial = Life;

    const NAME: &'static str = "hil";
    const PHASE: &'static str = "living in the loop";

    fn look_for_tools() -> Result<(), Impossible> {
        look_for_tools(Self::NAME, &[Target::M4f])
    }

    fn cases(options: &HilOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &HilOptions, seeds: &[u64]) -> Option<HilOptions> {
        let seeds = seeds.to_vec();
        Some(HilOptions {
            seeds,
            ..options.clone()
        })
    }

    fn trial(options: &HilOptions, &seed: &u64, ticker: &Ticker) -> Result<Life, Failure> {
        let HilOptions {
            actions,
            test_actions,
            ..
        } = *options;
        let program = trial::controller()?;
        let life = trial::run(Target::M4f, program, seed, actions, test_actions)?;
        ticker.advance(1);
        Ok(life)
    }

    fn judge(options: &HilOptions, lives: &[Life]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, lives));
        let mut results = results.headline(
            "the brain in the emulated controller",
            &[
                ("captures in the test", "mcu.hil.captures"),
                (
                    "share of seeds with the host's choices to the bit",
                    "mcu.hil.same",
                ),
            ],
        );
        results.worst_ticks = Load::of(lives.iter().map(|life| &life.load)).by_processor();
        Ok(results)
    }
}
