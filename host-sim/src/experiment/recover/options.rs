//! What the recovery experiment varies.

use super::life::Protocol;
use crate::world::config::PioneerConfig;
use crate::world::damage::Damage;
use crate::world::setting::WorldOptions;

/// What is varied.
#[derive(Clone, Debug, PartialEq)]
pub struct RecoverOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// The world of all lives.
    pub world: WorldOptions,
    /// What breaks, one after another in lives of their own; at least one.
    pub damages: Vec<Damage>,
    /// How long everything takes.
    pub protocol: Protocol,
}

impl RecoverOptions {
    /// Whether this is another world or length than the one that the claims are about.
    #[must_use]
    pub fn is_varied(&self) -> bool {
        self.world.config != PioneerConfig::NOISY
            || self.world.layout.is_some()
            || self.protocol != Protocol::STANDARD
    }
}
