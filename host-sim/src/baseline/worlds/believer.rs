//! Who knows a world's file, but not its state: keeps a belief, and acts by a plan for it.

use std::sync::Arc;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::pomdp::planner::{Plan, believed};

/// Acts by a plan, on the percepts that everybody gets.
///
/// ```no_run
/// use std::sync::Arc;
/// use host_sim::baseline::worlds::believer::Believer;
/// use host_sim::world::pomdp::{Pomdp, SHUTTLE, planner::{Plan, PlanConfig}};
/// let model = Arc::new(Pomdp::parse(SHUTTLE)?);
/// let planner = Believer::new(Arc::new(Plan::new(model, PlanConfig::DEFAULT)));
/// # Ok::<(), host_sim::world::pomdp::PomdpError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Believer {
    plan: Arc<Plan>,
    belief: Vec<f64>,
    done: Option<usize>,
}

impl Believer {
    /// One who has just begun.
    #[must_use]
    pub fn new(plan: Arc<Plan>) -> Self {
        Self {
            belief: plan.model().start().to_vec(),
            plan,
            done: None,
        }
    }
}

impl Controller for Believer {
    fn choose(&mut self, percept: &Percept, _: &mut Rng) -> usize {
        let model = self.plan.model();
        let on = |seen: &usize| percept.get(ItemId(*seen as u16)) == Some(true);
        let seen = (0..model.observations().len()).find(on);
        if let (Some(action), Some(seen)) = (self.done, seen) {
            self.belief = believed(model, &self.belief, action, seen);
        }
        let action = self.plan.action(&self.belief);
        self.done = Some(action);
        action
    }
}
