//! Puts the shards of a sweep together, from the journals that they have written.
//!
//! Refused, each with its sentence: what is no shard, shards of another build, shards of another sweep,
//! what is there twice, and what is missing.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::Value;

use super::options::{Case, Shard, SweepOptions};
use super::{Sweep, Trial};
use crate::experiment::noted::build;
use crate::experiment::plan::Experiment;
use crate::failure::{Failure, Impossible};
use crate::report::{Circumstances, Journal, Results};
use crate::whole::read_text;

/// Most bytes of a journal.
const MOST_BYTES: u64 = 1 << 34;

/// A shard as it was found.
struct Found {
    directory: PathBuf,
    about: Value,
    options: Value,
    shard: Option<Shard>,
    trials: BTreeMap<Case, Trial>,
}

impl Found {
    /// Where it was found, and the commit that it was made at, if that is known.
    fn built(&self) -> String {
        let commit = commit(&self.directory).map(|commit| format!(" (commit {commit})"));
        format!("{}{}", self.directory.display(), commit.unwrap_or_default())
    }
}

/// A line of a shard's journal.
#[derive(Deserialize)]
struct Entry {
    case: Case,
    trial: Trial,
}

/// Reads the shards in these directories, or right below them, and judges them together.
///
/// # Errors
/// [`Impossible`] when they do not make up one sweep; [`Failure`] of the judgement.
pub fn merge(directories: &[PathBuf]) -> Result<Results, Failure> {
    let (options, trials) = whole(directories, &build()?)?;
    let mut results = Sweep::judge(&options, &trials)?;
    results.summary.options = Some(serde_json::to_value(&options)?);
    Ok(results)
}

/// The options of the whole sweep, and the trials of all of its cases.
fn whole(directories: &[PathBuf], ours: &Value) -> Result<(SweepOptions, Vec<Trial>), Impossible> {
    let mut found = Vec::new();
    for directory in places(directories)? {
        found.push(read(&directory)?);
    }
    let Some((first, others)) = found.split_first() else {
        return Err(Impossible::new("there is no shard to merge"));
    };
    for other in others {
        if !same_build(&first.about, &other.about) {
            return Err(Impossible::new(format!(
                "{} and {} were made by different builds",
                first.built(),
                other.built()
            )));
        }
        same_sweep(first, other)?;
    }
    if !same_build(&first.about, ours) {
        return Err(Impossible::new(format!(
            "{} was made by another build than the one that is to judge it: merge with the program \
             that made it",
            first.built()
        )));
    }
    let sweep = SweepOptions::of_journal(&first.options)
        .map_err(|error| Impossible::new(format!("{}: {error}", first.directory.display())))?;
    let sweep = sweep.whole();
    let mut all: BTreeMap<Case, (&Path, &Trial)> = BTreeMap::new();
    for shard in &found {
        for (&case, trial) in &shard.trials {
            if let Some((earlier, _)) = all.insert(case, (&shard.directory, trial)) {
                return Err(Impossible::new(format!(
                    "seed {} of point {} is there twice: in {} and in {}",
                    case.seed,
                    case.point,
                    earlier.display(),
                    shard.directory.display()
                )));
            }
        }
    }
    let cases = sweep.cases();
    let there = |case: &&Case| all.contains_key(*case);
    if let Some(missing) = cases.iter().find(|case| !there(case)) {
        let count = cases.len() - cases.iter().filter(there).count();
        return Err(Impossible::new(missing_trials(
            missing, count, &cases, &found,
        )));
    }
    let trials = cases.iter().filter_map(|case| all.get(case));
    let trials = trials.map(|(_, trial)| (*trial).clone()).collect();
    Ok((sweep, trials))
}

/// How many trials are missing, and who has to make the first of them.
fn missing_trials(first: &Case, count: usize, cases: &[Case], found: &[Found]) -> String {
    let of = found.iter().find_map(|it| it.shard).map(|it| it.of);
    let at = cases.iter().position(|case| case == first);
    let whose = match (of, at) {
        (Some(of), Some(at)) => {
            let shard = Shard {
                index: (at % of as usize) as u32,
                of,
            };
            format!(", which shard {shard} makes")
        }
        _ => String::new(),
    };
    format!(
        "{count} of {} trials are missing, first seed {} of point {}{whose}: make it again and merge then",
        cases.len(),
        first.seed,
        first.point
    )
}

