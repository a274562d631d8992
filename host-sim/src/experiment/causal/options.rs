//! What the causal experiment varies.

use serde::Serialize;

use super::network::CausalConfig;

/// Its seeds and parameters.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CausalOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// One set of parameters for all claims.
    pub config: CausalConfig,
}

impl CausalOptions {
    /// The standard parameters.
    #[must_use]
    pub fn standard(seeds: Vec<u64>) -> Self {
        Self {
            seeds,
            config: CausalConfig::standard(),
        }
    }
}
