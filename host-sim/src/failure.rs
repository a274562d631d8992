//! Why something cannot be or did not come to its end: the two errors that all storeys share.

use std::{error, fmt};

/// Options that cannot be run, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Impossible(String);

impl Impossible {
    /// The sentence, without a full stop.
    #[must_use]
    pub fn new(sentence: impl fmt::Display) -> Self {
        Self(sentence.to_string().replace('\n', " "))
    }
}

impl fmt::Display for Impossible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl error::Error for Impossible {}

/// Why an experiment that could be run failed.
pub type Failure = Box<dyn error::Error + Send + Sync>;
