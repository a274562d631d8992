//! How what follows an item's success counts a step before.

use super::belief::Row;
use super::config::Level2Config;
use crate::choice::ValueConfig;
use crate::snapshot::stored;

/// How what follows counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rates {
    pub(super) discount: f32,
    pub(super) experience: f32,
}

impl Rates {
    pub(super) const NONE: Self = Self {
        discount: 0.0,
        experience: 0.0,
    };

    pub(super) const fn of(values: &ValueConfig, config: &Level2Config) -> Self {
        Self {
            discount: values.discount,
            experience: config.experience,
        }
    }

    /// The discounted value of the state after the success of a row's schema.
    pub(super) fn then<const ACTIONS: usize>(&self, row: &Row<ACTIONS>) -> f32 {
        self.discount * (row.value + self.experience * (row.experienced - row.value))
    }
}

stored! { impl[] Rates { discount => up_to 1.0, experience => up_to 1.0 } }
