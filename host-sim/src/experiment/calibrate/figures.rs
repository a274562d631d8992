//! The figures of the calibration.

use super::compare::Finding;
use crate::report::figure::{Axes, Bar, FigureError, Picture, bar_chart};

/// Both figures, with the names of the files.
pub(super) fn all(found: &[Finding]) -> Result<[(&'static str, Picture); 2], FigureError> {
    let picture = |prefix: &str, title: &str, unit: &str| {
        let bars: Vec<Bar> = found
            .iter()
            .filter_map(|finding| bar(finding, prefix))
            .collect();
        bar_chart(&Axes::new(title, "room's radius and step", unit), &bars)
    };
    Ok([
        (
            "actions",
            picture(
                "calibrate.actions.",
                "Sector controller: ours (bars) and Stage 1.3.4 (strokes)",
                "actions to the last capture, median",
            )?,
        ),
        (
            "p-s3",
            picture(
                "calibrate.p_s3.",
                "P(s3 stays s3): ours (bars) and Stage 1.3.4 (strokes)",
                "probability after forward",
            )?,
        ),
    ])
}

fn bar(finding: &Finding, prefix: &str) -> Option<Bar> {
    let condition = finding.id.strip_prefix(prefix)?;
    let bar = Bar::new(&condition.replace("_f0_", ", 0."), finding.ours);
    Some(match finding.stage_1_3_4 {
        Some(stage) => bar.beside(stage),
        None => bar,
    })
}
