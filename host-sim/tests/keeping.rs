//! Brains in files, as the program's user and its library meet them.

use std::fs;
use std::process::{Command, Output};

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer::VOCABULARY;
use host_sim::keeping::{keep, recall};
use host_sim::learner::forager::Forager;
use host_sim::learner::{Learner, live};
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::Pioneer;
use tempfile::{TempDir, tempdir};

fn run(folder: &TempDir, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
    let command = command
        .args(arguments.split(' '))
        .current_dir(folder.path());
    command.output().unwrap()
}

fn said(folder: &TempDir, arguments: &str) -> String {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_life_that_is_stopped_and_gone_on_with_ends_in_the_same_bytes() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    for (index, config) in [AgentConfig::FORAGER, AgentConfig::RESILIENT_LEVEL2]
        .into_iter()
        .enumerate()
    {
        let seed = 7 + index as u64;
        let born = || Forager::born(config, Adaptation::Relearning, seed).unwrap();
        let end = |stops: &[u32]| {
            let mut world = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
            let mut forager = born();
            for (done, stop) in stops.iter().enumerate() {
                if done == 2 {
                    forager.act().unwrap();
                }
                let lived = live(&mut forager, &mut world, *stop).unwrap();
                assert!(lived.total() < 1000);
                keep(forager.brain(), VOCABULARY.names(), &file("life")).unwrap();
                let mut other =
                    Forager::born(AgentConfig::BOOK, Adaptation::Relearning, 1).unwrap();
                recall(other.brain_mut(), VOCABULARY.names(), &file("life")).unwrap();
                forager = other;
            }
            fs::read(file("life")).unwrap()
        };
        let whole = {
            let mut world = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
            let mut forager = born();
            live(&mut forager, &mut world, 1500).unwrap();
            forager.act().unwrap();
            live(&mut forager, &mut world, 1000).unwrap();
            keep(forager.brain(), VOCABULARY.names(), &file("whole")).unwrap();
            fs::read(file("whole")).unwrap()
        };
        assert!(end(&[700, 800, 1000]) == whole, "{config:?}");
    }
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().flatten().collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

#[test]
fn a_brain_is_trained_kept_gone_on_with_and_looked_into() {
    let folder = tempdir().expect("a folder");
    let first = said(
        &folder,
        "train --actions 1500 --brain forager-level2 --save a.brain",
    );
    assert!(first.contains("trained for 1500 actions") && first.contains("saved a.brain"));
    let second = said(
        &folder,
        "train --actions 300 --act relearning --load a.brain --save b.brain",
    );
    assert!(second.contains("loaded a.brain") && second.contains("acted for 300"));
    let again = said(
        &folder,
        "train --actions 300 --act relearning --load a.brain --save c.brain",
    );
    assert_eq!(again, second.replace("b.brain", "c.brain"));
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("b.brain") == read("c.brain") && read("a.brain") != read("b.brain"));
    let seen = said(&folder, "inspect a.brain --most 5");
    for word in [
        "Training",
        "ingrip",
        "agent of the forager",
        "10.00",
        "/forward/",
        "synthetic items",
        "→",
    ] {
        assert!(seen.contains(word), "{word}: {seen}");
    }
}

#[test]
fn a_mind_is_trained_kept_gone_on_with_and_looked_into() {
    let folder = tempdir().expect("a folder");
    let first = said(&folder, "train --actions 1500 --brain mind --save a.brain");
    assert!(first.contains("trained for 1500 actions") && first.contains("leaves"));
    // The file says what it is.
    let go_on = "train --actions 300 --act relearning --load a.brain --save";
    let second = said(&folder, &format!("{go_on} b.brain"));
    assert!(second.contains("loaded a.brain") && second.contains("acted for 300"));
    assert_eq!(
        said(&folder, &format!("{go_on} c.brain")),
        second.replace("b.brain", "c.brain")
    );
    // It has one way to adapt, and no other is promised.
    for (arguments, code) in [
        ("train --act frozen --load a.brain", 1),
        ("train --brain mind --act frozen", 2),
    ] {
        let output = run(&folder, arguments);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        assert!(
            String::from_utf8(output.stderr)
                .unwrap()
                .contains("adapts in its own way")
        );
    }
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("b.brain") == read("c.brain") && read("a.brain") != read("b.brain"));
    let seen = said(&folder, "inspect a.brain --most 5 --page a.html");
    for word in [
        "mind of the forager",
        "Training",
        "ingrip",
        "10.00",
        "/forward/",
        "samples 15",
    ] {
        assert!(seen.contains(word), "{word}: {seen}");
    }
    assert!(
        fs::read_to_string(folder.path().join("a.html"))
            .unwrap()
            .contains("<svg class=\"graph\"")
    );
    let exported = said(&folder, "export a.brain --json");
    let whole: serde_json::Value = serde_json::from_str(&exported).unwrap();
    assert_eq!(whole["kind"], "mind");
    assert_eq!(whole["items"].as_array().unwrap().len(), 7);
    said(&folder, "export a.brain --json --out a.json");
    assert_eq!(
        fs::read_to_string(folder.path().join("a.json")).unwrap(),
        exported
    );
}

