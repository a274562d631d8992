//! Goals: a composite action tries to bring one about, by a chain of schemas or by a plan (5.1.1).

mod composite_action;
mod planner;

pub use composite_action::{Attempt, Progress, chain_backward};
pub use planner::{Planner, PlannerConfig};
