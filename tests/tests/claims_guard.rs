//! The committed claims are guarded: whoever alters a digit of them is caught.
//!
//! Every number that a file states is computed again from what its seeds measured, every rule is
//! the one that `docs/claims-ledger.tsv` has for its id, every status goes with its seeds, and a
//! seal holds the rest.
//! That the seeds measured this is what the tests of the experiments show, which live some of them
//! again.

use std::collections::BTreeMap;
use std::fs;

use cla_core::num::Rng;
use cla_tests::claims::{File, files};
use cla_tests::root;
use host_sim::experiment::declared;
use host_sim::report::{Claim, Origin, Rule, Status, Summary, Verdict};
use serde_json::Value;

/// What the ledger writes of an id that has not ended.
const OPEN: &str = "-";

/// Alterations of each file.
const ALTERATIONS: u32 = 50;

/// One line of the ledger: an id, and what was asked under it from when until when.
struct Entry {
    estimator: String,
    rule: String,
    until: String,
    why: String,
}

fn ledger() -> BTreeMap<String, Entry> {
    let path = root().join("docs/claims-ledger.tsv");
    let text = fs::read_to_string(path).expect("the ledger can be read");
    let mut entries = BTreeMap::new();
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split('\t').collect();
        let [id, estimator, rule, _since, until, why] = cells[..] else {
            panic!("a line of the ledger has six cells: {line}");
        };
        let entry = Entry {
            estimator: estimator.to_owned(),
            rule: rule.to_owned(),
            until: until.to_owned(),
            why: why.to_owned(),
        };
        assert!(
            entries.insert(id.to_owned(), entry).is_none(),
            "{id} stands twice"
        );
    }
    entries
}

fn in_words(claim: &Claim) -> (String, String) {
    let estimator = serde_json::to_value(claim.estimator).expect("a word");
    (
        estimator.as_str().unwrap_or_default().to_owned(),
        claim.rule.to_string(),
    )
}

/// What is wrong with a claims file, without its seal.
fn faults(summary: &Summary, ledger: &BTreeMap<String, Entry>) -> Vec<String> {
    let mut found = Vec::new();
    let again = summary.judged();
    if again.verdicts != summary.verdicts {
        found.push("the verdicts are counted wrong".to_owned());
    }
    if summary.claims.len() != again.claims.len() {
        found.push("claims are missing".to_owned());
    }
    for (claim, again) in summary.claims.iter().zip(&again.claims) {
        if claim != again {
            found.push(format!("{} is not what its seeds say", claim.id));
        }
        let (estimator, rule) = in_words(claim);
        let known = ledger.get(&claim.id);
        if known.is_none_or(|it| it.rule != rule || it.estimator != estimator || it.until != OPEN) {
            found.push(format!(
                "{} asks something else than the ledger says",
                claim.id
            ));
        }
        let seeds = claim.per_seed.len();
        if seeds > 1 && seeds != summary.seeds.len() {
            found.push(format!("{} has {seeds} seeds", claim.id));
        }
    }
    if !summary.status.fits(&summary.seeds) {
        found.push(format!("{} does not go with the seeds", summary.status));
    }
    if matches!(summary.status, Status::Tuning | Status::Trial) {
        found.push(format!("nothing that is {} is committed", summary.status));
    }
    found
}

/// Whether a text is a claims file to which nothing can be objected.
fn is_sound(text: &str, ledger: &BTreeMap<String, Entry>) -> bool {
    Summary::from_json(text).is_ok_and(|it| it.to_json() == text && faults(&it, ledger).is_empty())
}

#[test]
fn every_claim_is_what_its_seeds_say() {
    let ledger = ledger();
    for File { name, mut text } in files() {
        let mut summary =
            Summary::from_json(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        // After a change of the statistics: from the same seeds, by the same rules.
        if std::env::var_os("UPDATE_CLAIMS").is_some() {
            summary = summary.judged();
            text = summary.to_json();
            let path = root().join("tests/claims").join(&name);
            fs::write(path, &text).expect("a claims file can be written");
        }
        let faults = faults(&summary, &ledger);
        assert!(faults.is_empty(), "{name}: {faults:#?}");
        assert!(summary.to_json() == text, "{name}: the seal is broken");
    }
}

#[test]
fn fifty_altered_digits_of_every_file_are_caught() {
    let ledger = ledger();
    for File { name, text } in files() {
        let digits: Vec<usize> = text
            .char_indices()
            .filter(|(_, letter)| letter.is_ascii_digit())
            .map(|(place, _)| place)
            .collect();
        let mut rng = Rng::stream(text.len() as u64, 1);
        let mut caught = 0;
        for _ in 0..ALTERATIONS {
            let place = digits[rng.below(digits.len() as u32) as usize];
            let mut altered = text.clone().into_bytes();
            altered[place] = b'0' + (altered[place] - b'0' + 1 + rng.below(9) as u8) % 10;
            let altered = String::from_utf8(altered).expect("digits are text");
            assert_ne!(altered, text);
            caught += u32::from(!is_sound(&altered, &ledger));
        }
        assert_eq!(caught, ALTERATIONS, "{name}");
    }
}

/// The places of all numbers below a value.
fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.to_owned()),
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                numbers(item, &format!("{path}/{index}"), found);
            }
        }
        Value::Object(fields) => {
            for (name, item) in fields {
                numbers(item, &format!("{path}/{name}"), found);
            }
        }
        _ => {}
    }
}

