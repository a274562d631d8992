//! Where a run goes: a directory of its own below `runs/`, named by its time, or one that was asked
//! for.
//!
//! `latest` beside the directories of an experiment is a link to the one that was begun last.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use super::journal::{Begin, Journal, JournalError};
use super::output::Output;

/// The link to the last run of an experiment.
const LATEST: &str = "latest";

/// Where a run goes, and what it does about an earlier one there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The directory of all runs of the experiment.
    pub home: PathBuf,
    /// The directory that was asked for; `None` for one by the time.
    pub asked: Option<PathBuf>,
    /// What is done about an earlier run.
    pub begin: Begin,
}

impl Place {
    /// Makes the directory and opens its journal.
    ///
    /// # Errors
    /// [`JournalError`] when it cannot be written to, is in use, or holds another run.
    ///
    /// ```
    /// use host_sim::report::{Begin, Place};
    /// let home = std::env::temp_dir().join("cla-place-example");
    /// let place = |begin| Place { home: home.clone(), asked: None, begin };
    /// let (first, _journal) = place(Begin::Fresh).open()?;
    /// let (second, journal) = place(Begin::Fresh).open()?;
    /// assert_ne!(first.directory(), second.directory());
    /// drop(journal);
    /// let (again, _journal) = place(Begin::Resume).open()?;
    /// # #[cfg(unix)]
    /// assert_eq!(again.directory(), second.directory());
    /// # std::fs::remove_dir_all(home)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn open(&self) -> Result<(Output, Journal), JournalError> {
        let failed = |path: &Path| {
            let path = path.to_owned();
            move |source: io::Error| JournalError::Io(path, source)
        };
        let directory = match (&self.asked, self.begin) {
            (Some(asked), Begin::Resume) if !asked.is_dir() => {
                return Err(JournalError::Nothing(asked.clone()));
            }
            (Some(asked), _) => asked.clone(),
            (None, Begin::Resume) => {
                let latest = self.home.join(LATEST);
                // A link is followed here, so that the files are named by their own place.
                let target = fs::read_link(&latest).map(|it| self.home.join(it));
                target.map_err(|_| JournalError::Nothing(latest))?
            }
            (None, Begin::Fresh | Begin::Force) => self.by_time().map_err(failed(&self.home))?,
        };
        let output =
            Output::prepare(&directory).map_err(|it| JournalError::Io(directory, it.into()))?;
        let journal = Journal::open(&output, self.begin)?;
        Ok((output, journal))
    }

    /// A new directory with a name that nobody else has, and the link to it.
    fn by_time(&self) -> io::Result<PathBuf> {
        fs::create_dir_all(&self.home)?;
        // Colons are no part of a name on some systems.
        let now = now().replace(':', "-");
        let mut name = now.clone();
        let mut more = 1_u32;
        let directory = loop {
            let directory = self.home.join(&name);
            match fs::create_dir(&directory) {
                Ok(()) => break directory,
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                    more += 1;
                    name = format!("{now}-{more}");
                }
                Err(error) => return Err(error),
            }
        };
        self.link(&name)?;
        Ok(directory)
    }

    /// Lets `latest` lead to a directory, in place of where it led.
    #[cfg(unix)]
    fn link(&self, name: &str) -> io::Result<()> {
        let beside = self.home.join(format!(".{LATEST}.{name}"));
        std::os::unix::fs::symlink(name, &beside)?;
        fs::rename(&beside, self.home.join(LATEST))
    }

    /// There are no links that everybody may make.
    #[cfg(not(unix))]
    fn link(&self, _: &str) -> io::Result<()> {
        Ok(())
    }
}

/// The time, to the second, in UTC.
pub(super) fn now() -> String {
    humantime::format_rfc3339_seconds(SystemTime::now()).to_string()
}
