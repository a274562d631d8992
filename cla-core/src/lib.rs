//! A robot brain that grows: self-organizing maps become schemas, schemas become behaviour.
//!
//! This is the Constructivist Learning Architecture of Harold Chaput (2004) for a robot's own
//! controller: `no_std`, no heap, no `unsafe`, every byte known at compile time, and the same seed
//! gives the same life to the bit on a desktop and on a microcontroller.
//!
//! Name the robot's items, actions and what is valuable; then sense, choose, act, learn:
//!
//! ```
//! use cla_core::clasm::{Adaptation, AgentConfig};
//!
//! cla_core::brain! {
//!     /// A robot that wants to stand in the light.
//!     pub mod moth {
//!         items: [light_left, light_ahead, light_right, at_lamp],
//!         actions: [left, forward, right],
//!         values: [at_lamp = 10.0],
//!         maps: 6 x 6,
//!         patterns: 32,
//!         schemas: 128,
//!         ram: 12_000, // a larger brain does not compile
//!     }
//! }
//! use moth::{Action, Item, Percept};
//! # struct Robot { bearing: i32, distance: i32 }
//! # impl Robot {
//! #     fn sense(&self) -> Percept {
//! #         let mut now = Percept::all_off(4);
//! #         let seen = [(Item::light_left, self.bearing == 1), (Item::light_ahead, self.bearing == 0),
//! #             (Item::light_right, self.bearing == -1), (Item::at_lamp, self.distance == 0)];
//! #         for (item, on) in seen { now.set(item.id(), Some(on)).unwrap(); }
//! #         now
//! #     }
//! #     fn act(&mut self, action: Action) {
//! #         if self.distance == 0 { self.distance = 5; self.bearing = 1; return; }
//! #         match action {
//! #             Action::left => self.bearing = (self.bearing - 1).max(-2),
//! #             Action::right => self.bearing = (self.bearing + 1).min(2),
//! #             Action::forward if self.bearing == 0 => self.distance -= 1,
//! #             Action::forward => {}
//! #         }
//! #     }
//! # }
//! # let mut robot = Robot { bearing: 1, distance: 3 };
//!
//! let mut brain = moth::brain(); // on a board: a static, all of it in .bss
//! moth::be_born(&mut brain, AgentConfig::FORAGER, 42)?;
//! let mut visits = 0;
//! for step in 0..4000 {
//!     if step == 2000 {
//!         brain.act(Adaptation::Reliabilities)?; // enough explored: use it
//!     }
//!     let choice = brain.choose(&robot.sense())?;
//!     robot.act(Action::of(choice.action).expect("an action of this robot"));
//!     let lesson = brain.learn(&robot.sense())?;
//!     if step >= 2000 && lesson.reward > 0.0 {
//!         visits += 1;
//!     }
//! }
//! assert!(visits > 200, "{visits}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The storeys, in the book's order; each knows only those before it:
//! [`num`] (arithmetic with the same bits everywhere) → [`som`] (self-organizing maps) →
//! [`layer`] (maps joined into hierarchies, overload, fallback) and, beside it,
//! [`clasm`] (items, Action SOMs, schemas, values, choice, the agent).
//! [`forager`] describes the book's robot.

#![no_std]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::todo,
        clippy::unimplemented,
        clippy::unreachable,
        clippy::panic_in_result_fn
    )
)]

#[cfg(test)]
extern crate std;

pub mod clasm;
pub mod forager;
pub mod layer;
pub mod num;
pub mod som;
