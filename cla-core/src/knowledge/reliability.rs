//! How often a schema's result comes when its context holds and its action is done (book, 5.1.1).

use core::fmt;

use crate::snapshot::{clipped, stored, stored_codes};

/// Which of the two estimates decides.
///
/// ```
/// use cla_core::knowledge::{Estimate, Reliability};
/// let mut it = Reliability::from_counts(3, 4);
/// assert_eq!(it.value(Estimate::Plain), 0.75);
/// it.record(false, 0.5);
/// assert_eq!((it.value(Estimate::Plain), it.value(Estimate::Recent)), (0.6, 0.375));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Estimate {
    /// Successes / activations: the book's.
    Plain,
    /// An average that forgets: the newest trials weigh most.
    Recent,
}

/// The trials of one schema.
///
/// In the field: the rate of a Bernoulli variable, as a share and as an exponential average.
///
/// See [`Estimate`] for an example.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reliability {
    successes: u32,
    activations: u32,
    recent: f32,
}

impl Reliability {
    /// No trial yet.
    pub const ZERO: Self = Self {
        successes: 0,
        activations: 0,
        recent: 0.0,
    };

    /// The record of `successes` out of `activations` trials (at least as many as successes).
    #[must_use]
    pub fn from_counts(successes: u32, activations: u32) -> Self {
        let activations = activations.max(successes);
        let mut it = Self {
            successes,
            activations,
            recent: 0.0,
        };
        it.recent = it.value(Estimate::Plain);
        it
    }

    /// Adds a trial; the recent average moves by at least `forgetting` (in `[0, 1]`) of the way.
    ///
    /// With `forgetting = 0` both estimates are the same; a number out of its range counts as the
    /// nearest in it, NaN as 0.
    /// At the end of the counters' range both are halved, so their share is kept.
    pub fn record(&mut self, success: bool, forgetting: f32) {
        if self.activations == u32::MAX {
            self.activations /= 2;
            self.successes /= 2;
        }
        self.activations += 1;
        self.successes = self.successes.saturating_add(u32::from(success));
        let trials = self.activations as f32;
        let forgetting = clipped(forgetting, 1.0);
        let step = if trials * forgetting > 1.01 {
            // The share is below, whatever the rounding: no division.
            forgetting
        } else {
            let share = 1.0 / trials;
            if share > forgetting {
                share
            } else {
                forgetting
            }
        };
        let outcome = if success { 1.0 } else { 0.0 };
        self.recent += step * (outcome - self.recent);
    }

    /// Replaces the recent average, when more than one trial speaks for another (see `surprise`).
    pub(crate) fn revise(&mut self, recent: f32) {
        self.recent = recent;
    }

    /// The estimate, in `[0, 1]`; 0 before the first trial.
    #[must_use]
    pub fn value(&self, estimate: Estimate) -> f32 {
        match estimate {
            Estimate::Plain if self.activations == 0 => 0.0,
            Estimate::Plain => self.successes as f32 / self.activations as f32,
            Estimate::Recent => self.recent,
        }
    }

    /// Whether its numbers can be so.
    pub(super) fn is_sound(&self) -> bool {
        self.successes <= self.activations && (0.0..=1.0 + ROUNDING).contains(&self.recent)
    }

    /// Trials so far.
    #[must_use]
    pub const fn activations(&self) -> u32 {
        self.activations
    }

    /// Trials in which the result came.
    #[must_use]
    pub const fn successes(&self) -> u32 {
        self.successes
    }
}

impl fmt::Display for Reliability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.successes, self.activations)
    }
}

/// What rounding may add to a share.
const ROUNDING: f32 = 1e-3;

stored! {
    impl[] Reliability { successes, activations, recent }
    sound |it, _limits| it.is_sound()
}

stored_codes!(Estimate {
    0: (Self::Plain),
    1: (Self::Recent)
});

#[cfg(test)]
mod tests {
    use super::{Estimate, Reliability};

    #[test]
    fn without_forgetting_both_estimates_agree() {
        let mut it = Reliability::default();
        for trial in 0..1000_u32 {
            it.record(trial % 3 == 0, 0.0);
        }
        let (plain, recent) = (it.value(Estimate::Plain), it.value(Estimate::Recent));
        assert!((plain - 0.334).abs() < 1e-6 && (plain - recent).abs() < 1e-4);
    }

    #[test]
    fn with_forgetting_a_change_is_seen_within_its_time_constant() {
        let mut it = Reliability::from_counts(900, 1000);
        for _ in 0..100 {
            it.record(false, 0.02);
        }
        assert!((it.value(Estimate::Recent) - 0.9 * 0.98_f32.powi(100)).abs() < 1e-4);
        assert!(it.value(Estimate::Plain) > 0.8);
    }

    #[test]
    fn full_counters_keep_their_share() {
        let mut it = Reliability::from_counts(u32::MAX / 4, u32::MAX);
        it.record(true, 0.0);
        assert!((it.value(Estimate::Plain) - 0.25).abs() < 1e-6);
        assert!(it.activations() < u32::MAX);
    }

    #[test]
    fn the_first_trials_weigh_as_much_as_their_share_even_where_old_ones_are_forgotten() {
        let mut it = Reliability::ZERO;
        let recent = [true, false, false, true, false].map(|success| {
            it.record(success, 0.3);
            it.value(Estimate::Recent)
        });
        // 1, 1/2, 1/3 and from then on never less than .3.
        let third = 1.0 / 3.0;
        let fourth = third + 0.3 * (1.0 - third);
        let expected = [1.0, 0.5, third, fourth, 0.7 * fourth];
        for (recent, expected) in recent.into_iter().zip(expected) {
            assert!((recent - expected).abs() < 1e-6, "{recent}, not {expected}");
        }
        assert_eq!(std::format!("{it}"), "2 of 5");
    }

    #[test]
    fn before_the_first_trial_nothing_is_reliable_and_counts_are_at_least_the_successes() {
        assert_eq!(Reliability::ZERO.value(Estimate::Plain), 0.0);
        assert_eq!(Reliability::ZERO, Reliability::from_counts(0, 0));
        let it = Reliability::from_counts(3, 2);
        assert_eq!((it.successes(), it.activations()), (3, 3));
        assert_eq!(
            (it.value(Estimate::Plain), it.value(Estimate::Recent)),
            (1.0, 1.0)
        );
    }
}
