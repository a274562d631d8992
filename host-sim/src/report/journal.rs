//! The journal of a run, `trials.jsonl`: what the run is about on its first line, then one finished
//! trial a line, each on the disk before the next is begun.
//!
//! Whoever holds the journal's lock is the only writer of its directory; the system lets go of the
//! lock when a process ends, however it ends.
//! A line that was cut off by a dead process is no line: it is removed and its trial made again.

use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{error, fmt};

use serde_json::Value;

use super::output::Output;

/// What a run does about an earlier one in its directory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// There must be none.
    Fresh,
    /// It is given up.
    Force,
    /// It is gone on with.
    Resume,
}

/// Why there is no journal, or not this one.
#[derive(Debug)]
pub enum JournalError {
    /// There is an earlier run in the directory.
    Used(PathBuf),
    /// Another run writes to the directory at this moment.
    Busy(PathBuf),
    /// There is no run to go on with in the directory.
    Nothing(PathBuf),
    /// The run that should go on is another one: how it differs, in words.
    Differs(String),
    /// The journal cannot be read or written.
    Io(PathBuf, io::Error),
}

impl fmt::Display for JournalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Used(at) => write!(
                f,
                "{} holds a run already: --resume goes on with it, --force replaces it",
                at.display()
            ),
            Self::Busy(at) => write!(f, "another run is writing to {}", at.display()),
            Self::Nothing(at) => write!(f, "there is no run to resume in {}", at.display()),
            Self::Differs(how) => write!(f, "cannot resume: {how}"),
            Self::Io(at, source) => write!(f, "cannot write to {}: {source}", at.display()),
        }
    }
}

impl error::Error for JournalError {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        match self {
            Self::Io(_, source) => Some(source),
            _ => None,
        }
    }
}

/// A journal that is open for writing, by this process alone.
///
/// ```
/// use host_sim::report::{Begin, Journal, Output};
/// use serde_json::json;
/// let directory = std::env::temp_dir().join("cla-journal-example");
/// let output = Output::prepare(&directory)?;
/// let journal = Journal::open(&output, Begin::Fresh)?;
/// assert!(journal.begin(&json!({"seeds": [1, 2]}))?.is_empty());
/// journal.append("0.25")?;
/// // Another run is refused while this one lives, and told of it afterwards.
/// assert!(Journal::open(&output, Begin::Force).is_err());
/// drop(journal);
/// assert!(Journal::open(&output, Begin::Fresh).is_err());
/// let again = Journal::open(&output, Begin::Resume)?;
/// let other = again.begin(&json!({"seeds": [1, 3]})).unwrap_err().to_string();
/// assert_eq!(other, "cannot resume: seeds[1] was 2 and is 3");
/// assert_eq!(again.begin(&json!({"seeds": [1, 2]}))?, ["0.25"]);
/// # std::fs::remove_dir_all(directory)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Journal {
    directory: PathBuf,
    earlier: Vec<String>,
    end: Mutex<End>,
}

/// The file and the bytes of its whole lines.
#[derive(Debug)]
struct End {
    file: File,
    length: u64,
}

impl Journal {
    /// The file's name.
    pub const NAME: &'static str = "trials.jsonl";
    /// The parameter of a summary that is not of all trials: how many it is of.
    pub const UNFINISHED: &'static str = "unfinished";

