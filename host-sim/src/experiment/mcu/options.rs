//! What is varied of the brain on microcontrollers.

use serde::Serialize;

/// The seeds of the lives.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct McuOptions {
    /// Which lives.
    pub seeds: Vec<u64>,
}
