//! What the foraging experiment varies, and the schemas of the book that it looks for.

use cla_core::agent::AgentConfig;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::experiment::record::in_words;
use crate::experiment::settled::{file, room};
use crate::failure::Impossible;
use crate::settings::tree_of;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::setting::{MOST_ACTIONS, WorldOptions};

/// Actions of training between two tests (book, 6.2.4).
pub const SNAPSHOT: u32 = 1000;

/// Number in the book, text, printed reliability with its deviation.
pub type BookSchema = (&'static str, &'static str, Option<(f64, f64)>);

/// Schemas that the book prints; all generated in every run.
pub const BOOK_SCHEMAS: [BookSchema; 8] = [
    ("6_1", "+s1/turnl/+s2", Some((0.286, 0.012))),
    ("6_2", "+s3/forward/+s3", Some((0.351, 0.012))),
    ("6_3", "+s3/forward/+s3+ingrip", None),
    ("6_5", "+s1/turnl/+s1", None),
    ("6_7", "/turnr/+s5", Some((0.082, 0.012))),
    ("6_8", "/turnl/+s1", Some((0.091, 0.014))),
    ("6_11", "+s3/forward/+s2", Some((0.113, 0.020))),
    ("6_12", "+s2/turnl/+s3", Some((0.26, 0.011))),
];

/// How long lives are, as settings say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lengths {
    /// Actions of training, a multiple of 1000.
    pub training: u32,
    /// Actions of a test.
    pub test: u32,
}

impl Lengths {
    /// Those of the book (6.2.4).
    pub const BOOK: Self = Self {
        training: 10_000,
        test: 3_000,
    };
}

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForageOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// The world of training and tests.
    pub world: WorldOptions,
    /// The learner.
    #[serde(serialize_with = "in_words")]
    pub brain: AgentConfig,
    /// Actions of training, a multiple of 1000 (book: 10,000).
    pub actions: u32,
    /// Actions of a test (book: 3000).
    pub test_actions: u32,
}

impl ForageOptions {
    /// The standard learner in a world; all that can be checked without running is.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be.
    pub fn new(
        seeds: Vec<u64>,
        world: WorldOptions,
        actions: u32,
        test_actions: u32,
    ) -> Result<Self, Impossible> {
        for (name, number) in [("--actions", actions), ("--test-actions", test_actions)] {
            if number > MOST_ACTIONS {
                let sentence = format!("{name} must be at most {MOST_ACTIONS}, not {number}");
                return Err(Impossible::new(sentence));
            }
        }
        if actions == 0 || !actions.is_multiple_of(SNAPSHOT) {
            return Err(Impossible::new(
                "--actions must be a multiple of 1000, at least 1000",
            ));
        }
        if test_actions == 0 {
            return Err(Impossible::new("--test-actions must be at least 1"));
        }
        if world.config.after_capture == AfterCapture::Removed {
            let sentence = "--removed does not go with forage: it tests both ways of counting";
            return Err(Impossible::new(sentence));
        }
        for &seed in &seeds {
            world.build(seed)?;
        }
        Ok(Self {
            seeds,
            world,
            brain: AgentConfig::FORAGER,
            actions,
            test_actions,
        })
    }

    /// Whether this is another world, learner or length than the one that the claims are about.
    #[must_use]
    pub fn is_varied(&self) -> bool {
        self.world.config != PioneerConfig::NOISY
            || self.world.layout.is_some()
            || self.brain != AgentConfig::FORAGER
            || self.actions != Lengths::BOOK.training
            || self.test_actions != Lengths::BOOK.test
    }

    /// All settings as a file, of which the same options come.
    ///
    /// # Errors
    /// [`Impossible`] for a value that TOML cannot say.
    pub fn file(&self) -> Result<String, Impossible> {
        file(
            &self.seeds,
            json!({
                "world": room(&self.world)?,
                "agent": tree_of(&self.brain)?,
                "protocol": Lengths { training: self.actions, test: self.test_actions },
            }),
        )
    }
}
