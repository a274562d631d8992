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
        let caption = format!(
            "n = 10 layouts, the same for both. {unit}. Stage 1.3.4: the original simulator. Below each pair: radius of the room, length of a step. No noise, 28 \
             specimens, those that are taken are gone.",
        );
        let axes = Axes::new(title, "", unit).caption(caption).sized(900, 440);
        bar_chart(&axes, ["ours", "Stage 1.3.4"], &bars)
    };
    Ok([
        (
            "actions",
            picture(
                "calibrate.actions.",
                "Claim: our Pioneer clears a room in about as many actions as the original simulator's",
                "Actions to the last capture, median",
            )?,
        ),
        (
            "p-s3",
            picture(
                "calibrate.p_s3.",
                "Claim: driving ahead keeps a specimen ahead about as often as in the original simulator",
                "Share of steps ahead after which the specimen is still in sector 3",
            )?,
        ),
    ])
}

/// A condition's name in ids (`R5_f0_5`) as it is read.
fn words(condition: &str) -> String {
    match condition.trim_start_matches('R').split_once("_f") {
        Some((radius, step)) => format!("{radius} m, {} m", step.replace('_', ".")),
        None => condition.to_owned(),
    }
}

fn bar(finding: &Finding, prefix: &str) -> Option<Bar> {
    let condition = finding.id.strip_prefix(prefix)?;
    let bar = Bar::new(&words(condition), finding.ours);
    Some(match finding.stage_1_3_4 {
        Some(stage) => bar.beside(stage),
        None => bar,
    })
}
