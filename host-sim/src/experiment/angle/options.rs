//! What the angle study varies.

use serde::Serialize;

use super::network::AngleConfig;

/// Its seeds and parameters.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AngleOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// One set of parameters for all claims.
    pub config: AngleConfig,
}

impl AngleOptions {
    /// The standard parameters.
    #[must_use]
    pub const fn standard(seeds: Vec<u64>) -> Self {
        Self {
            seeds,
            config: AngleConfig::STANDARD,
        }
    }
}