/// As a forger would, who mends the seal. Left out are the seeds of a median, of which one may be
/// another without the median moving, and the numbers of the book, which are held against the
/// program's own below.
#[test]
fn fifty_altered_numbers_of_claims_are_caught_without_the_seal() {
    let ledger = ledger();
    for File { name, text } in files() {
        let whole: Value = serde_json::from_str(&text).expect("a claims file is JSON");
        let mut places = Vec::new();
        for (index, claim) in whole["claims"]
            .as_array()
            .expect("claims")
            .iter()
            .enumerate()
        {
            let of_median = claim["estimator"]
                .as_str()
                .is_some_and(|it| it.starts_with("median"));
            let mut found = Vec::new();
            numbers(claim, "", &mut found);
            found.retain(|path| {
                let seeds = path.starts_with("/per_seed") || path.starts_with("/against");
                !(path.starts_with("/reference") || of_median && seeds)
            });
            places.extend(
                found
                    .into_iter()
                    .map(|path| format!("/claims/{index}{path}")),
            );
        }
        let mut rng = Rng::stream(text.len() as u64, 2);
        for _ in 0..ALTERATIONS {
            let place = &places[rng.below(places.len() as u32) as usize];
            let mut altered = whole.clone();
            let number = altered.pointer_mut(place).expect("the place is there");
            let value = number.as_f64().expect("a number");
            // A tenth more, or one in place of nothing; whole numbers stay whole.
            *number = match number.as_u64() {
                Some(whole) => (whole + 1 + whole / 10).into(),
                None if value == 0.0 => 1.0.into(),
                None => (value * 1.1).into(),
            };
            let read = serde_json::from_value::<Summary>(altered);
            let caught = read.map_or(true, |it| !faults(&it, &ledger).is_empty());
            assert!(caught, "{name}: {place}");
        }
    }
}

#[test]
fn seeds_that_do_not_fit_their_status_are_refused() {
    let ledger = ledger();
    for File { name, text } in files() {
        let summary = Summary::from_json(&text).expect("a claims file");
        for status in [Status::Final, Status::Trial, Status::Tuning] {
            let other = Summary {
                status,
                ..summary.clone()
            };
            assert!(!faults(&other, &ledger).is_empty(), "{name} as {status}");
        }
        let mut seeds = summary.seeds.clone();
        seeds[0] = 700;
        let other = Summary { seeds, ..summary };
        assert!(
            !faults(&other, &ledger).is_empty(),
            "{name} with a seed of the final block"
        );
    }
}

#[test]
fn a_final_result_has_the_runs_that_touched_its_seeds_in_the_documentation() {
    let text = fs::read_to_string(root().join("docs/claims.md")).expect("the page can be read");
    let (_, runs) = text
        .split_once("## Runs on final blocks")
        .expect("the page lists runs");
    for File { name, text } in files() {
        let summary = Summary::from_json(&text).expect("a claims file");
        if summary.status == Status::Final {
            assert!(runs.contains(&format!("`{}`", summary.command)), "{name}");
        }
    }
}

#[test]
fn what_is_committed_is_what_the_program_declares_before_it_runs() {
    let mut compared = 0;
    for File { name, text } in files() {
        let summary = Summary::from_json(&text).expect("a claims file");
        let Some(declared) = declared(&summary.experiment) else {
            continue;
        };
        compared += 1;
        let ids = |claims: &[Claim]| -> Vec<String> {
            claims.iter().map(|claim| claim.id.clone()).collect()
        };
        assert_eq!(ids(&summary.claims), ids(&declared), "{name}");
        for (claim, before) in summary.claims.iter().zip(&declared) {
            assert_eq!(claim.declared(), before.declared(), "{name}");
        }
    }
    // Those of microcontrollers are made by building programs.
    assert_eq!(compared, files().len() - 1);
}

#[test]
fn every_claim_has_a_rule_and_every_id_its_history() {
    let ledger = ledger();
    let mut living = Vec::new();
    for File { name, text } in files() {
        let summary = Summary::from_json(&text).expect("a claims file");
        for claim in &summary.claims {
            // What nothing is asked of is no claim: it has no verdict, and says so.
            let nothing = claim.rule == Rule::Measured;
            assert_eq!(
                nothing,
                claim.verdict == Verdict::Measured,
                "{name}: {}",
                claim.id
            );
            assert!(
                !(nothing && claim.reference.is_some()),
                "{name}: {}",
                claim.id
            );
            assert!(claim.origin != Origin::Varied, "{name}: {}", claim.id);
            assert!(
                !living.contains(&claim.id),
                "{name}: {} stands twice",
                claim.id
            );
            living.push(claim.id.clone());
        }
    }
    for (id, entry) in &ledger {
        assert_eq!((entry.until == OPEN), living.contains(id), "{id}");
        assert_eq!(
            (entry.until == OPEN),
            (entry.why == OPEN),
            "{id}: why it ended"
        );
        if let Some((name, version)) = id.split_once('@') {
            let version: u32 = version
                .parse()
                .unwrap_or_else(|_| panic!("{id}: its version"));
            let earlier = if version == 2 {
                name.to_owned()
            } else {
                format!("{name}@{}", version - 1)
            };
            let ended = ledger.get(&earlier).is_some_and(|it| it.until != OPEN);
            assert!(version >= 2 && ended, "{id}: {earlier} has not ended");
        }
    }
}
