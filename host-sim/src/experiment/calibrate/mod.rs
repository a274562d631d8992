//! Calibration: our Pioneer beside the original simulator, Stage 1.3.4 and 4.3.0.
//!
//! The controllers of the Stage runs drive our robot on the same layouts; compared are the actions
//! to the last capture and P(s3 stays s3, nearest blob) after `forward`, and for `random` the
//! captures.
//! Percepts after an action are those after its reflexes, as in the Stage runs: counted before them
//! P(s3 stays s3) would be .57 instead of .31 in the smallest room.
//! `trial` runs, `yardstick` holds the Stage runs, `compare` judges.

pub mod compare;
pub mod report;
pub mod trial;
pub mod yardstick;
