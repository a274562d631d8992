//! Worlds, learners, experiments and reports around [`cla_core`], on a computer.
//!
//! From the command line `host-sim --help` says what there is; what follows is for who writes Rust.
//!
//! # Run one experiment
//!
//! An [experiment](experiment::plan::Experiment) is options, cases, a trial of each case and a judgement
//! of all; [`experiment::live`] has every world and every learner by name.
//!
//! ```
//! use host_sim::experiment::live::{Live, LiveOptions};
//! use host_sim::experiment::plan::{Experiment, trials};
//! use host_sim::progress::Progress;
//! use serde_json::json;
//!
//! let given = json!({
//!     "world": {"name": "lake"},
//!     "agent": {"name": "q", "alpha": 0.2},
//!     "rivals": ["random"],
//!     "protocol": {"training": 2000, "before": 100, "after": 1000},
//! });
//! let options = LiveOptions::new(vec![1, 2, 3], given)?;
//! let lives = trials::<Live>(&options, &Progress::hidden())?;
//! let results = Live::judge(&options, &lives)?;
//! let learned = results.summary.find("live.q.obtained").ok_or("it was measured")?;
//! assert_eq!(learned.ours.n, 3);
//! # Ok::<(), host_sim::failure::Failure>(())
//! ```
//!
//! # One life
//!
//! A [learner](learner::Learner) chooses and learns, a [world](world::World) senses and acts, and
//! [`learner::live`] lets one live in the other, reflexes and all.
//! Around any world [`world::damage::Damaged`] breaks something, [`world::veil`] hides readings and
//! [`world::distracted`] adds items that mean nothing.
//!
//! # Your own world
//!
//! A world is what can be sensed, what can be done, and what has been obtained.
//!
//! ```
//! use cla_core::forest::MindConfig;
//! use cla_core::word::ItemId;
//! use host_sim::learner::{Learner, live, mind::Minded};
//! use host_sim::world::{Percept, World};
//!
//! /// A corridor of five places with food at its far end; who has eaten is at the door again.
//! #[derive(Default)]
//! struct Corridor {
//!     at: usize,
//!     eaten: u32,
//! }
//!
//! impl World for Corridor {
//!     fn items(&self) -> &'static [&'static str] {
//!         &["food", "door"]
//!     }
//!
//!     fn actions(&self) -> &'static [&'static str] {
//!         &["back", "on"]
//!     }
//!
//!     fn sense(&self) -> Percept {
//!         let mut now = Percept::all_off(2);
//!         for (item, on) in [(0, self.at == 4), (1, self.at == 0)] {
//!             now.set(ItemId(item), Some(on)).expect("there are two items");
//!         }
//!         now
//!     }
//!
//!     fn act(&mut self, action: usize) {
//!         self.at = match action {
//!             _ if self.at == 4 => 0,
//!             0 => self.at.saturating_sub(1),
//!             _ => self.at + 1,
//!         };
//!         self.eaten += u32::from(self.at == 4);
//!     }
//!
//!     fn obtained(&self) -> u32 {
//!         self.eaten
//!     }
//! }
//!
//! // The one learner, to whom food is worth 10.
//! let mut mind = Minded::<1, 2, 2>::born(MindConfig::DEFAULT, [10.0, 0.0], 1)?;
//! let mut world = Corridor::default();
//! live(&mut mind, &mut world, 2000)?;
//! mind.act()?;
//! let eaten = live(&mut mind, &mut world, 500)?.total();
//! assert!(eaten > 60, "{eaten} of 100 that are possible");
//! # Ok::<(), host_sim::failure::Failure>(())
//! ```
//!
//! `examples/new_world.rs`, `new_learner.rs` and `new_experiment.rs` go on from here.
//!
//! # A robot of your own
//!
//! [`teaching`] makes items and actions of a recorded log and teaches the learner by it; [`keeping`] has
//! brains in files, [`logs`] lives action by action.

pub mod baseline;
pub mod cli;
pub mod device;
pub mod experiment;
pub mod failure;
pub mod keeping;
pub mod learner;
pub mod logs;
pub mod options;
pub mod progress;
pub mod report;
pub mod settings;
pub mod teaching;
pub mod whole;
pub mod world;
