//! The documents, held: links lead somewhere, commands are ones that the programs take, the code of
//! README is the code that the crate's page runs, pages say what a page has to say.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cla_tests::root;
use clap::Parser;
use host_sim::cli::{Cli, Command, Errand};
use host_sim::options::{self, Order};
use serde_json::Value;

/// A Markdown file: its path in the project and its text.
type Document = (String, String);

/// All Markdown files of the project, but those that a build or a run has left.
fn documents() -> Vec<Document> {
    let mut found = Vec::new();
    collect(&root(), "", &mut found);
    found.sort();
    assert!(found.len() > 20, "{}", found.len());
    found
}

fn collect(folder: &Path, name: &str, found: &mut Vec<Document>) {
    for entry in fs::read_dir(folder)
        .expect("a folder can be read")
        .flatten()
    {
        let file = entry.file_name().to_string_lossy().into_owned();
        let path = if name.is_empty() {
            file.clone()
        } else {
            format!("{name}/{file}")
        };
        if entry.path().is_dir() {
            if !file.starts_with('.') && file != "target" && file != "runs" {
                collect(&entry.path(), &path, found);
            }
        } else if file.ends_with(".md") {
            found.push((
                path,
                fs::read_to_string(entry.path()).expect("Markdown is text"),
            ));
        }
    }
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The lines outside of fenced blocks.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut inside = false;
    text.lines().filter(move |line| {
        let fence = line.starts_with("```");
        inside ^= fence;
        !inside && !fence
    })
}

/// The fenced blocks in a language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let opening = format!("```{language}\n");
    text.split(&opening)
        .skip(1)
        .filter_map(|it| it.split("```").next())
        .collect()
}

/// The spans of a line in and outside of backticks.
fn spans(line: &str, code: bool) -> impl Iterator<Item = &str> {
    line.split('`').skip(usize::from(code)).step_by(2)
}

/// Where the links and images of a text lead.
fn links(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in prose(text) {
        // Code spans are blanked, so that a link whose words are code still is one.
        let blank: String = line
            .split('`')
            .enumerate()
            .map(|(index, span)| {
                if index % 2 == 0 {
                    span.to_owned()
                } else {
                    "x".repeat(span.len())
                }
            })
            .collect();
        let inline = blank
            .split("](")
            .skip(1)
            .filter_map(|it| it.split(')').next());
        found.extend(inline.map(|it| it.split(' ').next().unwrap_or(it).to_owned()));
        if let Some((_, target)) = line.strip_prefix('[').and_then(|it| it.split_once("]: ")) {
            found.push(target.trim().to_owned());
        }
        found.extend(
            blank
                .split("src=\"")
                .skip(1)
                .filter_map(|it| it.split('"').next())
                .map(str::to_owned),
        );
    }
    found
}

/// The anchors of a Markdown text, as GitHub makes them of its headings.
fn anchors(text: &str) -> Vec<String> {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut found = Vec::new();
    for line in prose(text).filter(|line| line.starts_with('#')) {
        let heading = line.trim_start_matches('#').trim().to_lowercase();
        let kept = heading
            .chars()
            .filter(|it| it.is_alphanumeric() || " -_".contains(*it));
        let anchor: String = kept.map(|it| if it == ' ' { '-' } else { it }).collect();
        let times = seen.entry(anchor.clone()).or_insert(0);
        found.push(if *times == 0 {
            anchor
        } else {
            format!("{anchor}-{times}")
        });
        *times += 1;
    }
    found
}

