//! The verdicts of the calibration: our runs against Stage 1.3.4, each with its rule.
//!
//! `sector`: the median of the actions to the last capture within 20 %, P(s3 stays s3, nearest)
//! within .08; `random`: the median of the captures within the range of Stage's runs.
//! Stage 4.3.0 stands beside them and decides nothing: its specimens are posts that stop the robot.

use super::trial::{Driver, Row};
use super::yardstick::Run;
use crate::report::{Bound, Rule};

/// How far the actions to the last capture may be off, as a share.
pub const ACTIONS_TOLERANCE: f64 = 0.20;
/// How far P(s3 stays s3, nearest) may be off.
pub const P_S3_TOLERANCE: f64 = 0.08;

/// One measured quantity of one condition.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The claim's id: `calibrate.actions.R5_f0_5`.
    pub id: String,
    /// What was measured, with its unit.
    pub unit: &'static str,
    /// When it counts as reproduced, in words.
    pub rule: &'static str,
    /// Ours.
    pub ours: f64,
    /// Ours, layout by layout; the runs that have none are left out.
    pub per_layout: Vec<f64>,
    /// Stage 1.3.4's; `None` where it was not run.
    pub stage_1_3_4: Option<f64>,
    /// Stage 4.3.0's; `None` where it was not run.
    pub stage_4_3_0: Option<f64>,
    /// Whether the rule holds; `None` without runs of Stage 1.3.4.
    pub holds: Option<bool>,
    /// The same rule as data.
    pub asked: Option<Rule>,
    /// Of a share that is pooled: what is counted on each layout, and of how many.
    pub counts: Option<(Vec<f64>, Vec<f64>)>,
}

/// The findings of some conditions, in their order.
#[must_use]
pub fn findings(rows: &[Row]) -> Vec<Finding> {
    rows.iter()
        .flat_map(|row| match row.condition.driver {
            Driver::Sector => vec![actions(row, "actions"), p_s3(row, "p_s3")],
            Driver::Lock => vec![actions(row, "lock.actions"), p_s3(row, "lock.p_s3")],
            Driver::Random => vec![captures(row), p_s3(row, "random.p_s3")],
        })
        .collect()
}

fn actions(row: &Row, name: &str) -> Finding {
    let of = |run: &Run| Some(f64::from(run.actions_last));
    let mut finding = Finding::new(row, name, of, median);
    finding.unit = "actions to the last capture, median";
    finding.rule = "within 20 % of Stage 1.3.4";
    finding.judge(|ours, stage| (ours / stage - 1.0).abs() <= ACTIONS_TOLERANCE);
    let near = |stage| Rule::median_within(stage, ACTIONS_TOLERANCE);
    finding.asked = finding.stage_1_3_4.map(near);
    finding
}

/// Pooled over the runs, as in the README of the Stage data: forwards, not runs, are counted.
fn p_s3(row: &Row, name: &str) -> Finding {
    let pooled = |runs: &[Run]| {
        let sum = |index: usize| runs.iter().fold(0, |sum, run| sum + run.near[index]);
        (sum(0) > 0).then(|| f64::from(sum(1)) / f64::from(sum(0)))
    };
    let mut finding = Finding::new(row, name, Run::p_s3, |_| None);
    finding.ours = pooled(&row.ours).unwrap_or(f64::NAN);
    finding.stage_1_3_4 = pooled(&row.stage_1_3_4);
    finding.stage_4_3_0 = pooled(&row.stage_4_3_0);
    finding.unit = "P(s3 stays s3 after forward, nearest blob)";
    finding.rule = "within .08 of Stage 1.3.4";
    finding.judge(|ours, stage| (ours - stage).abs() <= P_S3_TOLERANCE);
    let near = |stage| Rule::mean_near(stage, P_S3_TOLERANCE);
    finding.asked = finding.stage_1_3_4.map(near);
    let column = |index: usize| {
        row.ours
            .iter()
            .map(|run| f64::from(run.near[index]))
            .collect()
    };
    finding.counts = Some((column(1), column(0)));
    finding
}

