//! The tables of results in the documents say what the committed claims say.
//!
//! `UPDATE_CLAIMS=1 cargo test -p cla-tests --test claims_tables` writes them anew.

mod recovery;

use std::collections::BTreeMap;
use std::fs;

use cla_tests::claims::files;
use cla_tests::root;
use host_sim::report::{Claim, Summary, Verdict};

/// The documents with the tables that are filled in from `tests/tables/<name>.md`.
fn tables() -> Vec<(String, String, String)> {
    let folder = root().join("tests/tables");
    let entries = fs::read_dir(&folder).expect("the templates can be listed");
    let mut tables: Vec<(String, String, String)> = entries
        .map(|entry| {
            let path = entry.expect("a template").path();
            let name = path.file_stem().expect("a name").to_string_lossy();
            let document = match &*name {
                "findings" => "README.md".to_owned(),
                "one-brain" => "docs/one-brain.md".to_owned(),
                page => format!("docs/findings/{page}.md"),
            };
            let template = fs::read_to_string(&path).expect("a template can be read");
            (document, name.into_owned(), template)
        })
        .collect();
    tables.sort();
    tables
}

fn summaries() -> Vec<Summary> {
    let read = |text: &str| Summary::from_json(text).expect("a claims file");
    files().iter().map(|file| read(&file.text)).collect()
}

/// `{id:digits}` becomes the claim's estimate, `{id:digits:sd}` that with its deviation, `median` the
/// median of its seeds, `printed` the number it is compared with (`mean_printed` without deviation),
/// `ours` and `against` each arm of its pairs by itself, `low` and `high` the ends of its interval, `t`
/// its test, `time` a time with the seeds in which it is
/// never; digits are `3`, `.3` (no 0 before the point),
/// `0,` (thousands apart) or `0%`. `verdict` says whether a rule of our own is met, and
/// `{experiment:rules}` how many of an experiment's are.
fn fill(template: &str, summaries: &[Summary]) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let (place, after) = after.split_once('}').expect("what is opened is closed");
        let parts: Vec<&str> = place.split(':').collect();
        text.push_str(before);
        rest = after;
        if let [experiment, "rules"] = parts[..] {
            let summary = summaries.iter().find(|it| it.experiment == experiment);
            text.push_str(&rules_met(summary.expect("an experiment")));
            continue;
        }
        let claim = summaries.iter().find_map(|it| it.find(parts[0]));
        let claim = claim.unwrap_or_else(|| panic!("no claim {place}"));
        text.push_str(&number(
            claim,
            parts[1],
            parts.get(2).copied().unwrap_or(""),
        ));
    }
    text + rest
}

/// How many rules of our own are met, of all that ask anything.
fn rules_met(summary: &Summary) -> String {
    let count = |verdict: Verdict| summary.verdicts.get(verdict.words()).copied().unwrap_or(0);
    let asked = summary.verdicts.values().sum::<u32>() - count(Verdict::Measured);
    format!("{} of {asked}", count(Verdict::Met))
}

/// A number as a table has it.
fn written(value: f64, digits: &str) -> String {
    let count = |digits: &str| digits.parse::<usize>().expect("a number of digits");
    if let Some(digits) = digits.strip_prefix('.') {
        let text = format!("{value:.*}", count(digits));
        return text
            .strip_prefix("0.")
            .map_or(text.clone(), |it| format!(".{it}"));
    }
    if let Some(digits) = digits.strip_suffix('%') {
        return format!("{:.*} %", count(digits), 100.0 * value);
    }
    if let Some(digits) = digits.strip_suffix(',') {
        let text = format!("{value:.*}", count(digits));
        let apart = text.as_bytes().rchunks(3).rev();
        let apart: Vec<String> = apart
            .map(|it| String::from_utf8_lossy(it).into_owned())
            .collect();
        return apart.join(",");
    }
    format!("{value:.*}", count(digits))
}

fn number(claim: &Claim, digits: &str, what: &str) -> String {
    let spread = |value: f64, sd: Option<f64>| {
        let sd = sd.map_or_else(String::new, |sd| format!(" ± {}", written(sd, digits)));
        format!("{}{sd}", written(value, digits))
    };
    let arm = |seeds: &[Option<f64>]| {
        let seeds: Vec<f64> = seeds.iter().flatten().copied().collect();
        let sd = host_sim::report::sample_sd(&seeds);
        spread(host_sim::report::mean(&seeds), Some(sd))
    };
    match what {
        "" | "sd" => {
            let value = claim.ours.value.expect("an estimate");
            spread(value, claim.ours.sd.filter(|_| what == "sd"))
        }
        "median" => {
            let seeds: Vec<f64> = claim.per_seed.iter().flatten().copied().collect();
            spread(host_sim::report::median(&seeds), None)
        }
        "printed" | "mean_printed" => {
            let printed = claim.reference.as_ref().expect("a printed number");
            spread(printed.mean, printed.sd.filter(|_| what == "printed"))
        }
        "time" => recovery::time(claim),
        "low" | "high" => {
            let interval = claim.ours.interval.as_ref().expect("an interval");
            let high = interval.high.expect("two ends");
            written(if what == "low" { interval.low } else { high }, digits)
        }
        "t" => {
            let tested = claim.tested.as_ref().expect("a test");
            recovery::mind::signed(tested.statistic.expect("a test by t"))
        }
        "verdict" => match claim.verdict {
            Verdict::Measured => String::new(),
            it => it.words().replace("extension: ", ""),
        },
        "ours" => arm(&claim.per_seed),
        "against" => arm(claim.against.as_ref().expect("pairs")),
        other => panic!("{other} is nothing of a claim"),
    }
}

