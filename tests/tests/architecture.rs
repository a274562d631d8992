//! The map of ARCHITECTURE.md, held: who imports whom, what the core does without, how long files are.

use cla_tests::imports::Imports;
use cla_tests::{Source, root, sources};

const CRATES: [&str; 4] = ["cla-core", "host-sim", "firmware-example", "tests"];

fn all() -> Vec<Source> {
    CRATES.iter().flat_map(|folder| sources(folder)).collect()
}

/// Lines of code that contain a word, as `path:line: text`.
fn lines_with(sources: &[Source], word: &str) -> Vec<String> {
    let mut found = Vec::new();
    for source in sources {
        for (number, line) in source.code_without_tests() {
            if line.contains(word) {
                found.push(format!("{}:{number}: {}", source.path, line.trim()));
            }
        }
    }
    found
}

fn under(folder: &str) -> Vec<Source> {
    let inside = |source: &Source| source.path.starts_with(folder);
    all().into_iter().filter(inside).collect()
}

#[test]
fn every_module_says_at_its_head_what_it_is() {
    for source in all() {
        let head = source.text.find("//! ");
        let head = head.unwrap_or_else(|| panic!("{} has no head", source.path));
        // Only attributes of the whole crate may stand before it.
        let before = &source.text[..head];
        for word in ["use ", "mod ", "fn ", "struct ", "enum ", "const ", "///"] {
            assert!(!before.contains(word), "{}: {before}", source.path);
        }
    }
}

#[test]
fn no_file_has_more_than_500_lines_of_code() {
    for source in all() {
        let lines = source.code().count();
        assert!(lines <= 500, "{}: {lines}", source.path);
    }
}

/// The storeys of the core and those that each may stand on: the picture in ARCHITECTURE.md.
const STOREYS: [(&str, &[&str]); 18] = [
    ("snapshot", &[]),
    ("flash", &["snapshot"]),
    ("check", &["snapshot"]),
    ("num", &["snapshot"]),
    ("som", &["num", "snapshot"]),
    ("layer", &["check", "num", "som"]),
    ("word", &["num", "snapshot"]),
    ("map", &["check", "num", "snapshot", "som", "word"]),
    ("knowledge", &["map", "num", "snapshot", "som", "word"]),
    ("choice", &["check", "knowledge", "num", "snapshot", "word"]),
    (
        "level2",
        &[
            "check",
            "choice",
            "knowledge",
            "map",
            "num",
            "snapshot",
            "som",
            "word",
        ],
    ),
    (
        "adaptation",
        &["check", "choice", "knowledge", "num", "snapshot", "word"],
    ),
    (
        "agent",
        &[
            "adaptation",
            "check",
            "choice",
            "knowledge",
            "level2",
            "map",
            "num",
            "snapshot",
            "som",
            "word",
        ],
    ),
    // The other learner shares the words and nothing else.
    ("growth", &["check", "num", "snapshot", "word"]),
    ("reason", &["growth", "num", "snapshot", "word"]),
    ("forest", &["check", "num", "reason", "snapshot", "word"]),
    (
        "brain",
        &["agent", "check", "forest", "reason", "som", "word"],
    ),
    ("forager", &["brain"]),
];

/// The storey of a file of the core; `None` for `lib.rs`.
fn storey(path: &str) -> Option<&str> {
    let inside = path.strip_prefix("cla-core/src/")?.trim_end_matches(".rs");
    let storey = inside.split('/').next()?;
    (storey != "lib").then_some(storey)
}

#[test]
fn each_storey_of_the_core_imports_only_storeys_below() {
    let mut upward = Vec::new();
    for import in Imports::of(&all()).iter() {
        let Some(from) = storey(&import.from) else {
            continue;
        };
        let named = STOREYS.iter().find(|(storey, _)| *storey == from);
        let (_, below) = named.unwrap_or_else(|| panic!("{from} is not in the list of storeys"));
        match storey(&import.to) {
            Some(to) if to == from || below.contains(&to) => {}
            // Also another crate, and the crate's root.
            _ => upward.push(import.to_string()),
        }
    }
    assert!(upward.is_empty(), "{upward:#?}");
    in_order(&STOREYS);
}

/// The list is in the order of the storeys: nobody stands on what comes after it.
fn in_order(storeys: &[(&str, &[&str])]) {
    for (index, (storey, below)) in storeys.iter().enumerate() {
        let before = &storeys[..index];
        let stands = |it: &&str| before.iter().any(|(other, _)| other == it);
        assert!(below.iter().all(stands), "{storey}: {below:?}");
    }
}

