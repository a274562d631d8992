//! How an agent notices that things no longer go its way, and doubts what it knows.

use super::config::{Adaptation, AgentConfig, Settings};
use super::life::{Agent, Stage};
use crate::adaptation::SurpriseConfig;
use crate::check::{Checked, ConfigError};
use crate::som::Prototypes;

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
    /// Gives the agent another sense of surprise, or none, from now on; what it knows stays.
    ///
    /// # Errors
    /// [`ConfigError`]; nothing has changed.
    pub fn set_surprise(&mut self, surprise: Option<SurpriseConfig>) -> Result<(), ConfigError> {
        if let Settings::Present(config) = self.config {
            self.reconfigure(AgentConfig {
                surprise,
                ..*config
            })?;
        }
        Ok(())
    }

    /// Doubts what it knows from now on, as after an alarm.
    ///
    /// Nothing happens unless it acts, re-learns and can be surprised.
    pub fn doubt(&mut self) {
        if let Some(config) = self.suspects() {
            self.alarm.alarm(&config);
            self.knowledge.begin_doubt();
        }
    }

    /// Alarms so far.
    #[must_use]
    pub const fn alarms(&self) -> u32 {
        self.alarm.alarms()
    }

    /// Whether the agent doubts what it knows: it was alarmed a short time ago.
    #[must_use]
    pub const fn doubts(&self) -> bool {
        self.alarm.doubts()
    }

    /// Alarms sound only where something can be learned from them.
    pub(crate) fn suspects(&self) -> Option<SurpriseConfig> {
        let relearns = self.stage == Stage::Acting(Adaptation::Relearning);
        match self.config {
            Settings::Present(Checked(AgentConfig { surprise, .. })) => {
                surprise.filter(|_| relearns)
            }
            Settings::Absent => None,
        }
    }

    /// Doubts what it knows after an alarm, and weighs the evidence while it doubts.
    #[inline(never)]
    pub(crate) fn feel(&mut self, rewarded: bool) {
        let Some(surprise) = self.suspects() else {
            return;
        };
        let doubted = self.alarm.doubts();
        if self.alarm.feel(&surprise, rewarded) {
            self.knowledge.begin_doubt();
        }
        if self.alarm.weighs()
            && let Settings::Present(config) = &self.config
        {
            // Like a harvest, it comes now and then and is no part of a tick.
            let cost = (self.knowledge.cost, self.level2.table.cost);
            self.knowledge.weigh::<ACTIONS>(&surprise, &config.values);
            let knowledge = &self.knowledge;
            self.level2
                .doubt(knowledge, |context, action| knowledge.hold(context, action));
            (self.knowledge.cost, self.level2.table.cost) = cost;
        }
        if !self.alarm.doubts() && doubted {
            self.knowledge.end_doubt();
            self.level2.forget_experience();
        }
    }

    /// Ends a doubt that nothing can be learned from any more: acting or the configuration changed.
    #[inline(never)]
    pub(crate) fn settle_doubt(&mut self) {
        if self.alarm.doubts() && self.suspects().is_none() {
            self.alarm.end();
            self.knowledge.end_doubt();
            self.level2.forget_experience();
        }
    }
}
