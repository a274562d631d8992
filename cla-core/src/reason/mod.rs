//! Reason: simple schemas of every action, grown from surprises, and what can be reached by them.
//!
//! What an action did is compared with what its schemas foresaw; what nobody foresaw grows a context,
//! one remembered sample at a time (`growing`), against a reservoir of what that action has done
//! (`accommodating`).
//! How much schemas are forgiven is what the action's own record says (`record`).
//! From schemas and from what was lived through come imagined states, over which values and goals
//! spread (`imagined`); the whole is a [`Reason`] (`faculty`), and its work is counted in units.
//! Unknown items satisfy neither sign; where a state must be whole they are believed to be what was
//! predicted of them.
//! Who wants none of it takes `()` for its [`Reasoning`].
//! It stands on the schemas of `growth`, and knows nothing of who asks it.

mod accommodating;
mod experience;
mod faculty;
mod growing;
mod imagined;
mod pursuit;
mod reasoning;
mod record;
mod table;

pub use experience::Experience;
pub use faculty::{Prospects, Reason};
pub use pursuit::{Pursuit, Way};
pub use reasoning::Reasoning;
