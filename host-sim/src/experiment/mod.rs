//! The book's experiments, a folder each, on one plan: options, trial, claims, tables, figures.

pub mod aliased;
pub mod angle;
pub mod calibrate;
pub mod causal;
pub mod forage;
pub mod hil;
pub mod live;
pub mod mcu;
pub mod measured;
pub mod microworld;
pub mod modules;
pub mod neighbours;
pub mod noted;
pub mod one;
pub mod plan;
pub mod record;
pub mod recover;
pub mod settled;
pub mod survive;
pub mod sweep;
pub mod words;

use crate::report::Claim;

/// What an experiment claims with its standard options, with nothing measured.
///
/// `None` where the claims come of programs that must be built first, as those of `mcu` do.
///
/// ```
/// use host_sim::experiment::declared;
/// let claims = declared("forage").unwrap_or_default();
/// assert!(claims.iter().any(|it| it.id == "forage.level1_over_sector"));
/// assert!(claims.iter().all(|it| it.ours.n == 0));
/// ```
#[must_use]
pub fn declared(experiment: &str) -> Option<Vec<Claim>> {
    match experiment {
        "aliased" => Some(aliased::declared()),
        "angle" => Some(angle::declared()),
        "calibrate" => Some(calibrate::declared()),
        "causal" => Some(causal::declared()),
        "forage" => Some(forage::declared()),
        "microworld" => Some(microworld::declared()),
        "modules" => Some(modules::declared()),
        "neighbours" => Some(neighbours::declared()),
        "one" => Some(one::declared()),
        "recover" => Some(recover::declared()),
        "survive" => Some(survive::declared()),
        "words" => Some(words::declared()),
        _ => None,
    }
}