fn captures(row: &Row) -> Finding {
    let of = |run: &Run| Some(f64::from(run.captured));
    let mut finding = Finding::new(row, "random.captures", of, median);
    finding.unit = "captures of 28 in 3000 actions, median";
    finding.rule = "within the range of the runs of Stage 1.3.4";
    let stage = || row.stage_1_3_4.iter().filter_map(of);
    let (least, most) = stage().fold((f64::INFINITY, 0.0), |(least, most), captured| {
        (captured.min(least), captured.max(most))
    });
    finding.judge(|ours, _| (least..=most).contains(&ours));
    let within = |_| Rule::median(Bound::Between(least, most));
    finding.asked = finding.stage_1_3_4.map(within);
    finding
}

impl Finding {
    fn new(
        row: &Row,
        name: &str,
        of: impl Fn(&Run) -> Option<f64>,
        summary: impl Fn(&[f64]) -> Option<f64>,
    ) -> Self {
        let values = |runs: &[Run]| runs.iter().filter_map(&of).collect::<Vec<f64>>();
        let per_layout = values(&row.ours);
        Self {
            id: format!("calibrate.{name}.{}", row.condition.id()),
            unit: "",
            rule: "",
            ours: summary(&per_layout).unwrap_or(f64::NAN),
            per_layout,
            stage_1_3_4: summary(&values(&row.stage_1_3_4)),
            stage_4_3_0: summary(&values(&row.stage_4_3_0)),
            holds: None,
            asked: None,
            counts: None,
        }
    }

    fn judge(&mut self, rule: impl Fn(f64, f64) -> bool) {
        self.holds = self.stage_1_3_4.map(|stage| rule(self.ours, stage));
    }
}

/// The mean of the two middle values when their number is even; `None` of nothing.
fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let upper = *sorted.get(sorted.len() / 2)?;
    if sorted.len() % 2 == 1 {
        return Some(upper);
    }
    Some(0.5 * (sorted[sorted.len() / 2 - 1] + upper))
}

#[cfg(test)]
mod tests {
    use super::{findings, median};
    use crate::experiment::calibrate::trial::{Condition, Driver, Row, run_row};

    fn row(driver: Driver, radius: u32, forward: f64) -> Row {
        run_row(Condition {
            driver,
            radius,
            forward,
        })
        .unwrap()
    }

    #[test]
    fn the_servo_does_in_our_world_what_it_did_in_stage() {
        let conditions = Condition::all(Driver::Sector).into_iter();
        let rows: Vec<Row> = conditions.map(|it| run_row(it).unwrap()).collect();
        let found = findings(&rows);
        assert_eq!(found.len(), 12);
        for finding in &found {
            assert_eq!(finding.holds, Some(true), "{finding:?}");
            assert_eq!(finding.per_layout.len(), 10);
        }
        assert_eq!(found[2].id, "calibrate.actions.R3_f0_5");
    }

    #[test]
    fn random_actions_capture_about_as_much_as_in_stage() {
        let found = findings(&[row(Driver::Random, 3, 0.1), row(Driver::Random, 3, 0.5)]);
        for finding in found {
            assert_eq!(finding.holds, Some(true), "{finding:?}");
        }
    }

    #[test]
    fn every_servo_run_clears_the_room() {
        let row = row(Driver::Sector, 5, 0.5);
        assert!(row.ours.iter().all(|run| run.captured == 28));
    }

    #[test]
    fn where_stage_was_not_run_nothing_is_judged() {
        let found = findings(&[row(Driver::Random, 8, 0.5)]);
        assert_eq!(found[0].id, "calibrate.random.captures.R8_f0_5");
        assert_eq!((found[0].stage_1_3_4, found[0].holds), (None, None));
    }

    #[test]
    fn medians_of_none_one_and_two() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[3.0]), Some(3.0));
        assert_eq!(median(&[4.0, 1.0]), Some(2.5));
    }
}
