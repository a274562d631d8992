//! The alarm: reward that stays away, by the agent's own usual rate; nobody tells it of damage.
//!
//! The book leaves this open (7.1.1); what follows an alarm is `doubt`.

/// When an agent is surprised, and what it does then.
///
/// ```
/// use cla_core::adaptation::SurpriseConfig;
/// use cla_core::agent::AgentConfig;
/// assert_eq!(AgentConfig::FORAGER.surprise, None);
/// assert_eq!(AgentConfig::RESILIENT.surprise, Some(SurpriseConfig::FORAGER));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurpriseConfig {
    /// Alarm when so many rewards have stayed away; finite, above 0.
    ///
    /// The missing rewards are a sum that falls with every reward and never below 0.
    pub missing: f32,
    /// Share of the usual rate of rewards that is good enough, in `[0, 1]`.
    pub enough: f32,
    /// Actions that a doubt lasts, at least 1; no alarm sounds in it.
    pub doubt: u16,
    /// Imagined trials of what lost its hold; finite, at least 0, and 0 is no optimism.
    pub optimism: f32,
}

impl SurpriseConfig {
    /// Tuned on the simulated Pioneer, seeds 0 to 19.
    ///
    /// An alarm by improbable predictions rang four times in 16,000 undamaged actions and was no
    /// faster; random exploration in the doubt, and hope for reward by any action, recovered slower.
    pub const FORAGER: Self = Self {
        missing: 8.0,
        enough: 0.65,
        doubt: 800,
        optimism: 3.0,
    };

    /// Whether the values make sense.
    pub(crate) fn is_valid(&self) -> bool {
        self.missing.is_finite()
            && self.missing > 0.0
            && (0.0..=1.0).contains(&self.enough)
            && self.optimism.is_finite()
            && self.optimism >= 0.0
            && self.doubt > 0
    }
}

/// Actions between two weighings of the evidence.
const EVERY: u16 = 25;
/// Actions over which the usual rate of rewards is averaged.
const USUAL: f32 = 3000.0;
/// Actions before the usual rate of rewards is known.
const ACQUAINTED: u16 = 500;

/// What an agent remembers of its surprises; all zero at first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surprise {
    missing: f32,
    /// Rewards an action, on average.
    usual: f32,
    acted: u16,
    /// Actions of doubt that are left.
    doubt: u16,
    alarms: u32,
}

impl Surprise {
    pub(crate) const NONE: Self = Self {
        missing: 0.0,
        usual: 0.0,
        acted: 0,
        doubt: 0,
        alarms: 0,
    };

    pub(crate) const fn alarms(&self) -> u32 {
        self.alarms
    }

    pub(crate) const fn doubts(&self) -> bool {
        self.doubt > 0
    }

    /// Takes note of what an action that the agent chose brought; whether an alarm begins.
    pub(crate) fn feel(&mut self, config: &SurpriseConfig, rewarded: bool) -> bool {
        let got = if rewarded { 1.0 } else { 0.0 };
        self.acted = self.acted.saturating_add(1);
        let acted = f32::from(self.acted);
        self.usual += (got - self.usual) / if acted < USUAL { acted } else { USUAL };
        if self.doubt > 0 {
            self.doubt -= 1;
            return false;
        }
        if self.acted < ACQUAINTED {
            return false;
        }
        let sum = self.missing + config.enough * self.usual - got;
        self.missing = if sum > 0.0 { sum } else { 0.0 };
        let alarmed = self.missing > config.missing;
        if alarmed {
            self.alarm(config);
        }
        alarmed
    }

    /// Begins a doubt.
    pub(crate) fn alarm(&mut self, config: &SurpriseConfig) {
        self.missing = 0.0;
        self.doubt = config.doubt;
        self.alarms = self.alarms.saturating_add(1);
    }

    /// Ends a doubt before its time.
    pub(crate) const fn end(&mut self) {
        self.doubt = 0;
    }

    /// Whether the evidence is to be weighed after this action.
    pub(crate) const fn weighs(&self) -> bool {
        self.doubt > 0 && self.doubt.is_multiple_of(EVERY)
    }
}
