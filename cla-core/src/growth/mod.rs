//! Growth: schemas that grow where something was not foreseen (book, chapter 5; accommodation after Piaget).
//!
//! Samples that were not foreseen are remembered in reservoirs; a context grows item by item until the
//! evidence no longer contradicts it, and loses again what it can do without.
//! What cannot be seen becomes synthetic items, labelled in hindsight; goals are reached by chains
//! of schemas and by search over predicted states.
//! It shares the words with the agent and nothing else: neither knows the other.

mod accommodation;
mod attention;
mod evidence;
mod goal;
mod grow;
mod hidden;
mod reservoir;
mod simple_schema;
mod simplify;

pub use accommodation::{Accommodated, Accommodation, AccommodationConfig};
pub(crate) use attention::Attention;
pub use evidence::{Evidence, Transition};
pub use goal::{Attempt, Planner, PlannerConfig, Progress, chain_backward};
pub use grow::GrowthConfig;
pub(crate) use grow::{Tally, gain};
pub use hidden::{HindsightSample, NoRoomForItem, SyntheticItem, SyntheticItems};
pub use reservoir::Reservoir;
pub use simple_schema::{Entry, SimpleSchema, SimpleSchemas};
pub use simplify::simplify;
