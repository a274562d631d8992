//! What one brain knows that another does not: learned, lost, revalued.

use core::fmt::Write as _;
use std::collections::BTreeMap;

use super::portrait::{Portrait, Schema};
use super::told::short;
use crate::failure::Failure;

/// Changes of a worth smaller than this are none.
const SAME: f64 = 0.005;

/// What was learned, lost and revalued from the first to the second; of each the first `most`.
///
/// # Errors
/// When they are of different robots or learners.
pub(super) fn compared(
    before: &Portrait,
    after: &Portrait,
    most: usize,
) -> Result<String, Failure> {
    if (&before.kind, &before.robot) != (&after.kind, &after.robot) {
        let of = |it: &Portrait| format!("{} of the {}", it.kind, it.robot);
        let sentence = format!(
            "there is nothing to compare: one is the {}, the other the {}",
            of(before),
            of(after)
        );
        return Err(sentence.into());
    }
    let mut text = format!(
        "{} of the {}: {} → {}; {} → {} samples; {} → {} alarms\n",
        before.kind,
        before.robot,
        before.stage,
        after.stage,
        before.samples,
        after.samples,
        before.alarms,
        after.alarms
    );
    let mut line = |it: String| {
        // A string takes everything.
        let _ = writeln!(text, "{it}");
    };
    for (one, other) in before.tables.iter().zip(&after.tables) {
        if one.used != other.used {
            line(format!(
                "{}: {} → {} of {}",
                one.table, one.used, other.used, other.capacity
            ));
        }
    }
    for (one, other) in before.losses.iter().zip(&after.losses) {
        if one.count != other.count {
            line(format!(
                "{}: {} → {}",
                one.what,
                short(one.count),
                short(other.count)
            ));
        }
    }
    let (old, new) = (by_text(before), by_text(after));
    let only = |of: &BTreeMap<&str, &Schema>, other: &BTreeMap<&str, &Schema>| {
        let mut only: Vec<(f64, String)> = of
            .iter()
            .filter(|(text, _)| !other.contains_key(*text))
            .map(|(text, it)| (it.worth(), format!("{:8.2}   {text}", it.worth())))
            .collect();
        only.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
        only
    };
    part(&mut line, "learned", only(&new, &old), most);
    part(&mut line, "lost", only(&old, &new), most);
    let mut revalued: Vec<(f64, String)> = old
        .iter()
        .filter_map(|(text, one)| Some((text, one.worth(), new.get(text)?.worth())))
        .map(|(text, one, other)| (other - one, format!("{one:8.2} → {other:8.2}   {text}")))
        .filter(|(change, _)| change.abs() >= SAME)
        .collect();
    revalued.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    part(&mut line, "revalued", revalued, most);
    part(&mut line, "items and habits", items(before, after), most);
    Ok(text.trim_end().to_owned())
}

fn by_text(portrait: &Portrait) -> BTreeMap<&str, &Schema> {
    let schemas = portrait.schemas.iter();
    schemas.map(|it| (it.text.as_str(), it)).collect()
}

fn items(before: &Portrait, after: &Portrait) -> Vec<(f64, String)> {
    let mut found = Vec::new();
    for (one, other) in before.items.iter().zip(&after.items) {
        let mut note = |what: &str, old: f64, new: f64| {
            if (new - old).abs() >= SAME {
                let said = format!("{old:8.2} → {new:8.2}   {what} of {}", one.name);
                found.push((new - old, said));
            }
        };
        let number = |it: Option<f64>| it.unwrap_or_default();
        note("inherent value", one.inherent, other.inherent);
        note(
            "deferred value",
            number(one.deferred),
            number(other.deferred),
        );
        note("relevance", number(one.relevance), number(other.relevance));
        let habits = one.habits.iter().zip(&other.habits);
        for ((old, new), action) in habits.zip(&before.actions) {
            note(&format!("habit {action}"), *old, *new);
        }
    }
    found.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    found
}

fn part(line: &mut impl FnMut(String), what: &str, of: Vec<(f64, String)>, most: usize) {
    line(format!("\n{what}: {}", of.len()));
    for (_, said) in of.iter().take(most) {
        line(said.clone());
    }
    if of.len() > most {
        line(format!("{:8} more", of.len() - most));
    }
}
