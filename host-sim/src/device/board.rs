//! The emulated boards: building the firmware for one, running it, reading what it prints.
//!
//! Builds take turns: cargo writes every variant of a program to the same place, so each is copied
//! away before the next begins.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::{env, fs};

use object::{Object, ObjectSection};

use super::target::Target;
use crate::failure::{Failure, Impossible};

/// What to build.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Build {
    /// For which processor.
    pub target: Target,
    /// The program in `firmware-example`.
    pub program: &'static str,
    /// Features of `firmware-example`.
    pub features: &'static str,
    /// The part whose memory it must fit; without one the board's own.
    pub part: Option<&'static str>,
    /// Cargo's level of optimization: `3` or `s`.
    pub opt_level: &'static str,
    /// The entry of `panic_free` that is linked; all when empty.
    pub entry: &'static str,
}

impl Build {
    /// A program at full optimization for a board's own memory.
    #[must_use]
    pub const fn new(target: Target, program: &'static str) -> Self {
        Self {
            target,
            program,
            features: "",
            part: None,
            opt_level: "3",
            entry: "",
        }
    }

    /// Builds it and answers where a copy of its own lies.
    ///
    /// # Errors
    /// The compiler's or linker's words, or why cargo could not be run.
    pub fn build(&self) -> Result<PathBuf, Failure> {
        static TURN: Mutex<()> = Mutex::new(());
        let _turn = TURN.lock();
        let folder = folder();
        let mut cargo = cargo();
        cargo.args([
            "build",
            "--release",
            "--locked",
            "--quiet",
            "--bin",
            self.program,
        ]);
        cargo.args([
            "--target",
            self.target.triple(),
            "--features",
            self.features,
        ]);
        cargo.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", self.opt_level);
        cargo.env_remove("PART").env_remove("ENTRY");
        cargo.envs(self.part.map(|part| ("PART", part)));
        if !self.entry.is_empty() {
            cargo.env("ENTRY", self.entry);
        }
        let output = cargo
            .output()
            .map_err(|error| Impossible::new(format!("cargo cannot be run: {error}")))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into());
        }
        let target = folder.join("target");
        let built = target
            .join(self.target.triple())
            .join("release")
            .join(self.program);
        let name = [
            self.program,
            self.target.triple(),
            self.features,
            self.part.unwrap_or("board"),
            self.opt_level,
            self.entry,
        ];
        let copy = target.join("programs").join(name.join("+"));
        fs::create_dir_all(target.join("programs"))?;
        fs::copy(built, &copy)?;
        Ok(copy)
    }

    /// Builds it, runs it to its end and answers what it printed.
    ///
    /// # Errors
    /// As [`build`](Self::build); or no emulator, or an exit code other than 0, with its last words.
    pub fn run(&self) -> Result<Printed, Failure> {
        let mut emulator = self.target.emulator(&self.build()?);
        let name = emulator.get_program().to_string_lossy().into_owned();
        let output = emulator
            .output()
            .map_err(|error| Impossible::new(format!("{name} cannot be run: {error}")))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        if output.status.success() {
            Ok(Printed(text))
        } else {
            let complaints = String::from_utf8_lossy(&output.stderr);
            let status = output.status;
            Err(format!(
                "{name} on {} ended with {status}:\n{text}{complaints}",
                self.target.name()
            )
            .into())
        }
    }
}

/// What a program printed: lines of names and numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printed(String);

impl From<String> for Printed {
    fn from(text: String) -> Self {
        Self(text)
    }
}

impl Printed {
    /// The whole text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0
    }

    /// The rest of the first line that begins with `start`, without blanks around it.
    ///
    /// # Errors
    /// When no line begins so.
    pub fn after(&self, start: &str) -> Result<&str, Impossible> {
        let mut lines = self.0.lines();
        let rest = lines.find_map(|line| line.strip_prefix(start));
        rest.map(str::trim).ok_or_else(|| {
            Impossible::new(format!("the firmware printed no {start:?}:\n{}", self.0))
        })
    }

    /// The number after `start` and, in the same line, after `word`.
    ///
    /// # Errors
    /// When there is none.
    pub fn number(&self, start: &str, word: &str) -> Result<u64, Impossible> {
        let line = self.after(start)?;
        let mut words = line.split_whitespace().peekable();
        if !word.is_empty() {
            words.by_ref().find(|&other| other == word);
        }
        let number = words.next().and_then(|digits| digits.parse().ok());
        number.ok_or_else(|| Impossible::new(format!("no number after {start} … {word}: {line}")))
    }
}

/// Bytes of the sections of a program whose names begin with `name`.
///
/// # Errors
/// For a file that cannot be read or is no program.
pub fn section_bytes(program: &Path, name: &str) -> Result<u64, Failure> {
    let bytes = fs::read(program)?;
    let file = object::File::parse(&*bytes)?;
    let sections = file.sections();
    let named = sections.filter(|it| it.name().is_ok_and(|it| it.starts_with(name)));
    Ok(named.map(|it| it.size()).sum())
}

/// The folder of the firmware, beside this crate's.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../firmware-example")
}

/// A cargo that builds the firmware as its user would: in its folder, with its settings and not
/// with those of the build that runs this.
#[must_use]
pub fn cargo() -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let ours = |name: &OsStr| {
        let name = name.to_string_lossy();
        name.starts_with("CARGO_BUILD") || name.contains("RUSTFLAGS") || name == "CARGO_TARGET_DIR"
    };
    for (name, _) in env::vars_os().filter(|(name, _)| ours(name)) {
        cargo.env_remove(name);
    }
    cargo.current_dir(folder());
    cargo
}

#[cfg(test)]
mod tests {
    use super::Printed;

    #[test]
    fn numbers_are_found_by_the_words_before_them() {
        let printed = Printed("learn instructions mean 12 worst 34\nstack bytes 5\n".to_owned());
        assert_eq!(printed.number("learn instructions", "worst"), Ok(34));
        assert_eq!(printed.number("stack bytes", ""), Ok(5));
        assert!(printed.number("stack bytes", "worst").is_err());
        assert!(printed.after("flash").is_err());
    }
}
