//! The tables on the page of recovery, from the claims of `recover` and from its own tables.

pub(crate) mod mind;

use std::fmt::Write;

use host_sim::report::{Claim, Summary, Table, mean};

/// The damages in the order of the run, as they are named on the command line; the ids of their
/// claims stand in the same order.
fn damages(summary: &Summary) -> Vec<(&str, &str)> {
    let ids = summary.claims.iter().filter_map(|claim| {
        let id = claim.name().strip_prefix("recover.")?;
        id.strip_suffix(".over_sarsa_3000")
    });
    let names = summary.tables.keys().filter_map(|title| {
        let (_, name) = title.split_once(' ')?;
        name.strip_suffix(": captures").filter(|it| *it != "none")
    });
    names.zip(ids).collect()
}

fn claim<'a>(summary: &'a Summary, id: &str, name: &str) -> &'a Claim {
    let id = format!("recover.{id}.{name}");
    let found = summary.find(&id);
    found.unwrap_or_else(|| panic!("{id}"))
}

fn arm(seeds: &[Option<f64>]) -> f64 {
    mean(&seeds.iter().flatten().copied().collect::<Vec<f64>>())
}

fn share(claim: &Claim) -> String {
    claim
        .ours
        .value
        .map_or("–".to_owned(), |it| format!("{it:.2}"))
}

/// The median time, and in how many seeds it is never.
pub(crate) fn time(claim: &Claim) -> String {
    let median = claim.ours.value;
    let median = median.map_or("never".to_owned(), |it| format!("{it:.0}"));
    format!(
        "{median}; {} of {}",
        claim.ours.never.unwrap_or(0),
        claim.ours.n
    )
}

/// Each damage: both levels beside the best rival, and beside their undamaged twins.
pub(crate) fn by_damage(summary: &Summary) -> String {
    let mut text = String::from(
        "| damage | both levels | best rival | ratio, 95 % interval | p, Holm | twin 0–3k | 3–6k | \
         10–13k | recovers after; never |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for (damage, id) in damages(summary) {
        let over = claim(summary, id, "over_sarsa_3000");
        let against = over.against.as_ref().expect("pairs");
        let interval = over.ours.interval.as_ref();
        let ends = interval.and_then(|it| Some((it.low, it.high?)));
        let ends = ends.map_or(String::new(), |(low, high)| format!(", {low:.2}–{high:.2}"));
        let holm = over.tested.as_ref().and_then(|it| it.holm);
        let holm = holm.map_or("–".to_owned(), |it| format!("{it:.2e}"));
        let twin = |name: &str| share(claim(summary, id, name));
        writeln!(
            text,
            "| `{damage}` | {:.0} | {:.0} | {}{ends} | {holm} | {} | {} | {} | {} |",
            arm(&over.per_seed),
            arm(against),
            share(over),
            twin("relearn_3000"),
            twin("relearn_6000"),
            twin("relearn_10000"),
            time(claim(summary, id, "time_to_recover")),
        )
        .expect("a text grows");
    }
    text
}

fn cell(table: &Table, row: usize, column: &str) -> String {
    let place = table.columns.iter().position(|it| it == column);
    let cell = &table.rows[row][place.unwrap_or_else(|| panic!("{column}"))];
    match cell.as_f64() {
        Some(number) if column.ends_with("twin") => format!("{number:.2}"),
        Some(number) if column.starts_with("sd") => format!("{number:.1}"),
        Some(number) => format!("{number:.0}"),
        None => cell.as_str().unwrap_or("–").to_owned(),
    }
}

fn table_of<'a>(summary: &'a Summary, damage: &str) -> &'a Table {
    let end = format!(" {damage}: captures");
    let found = summary
        .tables
        .iter()
        .find(|(title, _)| title.ends_with(&end));
    found.unwrap_or_else(|| panic!("{damage}")).1
}

/// Everybody who met the turned camera.
pub(crate) fn camera(summary: &Summary) -> String {
    let table = table_of(summary, "camera:+12");
    let mut text = String::from(
        "| learner | before | 0–3k | 3–6k | 10–13k | twin 0–3k | 3–6k | 10–13k | recovers after; \
         never |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for row in 0..table.rows.len() {
        let at = |column: &str| cell(table, row, column);
        writeln!(
            text,
            "| {} | {} | {} ± {} | {} | {} ± {} | {} | {} | {} | {}; {} of {} |",
            at("learner"),
            at("before"),
            at("0-3k"),
            at("sd"),
            at("3-6k"),
            at("10-13k"),
            at("sd "),
            at("0-3k/twin"),
            at("3-6k/twin"),
            at("10-13k/twin"),
            at("recovers"),
            at("never"),
            summary.seeds.len(),
        )
        .expect("a text grows");
    }
    text
}

/// What everybody who met all damages captured in the first 3000 actions after each.
pub(crate) fn everybody(summary: &Summary) -> String {
    let damages = damages(summary);
    let first = table_of(summary, damages[1].0);
    let mut text = String::from("| learner |");
    for (damage, _) in &damages {
        write!(text, " `{damage}` |").expect("a text grows");
    }
    write!(text, "\n|---|{}\n", "---:|".repeat(damages.len())).expect("a text grows");
    for row in 0..first.rows.len() {
        let name = cell(first, row, "learner");
        write!(text, "| {name} |").expect("a text grows");
        for (damage, _) in &damages {
            let table = table_of(summary, damage);
            let same = table
                .rows
                .iter()
                .position(|it| it[0].as_str() == Some(&name));
            let captures = cell(table, same.expect("it met them all"), "0-3k");
            write!(text, " {captures} |").expect("a text grows");
        }
        text.push('\n');
    }
    text
}
