//! Under which circumstances a run was made, `run.json`: command, commit, machine and duration.
//!
//! None of it decides a result, so none of it stands in the summary.

use std::process::Command;
use std::time::Instant;

use serde_json::json;

use super::place::now;

/// What is noted of a run besides its results.
///
/// ```
/// use host_sim::report::Circumstances;
/// let noted = Circumstances::begin().to_json("host-sim angle");
/// let noted: serde_json::Value = serde_json::from_str(&noted)?;
/// assert_eq!(noted["command"], "host-sim angle");
/// assert!(noted["seconds"].as_f64().is_some_and(|it| it >= 0.0));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Circumstances {
    begun: String,
    clock: Instant,
    commit: Option<String>,
}

impl Circumstances {
    /// The name of their file.
    pub const NAME: &'static str = "run.json";

    /// At the beginning of a run.
    #[must_use]
    pub fn begin() -> Self {
        Self {
            begun: now(),
            clock: Instant::now(),
            commit: commit(),
        }
    }

    /// The commit of the checkout that the program was built from, `-dirty` when something in it has
    /// changed; `None` where there is none any more.
    #[must_use]
    pub fn commit(&self) -> Option<&str> {
        self.commit.as_deref()
    }

    /// At its end; a run that was resumed tells of its last part.
    #[must_use]
    pub fn to_json(&self, command: &str) -> String {
        let noted = json!({
            "command": command,
            "commit": self.commit,
            "host": {
                "name": said("uname", &["-n"]),
                "system": std::env::consts::OS,
                "architecture": std::env::consts::ARCH,
                "processors": std::thread::available_parallelism().ok().map(|it| it.get()),
            },
            "begun": self.begun,
            "seconds": self.clock.elapsed().as_secs_f64(),
        });
        format!("{noted:#}\n")
    }
}

/// What a program says in one line; nothing where there is no such program or it fails.
fn said(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output();
    let output = output.ok().filter(|it| it.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

fn commit() -> Option<String> {
    let checkout = env!("CARGO_MANIFEST_DIR");
    let describe = "describe --always --dirty --abbrev=40 --exclude=*";
    let arguments: Vec<&str> = ["-C", checkout]
        .into_iter()
        .chain(describe.split(' '))
        .collect();
    said("git", &arguments)
}
