//! The directory that a run writes to: whole files or none.
//!
//! [`Output::prepare`] is called before anything is trained, so that a run that cannot be saved
//! says so at once.
//! Every file is written beside its place and then renamed, so an interrupted run leaves no halves.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::{fmt, io, process};

use super::figure::Picture;
use super::summary::Summary;

/// The end of the names of files that are being written.
const UNFINISHED: &str = ".unfinished";

/// A directory that is known to be writable.
#[derive(Clone, Debug)]
pub struct Output {
    directory: PathBuf,
}

/// A directory or file that could not be written.
#[derive(Debug)]
pub struct OutputError {
    path: PathBuf,
    source: io::Error,
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "cannot write to {}: {}",
            self.path.display(),
            self.source
        )
    }
}

impl std::error::Error for OutputError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.source)
    }
}

impl From<OutputError> for io::Error {
    fn from(error: OutputError) -> Self {
        error.source
    }
}

impl Output {
    /// The name of the claims file.
    pub const SUMMARY: &'static str = "summary.json";

    /// Makes the directory if need be and tries to write to it.
    ///
    /// # Errors
    /// [`OutputError`] when the directory cannot be made or written to.
    ///
    /// ```
    /// use host_sim::report::Output;
    /// let directory = std::env::temp_dir().join("cla-output-example");
    /// let output = Output::prepare(&directory)?;
    /// output.write("note.txt", b"whole or not at all")?;
    /// assert_eq!(std::fs::read(directory.join("note.txt"))?, b"whole or not at all");
    /// assert!(Output::prepare(directory.join("note.txt")).is_err());
    /// # std::fs::remove_dir_all(directory)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn prepare(directory: impl AsRef<Path>) -> Result<Self, OutputError> {
        let directory = directory.as_ref();
        let failed = |source| OutputError {
            path: directory.to_owned(),
            source,
        };
        fs::create_dir_all(directory).map_err(failed)?;
        let output = Self {
            directory: directory.to_owned(),
        };
        let trial = output.unfinished("trial");
        File::create(&trial)
            .and_then(|mut file| file.write_all(b"."))
            .and_then(|()| fs::remove_file(&trial))
            .map_err(failed)?;
        Ok(output)
    }

    /// Where the files go.
    #[must_use]
    pub fn directory(&self) -> &Path {
        &self.directory
    }

    /// Removes what a dead run left unfinished; for whoever is the only writer here.
    pub(super) fn tidy(&self) {
        let entries = fs::read_dir(&self.directory);
        for entry in entries.into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().ends_with(UNFINISHED) {
                // A leftover that cannot be removed harms nobody.
                let _ = fs::remove_file(entry.path());
            }
        }
    }

    /// Writes a file whole, in place of one with the same name, and returns its path.
    ///
    /// # Errors
    /// [`OutputError`] when it cannot be written; an earlier file of that name is then unchanged.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, OutputError> {
        let path = self.directory.join(name);
        let beside = self.unfinished(name);
        let written = File::create(&beside)
            .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
            .and_then(|()| fs::rename(&beside, &path));
        match written {
            Ok(()) => Ok(path),
            Err(source) => {
                // The failure to report is the one above, whether or not this cleans up.
                let _ = fs::remove_file(&beside);
                Err(OutputError { path, source })
            }
        }
    }

    /// Writes a picture as `name.svg` and `name.png`, and its points as `name.csv`.
    ///
    /// # Errors
    /// [`OutputError`] when one of them cannot be written.
    pub fn write_picture(&self, name: &str, picture: &Picture) -> Result<PathBuf, OutputError> {
        if let Some(points) = &picture.csv {
            self.write(&format!("{name}.csv"), points.as_bytes())?;
        }
        self.write(&format!("{name}.svg"), picture.svg.as_bytes())?;
        self.write(&format!("{name}.png"), &picture.png)
    }

    /// Writes the claims file, `summary.json`.
    ///
    /// # Errors
    /// [`OutputError`] when it cannot be written.
    pub fn write_summary(&self, summary: &Summary) -> Result<PathBuf, OutputError> {
        self.write(Self::SUMMARY, summary.to_json().as_bytes())
    }

    fn unfinished(&self, name: &str) -> PathBuf {
        let file = format!(".{name}.{}{UNFINISHED}", process::id());
        self.directory.join(file)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::Output;

    #[test]
    fn nothing_unfinished_is_left_behind() {
        let directory = std::env::temp_dir().join(format!("cla-output-{}", std::process::id()));
        fs::create_dir_all(&directory).unwrap();
        fs::write(directory.join(".old.png.1.unfinished"), b"half").unwrap();
        let output = Output::prepare(&directory).unwrap();
        output.tidy();
        output.write("a.txt", b"first").unwrap();
        output.write("a.txt", b"second").unwrap();
        let names: Vec<String> = fs::read_dir(&directory)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        assert_eq!(names, ["a.txt"]);
        assert_eq!(fs::read(directory.join("a.txt")).unwrap(), b"second");
        // A name that is a directory cannot be replaced by a file: the error names it.
        fs::create_dir(directory.join("taken")).unwrap();
        let refused = output.write("taken", b"x").unwrap_err().to_string();
        assert!(refused.contains("taken"), "{refused}");
        fs::remove_dir_all(&directory).unwrap();
    }
}