/// The directories with journals: those that were named, and the shards below those without one.
fn places(directories: &[PathBuf]) -> Result<Vec<PathBuf>, Impossible> {
    let mut places = Vec::new();
    for directory in directories {
        if directory.join(Journal::NAME).is_file() {
            places.push(directory.clone());
            continue;
        }
        let entries = fs::read_dir(directory).map_err(|error| {
            let sentence = format!("cannot read {}: {error}", directory.display());
            Impossible::new(sentence)
        })?;
        let mut below: Vec<PathBuf> = entries
            .flatten()
            .map(|entry| entry.path())
            .filter(|path| path.join(Journal::NAME).is_file())
            .collect();
        // The order of a directory is one of chance.
        below.sort();
        if below.is_empty() {
            let sentence = format!("{} holds no shard of a sweep", directory.display());
            return Err(Impossible::new(sentence));
        }
        places.extend(below);
    }
    Ok(places)
}

fn read(directory: &Path) -> Result<Found, Impossible> {
    let name = directory.display();
    let no_shard =
        |why: String| Impossible::new(format!("{name} holds no shard of a sweep: {why}"));
    let path = directory.join(Journal::NAME);
    let text = read_text(&path, MOST_BYTES).map_err(|why| no_shard(why.to_string()))?;
    // A line that was cut off is no line.
    let whole = text.rfind('\n').map_or("", |at| &text[..at]);
    let mut lines = whole.lines();
    let about: Value = lines
        .next()
        .and_then(|line| serde_json::from_str(line).ok())
        .ok_or_else(|| no_shard("its journal does not say what it is about".to_owned()))?;
    let experiment = about.get("experiment").and_then(Value::as_str);
    if experiment != Some(Sweep::NAME) {
        let other = experiment.unwrap_or("nothing that is known");
        return Err(no_shard(format!("its journal is about {other}")));
    }
    let mut options = about.get("options").cloned().unwrap_or_default();
    let shard = options.get("shard").cloned().unwrap_or_default();
    let shard = serde_json::from_value(shard).map_err(|error| no_shard(error.to_string()))?;
    if let Some(table) = options.as_object_mut() {
        table.insert("shard".to_owned(), Value::Null);
    }
    let mut trials = BTreeMap::new();
    for (number, line) in lines.enumerate() {
        let entry: Entry = serde_json::from_str(line)
            .map_err(|error| no_shard(format!("line {} of its journal: {error}", number + 2)))?;
        if trials.insert(entry.case, entry.trial).is_some() {
            let Case { point, seed } = entry.case;
            let sentence = format!("seed {seed} of point {point} is there twice in {name}");
            return Err(Impossible::new(sentence));
        }
    }
    Ok(Found {
        directory: directory.to_owned(),
        about,
        options,
        shard,
        trials,
    })
}

/// The commit that a shard was made at, if its run came to its end.
fn commit(directory: &Path) -> Option<String> {
    let text = read_text(&directory.join(Circumstances::NAME), 1 << 20).ok()?;
    let noted: Value = serde_json::from_str(&text).ok()?;
    Some(noted.get("commit")?.as_str()?.to_owned())
}

fn same_build(one: &Value, other: &Value) -> bool {
    let same = |key: &str| one.get(key) == other.get(key);
    same("version") && same("checksum of the program")
}

fn same_sweep(one: &Found, other: &Found) -> Result<(), Impossible> {
    let different = |how: String| {
        Err(Impossible::new(format!(
            "{} and {} are of different sweeps: {how}",
            one.directory.display(),
            other.directory.display()
        )))
    };
    if let Some(how) = Journal::difference(&one.options, &other.options) {
        return different(how);
    }
    match (one.shard.map(|it| it.of), other.shard.map(|it| it.of)) {
        (Some(ours), Some(theirs)) if ours != theirs => different(format!(
            "one is cut into {ours} shards and the other into {theirs}"
        )),
        _ => Ok(()),
    }
}