    /// Opens the journal of a directory and keeps all others from writing there.
    ///
    /// # Errors
    /// [`JournalError`]; what an earlier or a living run has written is then as it was.
    pub fn open(output: &Output, begin: Begin) -> Result<Self, JournalError> {
        let directory = output.directory().to_owned();
        let (path, summary) = (directory.join(Self::NAME), directory.join(Output::SUMMARY));
        let io = |source| JournalError::Io(path.clone(), source);
        match begin {
            Begin::Fresh if summary.exists() => return Err(JournalError::Used(directory)),
            Begin::Resume if !path.exists() => return Err(JournalError::Nothing(directory)),
            _ => {}
        }
        let mut options = File::options();
        options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(&path).map_err(io)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(JournalError::Busy(directory)),
            Err(TryLockError::Error(source)) => return Err(io(source)),
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(io)?;
        match begin {
            // Looked at again: the run that held the lock a moment ago may have ended well.
            Begin::Fresh if !bytes.is_empty() || summary.exists() => {
                return Err(JournalError::Used(directory));
            }
            Begin::Fresh | Begin::Resume => {}
            Begin::Force => {
                bytes.clear();
                // Without its trials the earlier summary would be taken for that of the new run.
                if summary.exists() {
                    fs::remove_file(&summary).map_err(io)?;
                }
            }
        }
        output.tidy();
        let whole = bytes.iter().rposition(|&byte| byte == b'\n');
        bytes.truncate(whole.map_or(0, |at| at + 1));
        let length = bytes.len() as u64;
        let end = End { file, length };
        let earlier = String::from_utf8(bytes)
            .map_err(|_| JournalError::Differs(format!("{} is no text", path.display())))?;
        let journal = Self {
            directory,
            earlier: earlier.lines().map(str::to_owned).collect(),
            end: Mutex::new(end),
        };
        journal.locked(End::cut).map_err(io)?;
        Ok(journal)
    }

    /// Where the journal lies.
    #[must_use]
    pub fn directory(&self) -> &Path {
        &self.directory
    }

    /// Says what the run is about; returns the lines of the trials that it has already.
    ///
    /// # Errors
    /// [`JournalError::Differs`] when the run that should go on was about something else.
    pub fn begin(&self, about: &Value) -> Result<Vec<String>, JournalError> {
        let text = about.to_string();
        let Some((first, trials)) = self.earlier.split_first() else {
            self.append(&text)?;
            return Ok(Vec::new());
        };
        // Both as they are read, so that equal numbers are equal.
        let read = |text: &str| serde_json::from_str::<Value>(text).ok();
        let (Some(was), Some(is)) = (read(first), read(&text)) else {
            let sentence = "the first line of the journal is none of ours".to_owned();
            return Err(JournalError::Differs(sentence));
        };
        match difference("", &was, &is) {
            Some(how) => Err(JournalError::Differs(how)),
            None => Ok(trials.to_vec()),
        }
    }

    /// The first difference between what two runs are about, in words; `None` when they are the same.
    #[must_use]
    pub fn difference(was: &Value, is: &Value) -> Option<String> {
        difference("", was, is)
    }

    /// Adds a line, which is on the disk afterwards.
    ///
    /// # Errors
    /// [`JournalError::Io`]; the journal then ends where it ended.
    pub fn append(&self, line: &str) -> Result<(), JournalError> {
        let written = self.locked(|end| {
            let bytes = format!("{line}\n");
            let written = end.file.write_all(bytes.as_bytes());
            match written.and_then(|()| end.file.sync_data()) {
                Ok(()) => {
                    end.length += bytes.len() as u64;
                    Ok(())
                }
                // The failure to report is this one, whether or not half a line can be removed.
                failed => end.cut().and(failed),
            }
        });
        written.map_err(|source| JournalError::Io(self.directory.join(Self::NAME), source))
    }