/// The storeys of the simulator, each with those that it may stand on.
const SIMULATOR: [(&str, &[&str]); 16] = [
    ("failure", &[]),
    ("whole", &["failure"]),
    ("settings", &["failure", "whole"]),
    ("progress", &["failure", "whole"]),
    ("report", &[]),
    ("world", &["failure", "whole"]),
    ("device", &["failure", "report"]),
    ("learner", &["device", "failure", "world"]),
    ("baseline", &["failure", "learner", "world"]),
    (
        "experiment",
        &[
            "baseline", "device", "failure", "learner", "progress", "report", "settings", "whole",
            "world",
        ],
    ),
    (
        "logs",
        &["experiment", "failure", "report", "whole", "world"],
    ),
    (
        "keeping",
        &[
            "experiment",
            "failure",
            "learner",
            "logs",
            "report",
            "whole",
            "world",
        ],
    ),
    (
        "teaching",
        &["failure", "learner", "report", "settings", "whole"],
    ),
    ("cli", &[]),
    (
        "options",
        &[
            "cli",
            "device",
            "experiment",
            "failure",
            "keeping",
            "logs",
            "progress",
            "report",
            "settings",
            "teaching",
            "world",
        ],
    ),
    (
        "main",
        &[
            "cli",
            "experiment",
            "failure",
            "keeping",
            "logs",
            "options",
            "progress",
            "report",
            "teaching",
        ],
    ),
];

#[test]
fn each_storey_of_the_simulator_imports_only_storeys_below() {
    let storey = |path: &str| -> Option<String> {
        let inside = path.strip_prefix("host-sim/src/")?.trim_end_matches(".rs");
        let storey = inside.split('/').next()?;
        (storey != "lib").then(|| storey.to_owned())
    };
    let mut upward = Vec::new();
    for import in Imports::of(&all()).iter() {
        let (Some(from), Some(to)) = (storey(&import.from), storey(&import.to)) else {
            continue;
        };
        let named = SIMULATOR.iter().find(|(storey, _)| *storey == from);
        let (_, below) = named.unwrap_or_else(|| panic!("{from} is not in the list of storeys"));
        if from != to && !below.contains(&to.as_str()) {
            upward.push(import.to_string());
        }
    }
    assert!(upward.is_empty(), "{upward:#?}");
    in_order(&SIMULATOR);
}

#[test]
fn nothing_in_the_simulator_but_its_program_prints() {
    let mut library = under("host-sim/src");
    library.retain(|source| !source.path.ends_with("src/main.rs"));
    for word in ["println!", "print!(", "dbg!"] {
        let found = lines_with(&library, word);
        assert!(found.is_empty(), "{found:?}");
    }
}

#[test]
fn no_file_imports_another_that_imports_it() {
    let imports = Imports::of(&all());
    assert!(imports.iter().count() > 300);
    let circles = imports.circles();
    let named: Vec<String> = circles
        .iter()
        .flat_map(|circle| imports.within(circle))
        .map(ToString::to_string)
        .collect();
    assert!(named.is_empty(), "{} circles: {named:#?}", circles.len());
}

#[test]
fn a_circle_is_found_through_every_way_to_name_a_file() {
    let file = |path: &str, text: &str| Source {
        path: path.to_owned(),
        text: text.to_owned(),
    };
    for (a, b) in [
        ("use crate::b::B;", "use super::a::A;"),
        (
            "use crate::{b::{B as C}, other};",
            "fn f(_: crate::a::A) {}",
        ),
        ("use super::B;", "use crate::A;"),
        (
            "fn f() { cla_core::b::B::new() }",
            "use crate::a::{self, A};",
        ),
        (
            "use crate::b;\nfn f() { b::f() }",
            "macro_rules! m { () => { $crate::a::A } }",
        ),
    ] {
        let sources = [
            file(
                "cla-core/src/lib.rs",
                "mod a;\nmod b;\npub use a::A;\npub use b::B;",
            ),
            file("cla-core/src/a.rs", a),
            file("cla-core/src/b.rs", b),
        ];
        let imports = Imports::of(&sources);
        let expected = [["cla-core/src/a.rs", "cla-core/src/b.rs"]];
        assert_eq!(imports.circles(), expected, "{a} {b} {imports:?}");
        // Not in a test, a comment or a text.
        for silent in [
            format!("#[cfg(test)]\nmod tests {{ {b} }}"),
            format!("// {b}"),
            format!("const TEXT: &str = \"{b}\";"),
        ] {
            let mut sources = sources.clone();
            sources[2].text = silent;
            assert!(Imports::of(&sources).circles().is_empty());
        }
    }
}

