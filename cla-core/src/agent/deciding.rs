//! How an agent decides: which level speaks, what habit says to it, and when chance does.

use super::config::{AgentConfig, Settings};
use super::life::Agent;
use super::step::{Choice, Level, Reason};
use crate::check::Checked;
use crate::choice::{Preference, Voice};
use crate::level2::Fallback;
use crate::som::Prototypes;
use crate::word::{ActionId, ItemStates};

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
> Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    /// What the highest level that has something to say prefers; in a doubt that is level 1.
    pub(crate) fn prefer(&mut self, now: &ItemStates<WORDS>) -> Option<(Level, Preference)> {
        // Only what is needed, here and in `observe`: a copy of the whole would lie below all that
        // is called.
        let Settings::Present(Checked(AgentConfig {
            rule,
            values,
            level2,
            habits,
            ..
        })) = self.config
        else {
            return None;
        };
        let doubts = self.alarm.doubts();
        let trace = self.trace_in(now);
        let voice = habits.map(|habits| Voice {
            weight: habits.weight,
            worth: self.habits.worth(now.on(), trace),
        });
        let trace = trace.filter(|_| !doubts);
        if let (Some(level2), Some(trace)) = (&level2, trace) {
            let Self {
                level2: level,
                knowledge,
                ..
            } = self;
            let overloaded = match level2.fallback {
                Fallback::MeanReliability(share) => level.is_overloaded(share),
                Fallback::Never | Fallback::ValueThenReliability => false,
            };
            let above = level
                .prefer(knowledge, now, trace, &values, level2, voice.as_ref())
                .filter(|_| !overloaded);
            if let Some(above) = above {
                let below = match level2.fallback {
                    Fallback::ValueThenReliability => {
                        knowledge.prefer_with(now, rule, &values, voice.as_ref())
                    }
                    Fallback::Never | Fallback::MeanReliability(_) => None,
                };
                return match below {
                    Some(below) if below.value > above.value => Some((Level::One, below)),
                    _ => Some((Level::Two, above)),
                };
            }
        }
        let found = self
            .knowledge
            .prefer_with(now, rule, &values, voice.as_ref());
        found.map(|preference| (Level::One, preference))
    }

    /// Whether this step of training is random; drawn anew for each run of actions.
    pub(crate) fn explores(&mut self) -> bool {
        let Settings::Present(config) = &self.config else {
            return false;
        };
        if self.run == 0 {
            self.run = config.training_run;
            self.exploring = !self.rng.chance(config.greedy_share);
        }
        self.run -= 1;
        self.exploring
    }

    pub(crate) fn random(&mut self, reason: Reason) -> Choice {
        let action = ActionId(self.rng.below(ACTIONS as u32) as u16);
        Choice {
            action,
            reason,
            level: None,
            schema: None,
            value: 0.0,
        }
    }

    /// Whether this step belongs to a burst of random actions.
    pub(crate) fn escapes(&mut self) -> bool {
        let Settings::Present(Checked(AgentConfig {
            escape: Some(escape),
            ..
        })) = self.config
        else {
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
}
