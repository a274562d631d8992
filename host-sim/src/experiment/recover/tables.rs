//! The table of each damage.

use serde_json::Value;

use super::trial::{Entrant, Lived, before};
use crate::report::{Table, mean, median, sample_sd};

/// What everybody collects, before and after it, and beside an undamaged twin.
pub(super) fn captures(of: &Lived<'_>, entrants: &[Entrant]) -> Table {
    let mut table = Table::new(&[
        "learner",
        "before",
        "0-3k",
        "sd",
        "3-6k",
        "10-13k",
        "sd ",
        "0-3k/twin",
        "3-6k/twin",
        "10-13k/twin",
        "recovers",
        "never",
        "alarms",
    ]);
    for &who in entrants {
        let (early, late) = (of.captures(who, 0, 3), of.captures(who, 10, 13));
        let twin = |from: u32, to: u32| {
            mean(&of.captures(who, from, to)) / mean(&of.of_twins(who, from, to))
        };
        let times = of.times(who);
        let recovers = median(&times);
        let alarms = of.of(who, |it| f64::from(it.alarms[0] + it.alarms[1]));
        let cells = [
            mean(&of.of(who, before)),
            mean(&early),
            sample_sd(&early),
            mean(&of.captures(who, 3, 6)),
            mean(&late),
            sample_sd(&late),
            twin(0, 3),
            twin(3, 6),
            twin(10, 13),
        ];
        let mut line = vec![Value::from(who.name())];
        line.extend(cells.map(Value::from));
        // Between two infinities there is no number.
        line.push(if recovers.is_finite() {
            Value::from(recovers)
        } else {
            Value::from("never")
        });
        line.push(times.iter().filter(|it| it.is_infinite()).count().into());
        line.push(mean(&alarms).into());
        table.row(line);
    }
    table
}
