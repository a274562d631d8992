//! What is concluded from lives anywhere: who obtains how much, undamaged and damaged.
//!
//! It is measured and compared, and nothing is promised: a world and a learner of one's own have no
//! rule yet.

use serde_json::Value;

use super::options::LiveOptions;
use super::trial::{Course, Lives, Trial};
use crate::report::{Claim, Expectation, Summary, Table, mean, median, sample_sd};

/// The damaged actions that are looked at first.
const FIRST: u32 = 3000;

pub(super) fn summary(options: &LiveOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("live", &options.seeds);
    for (name, value) in [
        ("world", options.world.settings()),
        ("agent", options.agent.settings()),
    ] {
        summary.parameter(name, value.clone());
    }
    summary.parameter("training", options.protocol.training);
    summary.parameter("before", options.protocol.before);
    summary.parameter("after", options.protocol.after);
    summary.claims = undamaged(options, trials);
    for (index, damage) in options.damages.iter().enumerate() {
        let claims = damaged(options, trials, index, &damage.id());
        summary.claims.extend(claims);
    }
    summary.table("lives", table(options, trials));
    summary
}

/// A learner's name as part of a claim's id.
fn id(who: &str) -> String {
    who.replace('-', "_")
}

/// A number of each seed's lives of one learner.
fn of(trials: &[Trial], who: usize, number: impl Fn(&Lives) -> f64) -> Vec<f64> {
    let lives = trials.iter().map(|it| it.0.get(who));
    lives.map(|it| it.map_or(f64::NAN, &number)).collect()
}

/// What was measured of a damaged life, beside its twin.
fn of_damaged(
    trials: &[Trial],
    who: usize,
    damage: usize,
    number: impl Fn(&Course, &Course) -> f64,
) -> Vec<f64> {
    of(trials, who, |it| {
        let damaged = it.damaged.get(damage);
        damaged.map_or(f64::NAN, |damaged| number(damaged, &it.twin))
    })
}

fn undamaged(options: &LiveOptions, trials: &[Trial]) -> Vec<Claim> {
    let claim =
        |name: String, unit: &str| Expectation::new(format!("live.{name}"), "–", unit).extension();
    let obtained = |who| of(trials, who, |it| it.twin.all());
    let mut claims = Vec::new();
    for (index, who) in options.everybody().enumerate() {
        let name = id(who.name());
        let unit = format!("in {} actions", options.protocol.after);
        claims.push(
            claim(format!("{name}.obtained"), &unit)
                .note("pieces that an undamaged life obtains after its childhood")
                .judge(&obtained(index)),
        );
        claims.push(
            claim(format!("{name}.earned"), "reward an action")
                .note("the same in rewards less costs")
                .judge(&of(trials, index, |it| it.twin.per_action())),
        );
        if index > 0 {
            claims.push(
                claim(format!("over_{name}"), "ratio")
                    .note(format!(
                        "what {} obtains undamaged over what {} does",
                        options.agent.name(),
                        who.name()
                    ))
                    .judge_ratio(&obtained(0), &obtained(index)),
            );
        }
    }
    claims
}

/// What is asked of every damage, in the way of `recover`.
fn damaged(options: &LiveOptions, trials: &[Trial], damage: usize, name: &str) -> Vec<Claim> {
    let claim = |what: String, unit: &str| {
        Expectation::new(format!("live.{name}.{what}"), "7.1.1", unit).extension()
    };
    let first = FIRST.min(options.protocol.after);
    let obtained = |who| of_damaged(trials, who, damage, |it, _| it.first(first));
    let of_twin = |who| of_damaged(trials, who, damage, |_, twin| twin.first(first));
    let mut claims = Vec::new();
    for (index, who) in options.everybody().enumerate() {
        let name = id(who.name());
        claims.push(
            claim(format!("{name}.over_twin"), "ratio")
                .note(format!(
                    "what the first {first} damaged actions bring over what its undamaged twin \
                     obtains meanwhile"
                ))
                .judge_ratio(&obtained(index), &of_twin(index)),
        );
        claims.push(
            claim(format!("{name}.time_to_recover"), "actions")
                .note("until what it obtains stays at .9 of the twin's, within the twin's error")
                .judge_time(&of_damaged(trials, index, damage, Course::recovered_after)),
        );
        if index > 0 {
            claims.push(
                claim(format!("over_{name}"), "ratio")
                    .note(format!(
                        "what {} obtains in the first {first} damaged actions over what {} does",
                        options.agent.name(),
                        who.name()
                    ))
                    .judge_ratio(&obtained(0), &obtained(index)),
            );
        }
    }
    claims
}

/// Everybody's lives in numbers.
fn table(options: &LiveOptions, trials: &[Trial]) -> Table {
    let first = FIRST.min(options.protocol.after);
    let heads = [
        "damage",
        "learner",
        &format!("first {first}"),
        "sd",
        "of the twin",
        "all",
        "reward/action",
        "recovers",
        "never",
        "alarms",
    ];
    let mut table = Table::new(&heads);
    let damages = options.damages.iter().enumerate();
    let damages = damages.map(|(index, damage)| (Some(index), damage.to_string()));
    for (damage, name) in core::iter::once((None, "none".to_owned())).chain(damages) {
        for (index, who) in options.everybody().enumerate() {
            let of = |number: &dyn Fn(&Course, &Course) -> f64| match damage {
                Some(damage) => of_damaged(trials, index, damage, number),
                None => of(trials, index, |it| number(&it.twin, &it.twin)),
            };
            let early = of(&|it, _| it.first(first));
            let twins = of(&|_, twin| twin.first(first));
            let times = of(&|it, twin| it.recovered_after(twin));
            let recovers = median(&times);
            table.row([
                Value::from(name.as_str()),
                who.name().into(),
                mean(&early).into(),
                sample_sd(&early).into(),
                (mean(&early) / mean(&twins)).into(),
                mean(&of(&|it, _| it.all())).into(),
                mean(&of(&|it, _| it.per_action())).into(),
                if recovers.is_finite() {
                    recovers.into()
                } else {
                    "never".into()
                },
                times.iter().filter(|it| it.is_infinite()).count().into(),
                mean(&of(&|it, _| f64::from(it.alarms[1]))).into(),
            ]);
        }
    }
    table
}
