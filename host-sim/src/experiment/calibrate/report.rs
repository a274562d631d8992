//! The calibration as an experiment: all conditions at once, then claims and two figures.

use super::compare::{Finding, findings};
use super::trial::{Driver, Row, STEPS, run_row};
use super::yardstick::{LAYOUTS, RADII};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::report::figure::{Axes, Bar, bar_chart};
use crate::report::{Claim, Expectation, Results, Rule, Summary, Table};

/// Runs the servo and the random controller in every condition; the seeds are the layouts' numbers.
///
/// # Errors
/// [`Failure`] when a layout that belongs to the program is missing or a figure cannot be drawn.
pub fn run(progress: &Progress) -> Result<Results, Failure> {
    let mut conditions = Vec::new();
    for driver in [Driver::Sector, Driver::Random] {
        for radius in RADII {
            conditions.extend(STEPS.map(|forward| (driver, radius, forward)));
        }
    }
    let rows: Vec<Row> = progress
        .over(
            "calibrating",
            &conditions,
            1,
            |&(driver, radius, forward), ticker| {
                let row = run_row(driver, radius, forward);
                ticker.advance(1);
                row
            },
        )
        .into_iter()
        .collect::<Result<_, _>>()?;
    let found = findings(&rows);
    let layouts: Vec<u64> = (1..=u64::from(LAYOUTS)).collect();
    let mut summary = Summary::new("calibrate", &layouts);
    summary.parameter("seeds", "the numbers of the layouts");
    summary.claims = found.iter().map(claim).collect();
    summary.table("ours beside Stage", table(&found));
    let picture = |prefix: &str, title: &str, unit: &str| {
        let bars: Vec<Bar> = found
            .iter()
            .filter_map(|finding| bar(finding, prefix))
            .collect();
        bar_chart(&Axes::new(title, "room's radius and step", unit), &bars)
    };
    let actions = picture(
        "calibrate.actions.",
        "Sector controller: ours (bars) and Stage 1.3.4 (strokes)",
        "actions to the last capture, median",
    )?;
    let p_s3 = picture(
        "calibrate.p_s3.",
        "P(s3 stays s3): ours (bars) and Stage 1.3.4 (strokes)",
        "probability after forward",
    )?;
    Ok(Results::new(summary)
        .picture("actions", actions)
        .picture("p-s3", p_s3))
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

fn table(found: &[Finding]) -> Table {
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

fn bar(finding: &Finding, prefix: &str) -> Option<Bar> {
    let condition = finding.id.strip_prefix(prefix)?;
    let bar = Bar::new(&condition.replace("_f0_", ", 0."), finding.ours);
    Some(match finding.stage_1_3_4 {
        Some(stage) => bar.beside(stage),
        None => bar,
    })
}

#[cfg(test)]
mod tests {
    use super::claim;
    use crate::experiment::calibrate::compare::findings;
    use crate::experiment::calibrate::trial::{Driver, run_row};
    use crate::report::Verdict;

    #[test]
    fn a_claim_has_the_verdict_of_its_finding() {
        let found = findings(&[run_row(Driver::Sector, 3, 0.5).unwrap()]);
        let claim = claim(&found[0]);
        assert_eq!(claim.id, "calibrate.actions.R3_f0_5");
        assert_eq!(claim.verdict, Verdict::Reproduced);
        assert_eq!(claim.per_seed.len(), 10);
    }
}
