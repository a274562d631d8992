//! The claims of the calibration.

use super::compare::Finding;
use super::tables;
use super::yardstick::LAYOUTS;
use crate::report::{Claim, Expectation, Rule, Summary};

pub(super) fn summary(found: &[Finding]) -> Summary {
    let layouts: Vec<u64> = (1..=u64::from(LAYOUTS)).collect();
    let mut summary = Summary::new("calibrate", &layouts);
    summary.parameter("seeds", "the numbers of the layouts");
    summary.claims = found.iter().map(claim).collect();
    summary.table("ours beside Stage", tables::beside_stage(found));
    summary
}

fn claim(finding: &Finding) -> Claim {
    let expectation = Expectation::new(&finding.id, "6.2.1", finding.unit);
    let expectation = match (finding.stage_1_3_4, finding.holds) {
        (Some(stage), Some(holds)) => expectation
            .book(stage)
            .rule(Rule::judged(finding.rule, holds))
            .note("the number to compare with is that of Stage 1.3.4"),
        _ => expectation.extension(),
    };
    expectation.judge(&finding.per_layout)
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
        assert_eq!(claim.verdict, Verdict::Reproduced);
        assert_eq!(claim.per_seed.len(), 10);
    }
}
