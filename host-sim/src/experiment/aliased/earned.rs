//! What was earned in the last tests, and which rival did best.

use super::places::Place;
use super::trial::Trial;
use crate::report::mean;

/// Rivals that see nothing but the percept.
pub(super) const MEMORYLESS: [&str; 2] = ["q", "sarsa"];
/// Rivals with history.
pub(super) const HISTORY: [&str; 4] = ["q_2", "sarsa_2", "q_4", "sarsa_4"];
/// Sarsa(λ), whatever it sees.
pub(super) const SARSA: [&str; 3] = ["sarsa", "sarsa_2", "sarsa_4"];

/// What everybody earned in an action of the last test, seed by seed.
pub(super) fn last(trials: &[Trial], place: Place, who: &str) -> Vec<f64> {
    trials.iter().map(|trial| trial.last(place, who)).collect()
}

/// The name of the rival with the best mean of all seeds.
pub(super) fn best(trials: &[Trial], place: Place, rivals: &[&'static str]) -> &'static str {
    let mut best = (f64::NEG_INFINITY, "");
    for &rival in rivals {
        let earned = mean(&last(trials, place, rival));
        // Nobody has lived where nothing is measured yet.
        if best.1.is_empty() || earned > best.0 {
            best = (earned, rival);
        }
    }
    best.1
}
