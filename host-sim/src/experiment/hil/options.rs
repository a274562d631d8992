//! What a life in the loop varies.

use serde::Serialize;

use crate::failure::Impossible;
use crate::world::setting::MOST_ACTIONS;

/// Its seeds and lengths.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct HilOptions {
    /// Which lives.
    pub seeds: Vec<u64>,
    /// Actions of training with one level, and as many with both.
    pub actions: u32,
    /// Actions of the test.
    pub test_actions: u32,
}

impl HilOptions {
    /// Lives with at least one action in each part.
    ///
    /// # Errors
    /// [`Impossible`] otherwise.
    pub fn new(seeds: Vec<u64>, actions: u32, test_actions: u32) -> Result<Self, Impossible> {
        if actions == 0 || test_actions == 0 {
            return Err(Impossible::new(
                "--actions and --test-actions must be at least 1",
            ));
        }
        if actions.max(test_actions) > MOST_ACTIONS {
            let sentence = format!("--actions and --test-actions must be at most {MOST_ACTIONS}");
            return Err(Impossible::new(sentence));
        }
        Ok(Self {
            seeds,
            actions,
            test_actions,
        })
    }
}
