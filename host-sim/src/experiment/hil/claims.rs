//! What is claimed of the brain in the loop.

use super::options::HilOptions;
use super::tables;
use super::trial::Life;
use crate::report::{Bound, Claim, Expectation, Rule, Summary};

pub(super) fn summary(options: &HilOptions, lives: &[Life]) -> Summary {
    let mut summary = Summary::new("hil", &options.seeds);
    summary.parameter("actions", options.actions);
    summary.parameter("test_actions", options.test_actions);
    summary.table(
        "the brain in the emulated controller",
        tables::lives(&options.seeds, lives),
    );
    summary.claims = in_the_loop(lives);
    summary
}

/// The claims about lives in the loop.
pub fn in_the_loop(lives: &[Life]) -> Vec<Claim> {
    let claim = |id: &str, unit: &str| Expectation::new(id, "–", unit).extension();
    let of = |number: fn(&Life) -> f64| lives.iter().map(number).collect::<Vec<f64>>();
    let same: Vec<bool> = lives
        .iter()
        .map(|it| it.same == it.choices && it.same_knowledge)
        .collect();
    vec![
        claim("mcu.hil.captures", "captures in the test")
            .note("the firmware's brain from birth, both levels; every choice is the host brain's, see mcu.hil.same")
            .judge(&of(|it| f64::from(it.captures))),
        claim("mcu.hil.same", "share of seeds")
            .rule(Rule::mean(Bound::AtLeast(1.0)))
            .note("all choices with their values, and all schemas at the end, are the host brain's to the bit")
            .judge_share(&same),
        claim("mcu.hil.round_trips", "a second")
            .note("by the clock, the world's and the host brain's work included; hoped for 3000 on an idle machine")
            .judge(&of(|it| f64::from(it.round_trips) / it.took.as_secs_f64())),
    ]
}
