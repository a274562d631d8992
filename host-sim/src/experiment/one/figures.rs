//! The figures of the one learner.

use super::damages::{FIRST, ids, name};
use super::measured::{Trial, sums};
use super::options::{OneOptions, Part};
use crate::report::figure::{Axes, Bar, FigureError, Picture, bar_chart};
use crate::report::{Bound, Claim, Estimator, mean, sample, sample_sd};

/// What is reached of what is asked, and the damages.
pub(super) fn all(
    options: &OneOptions,
    trials: &[Trial],
    claims: &[Claim],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    let mut pictures = Vec::new();
    let bars: Vec<Bar> = claims.iter().filter_map(reached).collect();
    if !bars.is_empty() {
        let caption = format!(
            "{}. Each bar is the estimate of a claim over what the claim asks for: from 1 on it is \
             reached. One configuration in all worlds.",
            sample(&options.seeds)
        );
        let axes = Axes::new(
            "What one learner reaches in every world, over what is asked",
            "",
            "reached, over what is asked",
        );
        let axes = axes.caption(caption).sized(1100, 520);
        pictures.push(("one", bar_chart(&axes, ["ours", ""], &bars)?));
    }
    if options.has(Part::Recover) {
        let bars: Vec<Bar> = ids().iter().map(|id| damage(trials, id)).collect();
        let caption = format!(
            "{}. Bars: mean; error bars: standard deviation. Beside each the better of tabular \
             Sarsa(λ) on percepts and with one step of history, each trained as long as suits it best.",
            sample(&options.seeds)
        );
        let axes = Axes::new(
            "Captures after each damage, beside the better of two kinds of Sarsa(λ)",
            "",
            "captures in the first 3000 damaged actions",
        );
        let axes = axes.caption(caption).sized(1100, 480);
        let names = ["ours", "the better Sarsa(λ)"];
        pictures.push(("damages", bar_chart(&axes, names, &bars)?));
    }
    Ok(pictures)
}

/// The estimate over what is asked of it; none for counts and for what nothing is asked of.
fn reached(claim: &Claim) -> Option<Bar> {
    if claim.estimator == Estimator::Count {
        return None;
    }
    let Bound::AtLeast(asked) = claim.rule.bound()? else {
        return None;
    };
    let label = claim.id.trim_start_matches("one.");
    Some(Bar::new(label, claim.ours.value? / asked))
}

fn damage(trials: &[Trial], id: &str) -> Bar {
    let first = |who: &str| sums(trials, &name(id, who), FIRST);
    let better = ["sarsa", "history"]
        .map(first)
        .into_iter()
        .max_by(|a, b| mean(a).total_cmp(&mean(b)))
        .unwrap_or_default();
    let bar = Bar::mean_of(&id.replace('_', " "), &first("mind"));
    bar.beside_with(mean(&better), sample_sd(&better))
}
