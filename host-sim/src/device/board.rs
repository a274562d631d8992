//! The emulated boards: building the firmware for one, running it, reading what it prints.
//!
//! Builds take turns: cargo writes every variant of a program to the same place, so each is copied
//! away before the next begins. A copy takes its place at once, by its name: an emulator that still
//! reads the one before keeps it.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::{env, fs, io, process};

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
        let folder = folder()?;
        let mut cargo = cargo(&folder);
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
        let programs = target.join("programs");
        fs::create_dir_all(&programs)?;
        let copy = programs.join(name.join("+"));
        put(&built, &copy)?;
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

/// Copies a program over another, which those who have it open keep as it was.
fn put(program: &Path, place: &Path) -> io::Result<()> {
    let mut beside = place.as_os_str().to_owned();
    beside.push(format!(".{}", process::id()));
    fs::copy(program, &beside)?;
    fs::rename(beside, place)
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

/// The folder of the firmware, in the checkout that this program lies in, or else in the one that
/// the current directory lies in; where a checkout was when it was compiled is not asked.
///
/// # Errors
/// [`Impossible`] when neither lies in a checkout.
pub fn folder() -> Result<PathBuf, Impossible> {
    let starts = [env::current_exe().ok(), env::current_dir().ok()];
    let found = starts.iter().flatten().find_map(|it| firmware_above(it));
    found.ok_or_else(|| {
        Impossible::new(
            "neither the program nor the current directory lies in a checkout of this project, of \
             which the firmware in firmware-example is built; run it there",
        )
    })
}

/// The folder of the firmware beside the core, in the nearest directory above that has both.
fn firmware_above(place: &Path) -> Option<PathBuf> {
    let both = ["firmware-example", "cla-core"];
    let whole = |root: &&Path| {
        let mut folders = both.iter().map(|it| root.join(it).join("Cargo.toml"));
        folders.all(|it| it.is_file())
    };
    let root = place.ancestors().find(whole)?;
    Some(root.join(both[0]))
}

/// Whether everything is there that builds the firmware for some processors and emulates them.
///
/// # Errors
/// [`Impossible`] with the first thing that is missing and how to install it.
pub fn look_for_tools(what: &str, targets: &[Target]) -> Result<(), Impossible> {
    let folder = folder()?;
    let missing = |it: &str, how: &str| {
        Impossible::new(format!("{what} needs {it}, which is missing: {how}"))
    };
    let rust = "https://rustup.rs installs it";
    if !starts(cargo(&folder).arg("--version")) {
        return Err(missing("cargo", rust));
    }
    let mut rustc = Command::new("rustc");
    let sysroot = rustc.args(["--print", "sysroot"]).current_dir(&folder);
    let sysroot = sysroot.output().map_err(|_| missing("rustc", rust))?;
    let sysroot = String::from_utf8_lossy(&sysroot.stdout).trim().to_owned();
    for target in targets {
        let triple = target.triple();
        if !Path::new(&sysroot)
            .join("lib/rustlib")
            .join(triple)
            .is_dir()
        {
            let it = format!("the Rust target {triple}");
            return Err(missing(&it, &format!("rustup target add {triple}")));
        }
        let (qemu, package) = target.qemu();
        if !starts(Command::new(qemu).arg("--version")) {
            let how = format!("apt-get install {package} on Debian, brew install qemu on macOS");
            return Err(missing(qemu, &how));
        }
    }
    Ok(())
}

/// Whether a program can be started and ends well.
fn starts(program: &mut Command) -> bool {
    program.output().is_ok_and(|it| it.status.success())
}

/// A cargo that builds the firmware as its user would: in its folder, with its settings and not
/// with those of the build that runs this.
fn cargo(folder: &Path) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let ours = |name: &OsStr| {
        let name = name.to_string_lossy();
        name.starts_with("CARGO_BUILD") || name.contains("RUSTFLAGS") || name == "CARGO_TARGET_DIR"
    };
    for (name, _) in env::vars_os().filter(|(name, _)| ours(name)) {
        cargo.env_remove(name);
    }
    cargo.current_dir(folder);
    cargo
}

#[cfg(test)]
mod tests {
    use std::io::Read;
    use std::path::Path;
    use std::{env, fs, process};

    use super::{Printed, firmware_above, folder, put};

    #[test]
    fn a_program_that_is_being_read_is_not_written_over() {
        let place = env::temp_dir().join(format!("cla-programs-{}", process::id()));
        fs::create_dir_all(&place).unwrap();
        let (built, copy) = (place.join("built"), place.join("copy"));
        for letter in ["first", "next"] {
            fs::write(&built, letter).unwrap();
            put(&built, &copy).unwrap();
            let mut open = fs::File::open(&copy).unwrap();
            fs::write(&built, "other").unwrap();
            put(&built, &copy).unwrap();
            let mut read = String::new();
            open.read_to_string(&mut read).unwrap();
            assert_eq!(read, letter);
            assert_eq!(fs::read_to_string(&copy).unwrap(), "other");
        }
        fs::remove_dir_all(place).unwrap();
    }

    #[test]
    fn the_firmware_is_that_of_the_checkout_that_the_program_lies_in() {
        let folder = folder().unwrap();
        assert!(folder.join("src/bin").is_dir());
        let root = folder.parent().unwrap();
        assert_eq!(
            firmware_above(&root.join("host-sim/src")),
            Some(folder.clone())
        );
        assert_eq!(firmware_above(Path::new("/")), None);
    }

    #[test]
    fn numbers_are_found_by_the_words_before_them() {
        let printed = Printed("learn instructions mean 12 worst 34\nstack bytes 5\n".to_owned());
        assert_eq!(printed.number("learn instructions", "worst"), Ok(34));
        assert_eq!(printed.number("stack bytes", ""), Ok(5));
        assert!(printed.number("stack bytes", "worst").is_err());
        assert!(printed.after("flash").is_err());
    }
}