#[test]
fn only_the_arena_names_the_physics_engine() {
    let mut elsewhere = under("host-sim");
    elsewhere.retain(|source| !source.path.ends_with("world/arena.rs"));
    let found = lines_with(&elsewhere, "rapier2d");
    assert!(found.is_empty(), "{found:?}");
    let arena = under("host-sim/src/world/arena.rs");
    assert!(!lines_with(&arena, "rapier2d").is_empty());
}

#[test]
fn reports_know_nothing_of_worlds_and_brains() {
    let report = under("host-sim/src/report");
    assert!(report.len() > 8);
    for module in ["crate::world", "crate::experiment", "cla_core"] {
        let found = lines_with(&report, module);
        assert!(found.is_empty(), "{found:?}");
    }
}

#[test]
fn the_core_does_without_std_and_alloc() {
    let core = under("cla-core/src");
    let text = &core
        .iter()
        .find(|source| source.path.ends_with("src/lib.rs"));
    let text = &text.expect("the core has a lib.rs").text;
    // A line of its own: not inside a `cfg_attr` and not in a comment.
    let unconditional = text.lines().any(|line| line == "#![no_std]");
    assert!(unconditional, "no_std is unconditional");
    for word in ["std::", "alloc::", "extern crate alloc"] {
        let mut found = lines_with(&core, word);
        found.retain(|line| !line.contains("no_std"));
        assert!(found.is_empty(), "{found:?}");
    }
    let externs = text.matches("extern crate").count();
    assert_eq!(
        externs,
        text.matches("#[cfg(test)]\nextern crate std;").count()
    );
}

/// What gives other bits on another target, or with another version of a library.
#[test]
fn the_core_does_no_arithmetic_that_depends_on_the_target() {
    let core = under("cla-core/src");
    for word in [
        "mul_add",
        ".powf(",
        ".powi(",
        ".sqrt()",
        ".exp()",
        ".exp2()",
        ".ln()",
        ".sin()",
        ".cos()",
        ".tanh()",
        ".hypot(",
        "sum::<f32>",
        "product::<f32>",
        "f64",
    ] {
        let found = lines_with(&core, word);
        assert!(found.is_empty(), "{word}: {found:?}");
    }
    // The sum of no floats is −0; integers say their type in the same line.
    let mut sums = lines_with(&core, ".sum()");
    sums.retain(|line| !(line.contains("as u16") || line.contains("as u32")));
    assert!(sums.is_empty(), "{sums:?}");
}

#[test]
fn only_num_calls_the_library_of_float_functions() {
    let mut core = under("cla-core/src");
    core.retain(|source| !source.path.contains("/num/"));
    let found = lines_with(&core, "libm::");
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn nothing_in_the_simulator_iterates_in_an_order_of_chance() {
    for word in ["HashMap", "HashSet", "thread_rng", "SystemTime"] {
        let mut found = lines_with(&under("host-sim/src"), word);
        // The folder of a run is named by its time; no result is.
        found.retain(|line| !line.starts_with("host-sim/src/report/place.rs"));
        assert!(found.is_empty(), "{found:?}");
    }
}

#[test]
fn the_root_holds_what_the_map_names_and_nothing_else() {
    let known = [
        "Cargo.toml",
        "Cargo.lock",
        "cla-core",
        "host-sim",
        "firmware-example",
        "tests",
        "memory-budget.md",
        "README.md",
        "ARCHITECTURE.md",
        "docs",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "LICENSE-MIT",
        "LICENSE-APACHE",
        "rust-toolchain.toml",
        "rustfmt.toml",
        "clippy.toml",
        "deny.toml",
        "target",
        "runs",
    ];
    for entry in std::fs::read_dir(root())
        .expect("the root can be read")
        .flatten()
    {
        let name = entry.file_name().to_string_lossy().into_owned();
        assert!(
            name.starts_with('.') || known.contains(&name.as_str()),
            "{name}"
        );
    }
}