/// How many claims of each experiment came out how.
fn verdicts(summaries: &[Summary]) -> String {
    let mut text = String::from("| experiment | status | seeds |");
    for verdict in Verdict::ALL {
        text.push_str(&format!(" {verdict} |"));
    }
    text.push_str("\n|---|---|---:|");
    text.push_str(&"---:|".repeat(Verdict::ALL.len()));
    let mut all: BTreeMap<&str, u32> = BTreeMap::new();
    for it in summaries {
        let (first, last) = (it.seeds[0], it.seeds[it.seeds.len() - 1]);
        text.push_str(&format!(
            "\n| `{}` | {} | {first}–{last} |",
            it.experiment, it.status
        ));
        for verdict in Verdict::ALL {
            let count = it.verdicts.get(verdict.words()).copied().unwrap_or(0);
            *all.entry(verdict.words()).or_default() += count;
            text.push_str(&format!(" {count} |"));
        }
    }
    text.push_str("\n| all | | |");
    for verdict in Verdict::ALL {
        text.push_str(&format!(" {} |", all[verdict.words()]));
    }
    text.push('\n');
    text
}

/// The text with the part between a table's markers replaced.
fn with_table(text: &str, name: &str, table: &str) -> String {
    let marker = format!("<!-- claims: {name} -->\n");
    let parts = text.split_once(&marker);
    let (before, rest) = parts.unwrap_or_else(|| panic!("no document has the marker {marker}"));
    let (_, after) = rest
        .split_once("<!-- end -->")
        .expect("the table has an end");
    format!("{before}{marker}{table}<!-- end -->{after}")
}

#[test]
fn the_tables_of_the_documents_say_what_the_claims_say() {
    let summaries = summaries();
    let filled = tables()
        .into_iter()
        .map(|(document, name, template)| (document, name, fill(&template, &summaries)));
    let (document, name) = ("docs/claims.md".to_owned(), "verdicts".to_owned());
    let counted = (document, name, verdicts(&summaries));
    let recover = summaries.iter().find(|it| it.experiment == "recover");
    let recover = recover.expect("the claims of recovery");
    let recovered = [
        ("camera", recovery::camera(recover)),
        ("damages", recovery::by_damage(recover)),
        ("everybody", recovery::everybody(recover)),
    ];
    let recovered = recovered.map(|(name, table)| {
        let document = "docs/findings/recovery.md".to_owned();
        (document, name.to_owned(), table)
    });
    let one = summaries.iter().find(|it| it.experiment == "one");
    let one = one.expect("the claims of the one learner");
    let minds = (
        "docs/one-brain.md".to_owned(),
        "one-damages".to_owned(),
        recovery::mind::by_damage(one, recover),
    );
    let made = filled.chain([counted, minds]).chain(recovered);
    for (path, name, table) in made {
        let path = root().join(path);
        let text = fs::read_to_string(&path).expect("the document can be read");
        let told = with_table(&text, &name, &table);
        if std::env::var_os("UPDATE_CLAIMS").is_some() {
            fs::write(&path, told).expect("the document can be written");
        } else {
            assert_eq!(
                text, told,
                "run UPDATE_CLAIMS=1 cargo test -p cla-tests --test claims_tables"
            );
        }
    }
}

#[test]
fn numbers_are_written_in_four_ways() {
    for (value, digits, text) in [
        (0.1345, "3", "0.135"),
        (0.1344, ".3", ".134"),
        (1.83, ".2", "1.83"),
        (0.45, "0%", "45 %"),
        (1_420.0, "0,", "1,420"),
        (85_156.2, "0,", "85,156"),
    ] {
        assert_eq!(written(value, digits), text);
    }
}

#[test]
fn the_front_page_says_that_what_is_not_final_is_validation() {
    let text = fs::read_to_string(root().join("README.md")).expect("README can be read");
    let is_final = summaries()
        .iter()
        .all(|it| it.status != host_sim::report::Status::Validation);
    assert_eq!(text.contains("**Status: validation.**"), !is_final);
}
