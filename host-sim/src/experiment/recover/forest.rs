//! All damages in one figure each: how far ahead of the rivals, and how far behind an undamaged life.

use super::options::RecoverOptions;
use super::rivals::Rival;
use super::trial::{Entrant, Lived, Trial};
use crate::report::figure::{Axes, FigureError, Picture, Row, Value, row_chart};
use crate::report::{mean, ratio_interval, sample};
use crate::world::damage::Damage;

/// What is drawn of several damages, with the names of the files; nothing of a single one.
pub(super) fn all(
    options: &RecoverOptions,
    trials: &[Trial],
) -> Result<Vec<(String, Picture)>, FigureError> {
    let damages: Vec<(usize, &Damage)> = options
        .damages
        .iter()
        .enumerate()
        .filter(|(_, damage)| **damage != Damage::None)
        .collect();
    if damages.len() < 2 {
        return Ok(Vec::new());
    }
    let rows = |values: &dyn Fn(&Lived<'_>) -> Vec<Option<Value>>| -> Vec<Row> {
        let row = |&(index, damage): &(usize, &Damage)| Row {
            label: damage.to_string(),
            values: values(&Lived { trials, index }),
        };
        damages.iter().map(row).collect()
    };
    let height = 110 + 44 * damages.len() as u32;
    let sampled = format!("{}. {}.", sample(&options.seeds), options.world.words());
    let best = Entrant::of(Rival::BEST);
    let over = |of: &Lived<'_>, rival: Entrant| {
        let ours = of.captures(Entrant::Both, 0, 3);
        ratio(&ours, &of.captures(rival, 0, 3))
    };
    let lead = {
        let title = "Captures of both levels over those of reinforcement learning, by damage";
        let label = "ratio in the first 3000 damaged actions";
        let caption = format!(
            "{sampled} Marks: ratio of means; bars: 95 % interval, bootstrap of pairs. Right of the \
             dashes both levels are ahead. All rivals tuned alike; the first is the best of six. A \
             damage after which nobody captures has no mark."
        );
        let axes = Axes::new(title, label, "").caption(caption);
        row_chart(
            &axes.x(0.25, 8.0).x_log().sized(900, height),
            &[best.name(), Entrant::Sarsa.name()],
            &rows(&|of| vec![over(of, best), over(of, Entrant::Sarsa)]),
            Some(1.0),
        )?
    };
    let behind = {
        let title = "Both levels beside their undamaged twins, by damage";
        let label = "share of the twin's captures";
        let caption = format!(
            "{sampled} Marks: ratio of means; bars: 95 % interval, bootstrap of pairs. The twin is the \
             same robot in the same room with the same chance, and nothing happens to it; dashes: as \
             many as the twin."
        );
        let axes = Axes::new(title, label, "").caption(caption);
        let share = |of: &Lived<'_>, from: u32| {
            let ours = of.captures(Entrant::Both, from, from + 3);
            ratio(&ours, &of.of_twins(Entrant::Both, from, from + 3))
        };
        row_chart(
            &axes.x(0.0, 1.2).sized(900, height),
            &["actions 0–3000", "3000–6000", "10,000–13,000"],
            &rows(&|of| [0, 3, 10].map(|from| share(of, from)).to_vec()),
            Some(1.0),
        )?
    };
    Ok(vec![
        ("forest".to_owned(), lead),
        ("forest-twins".to_owned(), behind),
    ])
}

/// A ratio of means with its interval; none where nothing is captured.
fn ratio(above: &[f64], below: &[f64]) -> Option<Value> {
    let value = mean(above) / mean(below);
    let interval = ratio_interval(above, below);
    let known = interval.low.is_finite() && interval.high.is_finite();
    (value.is_finite() && value > 0.0)
        .then_some((value, known.then_some((interval.low, interval.high))))
}