/// Why a link of a document leads nowhere.
fn broken(document: &str, link: &str) -> Option<String> {
    if ["http://", "https://", "mailto:"]
        .iter()
        .any(|it| link.starts_with(it))
    {
        return None;
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let here = root().join(document);
    let target: PathBuf = match path {
        "" => here,
        _ => here
            .parent()
            .expect("a document lies in a folder")
            .join(path),
    };
    if !target.exists() {
        return Some(format!("{document}: {link}: there is no such file"));
    }
    let missing = || Some(format!("{document}: {link}: there is no such heading"));
    match fs::read_to_string(&target) {
        _ if anchor.is_empty() => None,
        Ok(text) if anchors(&text).iter().any(|it| it == anchor) => None,
        _ => missing(),
    }
}

/// The commands of a text: lines of `sh` blocks and spans of code, without their comments.
fn commands(text: &str) -> Vec<String> {
    let lines = blocks(text, "sh").into_iter().flat_map(str::lines);
    let inline = prose(text).flat_map(|line| spans(line, true));
    let mut found = Vec::new();
    for line in lines.chain(inline) {
        let line = line.split(" #").next().unwrap_or(line).trim();
        if ["cargo ", "host-sim ", "tests/run"]
            .iter()
            .any(|it| line.starts_with(it))
        {
            found.push(line.to_owned());
        }
    }
    found
}

/// Why a command of a document is none; `Ok(false)` when nothing here can judge it.
fn judge(command: &str, firmware: bool) -> Result<bool, String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    // `NAME` stands for a name; `…` for what is left out.
    let placeholder =
        |it: &&str| it.contains('…') || it.len() > 2 && it.chars().all(|c| c.is_ascii_uppercase());
    if words.iter().any(placeholder) {
        return Ok(false);
    }
    let after = |flag: &str| {
        words
            .iter()
            .skip_while(move |it| **it != flag)
            .nth(1)
            .copied()
    };
    if words[0] == "tests/run" {
        let Some(step) = words.get(1) else {
            return Ok(true);
        };
        return if read("tests/run").contains(step) {
            Ok(true)
        } else {
            Err(format!("no step {step}"))
        };
    }
    if let (Some(name), Some(package)) = (after("--example"), after("-p").or(after("--package"))) {
        let exists = root()
            .join(format!("{package}/examples/{name}.rs"))
            .is_file();
        return if exists {
            Ok(true)
        } else {
            Err(format!("{package} has no example {name}"))
        };
    }
    if let (Some(name), Some("cla-tests")) = (after("--test"), after("-p")) {
        let file = root().join(format!("tests/tests/{name}.rs")).is_file();
        let folder = root().join(format!("tests/tests/{name}/main.rs")).is_file();
        return if file || folder {
            Ok(true)
        } else {
            Err(format!("no test {name}"))
        };
    }
    let arguments = match words[0] {
        "host-sim" => &words[1..],
        _ if words[1] == "run" && !firmware && after("--example").is_none() => {
            let from = words
                .iter()
                .position(|it| *it == "--")
                .map_or(words.len(), |at| at + 1);
            &words[from..]
        }
        _ => return Ok(false),
    };
    let cli = Cli::try_parse_from([&["host-sim"], arguments].concat());
    let cli = cli.map_err(|error| error.to_string())?;
    let ordered = match &cli.command {
        Some(Command::Errand(Errand::Train(args))) => options::training(args).map(|_| true),
        Some(Command::Errand(Errand::Teach(args))) => options::teaching(args).map(|_| true),
        Some(Command::Errand(Errand::Size(args))) => options::sizing(args).map(|_| true),
        // The others take what is parsed as it is.
        Some(Command::Errand(_)) => Ok(true),
        _ => Order::new(&cli).map(|_| true),
    };
    ordered.map_err(|impossible| impossible.to_string())
}

