//! What the recovery experiment varies.

use serde::Serialize;
use serde_json::json;

use super::life::Protocol;
use crate::experiment::settled::{file, room};
use crate::failure::Impossible;
use crate::settings::tree_of;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::damage::{Damage, Damaged};
use crate::world::pioneer::{ACTIONS, ITEMS};
use crate::world::setting::WorldOptions;

/// Least undamaged actions, a point of a curve, and damaged ones, the first that are judged.
const LEAST_BEFORE: u32 = 1000;
const LEAST_AFTER: u32 = 3000;
/// Most damages of one run.
const MOST_DAMAGES: usize = 100;

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
    /// The standard protocol in a world, with damages by their texts; `all` are all that are
    /// reported.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be.
    pub fn new(
        seeds: Vec<u64>,
        world: WorldOptions,
        damages: &[String],
    ) -> Result<Self, Impossible> {
        if world.config.after_capture == AfterCapture::Removed {
            let sentence =
                "--removed does not go with recover: a cleared room teaches nothing more";
            return Err(Impossible::new(sentence));
        }
        let mut read = Vec::new();
        for text in damages {
            let texts = match text.as_str() {
                "all" => &Damage::REPORTED[..],
                one => &[one],
            };
            for text in texts {
                let damage = Damage::parse(text, &ITEMS, &ACTIONS);
                read.push(damage.map_err(|error| Impossible::new(format!("--damage: {error}")))?);
            }
        }
        if read.len() > MOST_DAMAGES {
            let sentence = format!("--damage may be given {MOST_DAMAGES} times at most");
            return Err(Impossible::new(sentence));
        }
        for &seed in &seeds {
            world.build(seed)?;
        }
        for &damage in &read {
            Damaged::new(world.build(0)?, damage, 0).map_err(Impossible::new)?;
        }
        Ok(Self {
            seeds,
            world,
            damages: read,
            protocol: Protocol::STANDARD,
        })
    }

    /// The same lives, longer or shorter.
    ///
    /// # Errors
    /// [`Impossible`] for parts that are too long, and for later parts that are shorter than what is
    /// drawn and measured of them.
    pub fn with_protocol(self, protocol: Protocol) -> Result<Self, Impossible> {
        protocol.check()?;
        for (name, actions, least) in [
            ("before", protocol.before, LEAST_BEFORE),
            ("after", protocol.after, LEAST_AFTER),
        ] {
            if actions < least {
                let sentence = format!("protocol.{name} is at least {least} here, not {actions}");
                return Err(Impossible::new(sentence));
            }
        }
        Ok(Self { protocol, ..self })
    }

    /// All settings as a file, of which the same options come.
    ///
    /// # Errors
    /// [`Impossible`] for a value that TOML cannot say.
    pub fn file(&self) -> Result<String, Impossible> {
        let damages: Vec<String> = self.damages.iter().map(Damage::to_string).collect();
        file(
            &self.seeds,
            json!({
                "world": room(&self.world)?,
                "damages": damages,
                "protocol": tree_of(&self.protocol)?,
            }),
        )
    }

    /// Whether this is another world or length than the one that the claims are about.
    #[must_use]
    pub fn is_varied(&self) -> bool {
        self.world.config != PioneerConfig::NOISY
            || self.world.layout.is_some()
            || self.protocol != Protocol::STANDARD
    }
}
