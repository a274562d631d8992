//! The figure of the angle study.

use super::options::AngleOptions;
use super::trial::{NAMED, Trial, of};
use crate::report::figure::{Axes, Bar, FigureError, Picture, bar_chart};
use crate::report::sample;

/// How much more novel one test is to each network than the other, as a factor.
pub(super) fn all(
    options: &AngleOptions,
    trials: &[Trial],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    let bars = NAMED.map(|(name, network)| {
        let preference = of(trials, |trial| {
            let looking = network(trial).top;
            (looking.opened / looking.rotated).log2()
        });
        Bar::mean_of(name, &preference)
    });
    let caption = format!(
        "{}. Bars: mean; error bars: standard deviation. Novelty: distance of the Top layer's answer \
         from the habituated one. 1: the new angle is twice as novel as the new lines; −1: half as \
         novel. \"A unseen\": that place in the circle was left out of training; \"no midpoints\": \
         without the direction from one line to the other.",
        sample(&options.seeds)
    );
    let axes = Axes::new(
        "Claim: young networks see lines (below 0), old ones see angles (above 0)",
        "",
        "doublings of novelty, a new angle (B) over new lines (A)",
    );
    let axes = axes.caption(caption).sized(800, 460);
    Ok(vec![("angle", bar_chart(&axes, ["ours", ""], &bars)?)])
}
