//! Tests that cross crates; what several of them need.

pub mod claims;
pub mod guide;
pub mod imports;
pub mod tokens;

use std::fs;
use std::path::{Path, PathBuf};

/// The folder that holds the whole project.
///
/// ```
/// assert!(cla_tests::root().join("Cargo.toml").is_file());
/// ```
#[must_use]
pub fn root() -> PathBuf {
    // Where the test runs, not where it was built: a copied `target` would judge another checkout.
    let package = std::env::var_os("CARGO_MANIFEST_DIR");
    PathBuf::from(package.unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into())).join("..")
}

/// A file of Rust source.
#[derive(Clone, Debug)]
pub struct Source {
    /// Its path in the project, with `/` between folders.
    pub path: String,
    /// Its text.
    pub text: String,
}

impl Source {
    /// The lines that are neither empty nor comments, with their numbers.
    pub fn code(&self) -> impl Iterator<Item = (usize, &str)> {
        self.text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line))
            .filter(|(_, line)| {
                let line = line.trim_start();
                !line.is_empty() && !line.starts_with("//")
            })
    }

    /// As [`code`](Self::code), up to the tests at the file's end; nothing of a file of tests.
    pub fn code_without_tests(&self) -> impl Iterator<Item = (usize, &str)> {
        let tests = self.text.find("#[cfg(test)]\nmod tests");
        let lines = match tests {
            Some(at) => self.text[..at].lines().count(),
            None if self.path.ends_with("_tests.rs") => 0,
            None => usize::MAX,
        };
        self.code().take_while(move |(number, _)| *number <= lines)
    }
}

/// All Rust sources under a folder of the project, in the order of their paths.
///
/// # Panics
/// When the folder cannot be read.
#[must_use]
pub fn sources(folder: &str) -> Vec<Source> {
    let mut found = Vec::new();
    collect(&root().join(folder), folder, &mut found);
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

fn collect(directory: &Path, name: &str, found: &mut Vec<Source>) {
    let entries = fs::read_dir(directory).expect("a folder of the project can be read");
    for entry in entries {
        let entry = entry.expect("an entry of the folder can be read");
        let path = format!("{name}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            if entry.file_name() != "target" {
                collect(&entry.path(), &path, found);
            }
        } else if path.ends_with(".rs") {
            let text = fs::read_to_string(entry.path()).expect("a source is text");
            found.push(Source { path, text });
        }
    }
}
