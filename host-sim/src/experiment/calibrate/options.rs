//! What the calibration varies: nothing but the conditions of the Stage runs.

use serde::Serialize;

use super::trial::{Condition, Driver};

/// The conditions.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CalibrateOptions {
    /// In their order.
    pub conditions: Vec<Condition>,
}

impl CalibrateOptions {
    /// The servo and the random controller in every condition.
    #[must_use]
    pub fn standard() -> Self {
        let drivers = [Driver::Sector, Driver::Random];
        Self {
            conditions: drivers.into_iter().flat_map(Condition::all).collect(),
        }
    }
}
