//! What fuzzers have found and where they have been, on stable: every file of the corpora goes through
//! the body of its target, and so do bytes of chance, the same in every run.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use cla_core::num::Rng;
use cla_fuzz_bodies::{TARGETS, run};
use cla_tests::root;

/// The committed inputs of a target, in the order of their names.
fn corpus(target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = root().join("tests/fuzz/corpus").join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    let read = |path: PathBuf| {
        let bytes = fs::read(&path).expect("an input can be read");
        (path, bytes)
    };
    files.into_iter().map(read).collect()
}

#[test]
fn every_input_of_the_corpora_ends_quietly() {
    for (target, _) in TARGETS {
        let corpus = corpus(target);
        assert!(!corpus.is_empty(), "{target}");
        for (path, bytes) in corpus {
            // The name comes before the reason, should it panic.
            println!("{}", path.display());
            run(target, &bytes);
        }
    }
}

#[test]
fn the_plan_of_the_fuzzers_has_every_target_and_a_hundred_million_executions() {
    let plan = fs::read_to_string(root().join("tests/fuzz/plan.tsv")).expect("the plan");
    let (mut targets, mut executions) = (BTreeSet::new(), 0_u64);
    for line in plan.lines().filter(|it| !it.starts_with('#')) {
        let cells: Vec<&str> = line.split('\t').collect();
        let [target, bytes, runs] = cells[..] else {
            panic!("three cells: {line}");
        };
        targets.insert(target);
        assert!((1..=4096).contains(&bytes.parse::<u32>().expect("bytes")));
        let runs: u64 = runs.parse().expect("executions");
        assert!(runs >= 60_000, "{line}");
        executions += runs;
    }
    let all: BTreeSet<&str> = TARGETS.iter().map(|(target, _)| *target).collect();
    assert_eq!(targets, all);
    assert!(executions >= 100_000_000, "{executions}");
}

/// An input of the corpus with other bytes, a piece of another one, or bytes of chance alone.
fn changed(corpus: &[(PathBuf, Vec<u8>)], rng: &mut Rng) -> Vec<u8> {
    let pick = |rng: &mut Rng| &corpus[rng.below(corpus.len() as u32) as usize].1;
    let mut bytes = pick(rng).clone();
    match rng.below(4) {
        0 => {
            let length = rng.below(300);
            bytes = (0..length).map(|_| rng.below(256) as u8).collect();
        }
        1 => {
            let other = pick(rng);
            let cut = rng.below(bytes.len() as u32 + 1) as usize;
            let from = rng.below(other.len() as u32 + 1) as usize;
            bytes.truncate(cut);
            bytes.extend(&other[from..]);
        }
        _ => {}
    }
    for _ in 0..rng.below(8) {
        let place = rng.below(bytes.len() as u32) as usize;
        if let Some(byte) = bytes.get_mut(place) {
            *byte = rng.below(256) as u8;
        }
    }
    bytes.truncate(4096);
    bytes
}

#[test]
fn bytes_of_chance_end_quietly() {
    // Each target has its time, at least so many inputs whatever the machine does; `tests/run all`
    // and the fuzzer itself look longer.
    let millis = std::env::var("CLA_FUZZ_MILLIS").map_or(500, |it| it.parse().unwrap());
    for (index, (target, body)) in (0..).zip(TARGETS) {
        let mut rng = Rng::stream(index, 18);
        let corpus = corpus(target);
        let (begun, mut done) = (Instant::now(), 0_u64);
        while done < 20 || begun.elapsed() < Duration::from_millis(millis) {
            body(&changed(&corpus, &mut rng));
            done += 1;
        }
        println!("{target}: {done} inputs");
    }
}
