//! Calibration: our Pioneer beside the original simulator, Stage 1.3.4 and 4.3.0.
//!
//! The controllers of the Stage runs drive our robot on the same layouts; compared are the actions
//! to the last capture and P(s3 stays s3, nearest blob) after `forward`, and for `random` the
//! captures.
//! Percepts after an action are those after its reflexes, as in the Stage runs: counted before them
//! P(s3 stays s3) would be .57 instead of .31 in the smallest room.
//! `trial` runs, `yardstick` holds the Stage runs, `compare`
//! judges.

mod claims;
pub mod compare;
mod figures;
mod options;
mod tables;
pub mod trial;
pub mod yardstick;

pub use options::CalibrateOptions;
pub use trial::{Condition, Row};

use super::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Calibrate;

impl Experiment for Calibrate {
    type Options = CalibrateOptions;
    type Case = Condition;
    type Trial = Row;

    const NAME: &'static str = "calibrate";
    const PHASE: &'static str = "calibrating";

    fn cases(options: &CalibrateOptions) -> Vec<Condition> {
        options.conditions.clone()
    }

    fn trial(_: &CalibrateOptions, &it: &Condition, ticker: &Ticker) -> Result<Row, Failure> {
        let row = trial::run_row(it)?;
        ticker.advance(1);
        Ok(row)
    }

    fn judge(_: &CalibrateOptions, rows: &[Row]) -> Result<Results, Failure> {
        let found = compare::findings(rows);
        let results = Results::new(claims::summary(&found));
        let mut results = results.headline(
            "room of 5 m, steps of 0.5 m",
            &[
                ("actions to clear it", "calibrate.actions.R5_f0_5"),
                (
                    "share of steps that keep a specimen ahead",
                    "calibrate.p_s3.R5_f0_5",
                ),
            ],
        );
        for (name, picture) in figures::all(&found)? {
            results = results.picture(name, picture);
        }
        Ok(results)
    }
}

/// What is claimed, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    claims::declared()
}
