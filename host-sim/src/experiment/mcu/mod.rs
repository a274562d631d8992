//! The brain on microcontrollers: what it costs there, and that it is the same brain.
//!
//! `bench` is measured once on the boards and on the host, `peers` are others that do the same;
//! `trial` adds the lives of each seed, in the loop and in both profiles.

pub mod bench;
mod claims;
mod options;
pub mod peers;
mod trial;

pub use options::McuOptions;
pub use trial::{Case, Lives, Trial};

use super::plan::Experiment;
use crate::device::board::look_for_tools;
use crate::device::meter::Load;
use crate::device::target::Target;
use crate::failure::{Failure, Impossible};
use crate::progress::Ticker;
use crate::report::Results;

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Mcu;

impl Experiment for Mcu {
    type Options = McuOptions;
    type Case = Case;
    type Trial = Trial;

    const NAME: &'static str = "mcu";
    const PHASE: &'static str = "living on microcontrollers";

    fn look_for_tools() -> Result<(), Impossible> {
        look_for_tools(Self::NAME, &Target::ALL)
    }

    fn cases(options: &McuOptions) -> Vec<Case> {
        let seeds = options.seeds.iter().map(|&seed| Case::Seed(seed));
        [Case::Bench].into_iter().chain(seeds).collect()
    }

    /// Without the bench there is nothing to judge.
    fn part(_: &McuOptions, cases: &[Case]) -> Option<McuOptions> {
        let seed = |case: &Case| match case {
            Case::Seed(seed) => Some(*seed),
            Case::Bench => None,
        };
        let seeds: Vec<u64> = cases.iter().filter_map(seed).collect();
        (cases.contains(&Case::Bench) && !seeds.is_empty()).then_some(McuOptions { seeds })
    }

    fn trial(_: &McuOptions, &case: &Case, ticker: &Ticker) -> Result<Trial, Failure> {
        let trial = trial::run(case)?;
        ticker.advance(1);
        Ok(trial)
    }

    fn judge(options: &McuOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let mut results = results.headline(
            "instructions of a tick on a Cortex-M4F",
            &[
                ("level 1", "mcu.tick.level1.m4f"),
                ("both levels", "mcu.tick.level2.m4f"),
            ],
        );
        let lives: Vec<Lives> = claims::lives(trials).collect();
        results.worst_ticks = Load::of(lives.iter().map(|it| &it.in_the_loop.load)).by_processor();
        Ok(results)
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::bench::{Bench, Board, Tick};
    use super::peers::{Race, Trained};
    use super::{Lives, Mcu, McuOptions, Trial};
    use crate::device::meter::Load;
    use crate::experiment::hil::Life;
    use crate::experiment::plan::Experiment;
    use crate::experiment::record::{line, read};
    use crate::report::Summary;

    fn bench(minisom: Option<Trained>) -> Trial {
        let tick = |mean| Tick {
            mean,
            worst: 2 * mean,
        };
        let board = Board {
            actions: 400,
            identical: true,
            level1: tick(20_001),
            level2: tick(50_003),
        };
        let trained = |seconds| Trained {
            seconds,
            error: seconds / 3.0,
        };
        Trial::Bench(Bench {
            boards: [
                board,
                Board {
                    identical: false,
                    ..board
                },
                board,
            ],
            small_statics: 90_007,
            stack: 1_200,
            best_match: [9_001, 163_767],
            flash: [30_001, 12_007],
            race: Race {
                binary: trained(0.1),
                plain: trained(0.7),
                minisom,
            },
        })
    }

    fn lives(seed: u32) -> Trial {
        Trial::Lives(Lives {
            in_the_loop: Life {
                choices: 23_000,
                same: 23_000,
                captures: 300 + seed,
                load: Load::default(),
                same_knowledge: true,
                round_trips: 70_001,
                took: Duration::from_nanos(12_345_678_901),
            },
            small: 280 + seed,
            large: 290,
        })
    }

    #[test]
    fn boards_and_lives_that_were_written_down_are_judged_the_same() {
        let options = McuOptions { seeds: vec![1, 2] };
        let committed = include_str!("../../../../tests/claims/mcu.json");
        let committed = Summary::from_json(committed).unwrap();
        let minisom = Trained {
            seconds: 1.3,
            error: 0.2,
        };
        for minisom in [None, Some(minisom)] {
            let trials = [bench(minisom), lives(1), lives(2)];
            let back = trials.each_ref().map(|it| {
                let back: Trial = read(&line(it).unwrap()).unwrap();
                back
            });
            assert_eq!(back, trials);
            let results = Mcu::judge(&options, &trials).unwrap();
            assert_eq!(Mcu::judge(&options, &back).unwrap(), results);
            let ids = |summary: &Summary| -> Vec<String> {
                summary.claims.iter().map(|it| it.id.clone()).collect()
            };
            assert_eq!(ids(&results.summary), ids(&committed));
            let hash = |id| results.summary.find(id).and_then(|claim| claim.met);
            assert_eq!(hash("mcu.hash.m4f"), Some(true));
            assert_eq!(hash("mcu.hash.m0"), Some(false));
        }
    }
}
