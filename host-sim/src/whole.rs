//! Files that are whole or not there, and files of a bounded size.
//!
//! A pipe may never end and a device has no end: neither is read, and neither is replaced by a file.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::Path;

use crate::failure::{Failure, Impossible};

/// Reads a file of at most so many bytes.
///
/// # Errors
/// [`Impossible`] says why there is no such file in the words that come after "cannot read": it is not
/// there, it is no regular file, or it is too long.
///
/// ```
/// use host_sim::whole::read;
/// use std::path::Path;
/// assert!(read(Path::new("Cargo.toml"), 1 << 20).is_ok());
/// let long = read(Path::new("Cargo.toml"), 10).unwrap_err();
/// assert_eq!(long.to_string(), "it has more than 10 bytes");
/// # #[cfg(unix)]
/// assert_eq!(read(Path::new("/dev/zero"), 10).unwrap_err().to_string(), "it is no file");
/// ```
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, Impossible> {
    // Before it is opened: opening a pipe waits for whoever writes.
    let about = fs::metadata(path).map_err(Impossible::new)?;
    if !about.is_file() {
        return Err(Impossible::new("it is no file"));
    }
    let long = || Impossible::new(format!("it has more than {most} bytes"));
    if about.len() > most {
        return Err(long());
    }
    let file = File::open(path).map_err(Impossible::new)?;
    let mut bytes = Vec::new();
    // It may grow meanwhile.
    let read = file.take(most.saturating_add(1)).read_to_end(&mut bytes);
    read.map_err(Impossible::new)?;
    if bytes.len() as u64 > most {
        return Err(long());
    }
    Ok(bytes)
}

/// As [`read`], for a text.
///
/// # Errors
/// As [`read`], and for bytes that are no text in UTF-8.
pub fn read_text(path: &Path, most: u64) -> Result<String, Impossible> {
    String::from_utf8(read(path, most)?).map_err(|_| Impossible::new("it is no text in UTF-8"))
}

/// Writes a whole file in place of what was there.
///
/// It is written beside its place, flushed to the disk and renamed, so whoever reads finds the old
/// bytes or the new ones.
///
/// # Errors
/// When it cannot be written, or its place is taken by what is no file; what was there stays.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |error| format!("cannot write {}: {error}", path.display());
    if fs::metadata(path).is_ok_and(|about| !about.is_file()) {
        return Err(format!("cannot write {}: it is no file", path.display()).into());
    }
    let name = path.file_name().ok_or("a file needs a name")?;
    let mut beside = name.to_owned();
    beside.push(format!(".unfinished.{}", std::process::id()));
    let beside = path.with_file_name(beside);
    let write = || {
        let mut file = File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&beside, path)
    };
    write().map_err(|error| {
        // What was begun is of no use to anybody.
        let _ = fs::remove_file(&beside);
        failed(error)
    })?;
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::net::UnixListener;
    use std::path::Path;
    use std::{env, fs, process};

    use super::{read, read_text, write};

    #[test]
    fn what_is_no_file_is_neither_read_nor_replaced() {
        let folder = env::temp_dir().join(format!("whole-{}", process::id()));
        fs::create_dir_all(&folder).unwrap();
        let socket = folder.join("socket");
        let _bound = UnixListener::bind(&socket).unwrap();
        for path in [Path::new("/dev/zero"), &socket, &folder] {
            assert_eq!(
                read(path, 1 << 40).unwrap_err().to_string(),
                "it is no file"
            );
            let refused = write(path, b"new").unwrap_err().to_string();
            assert!(refused.ends_with("it is no file"), "{refused}");
        }
        let file = folder.join("file");
        write(&file, b"one \xff").unwrap();
        assert_eq!(read(&file, 5).unwrap(), b"one \xff");
        assert!(
            read_text(&file, 5)
                .unwrap_err()
                .to_string()
                .contains("UTF-8")
        );
        assert!(read(&file, 4).is_err() && read(&folder.join("none"), 4).is_err());
        fs::remove_dir_all(folder).unwrap();
    }
}
