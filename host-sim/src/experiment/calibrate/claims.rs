//! The claims of the calibration.

use super::compare::{Finding, findings};
use super::options::CalibrateOptions;
use super::tables;
use super::trial::{Condition, Row};
use super::yardstick::{LAYOUTS, Stage, stage_runs};
use crate::report::{Claim, Expectation, Status, Summary};

pub(super) fn summary(found: &[Finding]) -> Summary {
    let layouts: Vec<u64> = (1..=u64::from(LAYOUTS)).collect();
    let mut summary = Summary::new("calibrate", &layouts);
    summary.status = Status::Layouts;
    summary.parameter("seeds", "the numbers of the layouts");
    summary.claims = found.iter().map(claim).collect();
    summary.table("ours beside Stage", tables::beside_stage(found));
    summary
}

fn claim(finding: &Finding) -> Claim {
    let mut claim = Expectation::new(&finding.id, "6.2.1", finding.unit).extension();
    if let (Some(stage), Some(rule)) = (finding.stage_1_3_4, &finding.asked) {
        claim = claim.beside("Stage 1.3.4", stage).rule(rule.clone());
    }
    match &finding.counts {
        Some((counted, of)) => claim
            .note("pooled: forwards are counted, not layouts")
            .judge_ratio(counted, of),
        None => claim.judge_median(&finding.per_layout),
    }
}

/// What is claimed, before our robot has driven: Stage's runs make the bounds.
pub(super) fn declared() -> Vec<Claim> {
    let row = |it: Condition| Row {
        condition: it,
        ours: Vec::new(),
        stage_1_3_4: stage_runs(Stage::V1_3_4, it.driver.name(), it.radius, it.forward),
        stage_4_3_0: Vec::new(),
    };
    let conditions = CalibrateOptions::standard().conditions;
    let rows: Vec<Row> = conditions.into_iter().map(row).collect();
    findings(&rows).iter().map(claim).collect()
}

#[cfg(test)]
mod tests {
    use super::claim;
    use crate::experiment::calibrate::compare::findings;
    use crate::experiment::calibrate::trial::{Condition, Driver, run_row};
    use crate::report::Verdict;

    #[test]
    fn a_claim_has_the_verdict_of_its_finding() {
        let condition = Condition {
            driver: Driver::Sector,
            radius: 3,
            forward: 0.5,
        };
        let found = findings(&[run_row(condition).unwrap()]);
        let claim = claim(&found[0]);
        assert_eq!(claim.id, "calibrate.actions.R3_f0_5");
        assert_eq!(claim.verdict, Verdict::Met);
        assert_eq!(claim.per_seed.len(), 10);
        for finding in &found {
            let claim = super::claim(finding);
            assert_eq!(claim.met, finding.holds, "{}", claim.id);
            let value = claim.ours.value.unwrap();
            assert!((value - finding.ours).abs() < 1e-12, "{}", claim.id);
        }
    }
}
