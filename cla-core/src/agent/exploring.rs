//! When an agent acts at random: runs of training, and bursts after a long time without reward.

use super::config::{AgentConfig, Escape};
use crate::num::Rng;
use crate::snapshot::stored;

/// Where it stands between value and chance; all zero at first.
#[derive(Clone, Debug)]
pub(super) struct Exploration {
    /// Own actions since the last reward.
    since_reward: u16,
    /// Random actions that are left of a burst.
    burst: u16,
    /// Actions that are left of a run of training, and whether they are random.
    run: u16,
    random: bool,
}

impl Exploration {
    pub(super) const NONE: Self = Self {
        since_reward: 0,
        burst: 0,
        run: 0,
        random: false,
    };

    /// Whether this step of training is random; drawn anew for each run of actions.
    pub(super) fn explores(&mut self, config: &AgentConfig, rng: &mut Rng) -> bool {
        if self.run == 0 {
            self.run = config.training_run;
            self.random = !rng.chance(config.greedy_share);
        }
        self.run = self.run.saturating_sub(1);
        self.random
    }

    /// Whether this step belongs to a burst of random actions.
    pub(super) fn escapes(&mut self, escape: Option<&Escape>) -> bool {
        let Some(escape) = escape else {
            return false;
        };
        if self.burst == 0 && self.since_reward >= escape.after {
            self.burst = escape.burst;
            self.since_reward = 0;
        }
        let escapes = self.burst > 0;
        self.burst = self.burst.saturating_sub(1);
        escapes
    }

    /// An own action has brought something, or nothing.
    pub(super) const fn count(&mut self, rewarded: bool) {
        self.since_reward = if rewarded {
            0
        } else {
            self.since_reward.saturating_add(1)
        };
    }

    /// Training is over: patience begins anew.
    pub(super) const fn pause(&mut self) {
        self.since_reward = 0;
        self.burst = 0;
    }
}

stored! { impl[] Exploration { since_reward, burst, run, random } }
