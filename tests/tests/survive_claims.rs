//! The committed results of `survive` are what the program measures: a seed that the commit chooses
//! is tried again with all parts that take minutes at most and with bits flipped in RAM, and every
//! number must be the same.
//!
//! `SURVIVE_FROM=runs/survive/latest/summary.json cargo test -p cla-tests --test survive_claims` takes
//! the parts of a run into the committed file, and new ids into the ledger.

mod lived;

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use cla_tests::claims::two_of;
use cla_tests::root;
use host_sim::experiment::declared;
use host_sim::experiment::record::judged_again;
use host_sim::experiment::survive::{Survive, SurviveOptions};
use host_sim::report::{Claim, Estimator, Summary};
use lived::{assert_same_measurements, committed};

const FILE: &str = "tests/claims/survive.json";

fn read(path: &Path) -> Summary {
    let text = fs::read_to_string(path);
    let text = text.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    committed(&text)
}

#[test]
fn a_seed_that_the_commit_chooses_is_tried_the_same_again() {
    if let Some(run) = env::var_os("SURVIVE_FROM") {
        take(&read(&root().join(run)));
    }
    let committed = read(&root().join(FILE));
    let [_, place] = two_of(committed.seeds.len(), FILE);
    for parts in [&[][..], &["ram_flips".to_owned()]] {
        let seed = vec![committed.seeds[place]];
        let options = SurviveOptions::new(seed, parts).expect("parts that run");
        let mut again = judged_again::<Survive>(&options)
            .expect("the experiment runs")
            .summary;
        // Of all seeds together, which one seed does not have.
        again.claims.retain(|it| it.estimator != Estimator::Count);
        // A debug build holds values that are computed twice against each other, and ends the life of
        // a brain in which a flipped bit makes them differ and nobody looks.
        again
            .claims
            .retain(|it| !cfg!(debug_assertions) || !it.id.contains("unguarded"));
        let compared = assert_same_measurements(&again, &committed);
        assert_eq!(compared, again.claims.len());
        assert!(compared >= 3, "{compared}");
    }
}

/// Takes the parts of a run into the committed file: a part depends on no other, and of each stands of
/// which commit it is.
fn take(run: &Summary) {
    let path = root().join(FILE);
    let mut whole = if path.exists() {
        read(&path)
    } else {
        run.clone()
    };
    assert_eq!(whole.seeds, run.seeds, "all parts have the same seeds");
    assert_eq!(
        run.options.as_ref().map(|it| &it["shorter"]),
        Some(&1.into())
    );
    let declared = declared("survive").expect("the claims of survive");
    for claim in &run.claims {
        let is_declared = declared.iter().any(|it| it.id == claim.id);
        assert!(is_declared, "{} is of a part that no file has", claim.id);
    }
    let of = |id: &str| -> Option<Claim> {
        let old = whole.claims.iter().find(|it| it.id == id);
        run.find(id).or(old).cloned()
    };
    whole.claims = declared.iter().filter_map(|it| of(&it.id)).collect();
    for (title, table) in &run.tables {
        whole.table(title, table.clone());
    }
    let (first, last) = (run.seeds[0], run.seeds[run.seeds.len() - 1]);
    whole.command = format!("host-sim survive --part all --seeds {first}..{}", last + 1);
    let all = SurviveOptions::standard(run.seeds.clone());
    let parts: Vec<&str> = all.parts.iter().map(|it| it.name).collect();
    whole.parameter("parts", parts.join(" "));
    whole.options = Some(serde_json::to_value(&all).expect("options are JSON"));
    let commit = run.commit.as_deref().unwrap_or("unknown");
    for part in run
        .options
        .iter()
        .filter_map(|it| it["parts"].as_array())
        .flatten()
    {
        let part = part.as_str().expect("a name");
        whole.parameter(&format!("commit of {part}"), commit);
    }
    whole.commit.clone_from(&run.commit);
    whole.version.clone_from(&run.version);
    let whole = whole.judged();
    fs::write(&path, whole.to_json()).expect("the claims file can be written");
    note(&whole);
}

/// Notes ids in the ledger that it does not have.
fn note(summary: &Summary) {
    let path = root().join("docs/claims-ledger.tsv");
    let text = fs::read_to_string(&path).expect("the ledger can be read");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let git = Command::new("git")
        .args(["log", "-1", "--format=%cs"])
        .output();
    let since = String::from_utf8(git.expect("git runs").stdout).expect("a date is text");
    let since = since.trim();
    for claim in &summary.claims {
        let known = |line: &String| line.split('\t').next() == Some(claim.id.as_str());
        if !lines.iter().any(known) {
            let estimator = serde_json::to_value(claim.estimator).expect("a word");
            let estimator = estimator.as_str().unwrap_or_default();
            let (id, rule) = (&claim.id, &claim.rule);
            lines.push(format!("{id}\t{estimator}\t{rule}\t{since}\t-\t-"));
        }
    }
    lines[1..].sort();
    fs::write(&path, lines.join("\n") + "\n").expect("the ledger can be written");
}
