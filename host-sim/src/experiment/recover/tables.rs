//! The table of each damage.

use serde_json::Value;

use super::trial::{Entrant, Lived, NEVER, before};
use crate::report::{Table, mean, median, sample_sd};

/// What everybody collects, before and after it.
pub(super) fn captures(of: &Lived<'_>, entrants: &[Entrant]) -> Table {
    let mut table = Table::new(&[
        "learner", "before", "0-3k", "sd", "3-6k", "10-13k", "sd ", "to 90 %", "alarms",
    ]);
    for &who in entrants {
        let early = of.captures(who, 0, 3);
        let late = of.captures(who, 10, 13);
        let to_90 = of.of(who, |it| {
            let actions = it.actions_to(0.9);
            if actions.is_finite() { actions } else { NEVER }
        });
        let alarms = of.of(who, |it| f64::from(it.alarms[0] + it.alarms[1]));
        let cells = [
            mean(&of.of(who, before)),
            mean(&early),
            sample_sd(&early),
            mean(&of.captures(who, 3, 6)),
            mean(&late),
            sample_sd(&late),
            median(&to_90),
            mean(&alarms),
        ];
        let mut line = vec![Value::from(who.name())];
        line.extend(cells.map(Value::from));
        table.row(line);
    }
    table
}
