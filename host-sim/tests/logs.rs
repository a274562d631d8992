//! Logs as the program writes them, read back by itself and by the `mcap` package of PyPI.
//!
//! `MCAP_PYTHON` names a Python that has it; `tests/run logs` installs one.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use host_sim::logs::read_log;
use serde_json::Value;
use tempfile::TempDir;

/// A folder of this test's own, removed at its end.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn run(&self, arguments: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
        let command = command
            .args(arguments.split(' '))
            .current_dir(self.0.path());
        command.output().unwrap()
    }

    fn said(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    }
}

const TRAIN: &str = "train --actions 1200 --brain resilient-level2 --seed 7";

#[test]
fn all_forms_of_a_log_say_the_same_and_a_log_changes_no_life() {
    let folder = Folder::new();
    let plain = folder.said(&format!("{TRAIN} --save a.brain"));
    let logged = folder.said(&format!(
        "{TRAIN} --save b.brain --log a.mcap --log a.jsonl --log a.csv"
    ));
    let read = |name: &str| fs::read(folder.0.path().join(name)).unwrap();
    assert!(read("a.brain") == read("b.brain"));
    assert!(logged.contains("logged 1200 actions in a.mcap"), "{logged}");
    assert_eq!(plain.lines().next(), logged.lines().next());
    let (mcap, lines) = ["a.mcap", "a.jsonl"]
        .map(|it| read_log(&folder.0.path().join(it)).unwrap())
        .into();
    assert_eq!(mcap, lines);
    // Nothing is lost: all captures that the life is said to have had, those of its last action, too.
    let obtained: u32 = lines.1.iter().map(|it| it.reward.obtained).sum();
    assert!(
        logged.contains(&format!("for 1200 actions: {obtained} captures")),
        "{logged}"
    );
    let counted: u32 = String::from_utf8(read("a.csv"))
        .unwrap()
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(2).unwrap().parse::<u32>().unwrap())
        .sum();
    assert_eq!(counted, obtained);
    assert_eq!((lines.1.len(), lines.1[1200].choice.as_ref()), (1201, None));
    let windows = String::from_utf8(read("a.csv")).unwrap();
    assert_eq!(windows.lines().count(), 3, "{windows}");
    let replayed = folder.said("replay a.mcap");
    assert!(replayed.starts_with("1200 actions, "), "{replayed}");
    let page = String::from_utf8(read("a.html")).unwrap();
    assert!(
        page.contains("id=\"room\"") && !page.contains("__"),
        "the page is filled in"
    );
}

#[test]
fn what_is_no_log_is_refused_in_a_sentence() {
    let folder = Folder::new();
    let refused = |arguments: &str, code| {
        let output = folder.run(arguments);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        let sentence = String::from_utf8(output.stderr).unwrap();
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
        sentence
    };
    folder.said("train --actions 300 --log a.mcap");
    let whole = fs::read(folder.0.path().join("a.mcap")).unwrap();
    fs::write(folder.0.path().join("b.mcap"), &whole[..whole.len() / 2]).unwrap();
    assert!(refused("replay b.mcap", 1).contains("cut off or damaged"));
    fs::write(folder.0.path().join("c.mcap"), b"nothing").unwrap();
    assert!(refused("replay c.mcap", 1).contains("c.mcap"));
    assert!(refused("replay none.mcap", 1).contains("none.mcap"));
    assert!(refused("train --actions 300 --log a.bag", 2).contains("a.bag"));
}

/// What the Python package reads.
fn in_python(python: &str, log: &Path) -> Value {
    let script = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../tests/fixtures/read_mcap.py"
    );
    let output = Command::new(python).arg(script).arg(log).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_package_of_pypi_reads_what_was_written() {
    let Ok(python) = std::env::var("MCAP_PYTHON") else {
        println!("skipped: MCAP_PYTHON names no Python; tests/run logs does");
        return;
    };
    let folder = Folder::new();
    folder.said(&format!("{TRAIN} --log a.mcap"));
    let log = folder.0.path().join("a.mcap");
    let (life, steps) = read_log(&log).unwrap();
    let seen = in_python(&python, &log);
    let alarms = steps.iter().filter(|it| it.alarm.is_some()).count();
    let moved = steps.iter().filter(|it| !it.specimens.is_empty()).count();
    for (topic, count) in [
        ("/life", 1),
        // Before every action, and what the last has led to.
        ("/percept", 1201),
        ("/choice", 1200),
        ("/reward", 1201),
        ("/pose", 1201),
        ("/alarm", alarms),
        ("/specimens", moved),
    ] {
        assert_eq!(
            seen["counts"][topic].as_u64().unwrap_or(0),
            count as u64,
            "{topic}"
        );
        assert_eq!(
            seen["stated"][topic].as_u64().unwrap_or(0),
            count as u64,
            "{topic}"
        );
    }
    assert_eq!(seen["strangers"], serde_json::json!([]));
    let last = steps.last().unwrap();
    assert_eq!(
        seen["last"]["/choice"],
        serde_json::to_value(&steps[1199].choice).unwrap()
    );
    assert_eq!(
        seen["last"]["/reward"],
        serde_json::to_value(last.reward).unwrap()
    );
    assert_eq!(
        seen["last"]["/pose"],
        serde_json::to_value(last.pose).unwrap()
    );
    assert_eq!(seen["last"]["/life"], serde_json::to_value(life).unwrap());
}
