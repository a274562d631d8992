//! The tables of results in the documents say what the committed claims say.
//!
//! `UPDATE_CLAIMS=1 cargo test -p cla-tests --test claims_tables` writes them anew.

use std::collections::BTreeMap;
use std::fs;

use cla_tests::claims::files;
use cla_tests::root;
use host_sim::report::{Claim, Summary, Verdict};

/// The findings on the front page; what stands in braces is filled in, see [`fill`].
const FINDINGS: &str = "\
| experiment | finding | ours | beside it |
|---|---|---:|---:|
| `calibrate` | actions to clear a room of 5 m in steps of 0.5 m, median | {calibrate.actions.R5_f0_5:0} | Stage 1.3.4 {calibrate.actions.R5_f0_5:1:printed} |
| `forage` | captures of 28; the book read literally | {forage.captures.level1_removed:2:sd}; {forage.captures.book:1:sd} | book {forage.captures.level1_removed:2:printed} |
| `forage` | captures in 3000 actions when specimens reappear, level 1 | {forage.captures.level1:1:sd} | servo on the same percept {forage.baseline.sector_nearest:1:sd} |
| `forage` | both levels with habits, after 20,000 actions | {forage.captures.level2:1:sd} | level 1 after as many {forage.captures.level1_20000:1:sd} |
| `recover` | first 3000 actions after the camera was turned by 12° | {recover.camera.over_sarsa_3000:1:ours} | Sarsa(λ) {recover.camera.over_sarsa_3000:1:against} |
| `recover` | damages of 13 in which both levels are ahead of Sarsa(λ) after Holm's correction | {recover.family.ahead_after_holm:0} | – |
| `recover` | reliability of level 2 before and after the damage | {recover.camera.level2_predictions_before:3}; {recover.camera.level2_predictions_after:3} | book .886; .446 |
| `causal` | Direct–Delay+Gap and Direct–Gap over Delay–Gap | {causal.direct_vs_delaygap:2}; {causal.direct_vs_gap:2} | book 1.80; 1.52 |
| `microworld` | the book's 23 equations, raw and simplified | {micro.equations:1}; {micro.equations_simplified:1} | book {micro.equations:0:printed} |
| `microworld` | changes predicted after 10,000 actions, in 62 kB | {micro.recall.simplified:3} | marginal attribution {micro.drescher.recall.10k:3}, 2.2 MB |
";

fn summaries() -> Vec<Summary> {
    let read = |text: &str| Summary::from_json(text).expect("a claims file");
    files().iter().map(|file| read(&file.text)).collect()
}

/// `{id:digits}` becomes the claim's estimate, `{id:digits:sd}` that with its deviation, `printed`
/// the number it is compared with, `ours` and `against` each arm of its pairs by itself.
fn fill(template: &str, summaries: &[Summary]) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let (place, after) = after.split_once('}').expect("what is opened is closed");
        let parts: Vec<&str> = place.split(':').collect();
        let claim = summaries.iter().find_map(|it| it.find(parts[0]));
        let claim = claim.unwrap_or_else(|| panic!("no claim {place}"));
        let digits = parts[1].parse().expect("a number of digits");
        text.push_str(before);
        text.push_str(&number(claim, digits, parts.get(2).copied().unwrap_or("")));
        rest = after;
    }
    text + rest
}

fn number(claim: &Claim, digits: usize, what: &str) -> String {
    let spread = |value: f64, sd: Option<f64>| {
        let sd = sd.map_or_else(String::new, |sd| format!(" ± {sd:.digits$}"));
        format!("{value:.digits$}{sd}")
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
        "printed" => {
            let printed = claim.reference.as_ref().expect("a printed number");
            spread(printed.mean, printed.sd)
        }
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
    let (before, rest) = text.split_once(&marker).expect("the table has its marker");
    let (_, after) = rest
        .split_once("<!-- end -->")
        .expect("the table has an end");
    format!("{before}{marker}{table}<!-- end -->{after}")
}

#[test]
fn the_tables_of_the_documents_say_what_the_claims_say() {
    let summaries = summaries();
    for (path, name, table) in [
        ("README.md", "findings", fill(FINDINGS, &summaries)),
        ("docs/claims.md", "verdicts", verdicts(&summaries)),
    ] {
        let path = root().join(path);
        let text = fs::read_to_string(&path).expect("the document can be read");
        let told = with_table(&text, name, &table);
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
fn the_front_page_says_that_what_is_not_final_is_validation() {
    let text = fs::read_to_string(root().join("README.md")).expect("README can be read");
    let is_final = summaries()
        .iter()
        .all(|it| it.status != host_sim::report::Status::Validation);
    assert_eq!(text.contains("**Status: validation.**"), !is_final);
}