    fn locked<T>(&self, job: impl FnOnce(&mut End) -> T) -> T {
        job(&mut self.end.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl End {
    /// Ends the file after its whole lines.
    fn cut(&mut self) -> io::Result<()> {
        self.file.set_len(self.length)?;
        self.file.seek(SeekFrom::Start(self.length)).map(|_| ())
    }
}

/// The first difference of two values, in words; `path` says where they stand.
fn difference(path: &str, was: &Value, is: &Value) -> Option<String> {
    match (was, is) {
        (Value::Object(a), Value::Object(b)) => {
            let names = a
                .keys()
                .chain(b.keys().filter(|name| !a.contains_key(*name)));
            names.into_iter().find_map(|name| {
                let dot = if path.is_empty() { "" } else { "." };
                let path = format!("{path}{dot}{name}");
                let value = |of: &serde_json::Map<String, Value>| of.get(name).cloned();
                difference(
                    &path,
                    &value(a).unwrap_or_default(),
                    &value(b).unwrap_or_default(),
                )
            })
        }
        (Value::Array(a), Value::Array(b)) if a.len() != b.len() => Some(format!(
            "{path} had {} entries and has {}",
            a.len(),
            b.len()
        )),
        (Value::Array(a), Value::Array(b)) => a
            .iter()
            .zip(b)
            .enumerate()
            .find_map(|(at, (a, b))| difference(&format!("{path}[{at}]"), a, b)),
        _ => (was != is).then(|| format!("{path} was {was} and is {is}")),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use serde_json::json;

    use super::{Begin, Journal, JournalError, Output, difference};

    #[test]
    fn a_line_that_was_cut_off_is_no_line() {
        let directory = std::env::temp_dir().join(format!("cla-journal-{}", std::process::id()));
        let output = Output::prepare(&directory).unwrap();
        let path = directory.join(Journal::NAME);
        let about = json!({"seeds": 3});
        let whole = "{\"seeds\":3}\n1\n2\n";
        for cut in 0..=whole.len() {
            fs::write(&path, &whole[..cut]).unwrap();
            let journal = Journal::open(&output, Begin::Resume).unwrap();
            let lines = journal.begin(&about).unwrap();
            assert_eq!(
                lines.len(),
                whole[..cut].matches('\n').count().saturating_sub(1)
            );
            journal.append("new").unwrap();
            let text = fs::read_to_string(&path).unwrap();
            assert!(text.starts_with("{\"seeds\":3}\n") && text.ends_with("new\n"));
            assert_eq!(text.lines().count(), lines.len() + 2, "{text}");
        }
        fs::remove_dir_all(&directory).unwrap();
    }

    #[test]
    fn force_gives_up_what_there_is_and_only_when_nobody_writes() {
        let directory = std::env::temp_dir().join(format!("cla-forced-{}", std::process::id()));
        let output = Output::prepare(&directory).unwrap();
        output.write(Output::SUMMARY, b"{}").unwrap();
        assert!(matches!(
            Journal::open(&output, Begin::Fresh),
            Err(JournalError::Used(_))
        ));
        assert!(matches!(
            Journal::open(&output, Begin::Resume),
            Err(JournalError::Nothing(_))
        ));
        // What a living run has not finished yet is not touched.
        fs::write(directory.join(".a.png.1.unfinished"), b"half").unwrap();
        let journal = Journal::open(&output, Begin::Force).unwrap();
        assert!(!directory.join(Output::SUMMARY).exists());
        assert!(!directory.join(".a.png.1.unfinished").exists());
        fs::write(directory.join(".b.png.2.unfinished"), b"half").unwrap();
        for begin in [Begin::Fresh, Begin::Force, Begin::Resume] {
            let refused = Journal::open(&output, begin);
            assert!(matches!(refused, Err(JournalError::Busy(_))), "{begin:?}");
        }
        assert!(directory.join(".b.png.2.unfinished").exists());
        drop(journal);
        fs::remove_dir_all(&directory).unwrap();
    }

    #[test]
    fn the_first_difference_is_named_with_its_place() {
        let was = json!({"a": {"b": [1, 2.5]}, "c": "x"});
        let differs = |is| difference("", &was, &is);
        assert_eq!(differs(was.clone()), None);
        assert_eq!(
            differs(json!({"a": {"b": [1, 2.25]}, "c": "x"})).unwrap(),
            "a.b[1] was 2.5 and is 2.25"
        );
        assert_eq!(
            differs(json!({"a": {"b": [1]}, "c": "x"})).unwrap(),
            "a.b had 2 entries and has 1"
        );
        assert_eq!(
            differs(json!({"a": {"b": [1, 2.5]}, "c": "x", "d": 1})).unwrap(),
            "d was null and is 1"
        );
    }
}
