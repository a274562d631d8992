//! Values and the choice of an action (book, 6.1.1, 6.2.2, 6.2.3).
//!
//! Value flows backwards through the schemas, from what is valuable for its own sake to the
//! contexts from which it can be reached; the best action is then a matter of a rule.
//! Habit is the other voice: what doing an action has really brought, without any model.

mod habit;
mod rule;
mod value;

pub use habit::{HabitConfig, Habits, Traces};
pub use rule::{ChoiceRule, Preference};
pub use value::{Appraisal, InherentValueError, ValueConfig};

pub(crate) use rule::{Voice, most_worth};
pub(crate) use value::{MOST_A_STEP, state_of};
