//! The figure of the angle study.

use super::trial::{NAMED, Trial, of};
use crate::report::figure::{Axes, Bar, FigureError, Picture, bar_chart};

/// Which test is more novel to each network, as a power of 2.
pub(super) fn all(trials: &[Trial]) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    let bars = NAMED.map(|(name, network)| {
        let preference = of(trials, |trial| {
            let looking = network(trial).top;
            (looking.opened / looking.rotated).log2()
        });
        Bar::mean_of(name, &preference)
    });
    let axes = Axes::new(
        "Young networks see lines (below 0), old ones see angles (above 0)",
        "",
        "log2 of novelty, new angle over new lines, mean ± sd",
    );
    Ok(vec![("angle", bar_chart(&axes, &bars)?)])
}
