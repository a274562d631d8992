//! The brain's way out of loops, for its rivals: random actions after a long time without reward.

use cla_core::agent::Escape;

/// Counts actions without reward, and says when a burst of random ones is due.
///
/// ```
/// use cla_core::agent::Escape;
/// use host_sim::baseline::patience::Patience;
/// let mut patience = Patience::NEW;
/// let escape = Escape { after: 2, burst: 1 };
/// for (rewarded, escapes) in [(false, false), (false, false), (false, true), (true, false)] {
///     assert_eq!(patience.ends(Some(escape)), escapes);
///     patience.feel(rewarded);
/// }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Patience {
    since_reward: u16,
    burst: u16,
}

impl Patience {
    /// Fresh.
    pub const NEW: Self = Self {
        since_reward: 0,
        burst: 0,
    };

    /// Whether the next action is one of a burst; never without an escape.
    pub fn ends(&mut self, escape: Option<Escape>) -> bool {
        let Some(escape) = escape else {
            return false;
        };
        if self.burst == 0 && self.since_reward >= escape.after {
            self.burst = escape.burst;
            self.since_reward = 0;
        }
        let ends = self.burst > 0;
        self.burst = self.burst.saturating_sub(1);
        ends
    }

    /// An action has brought something, or nothing.
    pub fn feel(&mut self, rewarded: bool) {
        self.since_reward = if rewarded {
            0
        } else {
            self.since_reward.saturating_add(1)
        };
    }

    /// Training is over: the count begins anew.
    pub fn begin(&mut self) {
        self.since_reward = 0;
    }
}
