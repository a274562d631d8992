//! The committed claims files, and the seeds of them that are lived again.

use std::fs;
use std::process::Command;

use crate::root;

/// A file of `tests/claims`.
#[derive(Clone, Debug)]
pub struct File {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// All claims files, by name.
///
/// # Panics
/// When they cannot be read.
#[must_use]
pub fn files() -> Vec<File> {
    let folder = root().join("tests/claims");
    let entries = fs::read_dir(folder).expect("the folder of claims can be read");
    let mut files: Vec<File> = entries
        .map(|entry| entry.expect("an entry can be read").path())
        .filter(|path| path.extension().is_some_and(|it| it == "json"))
        .map(|path| File {
            name: path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
            text: fs::read_to_string(&path).expect("a claims file is text"),
        })
        .collect();
    files.sort_by(|a, b| a.name.cmp(&b.name));
    assert!(!files.is_empty(), "there are claims");
    files
}

/// A number that changes with every commit: the commit's hash, without git that of `text`.
///
/// What is chosen by it is another at every commit, and the same for everybody who tests one.
#[must_use]
pub fn draw(text: &str) -> u64 {
    let git = Command::new("git")
        .args(["rev-parse", "HEAD"])
        .current_dir(root())
        .output();
    let hash = git.ok().filter(|it| it.status.success());
    let hash = hash.and_then(|it| String::from_utf8(it.stdout).ok());
    let hash = hash.filter(|it| it.trim().len() == 40);
    fnv1a(hash.as_deref().unwrap_or(text).as_bytes())
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// The places of two seeds to live again: the first, and another that the commit chooses.
///
/// ```
/// let [first, other] = cla_tests::claims::two_of(20, "text");
/// assert!(first == 0 && (1..20).contains(&other));
/// ```
#[must_use]
pub fn two_of(seeds: usize, text: &str) -> [usize; 2] {
    let others = (seeds.max(2) - 1) as u64;
    [0, 1 + (draw(text) % others) as usize]
}