#[test]
fn the_brains_of_a_run_are_kept_in_files_that_can_be_looked_into() {
    let folder = tempdir().expect("a folder");
    let forage = "forage --seeds 3 --actions 1000 --test-actions 100 --out here";
    said(&folder, &format!("{forage} --save-brains brains"));
    for name in ["forage-3-level1", "forage-3-both"] {
        let seen = said(&folder, &format!("inspect brains/{name}.brain --most 5"));
        for word in ["agent of the forager", "ingrip", "10.00"] {
            assert!(seen.contains(word), "{name}, {word}: {seen}");
        }
    }
    let kept = fs::read_dir(folder.path().join("brains")).unwrap();
    assert_eq!(kept.count(), 2);
    // Who has none to keep says so, and who has.
    let output = run(&folder, "live --save-brains others");
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let sentence = String::from_utf8(output.stderr).unwrap();
    assert!(sentence.contains("forage, recover, one have"), "{sentence}");
    assert!(!folder.path().join("others").exists());
}

#[test]
fn the_brains_of_readme_are_trained_looked_into_and_compared_as_it_says() {
    let folder = tempdir().expect("a folder");
    let readme = include_str!("../../README.md");
    let errands = ["train", "inspect", "diff", "replay", "export"];
    let commands = readme.lines().filter_map(|line| {
        let command = line.strip_prefix("cargo run --release -- ")?;
        let command = command.split('#').next().unwrap_or_default().trim();
        let errand = command.split(' ').next()?;
        errands.contains(&errand).then_some(command)
    });
    let mut done = 0;
    for command in commands {
        let shorter = if command.starts_with("train") {
            " --actions 300"
        } else {
            ""
        };
        let said = said(&folder, &format!("{command}{shorter}"));
        assert!(!said.is_empty(), "{command}");
        done += 1;
    }
    assert!(done >= 6, "{done} commands");
}

#[test]
fn a_difference_names_what_was_learned_lost_and_revalued() {
    let folder = tempdir().expect("a folder");
    said(
        &folder,
        "train --actions 1000 --brain forager-level2 --save a.brain",
    );
    said(
        &folder,
        "train --actions 1000 --load a.brain --save b.brain",
    );
    let same = said(&folder, "diff a.brain a.brain");
    for none in [
        "learned: 0",
        "lost: 0",
        "revalued: 0",
        "items and habits: 0",
    ] {
        assert!(same.contains(none), "{same}");
    }
    let there = said(&folder, "diff a.brain b.brain --most 100000");
    let back = said(&folder, "diff b.brain a.brain --most 100000");
    let rows = |text: &str, part: &str| -> Vec<String> {
        let begins = text.lines().skip_while(|it| !it.starts_with(part));
        let rows = begins.skip(1).take_while(|it| !it.is_empty());
        let mut rows: Vec<String> = rows.map(str::to_owned).collect();
        rows.sort();
        rows
    };
    assert!(rows(&there, "learned:").len() > 10, "{there}");
    // What is learned one way is lost the other way.
    assert_eq!(rows(&there, "learned:"), rows(&back, "lost:"));
    assert_eq!(rows(&there, "lost:"), rows(&back, "learned:"));
    assert!(there.contains("habit forward of s3"), "{there}");
    said(&folder, "train --actions 100 --brain mind --save m.brain");
    let output = run(&folder, "diff a.brain m.brain");
    assert_eq!(output.status.code(), Some(1));
    let sentence = String::from_utf8(output.stderr).unwrap();
    assert!(sentence.contains("nothing to compare"), "{sentence}");
}

#[test]
fn a_file_that_is_no_brain_is_refused_in_a_sentence_and_stays() {
    let folder = tempdir().expect("a folder");
    said(&folder, "train --actions 200 --save a.brain");
    let whole = fs::read(folder.path().join("a.brain")).unwrap();
    let refused = |arguments: &str| {
        let output = run(&folder, arguments);
        assert_eq!(output.status.code(), Some(1), "{output:?}");
        let sentence = String::from_utf8(output.stderr).unwrap();
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
        sentence
    };
    let mut damaged = whole.clone();
    damaged[5000] ^= 4;
    let with = |bytes: &[u8]| fs::write(folder.path().join("b.brain"), bytes).unwrap();
    with(&damaged);
    assert!(refused("inspect b.brain").contains("damaged in its"));
    assert!(refused("train --load b.brain --save b.brain").contains("damaged"));
    assert!(fs::read(folder.path().join("b.brain")).unwrap() == damaged);
    with(&whole[..whole.len() - 1]);
    assert!(refused("inspect b.brain").contains("the end of the image is missing"));
    with(&[&whole[..], &[0]].concat());
    assert!(refused("inspect b.brain").contains("bytes behind the image"));
    with(b"no brain at all, but long enough to have a header: it goes on and on and on and on");
    assert!(refused("inspect b.brain").contains("no image of a brain"));
    assert!(refused("inspect none.brain").contains("cannot read"));
    let output = run(&folder, "train --act never");
    assert_eq!(output.status.code(), Some(2));
}
