//! What is said in several places is the same in all of them: the version, the features of the core,
//! the configuration of the one learner.

use std::fs;
use std::path::{Path, PathBuf};

use cla_core::forest::{Heard, MindConfig, Voice};
use cla_tests::root;
use firmware_example::trace::ACTIONS;
use host_sim::report::{Summary, Verdict, mean};
use toml::Table;

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn table(path: &Path) -> Table {
    let text = read(path);
    text.parse()
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All files of this name, but those that a build has left.
fn named(name: &str, folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder)
        .expect("a folder can be read")
        .flatten()
    {
        let file = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() {
            if !file.starts_with('.') && file != "target" && file != "runs" {
                named(name, &entry.path(), found);
            }
        } else if file == name {
            found.push(entry.path());
        }
    }
}

fn all(name: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    named(name, &root(), &mut found);
    found.sort();
    found
}

/// The version of the workspace.
fn version() -> String {
    let manifest = table(&root().join("Cargo.toml"));
    let version = &manifest["workspace"]["package"]["version"];
    version.as_str().expect("a version is text").to_owned()
}

/// The value after a key at the beginning of a line.
fn value<'a>(text: &'a str, key: &str) -> &'a str {
    let line = text.lines().find_map(|line| line.strip_prefix(key));
    let line = line.unwrap_or_else(|| panic!("no line begins with {key:?}"));
    line.trim().trim_matches('"')
}

#[test]
fn every_package_has_the_version_of_the_workspace() {
    let (version, mut packages) = (version(), 0);
    for path in all("Cargo.toml") {
        let manifest = table(&path);
        let Some(package) = manifest.get("package") else {
            continue;
        };
        packages += 1;
        let own = &package["version"];
        let follows = own.get("workspace").and_then(toml::Value::as_bool);
        assert!(
            follows == Some(true) || own.as_str() == Some(&version),
            "{}: {own}",
            path.display()
        );
    }
    assert!(packages >= 8, "{packages}");
    let python = root().join("host-sim/python");
    let project = table(&python.join("pyproject.toml"));
    assert_eq!(project["project"]["version"].as_str(), Some(&*version));
    let module = read(&python.join("python/cla/__init__.py"));
    assert_eq!(value(&module, "__version__ = "), version);
}

#[test]
fn every_lock_file_has_that_version_of_what_is_ours() {
    let (version, mut ours) = (version(), 0);
    for path in all("Cargo.lock") {
        let lock = table(&path);
        for package in lock["package"].as_array().expect("a list of packages") {
            if package.get("source").is_none() {
                ours += 1;
                assert_eq!(
                    package["version"].as_str(),
                    Some(&*version),
                    "{}: {}",
                    path.display(),
                    package["name"]
                );
            }
        }
    }
    assert!(ours >= 15, "{ours}");
}

#[test]
fn the_changelog_and_the_citation_name_that_version_and_its_day() {
    let version = version();
    let changelog = read(&root().join("CHANGELOG.md"));
    let mut headings = changelog
        .lines()
        .filter_map(|line| line.strip_prefix("## "));
    assert_eq!(headings.next(), Some("Unreleased"));
    let released = headings.next().expect("a version was released");
    let (number, day) = released.split_once(' ').expect("a version and its day");
    let day = day.trim_matches(['(', ')']);
    assert_eq!(number, version, "the newest heading with a day");
    let citation = read(&root().join("docs/CITATION.cff"));
    assert_eq!(value(&citation, "version: "), version);
    assert_eq!(value(&citation, "date-released: "), day);
}

#[test]
fn the_page_of_the_core_names_every_feature() {
    let manifest = table(&root().join("cla-core/Cargo.toml"));
    let page = read(&root().join("cla-core/README.md"));
    let features = manifest["features"].as_table().expect("features");
    assert!(features.len() >= 5, "{features:?}");
    for feature in features.keys() {
        assert!(page.contains(&format!("\n| `{feature}` | ")), "{feature}");
    }
    let oldest = manifest["package"]["rust-version"].as_str();
    let oldest = oldest.expect("the oldest compiler");
    assert!(
        page.contains(&format!("Rust {oldest} or newer")),
        "{oldest}"
    );
}

#[test]
fn the_page_of_the_one_learner_says_the_configuration_that_it_has() {
    let page = read(&root().join("docs/one-brain.md"));
    let made = page
        .split("\n## ")
        .find(|it| it.starts_with("How it is made"));
    let made = made.expect("the page says how it is made");
    let it = MindConfig::DEFAULT;
    for words in [
        format!("lead in turn for {} actions", it.block),
        format!("replay {} samples", it.replayed),
        format!("remembers the last {:.0} trials", it.remembered),
        format!("doubts for {} actions", it.doubt_lasts),
        format!("keep {:.1} of what", it.kept_doubting).replace("0.", "."),
        format!("weighs {:.0} trial in the model", it.trials_doubting),
    ] {
        assert!(made.contains(&words), "{words}");
    }
    // "a tenth of its actions are by chance", and "Habits lead then, and plans where there are any".
    assert_eq!((it.exploring, it.exploring_acting), (0.1, 0.0));
    assert_eq!(
        it.heard_doubting,
        Heard::only(Voice::Habits).and(Voice::Plans)
    );
}

/// The paths of all files and folders, each with `/` before it, but what a build or a run has left.
fn paths(folder: &Path, name: &str, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder)
        .expect("a folder can be read")
        .flatten()
    {
        let file = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{name}/{file}");
        if file.starts_with('.') || file == "target" || file == "runs" {
            continue;
        }
        if entry.path().is_dir() {
            paths(&entry.path(), &path, found);
        }
        found.push(path);
    }
}

