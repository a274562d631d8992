//! A portrait for people: what a brain knows, on the terminal.

use core::fmt::Write as _;

use super::portrait::Portrait;

/// Sizes, health, items, schemas, beliefs, voices; of each table the first `most` rows.
pub(super) fn told(portrait: &Portrait, most: usize) -> String {
    let mut text = String::new();
    let mut line = |it: String| {
        // A string takes everything.
        let _ = writeln!(text, "{it}");
    };
    line(format!(
        "{} of the {}; {} bytes; {}; {} samples; {} alarms",
        portrait.kind,
        portrait.robot,
        portrait.bytes,
        portrait.stage,
        portrait.samples,
        portrait.alarms
    ));
    let tables = portrait.tables.iter();
    let tables: Vec<String> = tables
        .map(|it| format!("{} {}/{}", it.table, it.used, it.capacity))
        .collect();
    line(tables.join(", "));
    for it in portrait.losses.iter().filter(|it| it.count != 0.0) {
        line(format!("{}: {}", it.what, short(it.count)));
    }

    let second = if portrait.kind == "mind" {
        "relevance"
    } else {
        "deferred"
    };
    line(format!(
        "\nitem             inherent  {second:>9}   habit of {}",
        portrait.actions.join(", ")
    ));
    for it in &portrait.items {
        let habits: Vec<String> = it.habits.iter().map(|it| format!("{it:7.2}")).collect();
        let other = it.deferred.or(it.relevance).unwrap_or_default();
        line(format!(
            "{:14} {:10.2} {other:10.2}   {}",
            it.name,
            it.inherent,
            habits.join(" ")
        ));
    }

    let (head, what) = if portrait.kind == "mind" {
        ("\n   value   context/action/", "contexts")
    } else {
        ("\n   value reliability  trials   schema", "schemas")
    };
    line(head.to_owned());
    for it in portrait.schemas.iter().take(most) {
        line(match (it.reliability, it.trials) {
            (Some(reliability), Some(trials)) => format!(
                "{:8.2} {reliability:11.3} {trials:7}   {}",
                it.value, it.brief
            ),
            _ => format!("{:8.2}   {}", it.value, it.text),
        });
    }
    left_out(&mut line, portrait.schemas.len(), most, what);

    if !portrait.beliefs.is_empty() {
        line("\n      on   tried   after → next".to_owned());
        for it in portrait.beliefs.iter().take(most) {
            line(format!(
                "{:8.1} {:7.1}   {} → {}",
                it.on, it.tried, it.after, it.item
            ));
        }
        left_out(&mut line, portrait.beliefs.len(), most, "beliefs");
    }
    if !portrait.voices.is_empty() {
        line("\n brought  blocks   voice".to_owned());
        for it in &portrait.voices {
            line(format!("{:8.3} {:7}   {}", it.brought, it.blocks, it.name));
        }
    }
    text.trim_end().to_owned()
}

fn left_out(line: &mut impl FnMut(String), all: usize, most: usize, what: &str) {
    if all > most {
        line(format!("{:8} more {what}", all - most));
    }
}

/// At most three digits behind the point.
pub(super) fn short(number: f64) -> String {
    let text = format!("{number:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
