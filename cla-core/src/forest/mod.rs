//! One learner for all worlds: contexts that say no more than they must, habits beside them, and a
//! track record that decides which of them leads.
//!
//! What happened goes into a bounded memory of samples (`memory`); from it context trees grow, a few
//! units of work a tick (`budget`, `tally`, `growth`, `tree`, `trees`), which also say which items
//! matter (`relevance`).
//! Habits learn at once from what was felt (`sarsa`) and again from what is remembered (`replay`); a
//! model counts what follows what (`model`).
//! Voices lead in turn (`voices`), and now and then anything is tried (`restless`); senses that got stuck
//! are not believed (`runs`); when rewards stay away new experience counts for more (`doubt`); the whole
//! is a [`Mind`] (`config`, `mind`).
//! Where it has a reason, schemas with results and plans are a voice among the others, goals are pursued,
//! and a choice is explained (`goals`).
//! It stands on words, `num` and `reason`, and knows nothing of maps.

mod audit;
mod budget;
mod capacities;
mod config;
mod doubt;
mod goals;
mod growth;
mod image;
mod inspect;
mod knowledge;
mod memory;
mod mind;
mod model;
mod moment;
mod rates;
mod relevance;
mod replay;
mod restless;
mod revalue;
mod runs;
mod sarsa;
mod step;
mod tally;
mod tree;
mod trees;
mod unborn;
mod voices;

pub use budget::WorkBudget;
pub use capacities::{Bytes, Capacities, Thoughts};
pub use config::{Doubting, Heard, MindConfig, Voice};
pub use goals::Explanation;
pub use inspect::Filled;
pub use mind::Mind;
pub use moment::Feature;
pub use step::{Actions, Deliberation, MOST_REWARD, MindError, Motive, Taught};