#[test]
fn every_link_of_the_documents_leads_somewhere() {
    let mut wrong = Vec::new();
    let mut number = 0;
    for (path, text) in documents() {
        for link in links(&text) {
            number += 1;
            wrong.extend(broken(&path, &link));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(number > 45, "only {number} links were found");
}

#[test]
fn a_link_that_leads_nowhere_is_noticed() {
    let text = "See [a](README.md#two-commands), [`b`](docs/none.md), `[c](d)`.\n```\n[e](f)\n```\n![g](h.png)";
    assert_eq!(
        links(text),
        ["README.md#two-commands", "docs/none.md", "h.png"]
    );
    assert_eq!(broken("CHANGELOG.md", "README.md#two-commands"), None);
    assert!(broken("CHANGELOG.md", "docs/none.md").is_some());
    assert!(broken("CHANGELOG.md", "README.md#three-commands").is_some());
    assert_eq!(
        broken("docs/findings/recovery.md", "../README.md#findings"),
        None
    );
}

#[test]
fn every_command_of_the_documents_is_one_that_the_programs_take() {
    let mut wrong = Vec::new();
    let mut judged = 0;
    for (path, text) in documents() {
        for command in commands(&text) {
            match judge(&command, path.starts_with("firmware-example/")) {
                Ok(certain) => judged += usize::from(certain),
                Err(why) => wrong.push(format!("{path}: {command}: {why}")),
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(judged > 40, "only {judged} commands were judged");
}

#[test]
fn a_command_that_the_programs_refuse_is_noticed() {
    let refused = [
        "cargo run --release -- forage --radius five",
        "cargo run --release -- recover --damage nothing",
        "host-sim calibrat",
        "cargo run --release -p host-sim --example none",
        "cargo test -p cla-tests --test none",
        "tests/run nonsense",
    ];
    for command in refused {
        assert!(judge(command, false).is_err(), "{command}");
    }
    assert_eq!(judge("cargo run --release", false), Ok(true));
    let text = "```sh\ncargo run --release   # trains\nls\n```\nWith `host-sim angle` it `sees`.";
    assert_eq!(commands(text), ["cargo run --release", "host-sim angle"]);
}

/// The ids of all committed claims.
fn claims() -> Vec<String> {
    let folder = fs::read_dir(root().join("tests/claims")).expect("the claims are there");
    let mut ids = Vec::new();
    for file in folder.flatten() {
        let text = fs::read_to_string(file.path()).expect("claims are text");
        let value: Value = serde_json::from_str(&text).expect("claims are JSON");
        let claims = value["claims"].as_array().cloned().unwrap_or_default();
        ids.extend(
            claims
                .iter()
                .filter_map(|it| it["id"].as_str())
                // A document may name a claim without its version: the one that there is now.
                .map(|id| id.split('@').next().unwrap_or(id).to_owned()),
        );
    }
    ids
}

/// Whether a name with one or more `*` stands for an id.
fn stands_for(name: &str, id: &str) -> bool {
    let mut rest = id;
    for (index, part) in name.split('*').enumerate() {
        match rest.find(part) {
            Some(at) if index > 0 || at == 0 => rest = &rest[at + part.len()..],
            _ => return false,
        }
    }
    rest.is_empty() || name.ends_with('*')
}

#[test]
fn every_claim_that_the_documents_name_is_committed() {
    let ids = claims();
    let families: BTreeSet<&str> = ids.iter().filter_map(|it| it.split('.').next()).collect();
    assert!(families.len() > 5, "{families:?}");
    let mut named = 0;
    for (path, text) in documents() {
        for name in prose(&text).flat_map(|line| spans(line, true)) {
            let family = name.split_once('.').map_or("", |(family, _)| family);
            let word = |it: char| it.is_ascii_alphanumeric() || "._*".contains(it);
            if path == "CHANGELOG.md" || !families.contains(family) || !name.chars().all(word) {
                continue;
            }
            named += 1;
            assert!(
                ids.iter().any(|id| stands_for(name, id)),
                "{path}: there is no claim {name}"
            );
        }
    }
    assert!(named > 20, "only {named} claims are named");
    assert!(stands_for("a.*.b*", "a.x.bc") && !stands_for("a.*.b", "a.x.bc"));
}

#[test]
fn the_code_of_readme_is_the_code_that_the_page_of_the_crate_runs() {
    let readme = read("README.md");
    let page = read("cla-core/README.md");
    let shown = blocks(&readme, "rust");
    let run = blocks(&page, "rust");
    assert!(!shown.is_empty());
    for block in shown {
        assert!(
            run.contains(&block),
            "README.md has other code than cla-core/README.md:\n{block}"
        );
    }
    let face = read("cla-core/src/lib.rs");
    assert!(
        face.contains("#![doc = include_str!(\"../README.md\")]"),
        "the page is not included"
    );
}

#[test]
fn every_finding_says_its_claim_its_n_and_its_command() {
    let pages = documents();
    let findings: Vec<_> = pages
        .iter()
        .filter(|(path, _)| path.starts_with("docs/findings/"))
        .collect();
    assert!(findings.len() > 15, "{}", findings.len());
    for (path, text) in findings {
        for word in ["**Claim.**", "n = ", "**Command.**"] {
            assert!(text.contains(word), "{path} has no {word}");
        }
    }
}

#[test]
fn every_page_under_docs_is_in_the_index() {
    let index = links(&read("docs/README.md"));
    for (path, _) in documents() {
        // The chapters of the guide are named by its summary.
        let named = |it: &&str| {
            *it != "README.md" && (!it.starts_with("guide/") || it.ends_with("SUMMARY.md"))
        };
        if let Some(page) = path.strip_prefix("docs/").filter(named) {
            assert!(
                index.iter().any(|it| it == page),
                "docs/README.md does not name {page}"
            );
        }
    }
}

#[test]
fn the_changelog_is_told_by_kind_of_change_in_short_lines() {
    let text = read("CHANGELOG.md");
    let kinds = [
        "Added",
        "Changed",
        "Deprecated",
        "Removed",
        "Fixed",
        "Security",
    ];
    for heading in text.lines().filter_map(|line| line.strip_prefix("### ")) {
        assert!(kinds.contains(&heading), "{heading}");
    }
    assert!(text.contains("\n## Unreleased\n"));
    for version in text.split("\n## ").skip(1) {
        let mut seen = BTreeSet::new();
        for heading in version.lines().filter(|line| line.starts_with("### ")) {
            assert!(seen.insert(heading), "{heading} stands twice");
        }
    }
    let mut seen = BTreeSet::new();
    for line in text.lines().filter(|line| line.starts_with("- ")) {
        assert!(seen.insert(line), "twice: {line}");
        let length = line.chars().count();
        assert!(length <= 200, "{length} characters: {line}");
    }
}

#[test]
fn the_guide_names_its_chapters_and_its_code_is_compiled() {
    let summary = read("docs/guide/src/SUMMARY.md");
    let compiled = read("tests/src/guide.rs");
    let guide = documents().into_iter().filter_map(|(path, text)| {
        let chapter = path.strip_prefix("docs/guide/src/")?.to_owned();
        (chapter != "SUMMARY.md").then_some((chapter, text))
    });
    let mut chapters = 0;
    for (chapter, text) in guide {
        chapters += 1;
        assert!(summary.contains(&format!("({chapter})")), "{chapter}");
        if text.contains("```rust") {
            assert!(
                compiled.contains(&format!("guide/src/{chapter}")),
                "{chapter}"
            );
            assert!(
                !text.contains("```rust,"),
                "{chapter}: code that is not run"
            );
        }
    }
    assert!(chapters >= 6, "{chapters}");
    // Of other languages, too: pytest runs one chapter, a test of host-sim the other.
    for (language, chapter, runner) in [
        ("python", "python.md", "host-sim/python/tests/test_guide.py"),
        ("sh", "cluster.md", "host-sim/tests/guide.rs"),
    ] {
        assert!(read(runner).contains(chapter), "{runner}");
        assert!(blocks(&read(&format!("docs/guide/src/{chapter}")), language).len() > 1);
    }
}
