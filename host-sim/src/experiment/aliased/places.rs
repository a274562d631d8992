//! The worlds: what their files say, who can plan in them, how long one lives there.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::world::pomdp::planner::{Plan, PlanConfig};
use crate::world::pomdp::{CHEESE, Pomdp, SHUTTLE, hallway, t_maze};

/// Where one lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// The forager's room with barriers that only a bump shows.
    Barriers,
    /// Chrisman's shuttle.
    Shuttle,
    /// McCallum's cheese maze.
    Cheese,
    /// A choice two actions after its cue.
    TMaze2,
    /// A choice four actions after its cue.
    TMaze4,
    /// A choice eight actions after its cue.
    TMaze8,
    /// A choice sixteen actions after its cue.
    TMaze16,
    /// The hallway.
    Hallway,
}

/// Plans are the same for all seeds, and the hallway's takes seconds.
static PLANS: [OnceLock<Arc<Plan>>; 8] = [const { OnceLock::new() }; 8];

impl Place {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Barriers,
        Self::Shuttle,
        Self::Cheese,
        Self::TMaze2,
        Self::TMaze4,
        Self::TMaze8,
        Self::TMaze16,
        Self::Hallway,
    ];

    /// Its name on the command line and in claims.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Barriers => "barriers",
            Self::Shuttle => "shuttle",
            Self::Cheese => "cheese",
            Self::TMaze2 => "t_maze_2",
            Self::TMaze4 => "t_maze_4",
            Self::TMaze8 => "t_maze_8",
            Self::TMaze16 => "t_maze_16",
            Self::Hallway => "hallway",
        }
    }

    /// The world of a file; `None` for the forager's room, which is none.
    ///
    /// # Errors
    /// [`Failure`] when the project's own text cannot be read.
    pub fn model(self) -> Result<Option<Arc<Pomdp>>, Failure> {
        let text = match self {
            Self::Barriers => return Ok(None),
            Self::Shuttle => SHUTTLE.to_owned(),
            Self::Cheese => CHEESE.to_owned(),
            Self::TMaze2 => t_maze(2),
            Self::TMaze4 => t_maze(4),
            Self::TMaze8 => t_maze(8),
            Self::TMaze16 => t_maze(16),
            Self::Hallway => hallway(),
        };
        Ok(Some(Arc::new(Pomdp::parse(&text)?)))
    }

    /// What to do for who knows this file, but not the state; made once.
    #[must_use]
    pub fn plan(self, model: &Arc<Pomdp>) -> Arc<Plan> {
        let config = match self {
            Self::Hallway => PlanConfig {
                discount: 0.95,
                points: 60,
                sweeps: 60,
                apart: 0.2,
                ..PlanConfig::DEFAULT
            },
            _ => PlanConfig::DEFAULT,
        };
        let make = || Arc::new(Plan::new(Arc::clone(model), config));
        Arc::clone(PLANS[self as usize].get_or_init(make))
    }

    /// The item that the book's agent values; what it earns is no number to it.
    #[must_use]
    pub const fn valued(self) -> &'static str {
        match self {
            Self::Barriers => "ingrip",
            Self::Shuttle => "docked_LRV",
            Self::Cheese => "cheese",
            Self::Hallway => "goal",
            Self::TMaze2 | Self::TMaze4 | Self::TMaze8 | Self::TMaze16 => "prize",
        }
    }

    /// Actions of training after which a twin is tested, the last of them for the claims.
    #[must_use]
    pub const fn lengths(self) -> &'static [u32] {
        match self {
            Self::Barriers => &[1_000, 2_000, 5_000, 10_000, 20_000],
            _ => &[1_000, 2_000, 5_000, 10_000, 20_000, 50_000],
        }
    }

    /// Actions of a test.
    #[must_use]
    pub const fn test(self) -> u32 {
        match self {
            Self::Barriers => 3_000,
            _ => 5_000,
        }
    }

    /// The most that an untried action is held to be worth when rivals are tuned: of the size of what
    /// is earned.
    #[must_use]
    pub const fn optimism(self) -> f64 {
        match self {
            Self::Shuttle => 5.0,
            Self::TMaze2 | Self::TMaze4 | Self::TMaze8 | Self::TMaze16 => 2.0,
            Self::Barriers | Self::Cheese | Self::Hallway => 0.5,
        }
    }
}