#[test]
fn the_map_of_the_architecture_names_what_there_is() {
    let text = read(&root().join("ARCHITECTURE.md"));
    let map = text.split("\n## The map").nth(1).expect("a map");
    let map = map.split("```").nth(1).expect("it is drawn");
    let words: Vec<&str> = map
        .split(|it: char| !(it.is_alphanumeric() || it == '_'))
        .collect();
    for crate_of in ["cla-core/src", "host-sim/src"] {
        for entry in fs::read_dir(root().join(crate_of))
            .expect("sources")
            .flatten()
        {
            let name = entry.file_name().to_string_lossy().into_owned();
            let stem = name.trim_end_matches(".rs");
            if !stem.ends_with("_tests") && stem != "lib" {
                assert!(
                    words.contains(&stem),
                    "the map does not name {crate_of}/{name}"
                );
            }
        }
    }
    let mut there = Vec::new();
    paths(&root(), "", &mut there);
    let is_there = |path: &str| {
        let (file, source) = (format!("/{path}"), format!("/{path}.rs"));
        there
            .iter()
            .any(|it| it.ends_with(&file) || it.ends_with(&source))
    };
    for word in words
        .iter()
        .filter(|it| it.contains('_') && **it != "no_std")
    {
        assert!(is_there(word), "there is no {word}");
    }
    let folders = map
        .lines()
        .filter_map(|line| line.split_whitespace().next());
    let folders: Vec<&str> = folders.filter(|it| it.contains('/')).collect();
    assert!(folders.len() > 30, "{folders:?}");
    for folder in folders {
        assert!(
            is_there(folder.trim_end_matches([',', '/'])),
            "there is no {folder}"
        );
    }
    let entries = text
        .split("\n## Entry points")
        .nth(1)
        .expect("entry points");
    let entries = entries.split("\n## ").next().unwrap_or(entries);
    let spans = entries.split('`').skip(1).step_by(2);
    let spans = spans.filter(|it| it.ends_with(".rs") || it.contains('/') || it.ends_with(".md"));
    let mut looked_at = 0;
    for path in spans.filter(|it| !it.contains(['*', '<', ' '])) {
        looked_at += 1;
        assert!(is_there(path.trim_end_matches('/')), "there is no {path}");
    }
    assert!(looked_at > 10, "{looked_at}");
}

/// The words of an array in `tests/run`.
fn steps(script: &str, name: &str) -> Vec<String> {
    let opening = format!("readonly {name}=(");
    let rest = script.split(&opening).nth(1).expect("the script has it");
    let words = rest.split(')').next().unwrap_or(rest);
    words.split_whitespace().map(str::to_owned).collect()
}

#[test]
fn every_step_of_the_tests_has_its_row_and_no_other_has() {
    let script = read(&root().join("tests/run"));
    let page = read(&root().join("CONTRIBUTING.md"));
    let rows = page.lines().filter_map(|line| {
        let (step, _) = line.strip_prefix("| `")?.split_once("` | ")?;
        Some((step.to_owned(), line.contains("slower, with `all` only")))
    });
    let mut rows: Vec<(String, bool)> = rows.collect();
    let quick = steps(&script, "steps").into_iter().map(|it| (it, false));
    let slower = steps(&script, "slower_steps").into_iter();
    let mut known: Vec<(String, bool)> = quick.chain(slower.map(|it| (it, true))).collect();
    rows.sort();
    known.sort();
    assert_eq!(rows, known);
}

#[test]
fn the_guide_says_what_was_measured() {
    let guide = root().join("docs/guide/src");
    let claims = read(&root().join("tests/claims/one.json"));
    let claims = Summary::from_json(&claims).expect("the claims can be read");
    let claim = |id: &str| claims.find(id).expect("a claim");
    let short = |value: f64| format!("{value:.2}").replace("0.", ".");
    let kept = |id: &str| short(claim(id).ours.value.expect("an estimate"));
    let robot = read(&guide.join("robot.md"));
    for words in [
        format!(
            "keeps {} of its captures with eight such items",
            kept("one.distractors.8")
        ),
        format!("and {} with twenty", kept("one.distractors.20")),
    ] {
        assert!(robot.contains(&words), "{words}");
    }
    let missed = claim("one.distractors.8").verdict == Verdict::Missed;
    assert_eq!(robot.contains("which misses the .95"), missed);
    let small = claim("one.forager.small");
    let interval = small.ours.interval.as_ref().expect("an interval");
    let high = interval.high.expect("two ends");
    let earned = |id: &str| {
        let seeds: Vec<f64> = claim(id).per_seed.iter().flatten().copied().collect();
        mean(&seeds)
    };
    let sizing = read(&guide.join("sizing.md"));
    for words in [
        format!("keeps {} of the captures", kept("one.forager.small")),
        format!("from {} to {}", short(interval.low), short(high)),
        format!(
            "earns {:.0} for {:.0}, t",
            earned("one.vacuum.lean"),
            earned("one.vacuum")
        ),
    ] {
        assert!(sizing.contains(&words), "{words}");
    }
    let actions = format!("{},000", ACTIONS / 1000);
    let fewer = format!("{},000", ACTIONS / 10_000);
    let words = format!("relive {actions} actions on the Cortex-M4F and {fewer} on the other two");
    assert!(read(&guide.join("cortex-m.md")).contains(&words), "{words}");
}
