//! The page of a brain: one file that asks the network for nothing.

use serde_json::{Value, json};

use super::graph::graph;
use super::portrait::{Item, Portrait};
use crate::report::{Section, Table, leaf, rows};

/// Rows of a table on a page.
const MOST: usize = 400;

fn rounded(number: f64) -> Value {
    json!((number * 1000.0).round() / 1000.0)
}

/// The page.
pub(super) fn page(portrait: &Portrait) -> String {
    let mut sections = vec![section("Health", rows(&tables(portrait)))];
    sections.push(section("Counts", rows(&counts(portrait))));
    let drawn = graph(portrait);
    if !drawn.is_empty() {
        let said = if portrait.kind == "mind" {
            "Contexts of the newest trees in which an action is worth most: what is perceived (what \
             was perceived before has was_ before its name, the last action did_), what is done, what \
             that is worth in discounted rewards. Dashed is what must be off."
        } else {
            "Schemas that bring most by themselves, and those that are worth most where something \
             new follows: what is perceived, what is done, what is expected. A number is value times \
             reliability; what is off is left out."
        };
        let html = format!("<p>{said}</p>{drawn}");
        sections.push(section("From sensors to reward", html));
    }
    sections.push(section("Items", rows(&items(portrait))));
    let title = if portrait.kind == "mind" {
        "Contexts"
    } else {
        "Schemas"
    };
    sections.push(section(title, words(&schemas(portrait))));
    if !portrait.beliefs.is_empty() {
        sections.push(section("Beliefs", words(&beliefs(portrait))));
    }
    if !portrait.voices.is_empty() {
        sections.push(section("Voices", rows(&voices(portrait))));
    }
    let title = format!("{}, {}", portrait.kind, portrait.robot);
    let lead = format!(
        "{}; {} samples, {} alarms; an image of {} bytes.",
        portrait.stage, portrait.samples, portrait.alarms, portrait.bytes
    );
    leaf(&title, &lead, &sections)
}

fn section(title: &str, html: String) -> Section {
    Section {
        title: title.to_owned(),
        html,
    }
}

/// A table of long words, which are not broken.
fn words(table: &Table) -> String {
    rows(table).replacen("class=\"sortable ", "class=\"sortable words ", 1)
}

fn tables(portrait: &Portrait) -> Table {
    let mut table = Table::new(&["table", "used", "capacity", "share"]);
    for it in &portrait.tables {
        let share = f64::from(it.used) / f64::from(it.capacity.max(1));
        table.row([
            json!(it.table),
            json!(it.used),
            json!(it.capacity),
            rounded(share),
        ]);
    }
    table
}

fn counts(portrait: &Portrait) -> Table {
    let mut table = Table::new(&["what", "how much"]);
    for it in &portrait.losses {
        table.row([json!(it.what), rounded(it.count)]);
    }
    table
}

fn items(portrait: &Portrait) -> Table {
    let second = if portrait.kind == "mind" {
        "relevance"
    } else {
        "deferred"
    };
    let habits = portrait.actions.iter().map(|it| format!("habit of {it}"));
    let mut heads = vec!["item".to_owned(), "inherent".to_owned(), second.to_owned()];
    heads.extend(habits);
    let mut table = Table {
        columns: heads,
        rows: Vec::new(),
    };
    let row = |it: &Item| {
        let second = it.deferred.or(it.relevance).map_or(Value::Null, rounded);
        let mut cells = vec![json!(it.name), rounded(it.inherent), second];
        cells.extend(it.habits.iter().map(|&it| rounded(it)));
        cells
    };
    for it in &portrait.items {
        table.row(row(it));
    }
    table
}

fn schemas(portrait: &Portrait) -> Table {
    let mut table = Table::new(&["schema", "value", "reliability", "trials"]);
    for it in portrait.schemas.iter().take(MOST) {
        table.row([
            json!(it.text),
            rounded(it.value),
            it.reliability.map_or(Value::Null, rounded),
            it.trials.map_or(Value::Null, |it| json!(it)),
        ]);
    }
    table
}

fn beliefs(portrait: &Portrait) -> Table {
    let mut table = Table::new(&["after", "next", "on", "tried"]);
    for it in portrait.beliefs.iter().take(MOST) {
        table.row([
            json!(it.after),
            json!(it.item),
            rounded(it.on),
            rounded(it.tried),
        ]);
    }
    table
}

fn voices(portrait: &Portrait) -> Table {
    let mut table = Table::new(&["voice", "brought an action", "blocks"]);
    for it in &portrait.voices {
        table.row([json!(it.name), rounded(it.brought), json!(it.blocks)]);
    }
    table
}
