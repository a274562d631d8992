//! Power that goes at every operation of saving into flash, within it, and after each of these cuts again
//! at every operation that brings the brain back.

use super::super::part::{Part, Scale, never, tried};
use crate::device::flash::cuts::{Cuts, History, on_every_shape};
use crate::device::flash::toy::{Brain, SmallMind, Toy, ages};
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::report::Claim;

/// The part.
pub(crate) const PART: Part = Part {
    name: "power_cut",
    measure,
    claims,
    ..Part::QUICK
};

/// Saves in a row, on each shape of flash.
const SAVES: u32 = 6;

/// Most that [`again_after`] is.
const SELDOM: usize = 7;

/// After which cuts the recovery is cut, too: at full length after each.
fn again_after(scale: Scale) -> u64 {
    scale.step().min(SELDOM) as u64
}

fn measure(scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let mut cuts = Cuts::default();
    of_brain::<Brain>(scale, seed, &mut cuts)?;
    of_brain::<SmallMind>(scale, seed, &mut cuts)?;
    for (name, number) in [
        ("points", cuts.points),
        ("distinct", cuts.distinct),
        ("again", cuts.again),
        ("lost", cuts.lost),
        ("wrong", cuts.wrong),
        ("regressed", cuts.regressed),
        ("refused", cuts.refused),
        ("violations", cuts.violations),
        ("sealed_anew", cuts.sealed_anew),
    ] {
        trial.note(format!("power_cut.{name}"), number as u32);
    }
    Ok(())
}

/// A life of the seed, saved at its ages into each shape of flash.
fn of_brain<B: Toy>(scale: Scale, seed: u64, cuts: &mut Cuts) -> Result<(), Failure> {
    let ages = ages::<B>(5, seed)?;
    for corrects_errors in [false, true] {
        let history = History {
            saves: scale.of(SAVES) as usize,
            seed: 2 * seed + u64::from(corrects_errors),
            corrects_errors,
            again_after: again_after(scale),
        };
        for (_, more) in on_every_shape(&ages, history)? {
            cuts.add(&more);
        }
    }
    Ok(())
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    let of = |name: &str| of(trials, &format!("power_cut.{name}"));
    vec![
        never(
            "power_cut",
            "generations",
            "generations that a save had answered for and that were not there after the cut",
            &of("lost"),
        ),
        never(
            "power_cut.wrong",
            "brains",
            "brains that were resumed and are not what was saved",
            &of("wrong"),
        ),
        never(
            "power_cut.regressed",
            "generations",
            "generations that were resumed once and were not there at the next reset",
            &of("regressed"),
        ),
        never(
            "power_cut.refused",
            "saves",
            "saves after a recovery that failed, and words written twice",
            &sums(&of("refused"), &of("violations")),
        ),
        tried("power_cut.points", "cuts", 100_000.0, &of("points")),
        tried("power_cut.distinct", "cuts", 100_000.0, &of("distinct")),
        tried("power_cut.again", "cuts", 30_000.0, &of("again")),
    ]
}

fn sums(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

#[cfg(test)]
mod tests {
    use super::{Scale, again_after};
    use crate::device::flash::cuts::{History, cut_everywhere};
    use crate::device::flash::toy::{Brain, ages};

    #[test]
    fn at_full_length_every_recovery_is_cut_too() {
        let ages = ages::<Brain>(1, 3).unwrap();
        let of = |scale| {
            let history = History {
                saves: 1,
                seed: 3,
                corrects_errors: false,
                again_after: again_after(scale),
            };
            cut_everywhere::<Brain, 256, 4096, 2>(&ages, history).unwrap()
        };
        let (each, some) = (of(Scale(1)), of(Scale(200)));
        assert!(each.all_survived() && some.all_survived());
        let of_saves = each.points - each.again;
        assert_eq!(of_saves, some.points - some.again);
        // In the save after it at least, and where there is something to repair in the recovery.
        assert!(of_saves > 20 && each.again > of_saves, "{each:?}");
        assert!(some.again < of_saves, "{some:?}");
    }
}
