//! What is concluded from a sweep: every point of the grid in numbers, and each life as a line.

use serde::Serialize;
use serde_json::{Map, Value};

use super::options::{Case, Point, SweepOptions};
use crate::experiment::live::{Course, Lives, Trial};
use crate::experiment::record::line;
use crate::failure::Failure;
use crate::report::{Claim, Expectation, Summary, Table, mean, sample_sd};

/// The lives of a point, in the order of its seeds.
fn of<'a>(
    point: usize,
    cases: &'a [Case],
    trials: &'a [Trial],
) -> impl Iterator<Item = &'a Lives> + Clone {
    let both = cases.iter().zip(trials);
    let here = both.filter(move |(case, _)| case.point as usize == point);
    here.filter_map(|(_, trial)| trial.0.first())
}

pub(super) fn summary(options: &SweepOptions, cases: &[Case], trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("sweep", &options.seeds);
    for axis in &options.grid {
        summary.parameter(&axis.key, Value::Array(axis.values.clone()));
    }
    if let Some(shard) = options.shard {
        summary.parameter("shard", shard.to_string());
    }
    for (index, point) in options.points.iter().enumerate() {
        let claims = claims(index, point, cases, trials);
        summary.claims.extend(claims);
    }
    summary.table("points", table(options, cases, trials));
    summary
}

fn claims(index: usize, point: &Point, cases: &[Case], trials: &[Trial]) -> Vec<Claim> {
    let lives = of(index, cases, trials);
    let claim = |name: String, unit: &str| {
        let claim = Expectation::new(format!("sweep.{index}.{name}"), "–", unit);
        claim.extension().note(point.named())
    };
    let numbers = |number: &dyn Fn(&Lives) -> f64| lives.clone().map(number).collect::<Vec<f64>>();
    let mut claims = vec![
        claim("obtained".to_owned(), "undamaged").judge(&numbers(&|it| it.twin.all())),
        claim("earned".to_owned(), "reward an action").judge(&numbers(&|it| it.twin.per_action())),
    ];
    for (place, damage) in point.live.damages.iter().enumerate() {
        let damaged = |number: fn(&Course) -> f64| {
            numbers(&|it| it.damaged.get(place).map_or(f64::NAN, number))
        };
        claims.push(
            claim(format!("{}.over_twin", damage.id()), "ratio")
                .judge_ratio(&damaged(Course::all), &numbers(&|it| it.twin.all())),
        );
    }
    claims
}

fn table(options: &SweepOptions, cases: &[Case], trials: &[Trial]) -> Table {
    let mut heads = vec!["point"];
    heads.extend(options.grid.iter().map(|it| it.key.as_str()));
    heads.extend(["lives", "obtained", "sd", "reward/action", "damaged/twin"]);
    let mut table = Table::new(&heads);
    for (index, point) in options.points.iter().enumerate() {
        let lives = of(index, cases, trials);
        let obtained: Vec<f64> = lives.clone().map(|it| it.twin.all()).collect();
        let earned: Vec<f64> = lives.clone().map(|it| it.twin.per_action()).collect();
        let damaged = lives.clone().flat_map(|it| &it.damaged);
        let damaged: Vec<f64> = damaged.map(Course::all).collect();
        let mut row = vec![Value::from(index)];
        let varied = options
            .grid
            .iter()
            .map(|axis| match &point.varied[&axis.key] {
                value @ (Value::String(_) | Value::Number(_)) => value.clone(),
                other => other.to_string().into(),
            });
        row.extend(varied);
        row.push(obtained.len().into());
        let cells = [
            mean(&obtained),
            sample_sd(&obtained),
            mean(&earned),
            mean(&damaged) / mean(&obtained),
        ];
        row.extend(cells.map(Value::from));
        table.row(row);
    }
    table
}

/// A life with where it was lived.
#[derive(Serialize, serde::Deserialize)]
struct Line {
    point: u32,
    settings: Map<String, Value>,
    seed: u64,
    lives: Trial,
}

/// A line of JSON for each life.
pub(super) fn lines(
    options: &SweepOptions,
    cases: &[Case],
    trials: &[Trial],
) -> Result<String, Failure> {
    let mut text = String::new();
    for (case, trial) in cases.iter().zip(trials) {
        let point = options.points.get(case.point as usize);
        text.push_str(&line(&Line {
            point: case.point,
            settings: point.map(|it| it.varied.clone()).unwrap_or_default(),
            seed: case.seed,
            lives: trial.clone(),
        })?);
        text.push('\n');
    }
    Ok(text)
}
