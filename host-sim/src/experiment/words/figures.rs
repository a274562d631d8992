//! The figure of the study of words.

use super::claims::STUDIES;
use super::options::WordsOptions;
use super::trial::Trial;
use crate::report::figure::{Axes, Bar, FigureError, Picture, bar_chart};
use crate::report::sample;

/// Names of the studies in the figure.
const LABELS: [&str; 5] = [
    "words",
    "words, frequency balanced",
    "nothing heard",
    "grammar",
    "grammar, sameness heard",
];

/// How much more novel the other items are, as a factor.
pub(super) fn all(
    options: &WordsOptions,
    trials: &[Trial],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    if trials.is_empty() {
        return Ok(Vec::new());
    }
    let bars: Vec<Bar> = LABELS
        .iter()
        .zip(STUDIES)
        .map(|(label, (_, of))| {
            let doublings: Vec<f64> = trials
                .iter()
                .map(|it| (of(it).other / of(it).familiar).log2())
                .collect();
            Bar::mean_of(label, &doublings)
        })
        .collect();
    let caption = format!(
        "{}. Bars: mean; error bars: standard deviation. Novelty: squared distance from the nearest \
         prototype of a layer with recurrence, mean of three syllables. 1: part-words, or sentences of \
         the other grammar, are twice as novel.",
        sample(&options.seeds)
    );
    let axes = Axes::new(
        "A layer with recurrence tells words from part-words, and grammars only where sameness is heard",
        "",
        "doublings of novelty, other over familiar",
    );
    let axes = axes.caption(caption).sized(900, 460);
    Ok(vec![("words", bar_chart(&axes, ["ours", ""], &bars)?)])
}
