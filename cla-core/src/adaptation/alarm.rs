//! The alarm: reward that stays away, by the agent's own usual rate; nobody tells it of damage.
//!
//! The book leaves this open (7.1.1); what follows an alarm is `doubt`.

use crate::check::{Config, ConfigError, Range};
use crate::snapshot::{LARGEST_COUNT, stored};

/// When an agent is surprised, and what it does then.
///
/// In the field: change detection by a CUSUM of missing reward; optimism is an exploration bonus.
///
/// ```
/// use cla_core::adaptation::SurpriseConfig;
/// use cla_core::agent::AgentConfig;
/// assert_eq!(AgentConfig::FORAGER.surprise, None);
/// assert_eq!(AgentConfig::RESILIENT.surprise, Some(SurpriseConfig::FORAGER));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
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
}

impl Config for SurpriseConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::ABOVE_ZERO.check("SurpriseConfig::missing", self.missing)?;
        Range::SHARE.check("SurpriseConfig::enough", self.enough)?;
        Range::AT_LEAST_ONE.check("SurpriseConfig::doubt", f32::from(self.doubt))?;
        Range::NOT_NEGATIVE.check("SurpriseConfig::optimism", self.optimism)
    }
}

/// Actions between two weighings of the evidence.
const EVERY: u16 = 25;
/// Actions over which the usual rate of rewards is averaged.
const USUAL: f32 = 3000.0;
/// Actions before the usual rate of rewards is known.
const ACQUAINTED: u16 = 500;

/// The alarm itself, all zero at first.
///
/// In the field: a one-sided cumulative sum (CUSUM, Page 1954) of the shortfall of reward against a
/// running mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Alarm {
    missing: f32,
    /// Rewards an action, on average.
    usual: f32,
    acted: u16,
    /// Actions of doubt that are left.
    doubt: u16,
    alarms: u32,
}

impl Alarm {
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
            self.ring(config);
        }
        alarmed
    }

    fn is_sound(&self) -> bool {
        (0.0..=LARGEST_COUNT).contains(&self.missing) && (0.0..1.1).contains(&self.usual)
    }

    /// Gets acquainted anew when its numbers cannot be so; whether they could not.
    pub(crate) fn audit(&mut self) -> bool {
        let sound = self.is_sound();
        if !sound {
            *self = Self {
                alarms: self.alarms,
                ..Self::NONE
            };
        }
        !sound
    }

    /// Begins a doubt.
    pub(crate) fn ring(&mut self, config: &SurpriseConfig) {
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

stored! { impl[] SurpriseConfig { missing, enough, doubt, optimism } }
stored! {
    impl[] Alarm { missing, usual, acted, doubt, alarms }
    sound |it, _limits| it.is_sound()
}

#[cfg(test)]
mod tests {
    use super::{Alarm, SurpriseConfig};
    use crate::check::Config;

    const CONFIG: SurpriseConfig = SurpriseConfig {
        missing: 8.0,
        enough: 0.65,
        doubt: 100,
        optimism: 3.0,
    };

    /// After so many actions of which every fourth is rewarded.
    fn usual(actions: u32) -> Alarm {
        let mut it = Alarm::NONE;
        for action in 0..actions {
            assert!(!it.feel(&CONFIG, action % 4 == 0));
        }
        it
    }

    /// Actions without reward up to the alarm.
    fn patience(mut it: Alarm) -> u32 {
        let mut actions = 1;
        while !it.feel(&CONFIG, false) {
            actions += 1;
            assert!(actions < 1000);
        }
        assert_eq!(it.alarms(), 1);
        actions
    }

    #[test]
    fn an_alarm_sounds_when_so_many_of_the_usual_rewards_have_stayed_away() {
        // .65 of a quarter of a reward is missing after each action; the usual rate falls with them.
        assert!((45..=49).contains(&patience(usual(2000))));
        // Nobody is surprised in the first 500 actions, and what was usual in them fades.
        let early = patience(usual(100));
        assert!((700..=735).contains(&early), "{early}");
        // A reward counts against what was missing, and more than that is not saved up.
        let mut it = usual(2000);
        for _ in 0..40 {
            it.feel(&CONFIG, false);
        }
        for _ in 0..3 {
            it.feel(&CONFIG, true);
        }
        assert!((20..=34).contains(&patience(it)), "{}", patience(it));
        for _ in 0..20 {
            it.feel(&CONFIG, true);
        }
        assert!(patience(it) > 45);
    }

    #[test]
    fn a_doubt_lasts_its_actions_sounds_no_alarm_and_weighs_every_twenty_five() {
        let mut it = usual(2000);
        assert!(!it.doubts() && !it.weighs());
        it.ring(&CONFIG);
        let mut weighed = std::vec::Vec::new();
        for action in 0..100 {
            assert!(it.doubts(), "{action}");
            if it.weighs() {
                weighed.push(action);
            }
            assert!(!it.feel(&CONFIG, false));
        }
        assert_eq!(weighed, [0, 25, 50, 75]);
        assert!(!it.doubts() && !it.weighs());
        assert_eq!(it.alarms(), 1);
        // What stayed away in the doubt is forgiven.
        assert!(patience(usual(2000)) < 60 && !it.feel(&CONFIG, false));
        it.ring(&CONFIG);
        it.end();
        assert!(!it.doubts());
        assert_eq!(it.alarms(), 2);
    }

    #[test]
    fn a_surprise_is_valid_when_every_number_is_in_range() {
        let bad: [fn(&mut SurpriseConfig); 9] = [
            |it| it.missing = 0.0,
            |it| it.missing = -1.0,
            |it| it.missing = f32::INFINITY,
            |it| it.enough = -0.1,
            |it| it.enough = 1.1,
            |it| it.optimism = -1.0,
            |it| it.optimism = f32::INFINITY,
            |it| it.doubt = 0,
            |it| it.enough = f32::NAN,
        ];
        for (index, spoil) in bad.into_iter().enumerate() {
            let mut config = CONFIG;
            assert!(config.check().is_ok());
            spoil(&mut config);
            assert!(config.check().is_err(), "{index}");
        }
        let edge = SurpriseConfig {
            missing: 1e-3,
            enough: 1.0,
            doubt: 1,
            optimism: 0.0,
        };
        assert!(edge.check().is_ok());
    }
}
