//! What the study of words varies.

use serde::Serialize;

use super::network::ListenerConfig;

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WordsOptions {
    /// The seeds: an infant each.
    pub seeds: Vec<u64>,
    /// The network that listens.
    pub config: ListenerConfig,
}

impl WordsOptions {
    /// The network of all claims.
    ///
    /// ```
    /// use host_sim::experiment::words::WordsOptions;
    /// assert_eq!(WordsOptions::standard(vec![1, 2]).seeds.len(), 2);
    /// ```
    #[must_use]
    pub const fn standard(seeds: Vec<u64>) -> Self {
        Self {
            seeds,
            config: ListenerConfig::STANDARD,
        }
    }
}
