//! The table of the calibration.

use super::compare::Finding;
use crate::report::Table;

/// Ours beside both versions of Stage.
pub(super) fn beside_stage(found: &[Finding]) -> Table {
    let mut table = Table::new(&["claim", "ours", "Stage 1.3.4", "Stage 4.3.0"]);
    for finding in found {
        table.row([
            finding.id.clone().into(),
            finding.ours.into(),
            finding.stage_1_3_4.into(),
            finding.stage_4_3_0.into(),
        ]);
    }
    table
}
