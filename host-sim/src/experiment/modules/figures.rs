//! The figures of the study of modules.

use super::module::Kind;
use super::options::ModulesOptions;
use super::trial::{Measured, Trial, of};
use crate::report::figure::{Axes, FigureError, Picture, Row, row_chart};
use crate::report::sample;

type Measure = fn(&Measured) -> f64;

/// Accuracies of each kind, and what pooling over shifts is worth.
pub(super) fn all(
    options: &ModulesOptions,
    trials: &[Trial],
) -> Result<Vec<(&'static str, Picture)>, FigureError> {
    if trials.is_empty() {
        return Ok(Vec::new());
    }
    let rows = |measures: &[Measure]| -> Vec<Row> {
        let row = |kind: Kind| {
            let samples: Vec<Vec<f64>> = measures.iter().map(|it| of(trials, kind, it)).collect();
            Row::means_of(&kind.to_string(), &samples)
        };
        Kind::ALL.map(row).into()
    };
    let accuracy = Axes::new(
        "What each module is worth",
        "share (of Noisy events: area under the ROC curve)",
        "",
    )
    .x(0.0, 1.0)
    .caption(format!(
        "{}. Means with 95 % intervals. Launching events: told by the nearest composite of a clean one. \
         Noisy: newer to the Top than clean ones. Transitions: results of forward that the prototype with \
         the nearest context says.",
        sample(&options.seeds)
    ))
    .sized(900, 420);
    let shifts = Axes::new(
        "Launching events at shifts never trained",
        "share of events told",
        "",
    )
    .x(0.0, 1.0)
    .caption(format!(
        "{}. Means with 95 % intervals. Pooled: a unit of the Position layer answers the window in which it is \
         most active. By chance .25.",
        sample(&options.seeds)
    ))
    .sized(900, 420);
    Ok(vec![
        (
            "accuracy",
            row_chart(
                &accuracy,
                &["launching events", "Noisy events", "transitions"],
                &rows(&[
                    |it| it.causal.told,
                    |it| it.causal.noisy,
                    |it| it.schemas.predicted,
                ]),
                None,
            )?,
        ),
        (
            "shifts",
            row_chart(
                &shifts,
                &["plain", "pooled"],
                &rows(&[
                    |it| it.invariance.plain.untrained,
                    |it| it.invariance.pooled.untrained,
                ]),
                Some(0.25),
            )?,
        ),
    ])
}
