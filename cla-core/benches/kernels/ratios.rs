//! Times closures with criterion and prints each median beside that of the plain loop.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion};

/// What the others of a group are held against.
pub(crate) const PEER: &str = "plain loop";

/// What has been timed: groups, and the names in each.
pub(crate) struct Ratios {
    start: SystemTime,
    groups: Vec<(String, Vec<String>)>,
}

impl Default for Ratios {
    fn default() -> Self {
        Self {
            start: SystemTime::now(),
            groups: Vec::new(),
        }
    }
}

/// One group; its first name is the peer's.
pub(crate) struct Group<'a> {
    criterion: BenchmarkGroup<'a, WallTime>,
    names: &'a mut Vec<String>,
}

/// Where criterion keeps its numbers: `target/criterion`.
pub(crate) fn directory() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("criterion")
}

impl Ratios {
    /// Begins a group of what does the same.
    pub(crate) fn group<'a>(&'a mut self, criterion: &'a mut Criterion, name: &str) -> Group<'a> {
        let place = self.groups.len();
        self.groups.push((name.to_owned(), Vec::new()));
        Group {
            criterion: criterion.benchmark_group(name),
            names: &mut self.groups[place].1,
        }
    }

    /// Prints the table of this run; what a filter left out is not in it.
    pub(crate) fn print(&self) {
        println!("\nmedian of this run, and how many times faster than the {PEER}:");
        for (group, names) in &self.groups {
            let Some(peer) = self.median(group, PEER) else {
                continue;
            };
            println!("{group}");
            for name in names {
                if let Some(time) = self.median(group, name) {
                    println!("  {name:<24}{time:>12.1} ns {:>8.2} x", peer / time);
                }
            }
        }
    }

    /// Nanoseconds; `None` where this run measured nothing.
    fn median(&self, group: &str, name: &str) -> Option<f64> {
        let file = directory()
            .join(group)
            .join(name)
            .join("new/estimates.json");
        if fs::metadata(&file).ok()?.modified().ok()? < self.start {
            return None;
        }
        let estimates: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(file).ok()?).ok()?;
        estimates["median"]["point_estimate"].as_f64()
    }
}

impl Group<'_> {
    /// Times one of the group.
    pub(crate) fn time<R>(&mut self, name: &str, mut it: impl FnMut() -> R) {
        self.criterion
            .bench_function(name, |bench| bench.iter(&mut it));
        self.names.push(name.to_owned());
    }
}
